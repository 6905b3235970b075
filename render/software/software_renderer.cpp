// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <atomic>
#include <set>
#include <string>
#include <utility>

#include "codec/octree_voxels.h"
#include "codec/parallel.h"
#include "render/renderer.h"
#include "render/software/frame.h"
#include "render/software/tile_painter.h"

namespace afx::render {
namespace {

/// Textures at all sizes: four thirds of four bytes a pixel. Each is made once.
Status check_pictures(const Scene& scene, const Limits& limits) {
  std::set<const Picture*> pictures;
  for (const Shape& shape : scene.shapes) pictures.insert(shape.look->texture.get());
  if (scene.backdrop)
    for (const auto& picture : scene.backdrop->pictures) pictures.insert(picture.get());
  uint64_t pixels = 0;
  for (const Picture* picture : pictures)
    if (picture != nullptr) pixels += uint64_t{picture->width} * picture->height;
  if (pixels <= limits.picture_pixels && pixels * 16 / 3 <= limits.memory) return {};
  return Error{Errc::limit_exceeded, Place::none(),
               "textures of " + std::to_string(pixels) + " pixels need more than the limits allow"};
}

/// Corners in the camera's system, and boxes with one to four places in cells.
uint64_t shape_bytes(const Scene& scene) {
  uint64_t bytes = scene.shapes.size() * sizeof(ShapeView);
  for (const Shape& shape : scene.shapes) {
    const Geometry& geometry = *shape.geometry;
    bytes += geometry.positions.size() * sizeof(glm::dvec3) +
             geometry.indices.size() / corners_of(geometry.kind) * (sizeof(Box) + 16);
  }
  return bytes;
}

/// Splats of surfels with one to four places in cells, shapes, and the picture.
Status check_memory(const Scene& scene, const RenderOptions& options, const Limits& limits) {
  const uint64_t clouds = scene.voxels.size() * codec::kMortonLevels * sizeof(OctreeView::Size);
  uint64_t surfels = 0;
  for (const SurfelCloud& cloud : scene.surfels) surfels += cloud.surfels->size();
  const uint64_t pixels = uint64_t{options.width} * options.height;
  const uint64_t bytes = clouds + surfels * (SplatTiles::kBytes + 16) + shape_bytes(scene) +
                         pixels * (options.depth ? 8 : 4);
  if (bytes <= limits.memory && pixels <= limits.picture_pixels) return {};
  return Error{Errc::limit_exceeded, Place::none(),
               "drawing " + std::to_string(surfels) + " surfels and " +
                   std::to_string(scene.shapes.size()) + " shapes into " + std::to_string(pixels) +
                   " pixels needs more than the limits allow"};
}

void paint(const Frame& frame, RenderedImage& image) {
  // Painters are costly to make, so each thread keeps one; which tiles it paints is open.
  const uint32_t count = frame.grid.columns * frame.grid.rows;
  const unsigned threads = thread_count(frame.options.threads);
  std::atomic<uint32_t> next{0};
  parallel_for(threads, threads, [&](size_t) {
    TilePainter painter(frame);
    for (uint32_t tile = next++; tile < count; tile = next++)
      painter.paint(tile % frame.grid.columns, tile / frame.grid.columns, image);
  });
}

class SoftwareRenderer : public Renderer {
 public:
  explicit SoftwareRenderer(const Limits& limits) : limits_(limits) {}

  [[nodiscard]] std::string name() const override { return "software"; }

  Status set_scene(Scene scene) override {
    scene_ = {};
    pictures_ = {};
    if (Status s = check_scene(scene); !s.ok()) return s;
    if (Status s = check_pictures(scene, limits_); !s.ok()) return s;
    scene_ = std::move(scene);
    for (const Shape& shape : scene_.shapes) pictures_.add(shape.look->texture);
    if (scene_.backdrop)
      for (const auto& picture : scene_.backdrop->pictures) pictures_.add(picture);
    return {};
  }

  Status draw(const Camera& camera, const RenderOptions& options, RenderedImage& image) override {
    if (Status s = check_options(options); !s.ok()) return s;
    if (Status s = check_camera(camera); !s.ok()) return s;
    if (Status s = check_memory(scene_, options, limits_); !s.ok()) return s;
    resize(image, options);
    paint(Frame(scene_, pictures_, camera, options), image);
    return {};
  }

 private:
  Limits limits_;
  Scene scene_;
  MipPictures pictures_;
};

}  // namespace

std::unique_ptr<Renderer> make_software_renderer(const Limits& limits) {
  return std::make_unique<SoftwareRenderer>(limits);
}

}  // namespace afx::render
