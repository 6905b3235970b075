// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Scene texts with DIBR nodes: reading, pieces of surface, drawing and layering end well; threads
// change nothing; a PointTexture that is written is read again. Everything else that they show
// holds together, also where they inline themselves; reading twice gives the same.
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <memory>
#include <span>
#include <string_view>

#include "afx/depth_image_nodes.h"
#include "afx/dibr_model.h"
#include "afx/known_nodes.h"
#include "afx/surfel_drawing.h"
#include "afx/surfel_layers.h"
#include "afx/surfel_sources.h"
#include "afx/visual_scene.h"
#include "codec/fuzz_test_support.h"
#include "nodes/scene_reader.h"

namespace {

using namespace afx;

Limits small_limits() {
  Limits limits;
  limits.memory = 1 << 24;
  limits.picture_pixels = 1 << 20;
  limits.octree_nodes = 100000;
  limits.scene_values = 100000;
  return limits;
}

// A scene holds colours in single precision: 8 bits come back.
void check_written(const DepthImage& image) {
  const auto* points = std::get_if<PointTexture>(&image.texture);
  if (points == nullptr) return;
  nodes::Scene scene;
  const nodes::NodeId top = add_known(scene, "Group");
  set_known(scene, top, "children",
            std::vector<nodes::NodeId>{add_depth_image(scene, image.camera, *points)});
  scene.add_root(top);
  Diagnostics diagnostics;
  const auto again = read_dibr_models(scene, UrlBase(""), small_limits(), diagnostics);
  require(again.ok());
  const auto& images = *again.value().at(0).depth_images();
  require(std::get<PointTexture>(images.at(0).texture) == *points);
}

void check_drawing(const Surfels& surfels) {
  const DepthCamera camera{{0, 0, 10}, {1, 0, 0, 0}, true, {4, 4}, 1, 100};
  const auto drawn = draw_surfels(surfels, {camera, 9, 7}, 16, 1, small_limits());
  if (drawn.ok()) require(check_depth_image(drawn.value()).ok());
  const auto layered = layer_surfels(surfels, {camera, 9, 7}, 12, small_limits());
  if (layered.ok()) require(check_depth_image(layered.value()).ok());
}

bool is_finite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void check_geometry(const Geometry& geometry) {
  const size_t corners = geometry.positions.size();
  const bool triangles = geometry.kind == Geometry::Kind::triangles;
  const size_t each = triangles ? 3 : geometry.kind == Geometry::Kind::lines ? 2 : 1;
  require(!geometry.indices.empty() && geometry.indices.size() % each == 0);
  for (const uint32_t index : geometry.indices) require(index < corners);
  require(geometry.normals.size() == (triangles ? corners : 0));
  require(geometry.colours.empty() || geometry.colours.size() == corners);
  require(geometry.texture_coordinates.size() == (triangles ? corners : 0));
  for (const glm::vec3& position : geometry.positions) require(is_finite(position));
  for (const glm::vec3& normal : geometry.normals)
    require(std::abs(glm::dot(normal, normal) - 1) < 1e-4F);
  for (const glm::vec3& colour : geometry.colours)
    for (int i = 0; i < 3; ++i) require(colour[i] >= 0 && colour[i] <= 1);
}

void check_visual_scene(const VisualScene& scene) {
  for (const Shape& shape : scene.shapes) {
    check_geometry(*shape.geometry);
    require(shape.look != nullptr);
    for (const uint32_t light : shape.lights) require(light < scene.lights.size());
  }
  for (const Light& light : scene.lights) {
    require(light.radius >= 0 && light.intensity >= 0 && light.intensity <= 1);
    require(std::abs(glm::length(light.direction) - 1) < 1e-6);
  }
  if (!scene.backdrop) return;
  require(scene.backdrop->sky_colours.size() == scene.backdrop->sky_angles.size() + 1);
  require(scene.backdrop->ground_colours.size() <= scene.backdrop->ground_angles.size() + 1);
}

/// Each Inline shows the scene itself, by as many names as it has urls.
void check_visible(const nodes::Scene& scene, const Limits& limits) {
  VisualOptions options;
  options.load_inline = [&](std::span<const nodes::Url> urls,
                            const UrlBase& base) -> Result<InlineScene> {
    if (urls.empty() || urls.front().is_descriptor())
      return Error{Errc::io, Place::none(), "is not there"};
    return InlineScene{{std::shared_ptr<void>(), &scene}, base, urls.front().text};
  };
  Diagnostics diagnostics;
  VisualSceneReader reader(scene, UrlBase("/nowhere"), options, limits);
  const nodes::Viewer viewers[] = {{{0, 0, 10}, {0, 1, 0}}, {{3, 40, 0}, {0, 0, 1}}};
  const auto first = reader.read(viewers[0], diagnostics);
  const auto other = reader.read(viewers[1], diagnostics);
  const auto again = reader.read(viewers[0], diagnostics);
  if (other.ok()) check_visual_scene(other.value());
  if (!first.ok()) return;
  check_visual_scene(first.value());
  require(again.ok() && again.value().shapes.size() == first.value().shapes.size());
  for (size_t i = 0; i < first.value().shapes.size(); ++i)
    require(again.value().shapes[i].geometry == first.value().shapes[i].geometry);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const Limits limits = small_limits();
  Diagnostics diagnostics;
  const auto scene = nodes::read_scene_text(text, limits, diagnostics);
  if (!scene.ok()) return 0;
  check_visible(scene.value(), limits);
  const auto models = read_dibr_models(scene.value(), UrlBase("/nowhere"), limits, diagnostics);
  if (!models.ok()) return 0;
  for (const DibrModel& model : models.value())
    if (const auto* images = model.depth_images())
      for (const DepthImage& image : *images) check_written(image);
  const auto one = surfels_of(models.value(), 1, limits, diagnostics);
  const auto three = surfels_of(models.value(), 3, limits, diagnostics);
  require(one.ok() == three.ok());
  if (!one.ok()) return 0;
  require(one.value().centres.size() == three.value().centres.size());
  require(one.value().colours == three.value().colours);
  check_drawing(one.value());
  return 0;
}
