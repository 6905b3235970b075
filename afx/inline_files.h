// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The files that a scene is made of: its own and those that its Inlines name.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "afx/dibr_model.h"
#include "afx/shapes/shape_cache.h"
#include "afx/visual_scene.h"

namespace afx {

/// A file, the main one or one that an Inline names, with what has been read of it.
struct SceneFile {
  SceneFile(InlineScene loaded, Limits& left)
      : source(std::move(loaded)), models(source.base, left), shapes(source.base, left) {}
  InlineScene source;
  DibrModelReader models;
  ShapeCache shapes;
};

/// Finds the files of Inlines; each is loaded once.
class InlineFiles {
 public:
  /// left   what all files together may keep. Must outlive this
  InlineFiles(InlineLoader load, Limits& left) : load_(std::move(load)), left_(left) {}

  /// The file that an Inline in `from` names; null, with a warning the first time, where there is
  /// none. Errors: limit_exceeded
  Result<SceneFile*> find(const nodes::NodeView& node, const SceneFile& from,
                          Diagnostics& diagnostics);

 private:
  Result<InlineScene> load(std::span<const nodes::Url> urls, const UrlBase& base);
  SceneFile* keep(InlineScene loaded);

  InlineLoader load_;
  Limits& left_;
  uint32_t loads_ = 0;
  std::vector<std::unique_ptr<SceneFile>> files_;
  std::map<std::pair<const SceneFile*, std::vector<uint32_t>>, SceneFile*> by_node_;
};

}  // namespace afx
