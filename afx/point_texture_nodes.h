// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// From PointTexture nodes to PointTextures, and back.
#pragma once

#include "afx/depth_image.h"
#include "codec/diagnostics.h"
#include "codec/error.h"
#include "codec/limits.h"
#include "nodes/node_view.h"
#include "nodes/scene.h"

namespace afx {

/// Reads a PointTexture.
/// Errors    bad_argument, naming node and field: a size below 1; a list of depths that ends inside
///           a pixel or has values left over, with a negative count, a depth below 0 or above dmax;
///           as many colours as it has not depths; depthNbBits outside 0..31; limit_exceeded
/// Warnings  zero_depth: depths that are 0, which are taken as the far plane
Result<PointTexture> read_point_texture(const nodes::NodeView& node, const Limits& limits,
                                        Diagnostics& diagnostics);

/// Adds a PointTexture to a scene, not yet standing anywhere.
nodes::NodeId add_point_texture(nodes::Scene& scene, const PointTexture& texture);

}  // namespace afx
