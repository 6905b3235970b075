// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/scene_maker.h"

#include <algorithm>
#include <utility>

#include "afx/octree_colours.h"
#include "afx/surfel_sources.h"

namespace afx::render {

SceneMaker::SceneMaker(const SceneMakerOptions& options, const Limits& limits)
    : options_(options), left_(limits) {}

Result<Scene> SceneMaker::make(const VisualScene& scene, Diagnostics& diagnostics) {
  auto made = make(std::span(scene.models), diagnostics);
  if (!made.ok()) return made;
  Scene& out = made.value();
  out.shapes = scene.shapes;
  out.lights = scene.lights;
  out.headlight = scene.navigation.headlight;
  out.fog = scene.fog;
  out.backdrop = scene.backdrop;
  return made;
}

Result<Scene> SceneMaker::make(std::span<const DibrModel> models, Diagnostics& diagnostics) {
  forget_what_is_gone();
  Scene scene;
  for (const DibrModel& model : models) {
    const auto ready = find(model, diagnostics);
    if (!ready.ok()) return ready.error();
    if (ready.value()->tree) scene.voxels.push_back({ready.value()->tree, model.to_world});
    for (const auto& surfels : ready.value()->surfels)
      scene.surfels.push_back({surfels, model.to_world});
  }
  return scene;
}

Result<const SceneMaker::Ready*> SceneMaker::find(const DibrModel& model,
                                                  Diagnostics& diagnostics) {
  if (!model.shape) return Error{Errc::bad_argument, Place::none(), "a model without shape"};
  const auto known = known_.find(model.shape.get());
  if (known != known_.end()) return &known->second;
  Ready ready;
  ready.shape = model.shape;
  if (Status made = make_ready(model, ready, diagnostics); !made.ok()) return made.error();
  left_.memory -= ready.bytes;
  return &known_.emplace(model.shape.get(), std::move(ready)).first->second;
}

Status SceneMaker::make_ready(const DibrModel& model, Ready& ready,
                              Diagnostics& diagnostics) const {
  const Status made = model.octree() != nullptr
                          ? add_octree(*model.octree(), left_, ready, diagnostics)
                          : add_images(*model.depth_images(), left_, ready);
  if (!made.ok() || ready.bytes <= left_.memory) return made;
  return Error{Errc::limit_exceeded, Place::none(),
               "what is to be drawn takes more memory than the limit"};
}

Status SceneMaker::add_octree(const OctreeModel& octree, const Limits& left, Ready& ready,
                              Diagnostics& diagnostics) const {
  const unsigned level = std::min(options_.level, octree_levels(octree.resolution));
  const auto coloured = colour_octree(octree, level, options_.threads, left, diagnostics);
  if (!coloured.ok()) return coloured.error();
  const ColouredVoxels& voxels = coloured.value();
  const VoxelSurface surface =
      voxel_surface(voxels.codes, voxels.level, VoxelBlocks(voxels.codes), options_.threads);
  auto tree = VoxelTree::make(voxels.level, voxels.codes, voxels.colours, &surface, left);
  if (!tree.ok()) return std::move(tree).error();
  ready.tree = std::move(tree).value();
  ready.bytes = ready.tree->bytes();
  return {};
}

Status SceneMaker::add_images(const std::vector<DepthImage>& images, Limits left,
                              Ready& ready) const {
  for (const DepthImage& image : images) {
    auto surfels = surfels_of(image, options_.threads, left);
    if (!surfels.ok()) return std::move(surfels).error();
    const uint64_t bytes = surfels.value().size() * kSurfelBytes;
    left.memory -= std::min(left.memory, bytes);
    ready.bytes += bytes;
    ready.surfels.push_back(std::make_shared<Surfels>(std::move(surfels).value()));
  }
  return {};
}

/// Also because another shape may come to lie at the same address.
void SceneMaker::forget_what_is_gone() {
  for (auto at = known_.begin(); at != known_.end();) {
    const bool gone = at->second.shape.expired();
    if (gone) left_.memory += at->second.bytes;
    at = gone ? known_.erase(at) : std::next(at);
  }
}

}  // namespace afx::render
