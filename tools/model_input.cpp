// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/model_input.h"

#include <utility>

#include "afx/builder/model_reader.h"
#include "afx/builder/rgbd_reader.h"
#include "afx/builder/point_surfels.h"
#include "afx/surfel_sources.h"
#include "tools/abort_guard.h"
#include "tools/input.h"
#include "tools/scene_input.h"

namespace afx::tools {
namespace {

Error in_file(Error error, const std::string& file) {
  if (error.file.empty()) error.file = file;
  return error;
}

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
  auto models = read_dibr_models(scene.value().scene, scene.value().base(), limits, diagnostics);
  if (models.ok() && models.value().empty())
    return Error{Errc::malformed, Place::none(),
                 "the scene has no DIBR nodes (expected DepthImage or OctreeImage)"};
  return models;
}

/// An octree alone, which has no pictures.
Result<std::vector<DibrModel>> read_octree_alone(const Input& input, const Limits& limits,
                                                 Diagnostics& diagnostics) {
  OctreeQuery query;
  auto octree = read_octree(input, query, limits, diagnostics);
  if (!octree.ok()) return std::move(octree).error();
  OctreeNode& node = octree.value();
  node.fields.voxel_image_index.clear();
  std::vector<DibrModel> models(1);
  models[0].shape = OctreeModel{node.resolution, std::move(node.fields), {}};
  return models;
}

}  // namespace

Result<ModelInput> read_model_input(const std::string& path, const Session& session,
                                    Diagnostics& diagnostics) {
  Diagnostics on_opening;
  const auto input = open_input(path, {}, session.limits, on_opening);
  const bool told = input.ok() && input.value().kind != Kind::unknown;
  if (!input.ok() && input.error().code != Errc::malformed) return input.error();
  if (!told || input.value().kind == Kind::model)
    return read_mesh_or_points(path, session.limits, diagnostics);
  diagnostics.append(on_opening);
  switch (input.value().kind) {
    case Kind::scene_text:
    case Kind::scene_xml:
    case Kind::mp4:
    case Kind::raw_bifs:
      return given(read_scene_models(input.value(), session.limits, diagnostics), path);
    case Kind::octree_stream:
      return given(read_octree_alone(input.value(), session.limits, diagnostics), path);
    case Kind::json:
      return given(read_rgbd(path, session.options.threads, session.limits, diagnostics), path);
    default:
      return Error{Errc::unsupported,
                   Place::none(),
                   std::string("is ") + describe(input.value().kind) +
                       " (expected a mesh, points, RGB-D pictures or a scene)",
                   {},
                   path};
  }
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
