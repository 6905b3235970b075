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

#include "afx/surroundings.h"
#include "codec/diagnostics.h"
#include "codec/error.h"
#include "render/model_cameras.h"
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

/// Viewpoints beyond so many are left out.
inline constexpr size_t kMostViewpoints = 1000;

/// The cameras of the pictures that models came with, in the world: of DepthImages and of the
/// images of OctreeImages. Those that are not finite or see nothing are left out.
[[nodiscard]] std::vector<ReferenceCamera> reference_cameras(
    const std::vector<render::ModelCamera>& of_models);

/// Reads a model of any kind and makes it ready to be drawn: scenes as they are without a viewer,
/// meshes as shapes.
///
/// doing     is told what is being done, for people
/// Errors    those of the readers; bad_argument: no such viewpoint
/// Warnings  those of the readers
[[nodiscard]] Result<std::shared_ptr<const ViewerModel>> load_view_model(
    const std::string& path, ViewQuery& query, const Session& session, Diagnostics& diagnostics,
    const std::function<void(const std::string&)>& doing);

}  // namespace afx::tools
