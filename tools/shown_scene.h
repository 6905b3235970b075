// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// A scene file with the files that its Inlines name.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "afx/visual_scene.h"
#include "codec/diagnostics.h"
#include "codec/error.h"
#include "codec/limits.h"
#include "tools/input.h"
#include "tools/scene_input.h"

namespace afx::tools {

/// A scene of any kind, kept open to be read for one viewer after another. Inlines may name scene
/// files of any kind, relative to the file that they stand in.
class ShownScene {
 public:
  /// Errors and warnings: those of read_scene.
  static Result<std::unique_ptr<ShownScene>> open(Input input, const Limits& limits,
                                                  Diagnostics& diagnostics);
  ShownScene(const ShownScene&) = delete;
  ShownScene& operator=(const ShownScene&) = delete;

  /// What it shows. Errors and warnings: those of VisualSceneReader, with the file; those of
  /// read_scene of the files of Inlines.
  Result<VisualScene> read(const std::optional<nodes::Viewer>& viewer, Diagnostics& diagnostics);

 private:
  /// A file that was opened; its scene may refer to its bytes.
  struct Opened {
    Input input;
    LoadedScene scene;
  };
  ShownScene(std::unique_ptr<Opened> main, const Limits& limits);
  static Result<std::unique_ptr<Opened>> open_file(Input input, const Limits& limits,
                                                   Diagnostics& diagnostics);
  Result<InlineScene> load_inline(std::span<const nodes::Url> urls, const UrlBase& base);

  std::unique_ptr<Opened> main_;
  Limits limits_;           // file_bytes: what is left for Inlines
  Diagnostics of_inlines_;  // of the reading at hand
  VisualSceneReader reader_;
};

}  // namespace afx::tools
