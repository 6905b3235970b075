// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// From DepthImage nodes to DepthImages, and back.
#pragma once

#include <string>

#include "afx/depth_image.h"
#include "afx/scene_files.h"
#include "codec/diagnostics.h"
#include "codec/error.h"
#include "codec/limits.h"
#include "nodes/node_view.h"
#include "nodes/scene.h"

namespace afx {

/// Reads a DepthImage (or DepthImageV2, whose further fields are hints for splats) with its
/// pictures or points.
///
/// node      a DepthImage; a BitWrapper around one is unsupported: no coding of DepthImages is
///           known here
/// base      where the urls of pictures lead
/// Errors    bad_argument, naming node and field: camera (check_depth_camera); diTexture NULL; a
///           SimpleTexture without texture, with neither a depth field nor an alpha channel, with
///           texture and depth of different sizes, with a depth of more than two components; a
///           PointTexture whose list of depths ends inside a pixel or has values left over, with a
///           negative count, a depth below 0 or above dmax, or as many colours as it has not
///           depths; depthNbBits outside 0..31; unsupported: other textures, e.g. MovieTexture;
///           those of reading pictures; limit_exceeded
/// Warnings  zero_depth: depths of a PointTexture that are 0, which are taken as the far plane
Result<DepthImage> read_depth_image(const nodes::NodeView& node, const UrlBase& base,
                                    const Limits& limits, Diagnostics& diagnostics);

/// The camera fields alone.
/// Errors  as check_depth_camera, naming node and field
Result<DepthCamera> read_depth_camera(const nodes::NodeView& node);

/// The names of the pictures of a SimpleTexture in a scene.
struct PictureUrls {
  std::string colour;
  std::string depth;  ///< empty: the depth is the alpha channel of the colour picture
};

/// Adds a DepthImage with a SimpleTexture of two ImageTextures to a scene, not yet standing
/// anywhere.
nodes::NodeId add_depth_image(nodes::Scene& scene, const DepthCamera& camera,
                              const PictureUrls& pictures);

/// The same with a PointTexture.
nodes::NodeId add_depth_image(nodes::Scene& scene, const DepthCamera& camera,
                              const PointTexture& texture);

/// A SimpleTexture as one picture, the depth in its alpha channel: 8 bits where the depth has no
/// more, else 16, of which colours and depths fill all. Opacity is left out.
DeepPicture with_depth_as_alpha(const SimpleTexture& texture);

}  // namespace afx
