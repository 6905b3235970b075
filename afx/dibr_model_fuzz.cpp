// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Scene texts with DIBR nodes: reading, pieces of surface, drawing and layering end well; threads
// change nothing; a PointTexture that is written is read again.
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string_view>

#include "afx/depth_image_nodes.h"
#include "afx/dibr_model.h"
#include "afx/known_nodes.h"
#include "afx/surfel_drawing.h"
#include "afx/surfel_layers.h"
#include "afx/surfel_sources.h"
#include "nodes/scene_reader.h"

namespace {

using namespace afx;

void require(bool claim) {
  if (!claim) std::abort();
}

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

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const Limits limits = small_limits();
  Diagnostics diagnostics;
  const auto scene = nodes::read_scene_text(text, limits, diagnostics);
  if (!scene.ok()) return 0;
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
