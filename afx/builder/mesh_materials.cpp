// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/mesh_materials.h"

#include <assimp/GltfMaterial.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <optional>
#include <string_view>
#include <utility>

#include "afx/srgb.h"

namespace afx {
namespace {

// KHR_texture_transform scales, then turns against the clock (as seen with v downwards, as it is in
// glTF), then moves. Assimp's importer has put these into terms of its step for texture
// coordinates, which turns around the middle of the texture, but that step works in another order:
// so they are taken out of these terms again, and the step is left out for glTF.
UvTransform gltf_transform(const aiUVTransform& t) {
  const float c = std::cos(t.mRotation), s = -std::sin(t.mRotation);
  const glm::vec2 scale(t.mScaling.x, t.mScaling.y);
  const glm::vec2 offset(t.mTranslation.x - 0.5F * scale.x * (1 - c + s),
                         1 - scale.y + 0.5F * scale.y * (c + s - 1) - t.mTranslation.y);
  // u' = c su u + s sv v + offset, v' = -s su u + c sv v + offset, both with v = 1 - v upwards.
  UvTransform result;
  result.linear = glm::mat2(c * scale.x, s * scale.x, -s * scale.y, c * scale.y);
  result.offset = {offset.x + s * scale.y, 1 - offset.y - c * scale.y};
  return result;
}

Wrap wrap_of(int mode) {
  if (mode == aiTextureMapMode_Clamp || mode == aiTextureMapMode_Decal) return Wrap::clamp;
  return mode == aiTextureMapMode_Mirror ? Wrap::mirror : Wrap::repeat;
}

std::string material_name(const aiMaterial& material) {
  aiString name;
  return material.Get(AI_MATKEY_NAME, name) == aiReturn_SUCCESS ? name.C_Str() : std::string();
}

std::string texture_name(const aiMaterial& material, aiTextureType type) {
  aiString name;
  return material.GetTexture(type, 0, &name) == aiReturn_SUCCESS ? name.C_Str() : std::string();
}

std::optional<aiTextureType> colour_texture(const aiMaterial& material) {
  for (const aiTextureType type : {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE})
    if (!texture_name(material, type).empty()) return type;
  return {};
}

// How a material lets light through.
struct Transparency {
  AlphaRule rule = AlphaRule::if_mixed;
  float cutoff = 0.5F;   // of the texture's alpha; above 1 nothing of the material can be seen
  bool blended = false;  // not meant to be cut, but to shine through
};

// An alpha of one half is where surface begins, unless the file says otherwise. The material's own
// opacity multiplies the texture's alpha; an opacity of 0 where no format defines it is a mistake
// of an exporter: nobody models what cannot be seen.
Transparency transparency_of(const aiMaterial& material, const aiColor4D& base_colour) {
  Transparency transparency;
  float opacity = 1;
  aiString mode;
  if (material.Get(AI_MATKEY_GLTF_ALPHAMODE, mode) == aiReturn_SUCCESS) {
    const std::string_view name(mode.C_Str());
    if (name != "MASK" && name != "BLEND") return {AlphaRule::ignore, 0, false};
    transparency.rule = AlphaRule::as_is;
    transparency.blended = name == "BLEND";
    if (!transparency.blended) material.Get(AI_MATKEY_GLTF_ALPHACUTOFF, transparency.cutoff);
    opacity = base_colour.a;
  } else if (material.Get(AI_MATKEY_OPACITY, opacity) == aiReturn_SUCCESS) {
    if (!(opacity > 0 && opacity <= 1)) opacity = 1;
    transparency.blended = opacity < 1;
  }
  transparency.cutoff = std::max(0.0F, transparency.cutoff) / std::max(0.0F, opacity);
  if (!(transparency.cutoff > 0)) return {AlphaRule::ignore, 0, false};  // nothing is below 0
  return transparency;
}

}  // namespace

glm::vec3 linear_colour(const aiColor4D& colour, bool is_linear) {
  const glm::vec3 given(colour.r, colour.g, colour.b);
  if (is_linear) return glm::clamp(given, glm::vec3(0), glm::vec3(1));
  return {srgb_to_linear(given.x), srgb_to_linear(given.y), srgb_to_linear(given.z)};
}

MaterialReader::MaterialReader(const aiScene& scene, const std::string& path, MeshFormat format,
                               const Limits& limits, Diagnostics& diagnostics)
    : scene_(scene),
      is_gltf_(format == MeshFormat::gltf),
      diagnostics_(diagnostics),
      textures_(scene, path, limits, diagnostics) {
  if (format == MeshFormat::obj) mtl_textures_ = mtl_textures_of_obj(path, limits);
}

Status MaterialReader::read(Mesh& mesh, std::vector<MaterialTraits>& traits) {
  for (unsigned i = 0; i < scene_.mNumMaterials; ++i) {
    traits.emplace_back();
    Result<Material> material = read_material(*scene_.mMaterials[i], traits.back());
    if (!material.ok()) return material.error();
    mesh.materials.push_back(material.value());
  }
  mesh.materials.emplace_back();
  traits.emplace_back();
  mesh.textures = std::move(textures_.textures());
  if (blended_ > 0)
    diagnostics_.warn("alpha_blending", {},
                      std::to_string(blended_) +
                          " materials shine through: they become opaque where their alpha is one "
                          "half or more, holes elsewhere");
  return {};
}

// Whether the colour is one that Assimp puts where the file has none: some grey or white on a
// material without a name of its own, or glTF's default, which is white.
bool MaterialReader::is_made_up(const aiMaterial& from, const aiColor4D& colour) const {
  const std::string name = material_name(from);
  const bool has_name = !name.empty() && name != AI_DEFAULT_MATERIAL_NAME;
  const bool grey = colour.r == colour.g && colour.g == colour.b;
  return grey && (!has_name || (is_gltf_ && colour.r == 1));
}

Result<Material> MaterialReader::read_material(const aiMaterial& from, MaterialTraits& traits) {
  Material material;
  aiColor4D colour(1, 1, 1, 1);
  const bool has_colour = from.Get(AI_MATKEY_BASE_COLOR, colour) == aiReturn_SUCCESS ||
                          from.Get(AI_MATKEY_COLOR_DIFFUSE, colour) == aiReturn_SUCCESS;
  const bool named = has_colour && !is_made_up(from, colour);
  material.colour = linear_colour(colour, is_gltf_);
  const Transparency transparency = transparency_of(from, colour);
  if (Status status = add_texture(from, transparency.rule, material, traits); !status.ok())
    return status.error();
  const bool textured = material.texture != Material::kNoTexture;
  // Many exporters leave black beside a texture that replaces it; black times the texture would
  // show nothing.
  if (textured && colour_texture(from) && !is_gltf_ && material.colour == glm::vec3(0))
    material.colour = glm::vec3(1);
  const bool has_alpha = textured && textures_.textures()[material.texture].components % 2 == 0;
  if (has_alpha) material.alpha_cutoff = transparency.cutoff;
  traits.named = named || textured;
  traits.transparent = transparency.cutoff > 1;
  if (transparency.blended && !traits.transparent && (has_alpha || transparency.cutoff > 0.5F))
    ++blended_;
  return material;
}

Status MaterialReader::add_texture(const aiMaterial& from, AlphaRule rule, Material& material,
                                   MaterialTraits& traits) {
  TextureNames names{{}, {}, rule};
  aiTextureType type = aiTextureType_OPACITY;
  if (rule == AlphaRule::if_mixed) names.opacity = texture_name(from, type);
  if (const auto colour = colour_texture(from)) {
    type = *colour;
    names.colour = texture_name(from, type);
  }
  aiUVTransform transform;
  if (is_gltf_ && from.Get(AI_MATKEY_UVTRANSFORM(type, 0), transform) == aiReturn_SUCCESS)
    traits.uv = gltf_transform(transform);
  if (const auto mtl = mtl_textures_.find(material_name(from)); mtl != mtl_textures_.end()) {
    type = aiTextureType_DIFFUSE;
    names.colour = mtl->second.file;
    traits.uv.linear = glm::mat2(mtl->second.scale.x, 0, 0, mtl->second.scale.y);
    traits.uv.offset = mtl->second.offset;
  }
  const Result<std::optional<uint32_t>> number = textures_.load(names);
  if (!number.ok()) return number.error();
  if (!number.value()) return {};
  material.texture = *number.value();
  int mode = 0, channel = 0;
  if (from.Get(AI_MATKEY_MAPPINGMODE_U(type, 0), mode) == aiReturn_SUCCESS)
    material.wrap_u = wrap_of(mode);
  if (from.Get(AI_MATKEY_MAPPINGMODE_V(type, 0), mode) == aiReturn_SUCCESS)
    material.wrap_v = wrap_of(mode);
  if (from.Get(AI_MATKEY_UVWSRC(type, 0), channel) == aiReturn_SUCCESS && channel >= 0 &&
      channel < AI_MAX_NUMBER_OF_TEXTURECOORDS)
    traits.uv_channel = static_cast<unsigned>(channel);
  return {};
}

}  // namespace afx
