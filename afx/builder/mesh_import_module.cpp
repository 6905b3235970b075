// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Meshes by Assimp: a module of its own (mesh_import_module.h).
#include <assimp/GltfMaterial.h>
#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <exception>
#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "afx/builder/mesh_import_module.h"
#include "afx/builder/texture_loader.h"
#include "afx/srgb.h"

namespace afx {
namespace {

constexpr unsigned kSteps = aiProcess_Triangulate | aiProcess_JoinIdenticalVertices |
                            aiProcess_GenUVCoords | aiProcess_TransformUVCoords;
// A node that is its own ancestor in some way would never end; no real file comes near.
constexpr size_t kMostInstances = size_t{1} << 20;

bool is_finite(const glm::vec3& v) {
  const auto usable = [](float c) { return std::abs(c) < 1e37F; };
  return usable(v.x) && usable(v.y) && usable(v.z);
}

Wrap wrap_of(int mode) {
  if (mode == aiTextureMapMode_Clamp || mode == aiTextureMapMode_Decal) return Wrap::clamp;
  return mode == aiTextureMapMode_Mirror ? Wrap::mirror : Wrap::repeat;
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

// Turns an imported scene into a Mesh.
class SceneConverter {
 public:
  SceneConverter(const aiScene& scene, const std::string& path, bool linear_colours,
                 const Limits& limits, Diagnostics& diagnostics)
      : scene_(scene),
        linear_colours_(linear_colours),
        limits_(limits),
        diagnostics_(diagnostics),
        textures_(scene, path, limits, diagnostics) {}

  Result<Mesh> convert() {
    for (unsigned i = 0; i < scene_.mNumMaterials; ++i)
      if (Status status = add_material(*scene_.mMaterials[i]); !status.ok()) return status.error();
    mesh_.materials.emplace_back();  // for meshes that name none
    traits_.emplace_back();
    mesh_.textures = std::move(textures_.textures());
    if (Status status = add_nodes(); !status.ok()) return status.error();
    warn();
    if (mesh_.triangles.empty()) return Error{Errc::malformed, {}, no_triangles(), {}, {}};
    return std::move(mesh_);
  }

 private:
  [[nodiscard]] std::string no_triangles() const {
    const uint64_t left_out = not_finite_ + bad_indices_ + transparent_;
    if (left_out == 0) return "the file has no triangles (expected a mesh)";
    return "none of the file's " + std::to_string(left_out) + " triangles can be used (" +
           std::to_string(not_finite_) + " have coordinates that are not finite, " +
           std::to_string(bad_indices_) + " name vertices that are not there, " +
           std::to_string(transparent_) + " are transparent)";
  }

  glm::vec3 linear(const aiColor4D& colour) const {
    const glm::vec3 given(colour.r, colour.g, colour.b);
    if (linear_colours_) return glm::clamp(given, glm::vec3(0), glm::vec3(1));
    return {srgb_to_linear(given.x), srgb_to_linear(given.y), srgb_to_linear(given.z)};
  }

  // Whether the colour is one that Assimp puts where the file has none: some grey or white on a
  // material without a name of its own, or glTF's default, which is white.
  [[nodiscard]] bool is_made_up(const aiMaterial& from, const aiColor4D& colour) const {
    aiString name;
    const bool has_name = from.Get(AI_MATKEY_NAME, name) == aiReturn_SUCCESS && name.length > 0 &&
                          std::string_view(name.C_Str()) != AI_DEFAULT_MATERIAL_NAME;
    const bool grey = colour.r == colour.g && colour.g == colour.b;
    return grey && (!has_name || (linear_colours_ && colour.r == 1));
  }

  Status add_material(const aiMaterial& from) {
    Material material;
    aiColor4D colour(1, 1, 1, 1);
    const bool has_colour = from.Get(AI_MATKEY_BASE_COLOR, colour) == aiReturn_SUCCESS ||
                            from.Get(AI_MATKEY_COLOR_DIFFUSE, colour) == aiReturn_SUCCESS;
    const bool named = has_colour && !is_made_up(from, colour);
    material.colour = linear(colour);
    const Transparency transparency = transparency_of(from, colour);
    unsigned uv_channel = 0;
    if (Status status = add_texture(from, transparency.rule, material, uv_channel); !status.ok())
      return status;
    const bool textured = material.texture != Material::kNoTexture;
    // Many exporters leave black beside a texture that replaces it; black times the texture would
    // show nothing.
    if (textured && colour_texture(from) && !linear_colours_ && material.colour == glm::vec3(0))
      material.colour = glm::vec3(1);
    const bool has_alpha = textured && textures_.textures()[material.texture].components % 2 == 0;
    if (has_alpha) material.alpha_cutoff = transparency.cutoff;
    if (transparency.blended && (has_alpha || transparency.cutoff > 0.5F)) ++blended_;
    mesh_.materials.push_back(material);
    traits_.push_back({named || textured, transparency.cutoff > 1, uv_channel});
    return {};
  }

  Status add_texture(const aiMaterial& from, AlphaRule rule, Material& material,
                     unsigned& uv_channel) {
    TextureNames names{{}, {}, rule};
    aiTextureType type = aiTextureType_OPACITY;
    if (rule == AlphaRule::if_mixed) names.opacity = texture_name(from, type);
    if (const auto colour = colour_texture(from)) {
      type = *colour;
      names.colour = texture_name(from, type);
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
      uv_channel = static_cast<unsigned>(channel);
    return {};
  }

  // Nodes depth first, children in their order, without recursion: files decide how deep they nest.
  Status add_nodes() {
    struct Visit {
      const aiNode* node;
      aiMatrix4x4 above;
    };
    std::vector<Visit> open;
    if (scene_.mRootNode != nullptr) open.push_back({scene_.mRootNode, aiMatrix4x4()});
    size_t instances = 0;
    while (!open.empty()) {
      const Visit visit = open.back();
      open.pop_back();
      const aiMatrix4x4 here = visit.above * visit.node->mTransformation;
      for (unsigned i = 0; i < visit.node->mNumMeshes; ++i)
        if (Status status = add_mesh(visit.node->mMeshes[i], here); !status.ok()) return status;
      for (unsigned i = visit.node->mNumChildren; i-- > 0;)
        if (visit.node->mChildren[i] != nullptr) open.push_back({visit.node->mChildren[i], here});
      if (++instances > kMostInstances)
        return Error{Errc::limit_exceeded, {}, "the scene has more than 2^20 nodes", {}, {}};
    }
    return {};
  }

  Status add_mesh(unsigned number, const aiMatrix4x4& m) {
    if (number >= scene_.mNumMeshes || !scene_.mMeshes[number]->HasPositions()) return {};
    const aiMesh& from = *scene_.mMeshes[number];
    constexpr uint64_t kVertexBytes = 32, kTriangleBytes = 16;
    const uint64_t vertices = uint64_t{from.mNumVertices} + mesh_.positions.size();
    const uint64_t triangles = uint64_t{from.mNumFaces} + mesh_.triangles.size();
    if (vertices > 0xFFFFFFFF ||
        vertices * kVertexBytes + triangles * kTriangleBytes > limits_.memory)
      return Error{Errc::limit_exceeded, {}, "the mesh takes more memory than the limit", {}, {}};
    const uint32_t material =
        from.mMaterialIndex < scene_.mNumMaterials ? from.mMaterialIndex : scene_.mNumMaterials;
    const auto first = static_cast<uint32_t>(mesh_.positions.size());
    const glm::mat3 linear_part(glm::vec3(m.a1, m.b1, m.c1), glm::vec3(m.a2, m.b2, m.c2),
                                glm::vec3(m.a3, m.b3, m.c3));
    for (unsigned i = 0; i < from.mNumVertices; ++i) {
      const aiVector3D& p = from.mVertices[i];
      mesh_.positions.push_back(linear_part * glm::vec3(p.x, p.y, p.z) +
                                glm::vec3(m.a4, m.b4, m.c4));
    }
    add_texture_coords(from, traits_[material].uv_channel);
    add_colours(from);
    add_triangles(from, first, material, glm::determinant(linear_part) < 0);
    mesh_.has_colours = mesh_.has_colours || traits_[material].named || from.HasVertexColors(0);
    return {};
  }

  void add_texture_coords(const aiMesh& from, unsigned channel) {
    if (!from.HasTextureCoords(channel)) channel = 0;
    if (!from.HasTextureCoords(channel)) {
      if (!mesh_.texture_coords.empty()) mesh_.texture_coords.resize(mesh_.positions.size());
      return;
    }
    mesh_.texture_coords.resize(mesh_.positions.size() - from.mNumVertices);
    for (unsigned i = 0; i < from.mNumVertices; ++i) {
      const aiVector3D& t = from.mTextureCoords[channel][i];
      const bool finite = std::isfinite(t.x) && std::isfinite(t.y);
      mesh_.texture_coords.push_back(finite ? glm::vec2(t.x, t.y) : glm::vec2(0));
    }
  }

  void add_colours(const aiMesh& from) {
    if (!from.HasVertexColors(0)) {
      if (!mesh_.colours.empty()) mesh_.colours.resize(mesh_.positions.size(), glm::vec3(1));
      return;
    }
    mesh_.colours.resize(mesh_.positions.size() - from.mNumVertices, glm::vec3(1));
    for (unsigned i = 0; i < from.mNumVertices; ++i) {
      const glm::vec3 colour = linear(from.mColors[0][i]);
      mesh_.colours.push_back(is_finite(colour) ? colour : glm::vec3(1));
    }
  }

  void add_triangles(const aiMesh& from, uint32_t first, uint32_t material, bool mirrored) {
    for (unsigned i = 0; i < from.mNumFaces; ++i) {
      const aiFace& face = from.mFaces[i];
      if (face.mNumIndices != 3 || face.mIndices == nullptr) {
        ++skipped_;
        continue;
      }
      glm::uvec3 triangle(face.mIndices[0], face.mIndices[1], face.mIndices[2]);
      if (glm::any(glm::greaterThanEqual(triangle, glm::uvec3(from.mNumVertices)))) {
        ++bad_indices_;
        continue;
      }
      triangle += glm::uvec3(first);
      if (mirrored) std::swap(triangle.y, triangle.z);
      const bool usable = is_finite(mesh_.positions[triangle.x]) &&
                          is_finite(mesh_.positions[triangle.y]) &&
                          is_finite(mesh_.positions[triangle.z]);
      if (!usable) {
        ++not_finite_;
        continue;
      }
      if (traits_[material].transparent) {
        ++transparent_;
        continue;
      }
      mesh_.triangles.push_back(triangle);
      mesh_.material_of.push_back(material);
    }
  }

  void warn() {
    if (skipped_ > 0)
      diagnostics_.warn("skipped_primitives", {},
                        std::to_string(skipped_) + " lines and points were left out");
    if (bad_indices_ > 0)
      diagnostics_.warn("bad_index", {},
                        std::to_string(bad_indices_) +
                            " triangles name vertices that are not there and were left out");
    if (not_finite_ > 0)
      diagnostics_.warn("non_finite", {},
                        std::to_string(not_finite_) +
                            " triangles with coordinates that are not finite were left out");
    if (transparent_ > 0)
      diagnostics_.warn(
          "transparent", {},
          std::to_string(transparent_) + " triangles of transparent materials were left out");
    if (blended_ > 0)
      diagnostics_.warn("alpha_blending", {},
                        std::to_string(blended_) +
                            " materials shine through: they become opaque where their alpha is one "
                            "half or more, holes elsewhere");
    for (glm::vec3& p : mesh_.positions)  // used by no triangle; the mesh promises finite ones
      if (!is_finite(p)) p = glm::vec3(0);
  }

  const aiScene& scene_;
  bool linear_colours_;
  const Limits& limits_;
  Diagnostics& diagnostics_;
  TextureLoader textures_;
  Mesh mesh_;
  // What of a material is not kept in the mesh.
  struct Traits {
    bool named = false;        // the file says its colour
    bool transparent = false;  // nothing of it can be seen
    unsigned uv_channel = 0;
  };
  std::vector<Traits> traits_;
  uint64_t skipped_ = 0, bad_indices_ = 0, not_finite_ = 0, transparent_ = 0, blended_ = 0;
};

Error import_error(const Assimp::Importer& importer, const std::string& path) {
  std::string reason = importer.GetErrorString();
  while (!reason.empty() && (reason.back() == '.' || reason.back() == '\n' || reason.back() == ' '))
    reason.pop_back();
  const bool unknown = reason.find("No suitable reader") != std::string::npos;
  if (unknown)
    return Error{Errc::unsupported,
                 {},
                 "is of no kind that can be built from (Assimp: " + reason + ")",
                 {},
                 path};
  if (reason.find("bad_alloc") != std::string::npos)
    return Error{Errc::no_memory, {}, "does not fit into memory", {}, path};
  return Error{Errc::malformed,
               {},
               "cannot be imported (Assimp: " + (reason.empty() ? "no reason given" : reason) + ")",
               {},
               path};
}

// glTF has its colours in linear light; whatever else there is has them as shown on screens.
bool has_linear_colours(const Assimp::Importer& importer) {
  const int number = importer.GetPropertyInteger("importerIndex", -1);
  if (number < 0) return false;
  const aiImporterDesc* description = importer.GetImporterInfo(static_cast<size_t>(number));
  return description != nullptr &&
         std::string_view(description->mName).find("glTF") != std::string_view::npos;
}

// Whether Assimp's later steps can work on it: Debian's build ends the process where they assert
// that they can. What is not sound goes through Assimp's validation, whose error says why.
// (Validation of everything would refuse files for a lamp without a place.)
bool is_sound(const aiScene& scene) {
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    const aiMesh* mesh = scene.mMeshes[m];
    if (mesh == nullptr || !mesh->HasPositions() || !mesh->HasFaces()) return false;
    for (unsigned f = 0; f < mesh->mNumFaces; ++f) {
      const aiFace& face = mesh->mFaces[f];
      if (face.mNumIndices == 0 || face.mIndices == nullptr) return false;
      for (unsigned i = 0; i < face.mNumIndices; ++i)
        if (face.mIndices[i] >= mesh->mNumVertices) return false;
    }
  }
  return true;
}

Result<Mesh> import(const std::string& path, const Limits& limits, Diagnostics& diagnostics) {
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(path, 0);
  if (scene != nullptr && !is_sound(*scene))
    scene = importer.ApplyPostProcessing(aiProcess_ValidateDataStructure);
  if (scene != nullptr) scene = importer.ApplyPostProcessing(kSteps);
  if (scene == nullptr) return import_error(importer, path);
  Result<Mesh> mesh =
      SceneConverter(*scene, path, has_linear_colours(importer), limits, diagnostics).convert();
  if (!mesh.ok() && mesh.error().file.empty()) mesh.error().file = path;
  return mesh;
}

Result<Mesh> import_safely(const std::string& path, const Limits& limits,
                           Diagnostics& diagnostics) {
  // Assimp catches most of what its readers throw, not all.
  try {
    return import(path, limits, diagnostics);
  } catch (const std::bad_alloc&) {
    return Error{Errc::no_memory, {}, "does not fit into memory", {}, path};
  } catch (const std::exception& thrown) {
    return Error{
        Errc::malformed, {}, std::string("cannot be imported (") + thrown.what() + ")", {}, path};
  } catch (...) {
    return Error{Errc::malformed, {}, "cannot be imported", {}, path};
  }
}

}  // namespace
}  // namespace afx

extern "C" {

__attribute__((visibility("default"))) void afx_mesh_import(const std::string* path,
                                                            const afx::Limits* limits,
                                                            afx::Diagnostics* diagnostics,
                                                            afx::Result<afx::Mesh>* mesh) {
  *mesh = afx::import_safely(*path, *limits, *diagnostics);
}
}
