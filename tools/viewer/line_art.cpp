// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/viewer/line_art.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

namespace afx::tools {
namespace {

constexpr Rgba8 kOctreeColour{255, 200, 60, 255};
constexpr Rgba8 kPiecesColour{90, 220, 140, 255};
constexpr Rgba8 kShapeColour{120, 190, 255, 255};

struct Box {
  glm::dvec3 least{INFINITY}, most{-INFINITY};
  void add(const glm::dvec3& point) {
    least = glm::min(least, point);
    most = glm::max(most, point);
  }
};

void add_box(const Box& box, const glm::dmat4& to_world, Rgba8 colour, std::vector<Line>& lines) {
  if (!(box.least.x <= box.most.x)) return;
  glm::dvec3 corners[8];
  for (unsigned k = 0; k < 8; ++k) {
    const glm::dvec3 corner(k & 1U ? box.most.x : box.least.x, k & 2U ? box.most.y : box.least.y,
                            k & 4U ? box.most.z : box.least.z);
    corners[k] = glm::dvec3(to_world * glm::dvec4(corner, 1));
  }
  for (unsigned k = 0; k < 8; ++k)
    for (unsigned side : {1U, 2U, 4U})
      if ((k & side) == 0) lines.push_back({corners[k], corners[k | side], colour});
}

/// A point in the camera's system and what the screen makes of it.
struct Projector {
  const render::Camera& camera;
  glm::dvec2 size;
  glm::dquat to_view = glm::conjugate(camera.orientation);
  bool perspective = camera.projection == render::Projection::perspective;
  double focal =
      size.y / 2 / (perspective ? std::tan(camera.field_of_view / 2) : camera.view_height / 2);
  // Cameras may stand nearer than the scene begins.
  double nearest = camera.near_plane * 1e-3;

  [[nodiscard]] glm::dvec3 to_camera(const glm::dvec3& point) const {
    return to_view * (point - camera.position);
  }
  /// Pixels from the middle of the picture, right and up.
  [[nodiscard]] glm::dvec2 place(const glm::dvec3& p) const {
    return glm::dvec2(p.x, p.y) * (perspective ? focal / -p.z : focal);
  }
  [[nodiscard]] float depth(const glm::dvec3& p) const {
    return static_cast<float>(perspective ? 1 / -p.z : -p.z);
  }
  /// Cuts off what is behind; false: nothing is left.
  [[nodiscard]] bool clip(glm::dvec3& a, glm::dvec3& b) const {
    if (-a.z < nearest && -b.z < nearest) return false;
    const double part = (-nearest - a.z) / (b.z - a.z);
    if (-a.z < nearest) {
      a += (b - a) * part;
    } else if (-b.z < nearest) {
      b = a + (b - a) * part;
    }
    return true;
  }
};

void add_strip(const Projector& projector, const Line& line, double reach,
               std::vector<LineVertex>& out) {
  glm::dvec3 ends[2] = {projector.to_camera(line.a), projector.to_camera(line.b)};
  if (!projector.clip(ends[0], ends[1])) return;
  const glm::dvec2 at[2] = {projector.place(ends[0]), projector.place(ends[1])};
  const double length = glm::length(at[1] - at[0]);
  if (!(length > 1e-6)) return;
  const glm::dvec2 along = (at[1] - at[0]) / length;
  const glm::dvec2 aside = glm::dvec2(-along.y, along.x) * reach;
  LineVertex corners[4];
  for (int k = 0; k < 4; ++k) {
    const int end = k / 2;
    const double sign = k % 2 == 0 ? -1 : 1;
    // Half a pixel longer, so that corners of boxes are closed.
    const glm::dvec2 place = at[end] + along * (end == 0 ? -0.5 : 0.5) + aside * sign;
    const glm::vec2 screen(place * 2.0 / projector.size);
    corners[k] = {screen.x, screen.y, projector.depth(ends[end]), static_cast<float>(sign * reach),
                  line.colour};
  }
  for (const int k : {0, 1, 2, 2, 1, 3}) out.push_back(corners[k]);
}

}  // namespace

void add_boxes(const render::Scene& scene, std::vector<Line>& lines) {
  size_t left = kMostBoxes;
  for (const render::VoxelCloud& cloud : scene.voxels) {
    if (left-- == 0) return;
    add_box({glm::dvec3(-0.5), glm::dvec3(0.5)}, cloud.local_to_world, kOctreeColour, lines);
  }
  for (size_t i = 0; i < scene.surfels.size();) {
    if (left-- == 0) return;
    // The DepthImages of one object follow each other.
    const glm::dmat4& place = scene.surfels[i].local_to_world;
    Box box;
    for (; i < scene.surfels.size() && scene.surfels[i].local_to_world == place; ++i)
      for (const glm::dvec3& centre : scene.surfels[i].surfels->centres) box.add(centre);
    add_box(box, place, kPiecesColour, lines);
  }
  for (const Shape& shape : scene.shapes) {
    if (left-- == 0) return;
    Box box;
    for (const glm::vec3& position : shape.geometry->positions) box.add(position);
    add_box(box, shape.to_world, kShapeColour, lines);
  }
}

void add_frustum(const ReferenceCamera& camera, double length, Rgba8 colour,
                 std::vector<Line>& lines) {
  const glm::dvec2 far = camera.half_view * (camera.orthographic ? 1 : length);
  const glm::dvec2 half = far * std::min(1.0, length / 2 / std::max({far.x, far.y, 1e-12}));
  const glm::dvec3 x = camera.right * half.x;
  const glm::dvec3 y = camera.up * half.y;
  const glm::dvec3 base = camera.position + camera.ahead * length;
  constexpr double kSigns[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  glm::dvec3 near_corners[4], far_corners[4];
  for (int k = 0; k < 4; ++k) {
    const glm::dvec3 off = x * kSigns[k][0] + y * kSigns[k][1];
    near_corners[k] = camera.position + (camera.orthographic ? off : glm::dvec3(0));
    far_corners[k] = base + off;
  }
  for (int k = 0; k < 4; ++k) {
    lines.push_back({near_corners[k], far_corners[k], colour});
    lines.push_back({far_corners[k], far_corners[(k + 1) % 4], colour});
    if (camera.orthographic) lines.push_back({near_corners[k], near_corners[(k + 1) % 4], colour});
  }
  const glm::dvec3 roof = base + y * 1.5;
  lines.push_back({base + y - x * 0.5, roof, colour});
  lines.push_back({roof, base + y + x * 0.5, colour});
}

std::vector<LineVertex> line_triangles(std::span<const Line> lines, const render::Camera& camera,
                                       const glm::dvec2& size, double width) {
  const Projector projector{camera, size};
  std::vector<LineVertex> out;
  out.reserve(lines.size() * 6);
  for (const Line& line : lines) add_strip(projector, line, width / 2 + 1, out);
  return out;
}

}  // namespace afx::tools
