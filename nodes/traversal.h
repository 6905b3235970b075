// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Finds what a scene shows: DIBR nodes, shapes, lights, surroundings, each with its matrix.
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
  glm::dmat4 to_world{1};                   ///< where the scene stands, e.g. that of an Inline
};

/// One thing that a scene shows, or that says how it is shown.
struct SceneObject {
  enum class Kind : uint8_t {
    depth_images,  ///< `nodes`: the DepthImages and DepthImageV2s under one Transform, in order; a
                   ///< BitWrapper among them holds one in its field `node`
    octree_image,  ///< `nodes`: one OctreeImage, or one BitWrapper that holds it
    shape,         ///< a Shape with a geometry
    light,         ///< a DirectionalLight, PointLight or SpotLight that is on
    background,    ///< a Background or Background2D
    fog,           ///< a Fog
    viewpoint,     ///< a Viewpoint
    navigation_info,  ///< a NavigationInfo
    inline_scene      ///< an Inline
  };
  Kind kind = Kind::shape;
  glm::dmat4 to_world{1};       ///< from the local coordinates of its nodes
  std::vector<NodeView> nodes;  ///< one, except depth_images
  /// light: it falls on the objects with the numbers from lit_begin to before lit_end. A
  /// DirectionalLight lights what stands in the group that it stands in, others everything.
  size_t lit_begin = 0, lit_end = 0;
};

struct SceneObjects {
  std::vector<SceneObject> objects;  ///< in the order of the scene
  bool depends_on_viewer = false;    ///< a LOD or Billboard was met
  uint64_t visits = 0;               ///< nodes met, as max_visits counts them
};

/// What a scene shows, in its order, a shared node once for each place where it stands.
///
/// What is followed: `children` of any node, what Switch and LOD choose, the insides of PROTO
/// instances, of Layer3D also its bound nodes; Shape.geometry where it is a BitWrapper that holds a
/// DIBR node is that. Transform, Transform2D and TransformMatrix2D give matrices; Layer2D, Layout
/// and Form are groups only. DepthImages in groups inside a Transform belong to that Transform. The
/// images of an OctreeImage are its own and not handed out.
/// Errors  limit_exceeded (max_visits, max_depth)
Result<SceneObjects> find_scene_objects(const Scene& scene, const TraversalOptions& options = {});

/// One DIBR object to draw.
struct DibrObject {
  enum class Kind : uint8_t {
    depth_images,  ///< as SceneObject has them
    octree_image
  };
  Kind kind = Kind::depth_images;
  glm::dmat4 to_world{1};  ///< from the local coordinates of its nodes
  std::vector<NodeView> nodes;
};

/// The DIBR object that it is; none if it is something else.
std::optional<DibrObject> dibr_object(const SceneObject& object);

/// The DIBR nodes among what find_scene_objects finds; errors as there.
Result<std::vector<DibrObject>> find_dibr_objects(const Scene& scene,
                                                  const TraversalOptions& options = {});

/// The matrix of a Transform, as VRML97 has it: T * C * R * SR * S * SR^-1 * C^-1 with translation
/// T, center C, rotation R, scaleOrientation SR, scale S. An axis of length 0 means no rotation.
glm::dmat4 transform_matrix(const NodeView& transform);

}  // namespace afx::nodes
