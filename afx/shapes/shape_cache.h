// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What the nodes of one scene are once they have been read.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "afx/scene_files.h"
#include "afx/shape.h"
#include "afx/surroundings.h"
#include "codec/diagnostics.h"
#include "codec/error.h"
#include "codec/limits.h"
#include "nodes/node_view.h"

namespace afx {

/// Reads geometries, looks and backgrounds of one scene and keeps them: nodes that are met again
/// are not read again, and warned of once. The scene must not change meanwhile.
class ShapeCache {
 public:
  /// left   what all together may take; its memory becomes less by what is kept. Must outlive this
  ShapeCache(UrlBase base, Limits& left) : base_(std::move(base)), left_(left) {}

  /// Errors  those of read_geometry; for all three limit_exceeded: more than what is left
  Result<std::shared_ptr<const Geometry>> geometry(const nodes::NodeView& node);
  /// Of an Appearance, or of none, with its texture. Errors, warnings: those of look_nodes.h
  Result<std::shared_ptr<const Look>> look(const nodes::NodeView& appearance,
                                           Diagnostics& diagnostics);
  /// Errors, warnings: those of read_backdrop
  Result<std::shared_ptr<const Backdrop>> backdrop(const nodes::NodeView& node,
                                                   Diagnostics& diagnostics);

 private:
  using Path = std::vector<uint32_t>;  // NodeView::path
  Result<std::shared_ptr<const Picture>> texture(const nodes::NodeView& node,
                                                 Diagnostics& diagnostics);
  template <class T>
  Result<std::shared_ptr<const T>> keep(std::map<Path, std::shared_ptr<const T>>& known, Path path,
                                        std::shared_ptr<const T> value, uint64_t bytes);

  UrlBase base_;
  Limits& left_;
  std::map<Path, std::shared_ptr<const Geometry>> geometries_;
  std::map<Path, std::shared_ptr<const Look>> looks_;
  std::map<Path, std::shared_ptr<const Picture>> textures_;
  std::map<Path, std::shared_ptr<const Backdrop>> backdrops_;
};

}  // namespace afx
