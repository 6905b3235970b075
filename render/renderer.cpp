// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/renderer.h"

namespace afx::render {
namespace {

Error bad(const std::string& text) { return {Errc::bad_argument, Place::none(), text}; }

}  // namespace

Status check_options(const RenderOptions& options) {
  const auto side_ok = [](uint32_t side) { return side >= 1 && side <= kMaxSide; };
  if (!side_ok(options.width) || !side_ok(options.height)) {
    return bad("a picture of " + std::to_string(options.width) + " x " +
               std::to_string(options.height) + " pixels (expected 1 to " +
               std::to_string(kMaxSide) + " each way)");
  }
  if (options.samples < 1 || options.samples > 8) {
    return bad("samples is " + std::to_string(options.samples) + " (expected 1 to 8)");
  }
  if (!(options.splat_scale >= 1 && options.splat_scale <= 8)) {
    return bad("splat scale is " + std::to_string(options.splat_scale) + " (expected 1 to 8)");
  }
  if (!(options.coarseness >= 0 && options.coarseness <= 8)) {
    return bad("coarseness is " + std::to_string(options.coarseness) + " (expected 0 to 8)");
  }
  return {};
}

void resize(RenderedImage& image, const RenderOptions& options) {
  const size_t pixels = size_t{options.width} * options.height;
  image.picture.width = options.width;
  image.picture.height = options.height;
  image.picture.components = 4;
  image.picture.samples.resize(pixels * 4);
  image.depth.resize(options.depth ? pixels : 0);
}

Result<RenderedImage> render(const Scene& scene, const Camera& camera, const RenderOptions& options,
                             const Limits& limits) {
  const std::unique_ptr<Renderer> renderer = make_software_renderer(limits);
  if (Status s = renderer->set_scene(scene); !s.ok()) return s.error();
  RenderedImage image;
  if (Status s = renderer->draw(camera, options, image); !s.ok()) return s.error();
  return image;
}

}  // namespace afx::render
