// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "afx/builder/mesh_look.h"
#include "afx/builder/view_source.h"
#include "afx/surfels.h"
#include "tools/build.h"

namespace afx::tools {

/// A model that can be looked at, with all that it needs. Not to be moved.
class LookedAt {
 public:
  /// Errors  those of surfels_of_input
  static Result<std::unique_ptr<LookedAt>> of(ModelInput&& model, const BuildJob& job);

  [[nodiscard]] const ViewSource& views() const { return *views_; }
  /// The model as pieces of surface, a mesh sampled at a resolution. Errors   limit_exceeded
  Result<Surfels> surfels(uint32_t resolution, const BuildJob& job) &&;

 private:
  std::optional<Mesh> mesh_;
  std::optional<MeshLook> look_;
  Surfels surfels_;
  std::unique_ptr<ViewSource> views_;
};

inline constexpr const char* kAutomaticViews = "auto";

/// The number that --views is, the greatest one where it is too large for that; nothing: it is
/// none.
std::optional<uint64_t> count_of_views(const std::string& views);

/// The error of a model of which no pixel shows anything.
Error nothing_to_see();

/// What --views asks for.
struct ViewsOption {
  unsigned count = 0;       ///< evenly spread; 0: as many as it takes
  std::vector<Shot> shots;  ///< not empty: these, in the coordinates of the model
};

/// Reads --views: a number, which has been checked, "auto", or the name of a camera list or of a
/// scene whose DepthImages' cameras are meant. What was taken off the model is taken off cameras.
/// Errors  bad_argument: a scene without DepthImages; unsupported: DepthImages that a Transform
///         turns or scales; those of reading the file
Result<ViewsOption> read_views_option(const BuildJob& job);

}  // namespace afx::tools
