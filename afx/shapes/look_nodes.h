// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Appearance, Material and TextureTransform as plain structs. Source: ISO/IEC 14772-1:1997
// (VRML97), Appearance, Material, TextureTransform (clauses not checked).
#pragma once

#include <glm/mat3x3.hpp>

#include "afx/scene_files.h"
#include "afx/shape.h"
#include "codec/diagnostics.h"
#include "codec/error.h"
#include "codec/limits.h"
#include "nodes/node_view.h"

namespace afx {

/// The look that an Appearance says, without its texture. Colours and others are drawn into 0..1.
///
/// appearance   a view of nothing, or one without material: unlit white. Material2D: unlit
/// Errors  bad_argument: fields that are not numbers
Result<Look> read_look(const nodes::NodeView& appearance);

/// The matrix of a TextureTransform: what a point (s, t, 1) becomes is moved by translation, then
/// by center, turned, scaled, and moved back by center (VRML97 has it in this order). A view of
/// nothing, and nodes of other types, change nothing.
/// Errors  bad_argument: fields that are not finite
Result<glm::mat3> read_texture_transform(const nodes::NodeView& transform);

/// The picture of a texture node; null where there is none, or where it cannot be had.
/// Errors    limit_exceeded
/// Warnings  texture_not_shown: another type of node (MovieTexture), a picture that cannot be read
Result<std::shared_ptr<const Picture>> read_texture(const nodes::NodeView& texture,
                                                    const UrlBase& base, const Limits& limits,
                                                    Diagnostics& diagnostics);

}  // namespace afx
