// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/model_input.h"

#include <utility>

#include "afx/builder/model_reader.h"
#include "afx/builder/point_surfels.h"
#include "afx/builder/rgbd_reader.h"
#include "afx/surfel_sources.h"
#include "tools/abort_guard.h"
#include "tools/scene_input.h"

namespace afx::tools {
namespace {

/// A model in memory, or the error with its file.
template <class Model>
Result<ModelInput> given(Result<Model> model, const std::string& path) {
  if (!model.ok()) return in_file(std::move(model).error(), path);
  return ModelInput(std::move(model).value());
}

Result<ModelInput> read_mesh_or_points(const std::string& path, const Limits& limits,
                                       Diagnostics& diagnostics) {
  auto source = [&] {
    const AbortGuard guard(path);
    return read_source_model(path, limits, diagnostics);
  }();
  if (!source.ok()) return in_file(std::move(source).error(), path);
  if (auto* mesh = std::get_if<Mesh>(&source.value())) return ModelInput(std::move(*mesh));
  return ModelInput(std::move(std::get<PointCloud>(source.value())));
}

Result<std::vector<DibrModel>> read_scene_models(const Input& input, const Limits& limits,
                                                 Diagnostics& diagnostics) {
  const auto scene = read_scene(input, limits, diagnostics);
  if (!scene.ok()) return scene.error();
  warn_of_left_out(scene.value().scene, diagnostics);
  auto models = read_dibr_models(scene.value().scene, scene.value().base(), limits, diagnostics);
  if (models.ok() && models.value().empty())
    return Error{Errc::malformed, Place::none(),
                 "the scene has no DIBR nodes (expected DepthImage or OctreeImage)"};
  return models;
}

/// An octree alone, which has no pictures.
Result<std::vector<DibrModel>> read_octree_alone(const Input& input, OctreeQuery& query,
                                                 const Limits& limits, Diagnostics& diagnostics) {
  auto octree = read_octree(input, query, limits, diagnostics);
  if (!octree.ok()) return std::move(octree).error();
  OctreeNode& node = octree.value();
  if (node.images > 0)
    diagnostics.warn("no_pictures", Place::none(),
                     "a stream alone has no pictures: the model is grey");
  node.fields.voxel_image_index.clear();
  std::vector<DibrModel> models;
  models.emplace_back(glm::dmat4(1), OctreeModel{node.resolution, std::move(node.fields), {}});
  return models;
}

Error no_model(const Input& input) {
  const std::string found = std::string("is ") + describe(input.kind);
  return {Errc::unsupported,
          Place::none(),
          found + " (expected a mesh, points, RGB-D pictures, a scene or .afx)",
          {},
          input.path};
}

}  // namespace

Result<ModelInput> read_model_input(const Input& input, OctreeQuery& query, const Session& session,
                                    Diagnostics& diagnostics) {
  const Limits& limits = session.limits;
  const std::string& path = input.path;
  switch (input.kind) {
    case Kind::model:
      return read_mesh_or_points(path, limits, diagnostics);
    case Kind::scene_text:
    case Kind::scene_xml:
    case Kind::mp4:
    case Kind::raw_bifs:
      return given(read_scene_models(input, limits, diagnostics), path);
    case Kind::octree_stream:
    case Kind::raw_octree:
      return given(read_octree_alone(input, query, limits, diagnostics), path);
    case Kind::json:
      return given(read_rgbd(path, session.options.threads, limits, diagnostics), path);
    default:
      return no_model(input);
  }
}

Status refuse_raw_octree(const Input& input) {
  return input.kind == Kind::raw_octree ? Status(no_model(input)) : Status();
}

Shade shade_of(const std::string& option) {
  if (option == "always") return Shade::always;
  return option == "never" ? Shade::never : Shade::automatic;
}

Result<Surfels> surfels_of_input(ModelInput&& model, const Session& session,
                                 Diagnostics& diagnostics) {
  const unsigned threads = session.options.threads;
  if (auto* surfels = std::get_if<Surfels>(&model)) return std::move(*surfels);
  if (const auto* cloud = std::get_if<PointCloud>(&model))
    return surfels_of(*cloud, threads, session.limits);
  if (const auto* models = std::get_if<std::vector<DibrModel>>(&model))
    return surfels_of(*models, threads, session.limits, diagnostics);
  return Error{Errc::bad_argument, Place::none(), "is a mesh (expected something sampled)"};
}

}  // namespace afx::tools
