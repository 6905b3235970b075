// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/surface_colour.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace afx {
namespace {

// A corner of a piece cut out of a triangle: where it is, and the weights of the triangle's
// corners.
struct CutCorner {
  glm::dvec3 place;
  double b, c;
};

// A triangle cut by six planes has at most nine corners.
struct Cut {
  std::array<CutCorner, 10> corners;
  size_t count = 0;
  void push(const CutCorner& corner) {
    if (count < corners.size()) corners[count++] = corner;
  }
};

CutCorner between(const CutCorner& p, const CutCorner& q, double t) {
  return {p.place + (q.place - p.place) * t, p.b + (q.b - p.b) * t, p.c + (q.c - p.c) * t};
}

// Keeps the part where sign * (coordinate - border) <= 0. Source: Sutherland and Hodgman, 1974.
void cut_by_plane(Cut& cut, int axis, double border, double sign) {
  const auto height = [&](const CutCorner& corner) { return sign * (corner.place[axis] - border); };
  bool outside = false;
  for (size_t i = 0; i < cut.count; ++i) outside = outside || height(cut.corners[i]) > 0;
  if (!outside) return;
  Cut kept;
  for (size_t i = 0; i < cut.count; ++i) {
    const CutCorner& here = cut.corners[i];
    const CutCorner& next = cut.corners[i + 1 < cut.count ? i + 1 : 0];
    const double h = height(here), n = height(next);
    if (h <= 0) kept.push(here);
    if ((h < 0 && n > 0) || (h > 0 && n < 0)) kept.push(between(here, next, h / (h - n)));
  }
  cut = kept;
}

Cut cut_by_box(const std::array<glm::dvec3, 3>& corners, const glm::ivec3& low, double margin) {
  Cut cut;
  cut.push({corners[0], 0, 0});
  cut.push({corners[1], 1, 0});
  cut.push({corners[2], 0, 1});
  for (int axis = 0; axis < 3; ++axis) {
    cut_by_plane(cut, axis, low[axis] - margin, -1);
    cut_by_plane(cut, axis, low[axis] + 1 + margin, 1);
  }
  return cut;
}

}  // namespace

void SurfaceSum::add(const Paint& paint, const glm::dvec3& direction, double of_area,
                     double alpha_cutoff) {
  const double seen = of_area * paint.alpha;
  light += paint.light * of_area;
  normal += direction * seen;
  weight += seen;
  area += of_area;
  surplus += of_area * (paint.alpha - alpha_cutoff);
}

SurfaceColour::SurfaceColour(const Mesh& mesh, const Grid& grid)
    : mesh_(mesh), grid_(grid), paint_(mesh) {}

SurfaceColour::Piece SurfaceColour::piece(size_t triangle) const {
  const glm::uvec3 v = mesh_.triangles[triangle];
  Piece piece{};
  piece.triangle = triangle;
  piece.alpha_cutoff = static_cast<double>(paint_.material(triangle).alpha_cutoff);
  for (int k = 0; k < 3; ++k)
    piece.corners[static_cast<size_t>(k)] = grid_.to_voxels(glm::dvec3(mesh_.positions[v[k]]));
  const glm::dvec3 across =
      glm::cross(piece.corners[1] - piece.corners[0], piece.corners[2] - piece.corners[0]);
  const double doubled = glm::length(across);
  if (!(doubled > 0)) return piece;
  piece.normal = across / doubled;
  piece.texels = paint_.texels(triangle) / (0.5 * doubled);
  return piece;
}

// Divides a part of the triangle into 1, 4 or 16 equal ones and takes the colour at their middles,
// each the mean over as many texels as it covers.
Paint SurfaceColour::mean_paint(const Piece& piece, const std::array<Weights, 3>& corners,
                                double area) const {
  Paint mean{{0, 0, 0}, 0};
  const double texels = area * piece.texels;
  const int parts = texels <= 1 ? 1 : (texels <= 16 ? 2 : 4);
  const double share = 1.0 / (parts * parts);
  const Weights &p = corners[0], &q = corners[1], &r = corners[2];
  const auto add_at = [&](double s, double t) {
    const Weights at{p.b + (q.b - p.b) * s + (r.b - p.b) * t,
                     p.c + (q.c - p.c) * s + (r.c - p.c) * t};
    const Paint paint = paint_.at(piece.triangle, at, texels * share);
    mean.light += paint.light * share;
    mean.alpha += paint.alpha * share;
  };
  for (int i = 0; i < parts; ++i) {
    for (int j = 0; i + j < parts; ++j) {
      add_at((i + 1.0 / 3) / parts, (j + 1.0 / 3) / parts);
      if (i + j + 1 < parts) add_at((i + 2.0 / 3) / parts, (j + 2.0 / 3) / parts);
    }
  }
  return mean;
}

void SurfaceColour::add(const Piece& piece, const glm::ivec3& low, double margin,
                        SurfaceSum& sum) const {
  sum.has_opaque = sum.has_opaque || !(piece.alpha_cutoff > 0);
  const Cut cut = cut_by_box(piece.corners, low, margin);
  const CutCorner& first = cut.corners[0];
  for (size_t i = 2; i < cut.count; ++i) {
    const CutCorner &before = cut.corners[i - 1], &here = cut.corners[i];
    const glm::dvec3 across = glm::cross(before.place - first.place, here.place - first.place);
    const double area = 0.5 * glm::length(across);
    if (!(area > 0)) continue;
    const Paint paint = mean_paint(
        piece, {Weights{first.b, first.c}, Weights{before.b, before.c}, Weights{here.b, here.c}},
        area);
    sum.add(paint, piece.normal, area, piece.alpha_cutoff);
  }
}

void SurfaceColour::add_touch(const Piece& piece, double area, SurfaceSum& sum) const {
  sum.add(paint_.at(piece.triangle, {1.0 / 3, 1.0 / 3}, 1), piece.normal, area, piece.alpha_cutoff);
}

}  // namespace afx
