// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// From a file to what the viewer shows.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "afx/dibr_model.h"
#include "afx/surroundings.h"
#include "codec/diagnostics.h"
#include "codec/error.h"
#include "nodes/scene.h"
#include "tools/session.h"
#include "tools/viewer/viewer_model.h"

namespace afx::tools {

/// Which model of a file is viewed.
struct ViewQuery {
  std::string input_format;
  std::optional<uint32_t> resolution;  ///< of a raw octree
  std::optional<uint32_t> frame;       ///< of a stream
  std::string viewpoint;  ///< number from 1, DEF name or description; empty: the scene's first one
  bool is_usage = false;  ///< set where one of these is what is wrong
};

/// The Viewpoints of a scene, in its order, in the world. Those whose place is not finite, and all
/// beyond kMostViewpoints, are left out.
inline constexpr size_t kMostViewpoints = 1000;
[[nodiscard]] std::vector<Viewpoint> viewpoints_of(const nodes::Scene& scene);

/// The cameras of the pictures that models came with, in the world: of DepthImages and of the
/// images of OctreeImages. Those that are not finite or see nothing are left out.
[[nodiscard]] std::vector<ReferenceCamera> reference_cameras(const std::vector<DibrModel>& models);

/// Reads a model of any kind but a mesh and makes it ready to be drawn.
///
/// doing     is told what is being done, for people
/// Errors    those of the readers; unsupported: a mesh; bad_argument: no such viewpoint
/// Warnings  those of the readers
[[nodiscard]] Result<std::shared_ptr<const ViewerModel>> load_view_model(
    const std::string& path, ViewQuery& query, const Session& session, Diagnostics& diagnostics,
    const std::function<void(const std::string&)>& doing);

}  // namespace afx::tools
