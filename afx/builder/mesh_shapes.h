// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// A mesh as renderers of scenes take it.
#pragma once

#include <memory>
#include <vector>

#include "afx/builder/mesh.h"
#include "afx/builder/shading.h"
#include "afx/shape.h"
#include "codec/error.h"
#include "codec/limits.h"

namespace afx {

/// One shape for each material that has triangles, in their order, both sides to be seen. A
/// headlight is meant to fall on them (render::Scene::headlight): those that Shade says are to be
/// shaded are lit, with normals that are smooth but where triangles meet at more than 60 degrees;
/// the others show their colours as they are. They look as MeshLook shows the mesh but for this:
/// - The light is another.
/// - Where there is a texture, colours of vertices are left out. A material's colour is in the
///   picture then, which is a copy.
/// - Alpha of a texture makes surface transparent, it does not cut it off.
/// - Colours of vertices are mixed as display values, not in linear light.
/// - Where normals would take more memory than the limit (kFaceCornerBytes a corner), those of lit
///   meshes are smooth everywhere.
///
/// mesh     not null; textures that need no change are shared with it, it must not change
/// Errors   limit_exceeded: more than limits.memory
Result<std::vector<Shape>> shapes_of(const std::shared_ptr<const Mesh>& mesh, Shade shade,
                                     const Limits& limits);

}  // namespace afx
