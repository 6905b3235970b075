// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/drawing.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "afx/octree_colours.h"
#include "afx/surfel_sources.h"

namespace afx::tools {
namespace {

DepthCamera depth_camera(const render::Camera& camera, const render::RenderOptions& options,
                         double far) {
  const double aspect = static_cast<double>(options.width) / options.height;
  DepthCamera result;
  result.position = camera.position;
  result.orientation = camera.orientation;
  result.orthographic = camera.projection == render::Projection::orthographic;
  result.near_plane = camera.near_plane;
  result.far_plane = far;
  if (result.orthographic) {
    result.field_of_view = {camera.view_height * aspect, camera.view_height};
  } else {
    const double slope = std::tan(camera.field_of_view / 2);
    result.field_of_view = {2 * std::atan(slope * aspect), camera.field_of_view};
  }
  return result;
}

/// The vertices that triangles use, each once.
std::vector<glm::dvec3> corners_of(const Mesh& mesh) {
  std::vector<bool> used(mesh.positions.size());
  for (const glm::uvec3& triangle : mesh.triangles)
    for (int k = 0; k < 3; ++k) used[triangle[k]] = true;
  std::vector<glm::dvec3> corners;
  for (size_t i = 0; i < used.size(); ++i)
    if (used[i]) corners.emplace_back(mesh.positions[i]);
  return corners;
}

}  // namespace

Result<std::shared_ptr<const render::VoxelTree>> Drawing::colour(const OctreeModel& model) {
  const unsigned level = std::min(level_, octree_levels(model.resolution));
  const auto coloured = colour_octree(model, level, session_.options.threads, left_, diagnostics_);
  if (!coloured.ok()) return coloured.error();
  const ColouredVoxels& voxels = coloured.value();
  const VoxelSurface surface = voxel_surface(voxels.codes, voxels.level, VoxelBlocks(voxels.codes),
                                             session_.options.threads);
  auto tree = render::VoxelTree::make(voxels.level, voxels.codes, voxels.colours, &surface);
  if (tree.ok()) left_.memory -= std::min(left_.memory, tree.value()->bytes());
  return tree;
}

std::shared_ptr<const Surfels> Drawing::keep(Surfels&& surfels) {
  left_.memory -= std::min(left_.memory, surfels.size() * kSurfelBytes);
  return std::make_shared<Surfels>(std::move(surfels));
}

Status Drawing::add(const LoadedScene& scene) {
  const auto models = read_dibr_models(scene.scene, scene.base(), left_, diagnostics_);
  if (!models.ok()) return models.error();
  if (Status added = add(models.value()); !added.ok()) return added;
  warn_of_left_out(scene.scene, diagnostics_);
  if (!scene_.voxels.empty() || !scene_.surfels.empty()) return {};
  return Error{Errc::malformed, Place::none(),
               "the scene shows nothing to draw (expected a DepthImage or an OctreeImage)"};
}

Status Drawing::add(const OctreeModel& model, const glm::dmat4& to_world) {
  const auto tree = colour(model);
  if (!tree.ok()) return tree.error();
  scene_.voxels.push_back({tree.value(), to_world});
  return {};
}

Status Drawing::add(ModelInput&& model, Shade shade) {
  if (auto* mesh = std::get_if<Mesh>(&model)) {
    mesh_ = std::make_unique<Mesh>(std::move(*mesh));
    look_ = std::make_unique<MeshLook>(*mesh_, shade);
    corners_ = corners_of(*mesh_);
    return {};
  }
  if (const auto* models = std::get_if<std::vector<DibrModel>>(&model)) return add(*models);
  auto surfels = surfels_of_input(std::move(model), session_, diagnostics_);
  if (!surfels.ok()) return std::move(surfels).error();
  scene_.surfels.push_back({keep(std::move(surfels).value()), glm::dmat4(1)});
  return {};
}

/// A shape that stands in several places is made ready once.
Status Drawing::add(const std::vector<DibrModel>& models) {
  std::map<const DibrShape*, render::Scene> known;
  for (const DibrModel& model : models) {
    const auto [at, is_new] = known.try_emplace(model.shape.get());
    if (is_new) {
      auto ready = make_ready(model);
      if (!ready.ok()) return std::move(ready).error();
      at->second = std::move(ready).value();
    }
    for (const render::VoxelCloud& cloud : at->second.voxels)
      scene_.voxels.push_back({cloud.tree, model.to_world});
    for (const render::SurfelCloud& cloud : at->second.surfels)
      scene_.surfels.push_back({cloud.surfels, model.to_world});
  }
  return {};
}

Result<render::Scene> Drawing::make_ready(const DibrModel& model) {
  render::Scene scene;
  if (const OctreeModel* octree = model.octree()) {
    const auto tree = colour(*octree);
    if (!tree.ok()) return tree.error();
    scene.voxels.push_back({tree.value(), glm::dmat4(1)});
    return scene;
  }
  for (const DepthImage& image : *model.depth_images()) {
    auto surfels = surfels_of(image, session_.options.threads, left_);
    if (!surfels.ok()) return std::move(surfels).error();
    scene.surfels.push_back({keep(std::move(surfels).value()), glm::dmat4(1)});
  }
  return scene;
}

std::vector<glm::dvec3> Drawing::outline() const {
  return mesh_ ? corners_ : render::outline(scene_);
}

Result<render::RenderedImage> Drawing::draw_mesh(const render::Camera& camera,
                                                 const render::RenderOptions& options) const {
  double far = 0;
  const glm::dvec3 ahead = camera.orientation * glm::dvec3(0, 0, -1);
  for (const glm::dvec3& point : corners_)
    far = std::max(far, glm::dot(point - camera.position, ahead));
  const Shot shot{depth_camera(camera, options, std::max(far, camera.near_plane) * 1.01 + 1e-6),
                  options.width, options.height};
  // 5 and 7 samples do not divide the rows of a band.
  const unsigned samples =
      options.samples == 5 || options.samples == 7 ? options.samples + 1 : options.samples;
  auto picture = draw_picture(*look_, shot, samples, options.background, session_.options.threads,
                              session_.limits);
  if (!picture.ok()) return std::move(picture).error();
  render::RenderedImage image{std::move(picture).value(), {}};
  if (!options.depth) return image;
  auto depth = draw_distances(*look_, shot, session_.options.threads, session_.limits);
  if (!depth.ok()) return std::move(depth).error();
  image.depth = std::move(depth).value();
  return image;
}

Result<render::RenderedImage> Drawing::draw(const render::Camera& camera,
                                            const render::RenderOptions& options) const {
  if (mesh_) return draw_mesh(camera, options);
  return render::render(scene_, camera, options, session_.limits);
}

uint64_t Drawing::voxels() const {
  uint64_t voxels = 0;
  for (const render::VoxelCloud& cloud : scene_.voxels) voxels += cloud.tree->voxels();
  return voxels;
}

std::string Drawing::size() const {
  if (mesh_) return counted(mesh_->triangles.size(), "triangle");
  uint64_t pieces = 0;
  for (const render::SurfelCloud& cloud : scene_.surfels) pieces += cloud.surfels->size();
  if (pieces == 0) return counted(voxels(), "voxel");
  if (voxels() == 0) return counted(pieces, "point");
  return counted(voxels(), "voxel") + " and " + counted(pieces, "point");
}

}  // namespace afx::tools
