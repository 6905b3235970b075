// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <tuple>

#include "afx/shapes/face_mesh.h"

namespace afx {
namespace {

/// A side of a face, with the corners at its ends. Sides of the same points stand together in
/// order.
struct Edge {
  uint32_t low = 0, high = 0;  // points
  uint32_t face = 0;
  uint32_t low_corner = 0, high_corner = 0;
};

std::vector<Edge> edges_of(const FaceMesh& mesh) {
  std::vector<Edge> edges;
  edges.reserve(mesh.corners.size());
  for (uint32_t face = 0; face < mesh.faces(); ++face) {
    const uint32_t begin = mesh.starts[face], end = mesh.starts[face + 1];
    for (uint32_t c = begin; c < end; ++c) {
      const uint32_t d = c + 1 < end ? c + 1 : begin;
      const uint32_t a = mesh.corners[c], b = mesh.corners[d];
      edges.push_back(a < b ? Edge{a, b, face, c, d} : Edge{b, a, face, d, c});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return std::tie(a.low, a.high, a.face, a.low_corner) <
           std::tie(b.low, b.high, b.face, b.low_corner);
  });
  return edges;
}

/// Sets of corners that are joined step by step.
class CornerSets {
 public:
  explicit CornerSets(size_t corners) : parent_(corners) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }
  uint32_t root(uint32_t corner) {
    while (parent_[corner] != corner) {
      parent_[corner] = parent_[parent_[corner]];
      corner = parent_[corner];
    }
    return corner;
  }
  void join(uint32_t a, uint32_t b) {
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<uint32_t> parent_;
};

CornerSets smooth_sets(const FaceMesh& mesh, const std::vector<glm::dvec3>& face_normals) {
  CornerSets sets(mesh.corners.size());
  const double least = std::cos(std::min(static_cast<double>(mesh.crease_angle), 3.1415926));
  const std::vector<Edge> edges = edges_of(mesh);
  for (size_t i = 1; i < edges.size(); ++i) {
    const Edge &a = edges[i - 1], &b = edges[i];
    if (a.low != b.low || a.high != b.high || a.face == b.face) continue;
    if (!(glm::dot(face_normals[a.face], face_normals[b.face]) > least)) continue;
    sets.join(a.low_corner, b.low_corner);
    sets.join(a.high_corner, b.high_corner);
  }
  return sets;
}

/// The angle of a face at its corner `c`.
double corner_angle(const FaceMesh& mesh, uint32_t face, uint32_t c) {
  const uint32_t begin = mesh.starts[face], end = mesh.starts[face + 1];
  const auto point = [&](uint32_t corner) { return glm::dvec3(mesh.points[mesh.corners[corner]]); };
  const glm::dvec3 at = point(c), to_next = point(c + 1 < end ? c + 1 : begin) - at,
                   to_last = point(c > begin ? c - 1 : end - 1) - at;
  const double lengths = glm::length(to_next) * glm::length(to_last);
  if (!(lengths > 0)) return 0;
  return std::acos(std::clamp(glm::dot(to_next, to_last) / lengths, -1.0, 1.0));
}

}  // namespace

std::vector<glm::vec3> crease_normals(const FaceMesh& mesh,
                                      const std::vector<glm::dvec3>& face_normals) {
  std::vector<glm::vec3> normals(mesh.corners.size());
  const bool flat = !(mesh.crease_angle > 0);
  CornerSets sets = flat ? CornerSets(0) : smooth_sets(mesh, face_normals);
  std::vector<glm::dvec3> sums(flat ? 0 : mesh.corners.size());
  for (uint32_t face = 0; face < mesh.faces(); ++face)
    for (uint32_t c = mesh.starts[face]; c < mesh.starts[face + 1]; ++c) {
      if (flat) normals[c] = glm::vec3(face_normals[face]);
      if (!flat) sums[sets.root(c)] += face_normals[face] * corner_angle(mesh, face, c);
    }
  if (flat) return normals;
  for (uint32_t face = 0; face < mesh.faces(); ++face)
    for (uint32_t c = mesh.starts[face]; c < mesh.starts[face + 1]; ++c) {
      const glm::dvec3 sum = sums[sets.root(c)];
      const double length = glm::length(sum);
      normals[c] = glm::vec3(length > 0 ? sum / length : face_normals[face]);
    }
  return normals;
}

}  // namespace afx
