// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/shapes/face_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "afx/shapes/ear_clipping.h"

namespace afx {
namespace {

constexpr uint64_t kClippingWork = uint64_t{1} << 30;  // some seconds
constexpr uint32_t kNone = 0xFFFFFFFF;

/// Sum over the sides; its length is twice the area, its direction the side that the corners run
/// counter-clockwise around.
glm::dvec3 area_vector(const FaceMesh& mesh, size_t face) {
  glm::dvec3 sum(0);
  const uint32_t begin = mesh.starts[face], end = mesh.starts[face + 1];
  if (end - begin < 3) return sum;
  const glm::dvec3 first(mesh.points[mesh.corners[begin]]);
  for (uint32_t c = begin + 1; c + 1 < end; ++c)
    sum += glm::cross(glm::dvec3(mesh.points[mesh.corners[c]]) - first,
                      glm::dvec3(mesh.points[mesh.corners[c + 1]]) - first);
  return sum;
}

/// The two axes to look at a face along its largest, so that its corners run counter-clockwise.
std::array<int, 2> plane_axes(const glm::dvec3& area) {
  const glm::dvec3 size = glm::abs(area);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  return area[axis] > 0 ? std::array{u, v} : std::array{v, u};
}

/// VRML97: the longest side of the bounding box is s from 0 to 1, the next longest t in the same
/// scale; of equal sides x goes before y before z.
class BoxMapping {
 public:
  explicit BoxMapping(const FaceMesh& mesh) {
    if (mesh.corners.empty()) return;
    low_ = glm::dvec3(mesh.points[mesh.corners.front()]);
    glm::dvec3 high = low_;
    for (const uint32_t point : mesh.corners) {
      low_ = glm::min(low_, glm::dvec3(mesh.points[point]));
      high = glm::max(high, glm::dvec3(mesh.points[point]));
    }
    const glm::dvec3 size = high - low_;
    for (const int axis : {1, 2})
      if (size[axis] > size[s_]) s_ = axis;
    t_ = s_ == 0 ? 1 : 0;
    for (const int axis : {1, 2})
      if (axis != s_ && size[axis] > size[t_]) t_ = axis;
    if (size[s_] > 0) length_ = size[s_];
  }

  [[nodiscard]] glm::vec2 operator()(const glm::vec3& point) const {
    const glm::dvec3 from_low = (glm::dvec3(point) - low_) / length_;
    return {static_cast<float>(from_low[s_]), static_cast<float>(from_low[t_])};
  }

 private:
  glm::dvec3 low_{0};
  int s_ = 0, t_ = 1;
  double length_ = 1;
};

class TriangleMaker {
 public:
  explicit TriangleMaker(const FaceMesh& mesh)
      : mesh_(mesh),
        face_normals_(face_normals(mesh)),
        mapping_(mesh),
        last_(mesh.points.size(), kNone) {
    if (mesh.normals.empty()) made_normals_ = crease_normals(mesh, face_normals_);
  }

  Result<Geometry> run() {
    out_.solid = mesh_.solid;
    for (size_t face = 0; face < mesh_.faces(); ++face) {
      if (face_normals_[face] == glm::dvec3(0)) continue;
      if (!add_face(face))
        return Error{Errc::limit_exceeded, Place::none(),
                     "has concave faces with too many corners to cut them into triangles"};
    }
    return std::move(out_);
  }

 private:
  bool add_face(size_t face) {
    const uint32_t begin = mesh_.starts[face], count = mesh_.starts[face + 1] - begin;
    if (mesh_.convex || count == 3) {
      for (uint32_t i = 1; i + 1 < count; ++i) add_triangle(face, begin, begin + i, begin + i + 1);
      return true;
    }
    const auto axes = plane_axes(area_vector(mesh_, face));
    std::vector<glm::dvec2> corners;
    for (uint32_t c = begin; c < begin + count; ++c) {
      const glm::vec3& p = mesh_.points[mesh_.corners[c]];
      corners.emplace_back(p[axes[0]], p[axes[1]]);
    }
    const auto triangles = clip_ears(corners, work_);
    for (const auto& t : triangles) add_triangle(face, begin + t[0], begin + t[1], begin + t[2]);
    return !triangles.empty();
  }

  void add_triangle(size_t face, uint32_t a, uint32_t b, uint32_t c) {
    if (!mesh_.ccw) std::swap(b, c);
    for (const uint32_t corner : {a, b, c}) out_.indices.push_back(vertex(face, corner));
  }

  uint32_t vertex(size_t face, uint32_t corner) {
    const uint32_t point = mesh_.corners[corner];
    const glm::vec3 normal = normal_of(face, corner);
    const glm::vec2 texture = mesh_.texture_coordinates.empty() ? mapping_(mesh_.points[point])
                                                                : mesh_.texture_coordinates[corner];
    const glm::vec3 colour = mesh_.colours.empty() ? glm::vec3(0) : mesh_.colours[corner];
    // A point that very many different corners share is not searched to the end.
    uint32_t known = last_[point];
    for (int tries = 0; tries < 16 && known != kNone; ++tries, known = previous_[known])
      if (out_.normals[known] == normal && out_.texture_coordinates[known] == texture &&
          (mesh_.colours.empty() || out_.colours[known] == colour))
        return known;
    previous_.push_back(last_[point]);
    last_[point] = static_cast<uint32_t>(out_.positions.size());
    out_.positions.push_back(mesh_.points[point]);
    out_.normals.push_back(normal);
    out_.texture_coordinates.push_back(texture);
    if (!mesh_.colours.empty()) out_.colours.push_back(colour);
    return last_[point];
  }

  [[nodiscard]] glm::vec3 normal_of(size_t face, uint32_t corner) const {
    const glm::dvec3 normal(mesh_.normals.empty() ? made_normals_[corner] : mesh_.normals[corner]);
    const double length = glm::length(normal);
    return glm::vec3(length > 0 ? normal / length : face_normals_[face]);
  }

  const FaceMesh& mesh_;
  std::vector<glm::dvec3> face_normals_;
  BoxMapping mapping_;
  std::vector<glm::vec3> made_normals_;
  std::vector<uint32_t> last_;      // of each point: the vertex that was made last there
  std::vector<uint32_t> previous_;  // of each vertex: the one before at the same point
  uint64_t work_ = kClippingWork;
  Geometry out_;
};

}  // namespace

std::vector<glm::dvec3> face_normals(const FaceMesh& mesh) {
  std::vector<glm::dvec3> normals(mesh.faces());
  for (size_t face = 0; face < mesh.faces(); ++face) {
    const glm::dvec3 area = area_vector(mesh, face);
    const double length = glm::length(area);
    if (length > 0) normals[face] = area / (mesh.ccw ? length : -length);
  }
  return normals;
}

Result<Geometry> geometry_of(const FaceMesh& mesh) { return TriangleMaker(mesh).run(); }

}  // namespace afx
