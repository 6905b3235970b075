// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Anything three-dimensional that the commands take: meshes, point clouds, RGB-D pictures, scenes.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "afx/builder/mesh.h"
#include "afx/dibr_model.h"
#include "afx/surfels.h"
#include "codec/diagnostics.h"
#include "codec/error.h"
#include "tools/session.h"

namespace afx::tools {

/// What was read: a mesh, points, pieces of surface (of RGB-D pictures), or the objects of a scene.
using ModelInput = std::variant<Mesh, PointCloud, Surfels, std::vector<DibrModel>>;

/// Reads a model of any kind. Whatever tells an RGB-D list (.json) from other JSON is its content.
/// Errors    those of the readers, with the file; unsupported: a picture, or another kind of which
///           no model is known
/// Warnings  those of the readers
Result<ModelInput> read_model_input(const std::string& path, const Session& session,
                                    Diagnostics& diagnostics);

/// Takes it to pieces of surface; for a mesh see afx/builder/mesh_surfels.h, that is not done here.
Result<Surfels> surfels_of_input(ModelInput&& model, const Session& session,
                                 Diagnostics& diagnostics);

}  // namespace afx::tools
