// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Anything three-dimensional that the commands take: meshes, point clouds, RGB-D pictures, scenes.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "afx/builder/mesh.h"
#include "afx/builder/shading.h"
#include "afx/dibr_model.h"
#include "afx/surfels.h"
#include "codec/diagnostics.h"
#include "codec/error.h"
#include "tools/input.h"
#include "tools/session.h"

namespace afx::tools {

/// What was read: a mesh, points, pieces of surface (of RGB-D pictures), or the objects of a scene.
using ModelInput = std::variant<Mesh, PointCloud, Surfels, std::vector<DibrModel>>;

/// Reads a model of any kind. Whatever tells an RGB-D list (.json) from other JSON is its content.
///
/// input     see open_model_input
/// query     the size of a raw octree, the frame of a stream
/// Errors    those of the readers, with the file; unsupported: a picture, or another kind of which
///           no model is known
/// Warnings  those of the readers; left_out: Shapes and Inlines of a scene; no_pictures: a stream
///           alone, which has indices of pictures
Result<ModelInput> read_model_input(const Input& input, OctreeQuery& query, const Session& session,
                                    Diagnostics& diagnostics);

/// For commands without an option that tells the size of a raw octree: unsupported if it is one.
Status refuse_raw_octree(const Input& input);

/// Takes it to pieces of surface; for a mesh see afx/builder/mesh_surfels.h, that is not done here.
Result<Surfels> surfels_of_input(ModelInput&& model, const Session& session,
                                 Diagnostics& diagnostics);

/// What --shade says: "always", "never", else automatic.
Shade shade_of(const std::string& option);

}  // namespace afx::tools
