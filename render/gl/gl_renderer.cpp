// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/gl/gl_renderer.h"

#include <algorithm>
#include <set>
#include <utility>

#include "render/gl/gl_resolve.h"
#include "render/gl/gl_shapes.h"
#include "render/gl/gl_splats.h"
#include "render/gl/gl_target.h"

namespace afx::render {
namespace {

Status check_upload(const Scene& scene, const Limits& limits) {
  uint64_t bytes = 0;
  std::set<const void*> seen;
  for (const VoxelCloud& cloud : scene.voxels)
    if (seen.insert(cloud.tree.get()).second) bytes += GlTree::bytes(*cloud.tree);
  for (const SurfelCloud& cloud : scene.surfels)
    if (seen.insert(cloud.surfels.get()).second)
      bytes += cloud.surfels->size() * sizeof(SurfelVertex);
  uint64_t pixels = 0;
  const auto add_picture = [&](const Picture* picture) {
    if (picture != nullptr && seen.insert(picture).second)
      pixels += uint64_t{picture->width} * picture->height;
  };
  for (const Shape& shape : scene.shapes) {
    add_picture(shape.look->texture.get());
    if (seen.insert(shape.geometry.get()).second)
      bytes += shape.geometry->positions.size() * 44 + shape.geometry->indices.size() * 48;
    if (shape.lights.size() > kMostLights) {
      return Error{Errc::limit_exceeded, Place::none(),
                   std::to_string(shape.lights.size()) +
                       " lights fall on a shape (expected at most " + std::to_string(kMostLights) +
                       " for OpenGL)"};
    }
  }
  if (scene.backdrop)
    for (const auto& picture : scene.backdrop->pictures) add_picture(picture.get());
  bytes += pixels * 16 / 3;
  if (bytes <= limits.memory && pixels <= limits.picture_pixels) return {};
  return Error{Errc::limit_exceeded, Place::none(),
               "a scene of " + std::to_string(bytes) + " bytes for OpenGL (expected at most " +
                   std::to_string(limits.memory) + ")"};
}

Status check_picture(const RenderOptions& options, const Limits& limits) {
  const uint64_t pixels = uint64_t{options.width} * options.height;
  if (pixels <= limits.picture_pixels && pixels * (options.depth ? 8 : 4) <= limits.memory)
    return {};
  return Error{Errc::limit_exceeded, Place::none(),
               "a picture of " + std::to_string(pixels) + " pixels is more than the limits allow"};
}

/// What was bound when a call began, bound again when it ends.
class Bindings {
 public:
  Bindings() {
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &draw_);
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read_);
    glGetIntegerv(GL_VIEWPORT, viewport_);
  }
  Bindings(const Bindings&) = delete;
  Bindings& operator=(const Bindings&) = delete;
  ~Bindings() {
    bind();
    glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read_));
    glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
  }

  void bind() const { glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(draw_)); }
  [[nodiscard]] const GLint* viewport() const { return viewport_; }

 private:
  GLint draw_ = 0, read_ = 0;
  GLint viewport_[4] = {};
};

/// State that others may have left and that all passes need otherwise.
void set_state(bool es) {
  constexpr GLenum kOff[] = {GL_CULL_FACE, GL_SCISSOR_TEST,        GL_STENCIL_TEST,
                             GL_DITHER,    GL_POLYGON_OFFSET_FILL, GL_SAMPLE_ALPHA_TO_COVERAGE};
  for (const GLenum off : kOff) glDisable(off);
  if (!es) {
    glDisable(GL_FRAMEBUFFER_SRGB);
    glDisable(GL_COLOR_LOGIC_OP);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glPointParameteri(GL_POINT_SPRITE_COORD_ORIGIN, GL_UPPER_LEFT);
    if (epoxy_gl_version() >= 45 || epoxy_has_gl_extension("GL_ARB_clip_control"))
      glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
  }
  glDepthRangef(0, 1);
  for (GLuint unit = 0; unit < 16; ++unit) glBindSampler(unit, 0);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
}

class TwoPassRenderer : public GlRenderer {
 public:
  TwoPassRenderer(const Limits& limits, GlFeatures features, GlSplats splats, GlShapes shapes,
                  GlResolve resolve)
      : limits_(limits),
        features_(std::move(features)),
        splats_(std::move(splats)),
        shapes_(std::move(shapes)),
        resolve_(std::move(resolve)) {}

  [[nodiscard]] std::string name() const override { return features_.name; }

  Status set_scene(Scene scene) override {
    Status status = check_scene(scene);
    if (status.ok()) status = check_upload(scene, limits_);
    take(status.ok() ? std::move(scene) : Scene{});
    if (status.ok()) status = check_gl("uploading a scene");
    if (!status.ok()) take({});
    return status;
  }

  Status draw(const Camera& camera, const RenderOptions& options, RenderedImage& image) override {
    if (Status s = check_options(options); !s.ok()) return s;
    if (Status s = check_picture(options, limits_); !s.ok()) return s;
    const Bindings bindings;
    return draw_tiles(camera, options, [&](const GlView& view, const GlBackdrop& backdrop) {
      if (view.tile.x == 0 && view.tile.y == 0) resize(image, options);
      target_.begin_pixels(view.tile, options.depth);
      resolve_.draw(view, backdrop, 0, 0, true, options.depth, has_layers());
      target_.read(view.tile, image);
    });
  }

  Status present(const Camera& camera, const RenderOptions& wanted) override {
    const Bindings bindings;
    const GLint* const port = bindings.viewport();
    RenderOptions options = wanted;
    options.width = static_cast<uint32_t>(std::max(port[2], 0));
    options.height = static_cast<uint32_t>(std::max(port[3], 0));
    options.depth = false;
    if (Status s = check_options(options); !s.ok()) return s;
    return draw_tiles(camera, options, [&](const GlView& view, const GlBackdrop& backdrop) {
      const GlTile& tile = view.tile;
      const GLint x = port[0] + static_cast<GLint>(tile.x);
      const GLint y = port[1] + static_cast<GLint>(options.height - tile.y - tile.height);
      bindings.bind();
      glViewport(x, y, static_cast<GLsizei>(tile.width), static_cast<GLsizei>(tile.height));
      resolve_.draw(view, backdrop, x, y, false, false, has_layers());
    });
  }

 private:
  void take(Scene scene) {
    scene_ = std::move(scene);
    splats_.set_scene(scene_);
    shapes_.set_scene(scene_);
    upload_pictures();
  }

  void upload_pictures() {
    GlPictures pictures;
    for (const Shape& shape : scene_.shapes) pictures.add(shape.look->texture, pictures_);
    if (scene_.backdrop)
      for (const auto& picture : scene_.backdrop->pictures) pictures.add(picture, pictures_);
    pictures_ = std::move(pictures);
  }

  [[nodiscard]] bool has_layers() const { return !scene_.shapes.empty() || scene_.fog; }

  /// Draws all samples of a tile.
  void draw_samples(GlSplats::Frame& splats, const GlShapes::Frame& shapes,
                    const GlView& view) const {
    const bool walls = shapes.has_walls;
    if (walls) {
      target_.begin_walls();
      shapes_.draw_walls(shapes, scene_, view);
    }
    splats_.draw(splats, view, target_, walls);
    target_.bind_samples(false);
    if (!has_layers()) return;
    if (walls) target_.bind_walls();
    target_.begin_finish();
    resolve_.finish(view, scene_, walls);
    if (!shapes.glass.empty()) {
      target_.begin_glass();
      shapes_.draw_glass(shapes, scene_, view);
    }
    target_.bind_samples(true);
  }

  /// Calls finish(view, backdrop) after the samples of each tile are drawn.
  template <class Finish>
  Status draw_tiles(const Camera& camera, const RenderOptions& options, const Finish& finish) {
    if (Status s = check_camera(camera); !s.ok()) return s;
    set_state(features_.es);
    const Lens lens(camera, options);
    GlSplats::Frame splats = splats_.frame(scene_, lens, options);
    const GlShapes::Frame shapes = shapes_.frame(scene_, pictures_, lens);
    GlView view(lens, options, std::max(splats.farthest, shapes.farthest),
                (features_.most_point - 1) / 2);
    const GlBackdrop backdrop(options.backdrop && scene_.backdrop ? &*scene_.backdrop : nullptr,
                              pictures_);
    const uint32_t side = kMostTileSamples / options.samples;
    const uint32_t width = std::min(side, options.width), height = std::min(side, options.height);
    if (Status s = target_.reserve(width, height, options.samples, has_layers()); !s.ok()) return s;
    for (uint32_t y = 0; y < options.height; y += side) {
      for (uint32_t x = 0; x < options.width; x += side) {
        view.set_tile(
            {x, y, std::min(side, options.width - x), std::min(side, options.height - y)});
        draw_samples(splats, shapes, view);
        finish(view, backdrop);
      }
    }
    return check_gl("drawing");
  }

  Limits limits_;
  GlFeatures features_;
  Scene scene_;
  GlSplats splats_;
  GlShapes shapes_;
  GlPictures pictures_;
  GlResolve resolve_;
  GlTarget target_;
};

}  // namespace

Result<std::unique_ptr<GlRenderer>> make_gl_renderer(const Limits& limits) {
  auto features = GlFeatures::find();
  if (!features.ok()) return features.error();
  auto splats = GlSplats::make(features.value());
  if (!splats.ok()) return splats.error();
  auto shapes = GlShapes::make(features.value());
  if (!shapes.ok()) return shapes.error();
  auto resolve = GlResolve::make(features.value());
  if (!resolve.ok()) return resolve.error();
  if (Status s = check_gl("making shaders"); !s.ok()) return s.error();
  return std::unique_ptr<GlRenderer>(std::make_unique<TwoPassRenderer>(
      limits, std::move(features).value(), std::move(splats).value(), std::move(shapes).value(),
      std::move(resolve).value()));
}

}  // namespace afx::render
