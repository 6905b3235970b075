// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What the builder builds from: triangles or points, as plain data.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

#include "afx/octree_model.h"
#include "afx/picture.h"

namespace afx {

/// What a texture shows outside [0, 1].
enum class Wrap : uint8_t { repeat, clamp, mirror };

/// What covers triangles: colour * vertex colour * texture.
struct Material {
  static constexpr uint32_t kNoTexture = std::numeric_limits<uint32_t>::max();
  glm::vec3 colour{1, 1, 1};      ///< linear light (not sRGB), 0..1
  uint32_t texture = kNoTexture;  ///< index into Mesh::textures
  Wrap wrap_u = Wrap::repeat;
  Wrap wrap_v = Wrap::repeat;
  /// Where the alpha of the texture is below this there is no surface; 0 = opaque everywhere. In
  /// 0..1.
  float alpha_cutoff = 0;
};

/// Triangles with their colours. Invariants: every index is in range, all positions and texture
/// coordinates are finite; per-vertex arrays are empty or as long as `positions`.
struct Mesh {
  std::vector<glm::vec3> positions;       ///< right-handed; units of the file
  std::vector<glm::vec2> texture_coords;  ///< (0, 0) = lower left corner of the texture
  std::vector<glm::vec3> colours;         ///< linear light (not sRGB), 0..1
  std::vector<glm::uvec3> triangles;  ///< three positions each, counterclockwise seen from outside
  std::vector<uint32_t> material_of;  ///< for each triangle, index into materials
  std::vector<Material> materials;    ///< at least one where there are triangles
  std::vector<Picture> textures;  ///< sRGB; with alpha only where materials have an alpha_cutoff
  bool has_colours = false;       ///< the file says what colour the surface has, somewhere
};

/// Points with or without colours and normals; arrays are empty or as long as `positions`.
struct PointCloud {
  /// What was taken off the file's coordinates, to keep their precision.
  glm::dvec3 origin{0, 0, 0};
  std::vector<glm::vec3> positions;  ///< finite
  std::vector<Rgba8> colours;        ///< sRGB
  std::vector<glm::vec3> normals;    ///< of any length; (0, 0, 0) where unknown
};

}  // namespace afx
