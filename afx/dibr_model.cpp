// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/dibr_model.h"

#include <algorithm>
#include <utility>

#include "afx/depth_image_nodes.h"
#include "afx/octree_image.h"

namespace afx {
namespace {

uint64_t bytes_of(const DepthImage& image) {
  if (const auto* simple = std::get_if<SimpleTexture>(&image.texture))
    return simple->colour.samples.size() + simple->depth.samples.size() * sizeof(uint16_t);
  const auto& points = std::get<PointTexture>(image.texture);
  return (points.starts.size() + points.depths.size()) * sizeof(uint32_t) +
         points.colours.size() * sizeof(Rgba8);
}

uint64_t bytes_of(const OctreeModel& model) {
  uint64_t bytes = model.fields.octree.size() + model.fields.voxel_image_index.size();
  for (const ReferenceImage& image : model.images) bytes += image.picture.samples.size();
  return bytes;
}

// What the fields of an object's nodes depend on.
std::vector<uint32_t> key_of(const nodes::DibrObject& object) {
  std::vector<uint32_t> key;
  for (const nodes::NodeView& node : object.nodes) {
    const std::vector<uint32_t> path = node.path();
    key.push_back(static_cast<uint32_t>(path.size()));
    key.insert(key.end(), path.begin(), path.end());
  }
  return key;
}

}  // namespace

Result<DibrModel> DibrModelReader::read(const nodes::DibrObject& object, Diagnostics& diagnostics) {
  std::vector<uint32_t> key = key_of(object);
  if (const auto known = known_.find(key); known != known_.end())
    return DibrModel{object.to_world, known->second};
  auto shape = object.kind == nodes::DibrObject::Kind::octree_image
                   ? read_octree(object, diagnostics)
                   : read_images(object, diagnostics);
  if (!shape.ok()) return std::move(shape).error();
  take(key.size() * sizeof(uint32_t));
  known_.emplace(std::move(key), shape.value());
  return DibrModel{object.to_world, shape.value()};
}

Result<DibrModelReader::Shared> DibrModelReader::read_octree(const nodes::DibrObject& object,
                                                             Diagnostics& diagnostics) {
  auto octree = read_octree_model(object.nodes.front(), base_, left_, diagnostics);
  if (!octree.ok()) return std::move(octree).error();
  take(bytes_of(octree.value()));
  return Shared(std::make_shared<DibrShape>(std::move(octree).value()));
}

Result<DibrModelReader::Shared> DibrModelReader::read_images(const nodes::DibrObject& object,
                                                             Diagnostics& diagnostics) {
  std::vector<DepthImage> images;
  for (const nodes::NodeView& node : object.nodes) {
    auto image = read_depth_image(node, base_, left_, diagnostics);
    if (!image.ok()) return std::move(image).error();
    take(bytes_of(image.value()));
    images.push_back(std::move(image).value());
  }
  return Shared(std::make_shared<DibrShape>(std::move(images)));
}

void DibrModelReader::take(uint64_t bytes) { left_.memory -= std::min(left_.memory, bytes); }

Result<std::vector<DibrModel>> read_dibr_models(const nodes::Scene& scene, const UrlBase& base,
                                                const Limits& limits, Diagnostics& diagnostics) {
  const auto objects = nodes::find_dibr_objects(scene);
  if (!objects.ok()) return objects.error();
  std::vector<DibrModel> models;
  Limits left = limits;
  DibrModelReader reader(base, left);
  for (const nodes::DibrObject& object : objects.value()) {
    auto model = reader.read(object, diagnostics);
    if (!model.ok()) return std::move(model).error();
    models.push_back(std::move(model).value());
  }
  return models;
}

}  // namespace afx
