// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/dibr_model.h"

#include <algorithm>
#include <map>
#include <utility>

#include "afx/depth_image_nodes.h"
#include "afx/octree_image.h"
#include "nodes/traversal.h"

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

class ModelReader {
 public:
  ModelReader(const UrlBase& base, const Limits& limits, Diagnostics& diagnostics)
      : base_(base), left_(limits), diagnostics_(diagnostics) {}

  Result<DibrModel> read(const nodes::DibrObject& object) {
    const std::vector<uint32_t> nodes = main_nodes(object);
    if (const auto known = known_.find(nodes); !nodes.empty() && known != known_.end())
      return DibrModel{object.to_world, known->second};
    auto shape = object.kind == nodes::DibrObject::Kind::octree_image ? read_octree(object)
                                                                      : read_images(object);
    if (!shape.ok()) return std::move(shape).error();
    if (!nodes.empty()) known_[nodes] = shape.value();
    return DibrModel{object.to_world, shape.value()};
  }

 private:
  // The numbers of an object's nodes; none if one of them stands in a PROTO.
  static std::vector<uint32_t> main_nodes(const nodes::DibrObject& object) {
    std::vector<uint32_t> numbers;
    for (const nodes::NodeView& node : object.nodes) {
      if (node.node().scope != nodes::Scene::kMain) return {};
      numbers.push_back(node.id().value);
    }
    return numbers;
  }

  using Shared = std::shared_ptr<const DibrShape>;

  Result<Shared> read_octree(const nodes::DibrObject& object) {
    auto octree = read_octree_model(object.nodes.front(), base_, left_, diagnostics_);
    if (!octree.ok()) return std::move(octree).error();
    take(bytes_of(octree.value()));
    return Shared(std::make_shared<DibrShape>(std::move(octree).value()));
  }

  Result<Shared> read_images(const nodes::DibrObject& object) {
    std::vector<DepthImage> images;
    for (const nodes::NodeView& node : object.nodes) {
      auto image = read_depth_image(node, base_, left_, diagnostics_);
      if (!image.ok()) return std::move(image).error();
      take(bytes_of(image.value()));
      images.push_back(std::move(image).value());
    }
    return Shared(std::make_shared<DibrShape>(std::move(images)));
  }

  void take(uint64_t bytes) { left_.memory -= std::min(left_.memory, bytes); }

  const UrlBase& base_;
  Limits left_;
  Diagnostics& diagnostics_;
  std::map<std::vector<uint32_t>, std::shared_ptr<const DibrShape>> known_;  // by numbers of nodes
};

}  // namespace

Result<std::vector<DibrModel>> read_dibr_models(const nodes::Scene& scene, const UrlBase& base,
                                                const Limits& limits, Diagnostics& diagnostics) {
  const auto objects = nodes::find_dibr_objects(scene);
  if (!objects.ok()) return objects.error();
  std::vector<DibrModel> models;
  ModelReader reader(base, limits, diagnostics);
  for (const nodes::DibrObject& object : objects.value()) {
    auto model = reader.read(object);
    if (!model.ok()) return std::move(model).error();
    models.push_back(std::move(model).value());
  }
  return models;
}

}  // namespace afx
