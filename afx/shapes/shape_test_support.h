// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Scenes of one node from text, and measures of triangles.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "afx/shape.h"
#include "afx/shapes/geometry_nodes.h"
#include "nodes/scene_reader.h"

namespace afx {

/// A scene that is expected to be good.
inline std::unique_ptr<nodes::Scene> scene_of(const std::string& text) {
  Diagnostics diagnostics;
  auto scene = nodes::read_scene_text(text, {}, diagnostics);
  EXPECT_TRUE(scene.ok()) << (scene.ok() ? "" : scene.error().text) << "\n" << text;
  return std::make_unique<nodes::Scene>(scene.ok() ? std::move(scene).value() : nodes::Scene());
}

inline nodes::NodeView first_root(const nodes::Scene& scene) {
  return {scene, scene.roots().at(0)};
}

/// The geometry of a Shape with such a node.
inline Result<Geometry> try_geometry(const std::string& text, const Limits& limits = {}) {
  const auto scene = scene_of("Shape { geometry " + text + " }");
  return read_geometry(first_root(*scene).child("geometry"), limits);
}
inline Geometry geometry_from(const std::string& text) {
  auto geometry = try_geometry(text);
  EXPECT_TRUE(geometry.ok()) << (geometry.ok() ? "" : geometry.error().text);
  return geometry.ok() ? std::move(geometry).value() : Geometry{};
}
/// The text of the error that is expected.
inline std::string geometry_error(const std::string& text, const Limits& limits = {}) {
  const auto geometry = try_geometry(text, limits);
  return geometry.ok()
             ? ""
             : std::string(to_string(geometry.error().code)) + ": " + geometry.error().text;
}

inline glm::dvec3 corner(const Geometry& g, size_t index) {
  return glm::dvec3(g.positions.at(g.indices.at(index)));
}

inline double area_of(const Geometry& g) {
  double sum = 0;
  for (size_t i = 0; i + 2 < g.indices.size(); i += 3)
    sum +=
        glm::length(glm::cross(corner(g, i + 1) - corner(g, i), corner(g, i + 2) - corner(g, i)));
  return sum / 2;
}

/// Of a closed surface whose triangles run counter-clockwise around the outside.
inline double volume_of(const Geometry& g) {
  double sum = 0;
  for (size_t i = 0; i + 2 < g.indices.size(); i += 3)
    sum += glm::dot(corner(g, i), glm::cross(corner(g, i + 1), corner(g, i + 2)));
  return sum / 6;
}

/// Each normal has the length 1 and lies on the side where the triangle runs counter-clockwise.
inline void expect_outward_normals(const Geometry& g) {
  ASSERT_EQ(g.normals.size(), g.positions.size());
  for (const glm::vec3& n : g.normals) EXPECT_NEAR(glm::length(n), 1, 1e-6);
  for (size_t i = 0; i + 2 < g.indices.size(); i += 3) {
    const glm::dvec3 n =
        glm::cross(corner(g, i + 1) - corner(g, i), corner(g, i + 2) - corner(g, i));
    for (size_t k = 0; k < 3; ++k)
      EXPECT_GT(glm::dot(n, glm::dvec3(g.normals[g.indices[i + k]])), 0) << "triangle " << i / 3;
  }
}

/// Corners - edges + triangles, corners at one place taken as one (to a millionth). Also that each
/// edge is in two triangles, once in each direction.
inline int euler_number(const Geometry& g) {
  using Spot = std::tuple<long, long, long>;
  const auto spot = [&](size_t index) {
    const glm::dvec3 p = corner(g, index) * 1e6;
    return Spot(std::lround(p.x), std::lround(p.y), std::lround(p.z));
  };
  std::set<Spot> places;
  std::map<std::pair<Spot, Spot>, int> edges;
  for (size_t i = 0; i < g.indices.size(); ++i) {
    places.insert(spot(i));
    ++edges[{spot(i), spot(i % 3 == 2 ? i - 2 : i + 1)}];
  }
  for (const auto& edge : edges) {
    EXPECT_EQ(edge.second, 1);
    EXPECT_EQ(edges.count({edge.first.second, edge.first.first}), 1U);
  }
  return static_cast<int>(places.size()) - static_cast<int>(edges.size() / 2) +
         static_cast<int>(g.indices.size() / 3);
}

/// The texture coordinate of the corner at a place with a normal nearest to that one.
inline glm::vec2 texture_at(const Geometry& g, glm::vec3 place, glm::vec3 normal) {
  size_t best = g.positions.size();
  float nearest = -2;
  for (size_t i = 0; i < g.positions.size(); ++i) {
    if (glm::distance(g.positions[i], place) > 1e-5F) continue;
    if (glm::dot(g.normals[i], normal) <= nearest) continue;
    nearest = glm::dot(g.normals[i], normal);
    best = i;
  }
  EXPECT_LT(best, g.positions.size())
      << "no corner at " << place.x << " " << place.y << " " << place.z;
  return best < g.positions.size() ? g.texture_coordinates[best] : glm::vec2(-9);
}

inline void expect_near(glm::vec2 a, glm::vec2 b) {
  EXPECT_LT(glm::distance(a, b), 1e-5)
      << a.x << " " << a.y << " (expected " << b.x << " " << b.y << ")";
}
inline void expect_near(glm::dvec3 a, glm::dvec3 b) {
  EXPECT_LT(glm::distance(a, b), 1e-6) << a.x << " " << a.y << " " << a.z;
}

}  // namespace afx
