// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <atomic>
#include <utility>

#include "codec/parallel.h"
#include "render/renderer.h"
#include "render/software/frame.h"
#include "render/software/tile_painter.h"

namespace afx::render {
namespace {

/// Splats of surfels with one to four places in cells, and the picture.
Status check_memory(const Scene& scene, const RenderOptions& options, const Limits& limits) {
  uint64_t surfels = 0;
  for (const SurfelCloud& cloud : scene.surfels) surfels += cloud.surfels->size();
  const uint64_t pixels = uint64_t{options.width} * options.height;
  const uint64_t bytes =
      surfels * (sizeof(Splat) + 16 + sizeof(Slant)) + pixels * (options.depth ? 8 : 4);
  if (bytes <= limits.memory && pixels <= limits.picture_pixels) return {};
  return Error{Errc::limit_exceeded, Place::none(),
               "drawing " + std::to_string(surfels) + " surfels into " + std::to_string(pixels) +
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
    if (Status s = check_scene(scene); !s.ok()) return s;
    scene_ = std::move(scene);
    return {};
  }

  Status draw(const Camera& camera, const RenderOptions& options, RenderedImage& image) override {
    if (Status s = check_options(options); !s.ok()) return s;
    if (Status s = check_camera(camera); !s.ok()) return s;
    if (Status s = check_memory(scene_, options, limits_); !s.ok()) return s;
    resize(image, options);
    paint(Frame(scene_, camera, options), image);
    return {};
  }

 private:
  Limits limits_;
  Scene scene_;
};

}  // namespace

std::unique_ptr<Renderer> make_software_renderer(const Limits& limits) {
  return std::make_unique<SoftwareRenderer>(limits);
}

}  // namespace afx::render
