// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Lines in the world that the viewer lays over its picture: boxes around models, small pyramids for
// the cameras of their pictures.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "afx/picture.h"
#include "render/camera.h"
#include "render/scene.h"
#include "tools/viewer/viewer_model.h"

namespace afx::tools {

struct Line {
  glm::dvec3 a{0}, b{0};  ///< in the world
  Rgba8 colour;
};

/// Adds a box for each object of the scene: an octree's cube, otherwise the box around it in its
/// own coordinates. Clouds of surfels at the same place in a row are one object. After kMostBoxes
/// no more are added.
inline constexpr size_t kMostBoxes = 4096;
void add_boxes(const render::Scene& scene, std::vector<Line>& lines);

/// Adds the frustum of a camera, `length` scene units long, a roof on its upper edge. A wide one is
/// made narrower as a whole, so that it is not larger than its length.
void add_frustum(const ReferenceCamera& camera, double length, Rgba8 colour,
                 std::vector<Line>& lines);

/// A corner of a triangle on the screen.
struct LineVertex {
  float x, y;    ///< -1..1, right and up
  float depth;   ///< perspective: 1 / distance from the camera's plane; parallel: the distance
  float across;  ///< pixels from the middle of the line
  Rgba8 colour;
};

/// The lines as strips `width` pixels wide and one more on either side, for a soft edge: two
/// triangles each. What is behind the camera is cut off.
[[nodiscard]] std::vector<LineVertex> line_triangles(std::span<const Line> lines,
                                                     const render::Camera& camera,
                                                     const glm::dvec2& size, double width);

}  // namespace afx::tools
