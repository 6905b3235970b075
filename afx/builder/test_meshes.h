// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// For tests: meshes whose voxels can be told beforehand.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <map>
#include <utility>
#include <vector>

#include "afx/builder/mesh.h"

namespace afx {

inline void add_triangle(Mesh& mesh, uint32_t a, uint32_t b, uint32_t c) {
  mesh.triangles.emplace_back(a, b, c);
  mesh.material_of.push_back(0);
}

/// A box of one colour (linear), 12 triangles, normals outwards.
inline Mesh box_mesh(const glm::vec3& low, const glm::vec3& high,
                     const glm::vec3& colour = {1, 1, 1}) {
  Mesh mesh;
  mesh.materials.push_back({.colour = colour});
  mesh.has_colours = true;
  for (uint32_t i = 0; i < 8; ++i)
    mesh.positions.emplace_back(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y,
                                i & 4 ? high.z : low.z);
  const uint32_t faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& f : faces) {
    add_triangle(mesh, f[0], f[1], f[2]);
    add_triangle(mesh, f[0], f[2], f[3]);
  }
  return mesh;
}

/// The unit sphere from an octahedron, each triangle split in four `rounds` times.
inline Mesh sphere_mesh(int rounds) {
  Mesh mesh;
  mesh.materials.emplace_back();
  mesh.has_colours = true;
  mesh.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  const uint32_t faces[8][3] = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  std::vector<glm::uvec3> triangles;
  for (const auto& f : faces) triangles.emplace_back(f[0], f[1], f[2]);
  for (int round = 0; round < rounds; ++round) {
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> middles;
    const auto middle = [&](uint32_t a, uint32_t b) {
      const std::pair<uint32_t, uint32_t> key = std::minmax(a, b);
      const auto [at, is_new] =
          middles.try_emplace(key, static_cast<uint32_t>(mesh.positions.size()));
      if (is_new) mesh.positions.push_back(glm::normalize(mesh.positions[a] + mesh.positions[b]));
      return at->second;
    };
    std::vector<glm::uvec3> finer;
    for (const glm::uvec3& t : triangles) {
      const uint32_t a = middle(t.x, t.y), b = middle(t.y, t.z), c = middle(t.z, t.x);
      for (const glm::uvec3& part : {glm::uvec3(t.x, a, c), glm::uvec3(a, t.y, b),
                                     glm::uvec3(c, b, t.z), glm::uvec3(a, b, c)})
        finer.push_back(part);
    }
    triangles = finer;
  }
  for (const glm::uvec3& t : triangles) add_triangle(mesh, t.x, t.y, t.z);
  return mesh;
}

/// The square -1..1 in x and y at z = 0 with the whole of a texture on it, facing +z.
inline Mesh textured_square(const Picture& texture) {
  Mesh mesh;
  mesh.materials.push_back({.texture = 0});
  mesh.textures.push_back(texture);
  mesh.has_colours = true;
  mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  mesh.texture_coords = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  add_triangle(mesh, 0, 1, 2);
  add_triangle(mesh, 0, 2, 3);
  return mesh;
}

}  // namespace afx
