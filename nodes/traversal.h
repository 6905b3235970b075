// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Finds what is to be drawn: each DIBR node of a scene with its matrix.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "codec/error.h"
#include "nodes/node_view.h"
#include "nodes/scene.h"

namespace afx::nodes {

/// Where the viewer is, in world coordinates.
struct Viewer {
  glm::dvec3 position{0, 0, 10};
  glm::dvec3 up{0, 1, 0};
};

struct TraversalOptions {
  std::optional<Viewer> viewer;  ///< LOD and Billboard need it: without, LOD shows its first level
                                 ///< and Billboard does not turn
  uint64_t max_visits = uint64_t{1} << 20;  ///< nodes met, a shared one each time
  uint32_t max_depth = 512;                 ///< nesting of grouping nodes
};

/// One thing to draw.
struct DibrObject {
  enum class Kind : uint8_t {
    depth_images,  ///< `nodes`: the DepthImages and DepthImageV2s under one Transform, in order; a
                   ///< BitWrapper among them holds one in its field `node`
    octree_image   ///< `nodes`: one OctreeImage, or one BitWrapper that holds it
  };
  Kind kind = Kind::depth_images;
  glm::dmat4 to_world{1};  ///< from the local coordinates of its nodes
  std::vector<NodeView> nodes;
};

/// The DIBR nodes of a scene, in the order of the scene (a group of DepthImages stands where its
/// first does), a shared node once for each place where it stands.
///
/// What is followed: `children` of any node, what Switch and LOD choose, Shape.geometry where it is
/// a BitWrapper, the insides of PROTO instances. Transform, Transform2D and TransformMatrix2D give
/// matrices; Layer2D, Layout and Form are groups only. DepthImages in groups inside a Transform
/// belong to that Transform. The images of an OctreeImage are its own and not handed out. Errors:
/// limit_exceeded (max_visits, max_depth).
Result<std::vector<DibrObject>> find_dibr_objects(const Scene& scene,
                                                  const TraversalOptions& options = {});

/// The matrix of a Transform, as VRML97 has it: T * C * R * SR * S * SR^-1 * C^-1 with translation
/// T, center C, rotation R, scaleOrientation SR, scale S. An axis of length 0 means no rotation.
glm::dmat4 transform_matrix(const NodeView& transform);

}  // namespace afx::nodes
