// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The OpenGL renderer, and for comparison the least that OpenGL can do with the same voxels.
#include <benchmark/benchmark.h>

#include <glm/gtc/matrix_transform.hpp>
#include <string>
#include <utility>
#include <vector>

#include "render/gl/egl_context.h"
#include "render/gl/gl_objects.h"
#include "render/gl/gl_renderer.h"
#include "render/test_surfels.h"

namespace afx::render {
namespace {

constexpr uint32_t kSide = 1024;

bool has_context() {
  static const auto context = EglContext::make();
  return context.ok();
}

/// A full sphere shell, about 880,000 voxels, filling a picture of 1024 x 1024.
const TestModel& sphere() {
  static const TestModel model = [] {
    TestModelMaker maker(9);
    add_sphere(maker, 9, 0.423, {200, 150, 90, 255});
    return maker.make();
  }();
  return model;
}

void draw(benchmark::State& state, const Scene& scene, size_t splats) {
  if (!has_context()) return state.SkipWithError("no OpenGL");
  const auto camera = fit_camera(outline(scene), View{}, 1);
  auto renderer = make_gl_renderer();
  if (!camera.ok() || !renderer.ok()) return state.SkipWithError("no renderer");
  const RenderOptions options{.width = kSide,
                              .height = kSide,
                              .coarseness = static_cast<double>(state.range(1)),
                              .samples = static_cast<unsigned>(state.range(0))};
  RenderedImage image;
  if (!renderer.value()->set_scene(scene).ok() ||
      !renderer.value()->draw(camera.value(), options, image).ok())
    return state.SkipWithError("no picture");
  for (auto _ : state) {
    const Status drawn = renderer.value()->draw(camera.value(), options, image);
    benchmark::DoNotOptimize(drawn);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(splats));
  state.counters["splats"] = static_cast<double>(splats);
  state.SetLabel(renderer.value()->name());
}

/// Arguments: samples each way, coarseness (0: every voxel).
void gl_sphere(benchmark::State& state) { draw(state, sphere().scene(), sphere().codes.size()); }
BENCHMARK(gl_sphere)
    ->Args({1, 0})
    ->Args({1, 1})
    ->Args({3, 0})
    ->Args({3, 1})
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

/// The same sphere as six cameras see it, a million surfels.
void gl_surfel_sphere(benchmark::State& state) {
  Surfels surfels;
  add_surfel_sphere(surfels, 0.423, 532, {200, 150, 90, 255});
  draw(state, scene_of(surfels), surfels.size());
}
BENCHMARK(gl_surfel_sphere)
    ->Args({1, 0})
    ->Args({3, 0})
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

constexpr char kPointVertex[] = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 colour;
uniform vec4 to_clip0, to_clip1, to_clip2, to_clip3;
flat out vec4 shown;
void main() {
  vec4 at = vec4(position, 1.0);
  gl_Position = vec4(dot(to_clip0, at), dot(to_clip1, at), dot(to_clip2, at), dot(to_clip3, at));
  gl_PointSize = 1.0;
  shown = colour;
}
)";
constexpr char kPointFragment[] = R"(
flat in vec4 shown;
layout(location = 0) out vec4 colour;
void main() { colour = shown; }
)";

struct PointVertex {
  glm::vec3 position;
  Rgba8 colour;
};

std::vector<PointVertex> sphere_points() {
  std::vector<PointVertex> points;
  const double side = std::ldexp(1.0, -static_cast<int>(sphere().level));
  for (size_t i = 0; i < sphere().codes.size(); ++i) {
    const Voxel v = codec::morton_decode(sphere().codes[i]);
    points.push_back(
        {glm::vec3((glm::dvec3(v.x, v.y, v.z) + 0.5) * side - 0.5), sphere().colours[i]});
  }
  return points;
}

/// World to clip coordinates.
glm::dmat4 matrix_of(const Camera& camera) {
  glm::dmat4 to_view = glm::mat4_cast(glm::conjugate(camera.orientation));
  to_view = glm::translate(to_view, -camera.position);
  return glm::perspective(camera.field_of_view, 1.0, camera.near_plane, 100.0) * to_view;
}

GlTexture attached(const GlFramebuffer& to, GLenum place, GLenum format) {
  GlTexture texture = GlTexture::make();
  glBindTexture(GL_TEXTURE_2D, texture.id());
  glTexStorage2D(GL_TEXTURE_2D, 1, format, kSide, kSide);
  glBindFramebuffer(GL_FRAMEBUFFER, to.id());
  glFramebufferTexture2D(GL_FRAMEBUFFER, place, GL_TEXTURE_2D, texture.id(), 0);
  return texture;
}

/// Each voxel as a point of one pixel, in one pass with a depth test, and read back. It leaves
/// holes.
void plain_points(benchmark::State& state) {
  if (!has_context()) return state.SkipWithError("no OpenGL");
  const auto features = GlFeatures::find();
  const auto camera = fit_camera(outline(sphere().scene()), View{}, 1);
  if (!features.ok() || !camera.ok()) return state.SkipWithError("no camera");
  const auto program = GlProgram::make(features.value(), "", kPointVertex, kPointFragment);
  if (!program.ok()) return state.SkipWithError("no program");
  const std::vector<PointVertex> points = sphere_points();
  const GlArray array = GlArray::make();
  const GlBuffer buffer = GlBuffer::make();
  glBindVertexArray(array.id());
  glBindBuffer(GL_ARRAY_BUFFER, buffer.id());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(points.size() * sizeof(PointVertex)),
               points.data(), GL_STATIC_DRAW);
  glEnableVertexAttribArray(0);
  glEnableVertexAttribArray(1);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(PointVertex), nullptr);
  glVertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(PointVertex),
                        reinterpret_cast<const void*>(sizeof(glm::vec3)));
  const glm::mat4 matrix(glm::transpose(matrix_of(camera.value())));
  const GlFramebuffer frame = GlFramebuffer::make();
  const GlTexture colours = attached(frame, GL_COLOR_ATTACHMENT0, GL_RGBA8);
  const GlTexture depths = attached(frame, GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F);
  std::vector<uint8_t> picture(size_t{kSide} * kSide * 4);
  for (auto _ : state) {
    glBindFramebuffer(GL_FRAMEBUFFER, frame.id());
    glViewport(0, 0, kSide, kSide);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDisable(GL_BLEND);
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    program.value().use();
    program.value().set("to_clip0", matrix[0]);
    program.value().set("to_clip1", matrix[1]);
    program.value().set("to_clip2", matrix[2]);
    program.value().set("to_clip3", matrix[3]);
    glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(points.size()));
    glReadPixels(0, 0, kSide, kSide, GL_RGBA, GL_UNSIGNED_BYTE, picture.data());
  }
  size_t seen = 0;
  for (size_t i = 3; i < picture.size(); i += 4) seen += picture[i] != 0 ? 1U : 0U;
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(points.size()));
  state.counters["pixels"] = static_cast<double>(seen);
  state.SetLabel(features.value().name);
}
BENCHMARK(plain_points)->MeasureProcessCPUTime()->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace afx::render

BENCHMARK_MAIN();
