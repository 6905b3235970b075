// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The materials of a scene that Assimp has imported.
#pragma once

#include <assimp/scene.h>

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "afx/builder/mesh.h"
#include "afx/builder/mtl_textures.h"
#include "afx/builder/texture_loader.h"
#include "codec/diagnostics.h"
#include "codec/error.h"
#include "codec/limits.h"

namespace afx {

/// Formats that want something of their own: glTF has its colours in linear light, whatever else
/// there is has them as shown on screens.
enum class MeshFormat { gltf, obj, other };

/// A colour of the scene in linear light, 0..1.
glm::vec3 linear_colour(const aiColor4D& colour, bool is_linear);

/// What is done to texture coordinates, (0, 0) the lower left corner.
struct UvTransform {
  glm::mat2 linear{1};
  glm::vec2 offset{0, 0};
  [[nodiscard]] glm::vec2 operator()(const glm::vec2& uv) const { return linear * uv + offset; }
};

/// What of a material is not kept in the mesh.
struct MaterialTraits {
  bool named = false;        ///< the file says its colour
  bool transparent = false;  ///< nothing of it can be seen
  unsigned uv_channel = 0;
  UvTransform uv;
};

class MaterialReader {
 public:
  /// path   the file that the scene came from
  MaterialReader(const aiScene& scene, const std::string& path, MeshFormat format,
                 const Limits& limits, Diagnostics& diagnostics);

  /// Fills in the materials of the scene, one more for meshes that name none, and the textures.
  /// Warnings and errors   as TextureLoader; alpha_blending
  Status read(Mesh& mesh, std::vector<MaterialTraits>& traits);

 private:
  Result<Material> read_material(const aiMaterial& from, MaterialTraits& traits);
  Status add_texture(const aiMaterial& from, AlphaRule rule, Material& material,
                     MaterialTraits& traits);
  [[nodiscard]] bool is_made_up(const aiMaterial& from, const aiColor4D& colour) const;

  const aiScene& scene_;
  bool is_gltf_;
  Diagnostics& diagnostics_;
  TextureLoader textures_;
  MtlTextures mtl_textures_;
  uint64_t blended_ = 0;
};

}  // namespace afx
