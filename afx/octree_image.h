// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// From OctreeImage nodes to plain models, and back.
// Source: ISO/IEC 14496-16, OctreeImage and BitWrapper (clauses not checked); the paper, section
// IV.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "afx/octree_model.h"
#include "afx/scene_files.h"
#include "codec/diagnostics.h"
#include "codec/error.h"
#include "codec/limits.h"
#include "nodes/node_view.h"
#include "nodes/scene.h"

namespace afx {

/// The OctreeImages of a scene, each once, in the order in which they are declared: those that
/// stand in it, shown or not, and those that PROTO instances show. One that a BitWrapper holds is
/// given as that.
std::vector<nodes::NodeView> find_octree_images(const nodes::Scene& scene);

/// The fields of an OctreeImage as a stream carries them.
struct OctreeNode {
  uint32_t resolution = 1;  ///< octreeResolution
  uint32_t images = 0;      ///< number of nodes in `images`
  OctreeFields fields;
};

/// Reads the fields of an OctreeImage, or of a BitWrapper that holds one: then from its stream.
///
/// base      where the url of a BitWrapper leads
/// Errors    bad_argument: octreeResolution < 1, a value outside 0..255 (the text names node, field
/// and
///           position), a BitWrapper without an OctreeImage or with both or neither of url and
///           buffer, more numOfTextures than images; unsupported: another `type` of BitWrapper, an
///           url that is neither a file nor an OctreeImage stream; io and whatever
///           decode_octree_stream says of the stream
/// Warnings  bitwrapper_fields: the node has fields that the stream replaces; frames_left_out: the
///           stream has more than one frame or sample; those of the stream, with its path
Result<OctreeNode> read_octree_node(const nodes::NodeView& node, const UrlBase& base,
                                    const Limits& limits, Diagnostics& diagnostics);

/// Reads an OctreeImage with its reference images; pictures are loaded from files and streams as
/// `base` has them. Errors    as read_octree_node; bad_argument: more than 255 images;
/// limit_exceeded: pictures beyond limits Warnings  missing_picture: an image has no picture that
/// could be loaded (it is left empty);
///           perspective_image: orthographic FALSE, fieldOfView is read as lengths
Result<OctreeModel> read_octree_model(const nodes::NodeView& node, const UrlBase& base,
                                      const Limits& limits, Diagnostics& diagnostics);

/// A reference image as it is written into a scene.
struct ReferenceImageNode {
  ReferenceImage image;     ///< camera; its picture is not written
  std::string picture_url;  ///< ImageTexture.url; empty: a DepthImage without texture
  float near_plane = 0.5F;  ///< of the camera, scene units
  float far_plane = 1.5F;
};

/// Adds an OctreeImage with those fields to a scene, and a DepthImage for each image. The node is
/// not yet anywhere in the scene.
nodes::NodeId add_octree_image(nodes::Scene& scene, uint32_t resolution, const OctreeFields& fields,
                               std::span<const ReferenceImageNode> images);

/// The same with `images` DepthImages that have nothing but defaults: what a decoded stream knows
/// of them.
nodes::NodeId add_octree_image(nodes::Scene& scene, const OctreeNode& octree);

}  // namespace afx
