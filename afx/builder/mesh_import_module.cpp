// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Meshes by Assimp: a module of its own (mesh_import_module.h).
#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <cmath>
#include <exception>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>
#include <new>
#include <string>
#include <string_view>
#include <utility>

#include "afx/builder/mesh_import_module.h"
#include "afx/builder/mesh_materials.h"

namespace afx {
namespace {

constexpr unsigned kSteps =
    aiProcess_Triangulate | aiProcess_JoinIdenticalVertices | aiProcess_GenUVCoords;
// A node that is its own ancestor in some way would never end; no real file comes near.
constexpr size_t kMostInstances = size_t{1} << 20;

MeshFormat format_of(const Assimp::Importer& importer) {
  const int number = importer.GetPropertyInteger("importerIndex", -1);
  const aiImporterDesc* description =
      number < 0 ? nullptr : importer.GetImporterInfo(static_cast<size_t>(number));
  if (description == nullptr) return MeshFormat::other;
  const std::string_view name(description->mName);
  if (name.find("glTF") != std::string_view::npos) return MeshFormat::gltf;
  return name.find("Wavefront") != std::string_view::npos ? MeshFormat::obj : MeshFormat::other;
}

bool is_finite(const glm::vec3& v) {
  const auto usable = [](float c) { return std::abs(c) < 1e37F; };
  return usable(v.x) && usable(v.y) && usable(v.z);
}

// Turns an imported scene into a Mesh.
class SceneConverter {
 public:
  SceneConverter(const aiScene& scene, const std::string& path, MeshFormat format,
                 const Limits& limits, Diagnostics& diagnostics)
      : scene_(scene),
        linear_colours_(format == MeshFormat::gltf),
        limits_(limits),
        diagnostics_(diagnostics),
        materials_(scene, path, format, limits, diagnostics) {}

  Result<Mesh> convert() {
    if (Status status = materials_.read(mesh_, traits_); !status.ok()) return status.error();
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
    add_texture_coords(from, traits_[material]);
    add_colours(from);
    add_triangles(from, first, material, glm::determinant(linear_part) < 0);
    mesh_.has_colours = mesh_.has_colours || traits_[material].named || from.HasVertexColors(0);
    return {};
  }

  void add_texture_coords(const aiMesh& from, const MaterialTraits& traits) {
    unsigned channel = traits.uv_channel;
    if (!from.HasTextureCoords(channel)) channel = 0;
    if (!from.HasTextureCoords(channel)) {
      if (!mesh_.texture_coords.empty()) mesh_.texture_coords.resize(mesh_.positions.size());
      return;
    }
    mesh_.texture_coords.resize(mesh_.positions.size() - from.mNumVertices);
    for (unsigned i = 0; i < from.mNumVertices; ++i) {
      const aiVector3D& t = from.mTextureCoords[channel][i];
      const glm::vec2 uv = traits.uv({t.x, t.y});
      const bool finite = std::isfinite(uv.x) && std::isfinite(uv.y);
      mesh_.texture_coords.push_back(finite ? uv : glm::vec2(0));
    }
  }

  void add_colours(const aiMesh& from) {
    if (!from.HasVertexColors(0)) {
      if (!mesh_.colours.empty()) mesh_.colours.resize(mesh_.positions.size(), glm::vec3(1));
      return;
    }
    mesh_.colours.resize(mesh_.positions.size() - from.mNumVertices, glm::vec3(1));
    for (unsigned i = 0; i < from.mNumVertices; ++i) {
      const glm::vec3 colour = linear_colour(from.mColors[0][i], linear_colours_);
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
    for (glm::vec3& p : mesh_.positions)  // used by no triangle; the mesh promises finite ones
      if (!is_finite(p)) p = glm::vec3(0);
  }

  const aiScene& scene_;
  bool linear_colours_;
  const Limits& limits_;
  Diagnostics& diagnostics_;
  MaterialReader materials_;
  Mesh mesh_;
  std::vector<MaterialTraits> traits_;
  uint64_t skipped_ = 0, bad_indices_ = 0, not_finite_ = 0, transparent_ = 0;
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
  const MeshFormat format = format_of(importer);
  const unsigned steps = format == MeshFormat::gltf ? kSteps : kSteps | aiProcess_TransformUVCoords;
  if (scene != nullptr) scene = importer.ApplyPostProcessing(steps);
  if (scene == nullptr) return import_error(importer, path);
  Result<Mesh> mesh = SceneConverter(*scene, path, format, limits, diagnostics).convert();
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
