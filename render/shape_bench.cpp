// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "render/renderer.h"
#include "render/test_shapes.h"

namespace afx::render {
namespace {

/// A sphere of 2 * rows * columns triangles with smooth normals.
Geometry sphere(uint32_t rows, uint32_t columns) {
  Geometry geometry;
  for (uint32_t j = 0; j <= rows; ++j) {
    const float polar =
        std::numbers::pi_v<float> * static_cast<float>(j) / static_cast<float>(rows);
    for (uint32_t i = 0; i <= columns; ++i) {
      const float part = static_cast<float>(i) / static_cast<float>(columns);
      const float around = 2 * std::numbers::pi_v<float> * part;
      const glm::vec3 p(std::sin(polar) * std::sin(around), std::cos(polar),
                        std::sin(polar) * std::cos(around));
      geometry.positions.push_back(p);
      geometry.normals.push_back(p);
      geometry.texture_coordinates.emplace_back(part, static_cast<float>(j));
    }
  }
  for (uint32_t j = 0; j < rows; ++j) {
    for (uint32_t i = 0; i < columns; ++i) {
      const uint32_t a = j * (columns + 1) + i, b = a + columns + 1;
      for (const uint32_t k : {a, b, b + 1, a, b + 1, a + 1}) geometry.indices.push_back(k);
    }
  }
  return geometry;
}

void draw(benchmark::State& state, const Look& look) {
  Scene scene{.shapes = {shape_of(sphere(200, 250), look)}, .headlight = true};
  const auto camera = fit_camera(outline(scene), View{}, 1);
  if (!camera.ok()) return state.SkipWithError("no camera");
  const RenderOptions options{.samples = static_cast<unsigned>(state.range(0)),
                              .threads = static_cast<unsigned>(state.range(1))};
  const auto triangles = static_cast<int64_t>(scene.shapes[0].geometry->indices.size() / 3);
  const auto renderer = make_software_renderer();
  if (!renderer->set_scene(scene).ok()) return state.SkipWithError("no scene");
  RenderedImage image;
  for (auto _ : state) {
    const Status drawn = renderer->draw(camera.value(), options, image);
    benchmark::DoNotOptimize(drawn);
  }
  state.SetItemsProcessed(state.iterations() * triangles);
}

/// A sphere of 100,000 triangles under the headlight, filling a picture of 1024 x 1024.
/// Arguments: samples each way, threads.
void draw_matt_sphere(benchmark::State& state) { draw(state, {}); }

/// The same with a texture and highlights.
void draw_shiny_sphere(benchmark::State& state) {
  auto picture = std::make_shared<Picture>(256, 256, 3);
  for (size_t k = 0; k < picture->samples.size(); ++k)
    picture->samples[k] = static_cast<uint8_t>(k * 7);
  draw(state, {.specular = glm::vec3(0.5F), .texture = picture});
}

/// The same, transparent.
void draw_glass_sphere(benchmark::State& state) { draw(state, {.transparency = 0.5F}); }

void arguments(benchmark::internal::Benchmark* bench) {
  bench->Args({1, 1})->Args({1, 2})->Args({3, 1})->Args({3, 2});
  bench->UseRealTime()->Unit(benchmark::kMillisecond);
}
BENCHMARK(draw_matt_sphere)->Apply(arguments);
BENCHMARK(draw_shiny_sphere)->Apply(arguments);
BENCHMARK(draw_glass_sphere)->Apply(arguments);

}  // namespace
}  // namespace afx::render

BENCHMARK_MAIN();
