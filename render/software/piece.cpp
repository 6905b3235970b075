// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/software/piece.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace afx::render {
namespace {

using Triangle = std::array<glm::dvec3, 3>;

bool is_finite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Of a plane that has been found by directions (x, y) on the plane at distance 1.
Plane in_samples(const glm::dvec3& p, const Lens& lens) {
  const double x = p.x / lens.focal, y = -p.y / lens.focal;
  return {x, y, p.z - x * lens.middle.x - y * lens.middle.y};
}

/// Where the way from a to b, on different sides of the near plane, meets it.
glm::dvec3 on_near_plane(const glm::dvec3& a, const glm::dvec3& b, double near_plane) {
  const double part = (-near_plane - a.z) / (b.z - a.z);
  return {a.x + part * (b.x - a.x), a.y + part * (b.y - a.y), -near_plane};
}

/// A rectangle around places on the screen, in double.
class Bounds {
 public:
  void add(const glm::dvec2& at) {
    low_ = glm::min(low_, at);
    high_ = glm::max(high_, at);
  }
  /// With a margin; kNoBox if it lies outside of the picture or somewhere is no number.
  [[nodiscard]] Box box(double margin, const Lens& lens) const {
    const glm::dvec2 low = low_ - margin, high = high_ + margin;
    if (!(low.x <= 2 * lens.middle.x && low.y <= 2 * lens.middle.y && high.x >= 0 && high.y >= 0))
      return kNoBox;
    const auto number = [](double v) { return static_cast<float>(std::clamp(v, -1e9, 1e9)); };
    return {number(low.x), number(low.y), number(high.x), number(high.y)};
  }

 private:
  glm::dvec2 low_{std::numeric_limits<double>::infinity()};
  glm::dvec2 high_{-std::numeric_limits<double>::infinity()};
};

constexpr double kMargin = 0.1;  // of boxes, for rounding
constexpr double kGrid = 256;    // steps of a sample, for corners on the screen
/// Up to here, in samples, products of places on that grid are whole numbers that a double holds.
constexpr double kMostPlace = 1 << 18;

bool is_on_grid(const glm::dvec3& v, const Lens& lens, glm::dvec2& place) {
  if (!(-v.z >= lens.near_plane)) return false;
  place = glm::round(lens.place(v) * kGrid) / kGrid;
  return std::abs(place.x) <= kMostPlace && std::abs(place.y) <= kMostPlace;
}

/// Grows to the left of the way from a to b, as one sees it on the screen.
Plane beside(const glm::dvec2& a, const glm::dvec2& b) {
  return {b.y - a.y, a.x - b.x, b.x * a.y - a.x * b.y};
}

Box box_of(const Triangle& v, const Lens& lens) {
  Bounds bounds;
  for (size_t k = 0; k < 3; ++k) {
    const glm::dvec3 &a = v[k], &b = v[(k + 1) % 3];
    const bool a_seen = -a.z >= lens.near_plane, b_seen = -b.z >= lens.near_plane;
    if (a_seen) bounds.add(lens.place(a));
    if (a_seen != b_seen) bounds.add(lens.place(on_near_plane(a, b, lens.near_plane)));
  }
  return bounds.box(kMargin, lens);
}

/// The depths of the plane of a triangle.
Plane depth_plane(const Triangle& v, const Lens& lens) {
  const glm::dvec3 normal = glm::cross(v[1] - v[0], v[2] - v[0]);
  const double offset = glm::dot(normal, v[0]);
  if (lens.perspective) return in_samples(glm::dvec3(normal.x, normal.y, -normal.z) / offset, lens);
  return in_samples(glm::dvec3(normal.x, normal.y, -offset) / normal.z, lens);
}

bool set_depths(Piece& piece, double least, double most, const Lens& lens) {
  if (!(most >= lens.near_plane) || !std::isfinite(most)) return false;
  const auto number = [](double v) {
    return static_cast<float>(std::min(v, double{std::numeric_limits<float>::max()}));
  };
  piece.inverse = lens.perspective;
  piece.cut = least >= lens.near_plane ? 0 : number(lens.near_plane);
  piece.least = least >= lens.near_plane ? number(least) : 0;
  piece.most = number(most);
  return true;
}

/// A point p of the triangle is the sum of its corners v times some parts, so on the screen, where
/// only the ratios of p count, part k goes with the product of p, v[k + 1] and v[k + 2].
bool make_triangle(const ShapeView& view, uint32_t primitive, const Lens& lens, Piece& piece) {
  Triangle v, h;
  for (uint32_t k = 0; k < 3; ++k) {
    v[k] = view.corners[view.corner(primitive, k)];
    h[k] = {v[k].x, v[k].y, lens.perspective ? -v[k].z : 1};
  }
  if (!set_depths(piece, -std::max({v[0].z, v[1].z, v[2].z}), -std::min({v[0].z, v[1].z, v[2].z}),
                  lens))
    return false;
  const double volume = glm::dot(h[0], glm::cross(h[1], h[2]));
  if (!std::isfinite(volume) || volume == 0) return false;
  piece.back = (volume < 0) != view.mirrored;
  if (piece.back && view.geometry->solid) return false;
  piece.box = box_of(v, lens);
  if (!(piece.box.x0 <= piece.box.x1)) return false;
  piece.depth = depth_plane(v, lens);
  bool finite = is_finite(piece.depth);
  std::array<glm::dvec2, 3> places;
  std::array<bool, 3> on_grid{};
  for (size_t k = 0; k < 3; ++k) on_grid[k] = is_on_grid(v[k], lens, places[k]);
  piece.edge_count = 3;
  for (size_t k = 0; k < 3; ++k) {
    const size_t a = (k + 1) % 3, b = (k + 2) % 3;
    const glm::dvec3 across = glm::cross(h[a], h[b]);
    piece.parts[k] = in_samples(volume < 0 ? -across : across, lens);
    piece.edges[k] = piece.parts[k];
    if (on_grid[a] && on_grid[b])
      piece.edges[k] = volume < 0 ? beside(places[b], places[a]) : beside(places[a], places[b]);
    finite = finite && is_finite(piece.parts[k]);
  }
  return finite;
}

/// Fills edges 0 and 1 so that values are distances from the sides of a band along a line.
void make_band(const glm::dvec2& from, const glm::dvec2& along, double half, Piece& piece) {
  const Plane across(-along.y, along.x, along.y * from.x - along.x * from.y);
  piece.edges[0] = across + Plane(0, 0, half);
  piece.edges[1] = Plane(0, 0, half) - across;
}

bool make_line(const ShapeView& view, uint32_t primitive, const Lens& lens, double half,
               Piece& piece) {
  std::array<glm::dvec3, 2> v{view.corners[view.corner(primitive, 0)],
                              view.corners[view.corner(primitive, 1)]};
  if (!(-std::min(v[0].z, v[1].z) >= lens.near_plane)) return false;
  piece.ends = {0, 1};
  for (size_t k = 0; k < 2; ++k) {
    if (-v[k].z >= lens.near_plane) continue;
    const double part = (-lens.near_plane - v[k].z) / (v[1 - k].z - v[k].z);
    piece.ends[static_cast<int>(k)] = k == 0 ? part : 1 - part;
    v[k] = on_near_plane(v[k], v[1 - k], lens.near_plane);
  }
  const double first = -v[0].z, second = -v[1].z;
  if (!set_depths(piece, std::min(first, second), std::max(first, second), lens)) return false;
  const glm::dvec2 from = lens.place(v[0]), to = lens.place(v[1]);
  const double length = glm::length(to - from);
  if (!(length > 0) || !std::isfinite(length)) return false;
  const glm::dvec2 along = (to - from) / length;
  make_band(from, along, half, piece);
  const Plane way(along.x, along.y, -glm::dot(along, from));
  piece.edge_count = 4;
  piece.edges[2] = way;
  piece.edges[3] = Plane(0, 0, length) - way;
  piece.parts[0] = piece.edges[3] * (lens.perspective ? 1 / first : 1);
  piece.parts[1] = piece.edges[2] * (lens.perspective ? 1 / second : 1);
  const double start = lens.perspective ? 1 / first : first;
  const double end = lens.perspective ? 1 / second : second;
  piece.depth = way * ((end - start) / length) + Plane(0, 0, start);
  Bounds bounds;
  bounds.add(from);
  bounds.add(to);
  piece.box = bounds.box(half + kMargin, lens);
  return piece.box.x0 <= piece.box.x1 && is_finite(piece.depth) && is_finite(piece.edges[0]);
}

bool make_point(const ShapeView& view, uint32_t primitive, const Lens& lens, double half,
                Piece& piece) {
  const glm::dvec3& v = view.corners[view.corner(primitive, 0)];
  if (!(-v.z >= lens.near_plane) || !set_depths(piece, -v.z, -v.z, lens)) return false;
  const glm::dvec2 at = lens.place(v);
  piece.edge_count = 4;
  piece.edges = {Plane(1, 0, half - at.x), Plane(-1, 0, half + at.x), Plane(0, 1, half - at.y),
                 Plane(0, -1, half + at.y)};
  piece.depth = {0, 0, lens.perspective ? -1 / v.z : -v.z};
  Bounds bounds;
  bounds.add(at);
  piece.box = bounds.box(half + kMargin, lens);
  return piece.box.x0 <= piece.box.x1;
}

}  // namespace

bool make_piece(const ShapeView& view, uint32_t primitive, const Lens& lens, unsigned n,
                Piece& piece) {
  piece.primitive = primitive;
  piece.back = false;
  switch (view.geometry->kind) {
    case Geometry::Kind::triangles:
      return make_triangle(view, primitive, lens, piece);
    case Geometry::Kind::lines:
      return make_line(view, primitive, lens, n / 2.0, piece);
    default:
      return make_point(view, primitive, lens, n / 2.0, piece);
  }
}

glm::dvec3 corner_parts(const Piece& piece, Geometry::Kind kind, double x, double y) {
  const auto part = [&](size_t k) { return std::max(0.0, value_at(piece.parts[k], x, y)); };
  if (kind == Geometry::Kind::points) return {1, 0, 0};
  if (kind == Geometry::Kind::lines) {
    const double first = part(0), second = part(1);
    if (!(first + second > 0)) return {1, 0, 0};
    const double place = glm::mix(piece.ends.x, piece.ends.y, second / (first + second));
    return {1 - place, place, 0};
  }
  const glm::dvec3 parts(part(0), part(1), part(2));
  const double sum = parts.x + parts.y + parts.z;
  return sum > 0 ? parts / sum : glm::dvec3(1.0 / 3);
}

}  // namespace afx::render
