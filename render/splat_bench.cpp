// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <benchmark/benchmark.h>

#include "render/renderer.h"
#include "render/test_surfels.h"

namespace afx::render {
namespace {

void draw(benchmark::State& state, const Scene& scene, size_t splats) {
  const auto camera = fit_camera(outline(scene), View{}, 1);
  if (!camera.ok()) return state.SkipWithError("no camera");
  const RenderOptions options{.samples = static_cast<unsigned>(state.range(0)),
                              .threads = static_cast<unsigned>(state.range(1))};
  const auto renderer = make_software_renderer();
  if (!renderer->set_scene(scene).ok()) return state.SkipWithError("no scene");
  RenderedImage image;
  for (auto _ : state) {
    const Status drawn = renderer->draw(camera.value(), options, image);
    benchmark::DoNotOptimize(drawn);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(splats));
  state.counters["splats"] = static_cast<double>(splats);
}

TestModel sphere(unsigned level) {
  TestModelMaker maker(level);
  add_sphere(maker, level, 0.423, {200, 150, 90, 255});
  return maker.make();
}

/// A full sphere shell of a 512 model, about 880,000 voxels, filling a picture of 1024 x 1024.
/// Arguments: samples each way, threads.
void draw_sphere(benchmark::State& state) {
  const TestModel model = sphere(9);
  draw(state, {.voxels = {model.smooth_cloud()}}, model.codes.size());
}

/// The same as models of 256 to 2048, one sample a pixel, one thread: the number of voxels grows
/// four times from each to the next, the picture stays. Argument: the level.
void draw_sphere_of_level(benchmark::State& state) {
  const TestModel model = sphere(static_cast<unsigned>(state.range(2)));
  draw(state, {.voxels = {model.smooth_cloud()}}, model.codes.size());
}

/// The same sphere as six cameras see it, a million surfels.
void draw_surfel_sphere(benchmark::State& state) {
  Surfels surfels;
  add_surfel_sphere(surfels, 0.423, 532, {200, 150, 90, 255});
  draw(state, scene_of(surfels), surfels.size());
}

void arguments(benchmark::internal::Benchmark* bench) {
  bench->Args({1, 1})->Args({1, 2})->Args({3, 1})->Args({3, 2});
  bench->UseRealTime()->Unit(benchmark::kMillisecond);
}
BENCHMARK(draw_sphere)->Apply(arguments);
BENCHMARK(draw_surfel_sphere)->Apply(arguments);
BENCHMARK(draw_sphere_of_level)
    ->ArgsProduct({{1}, {1}, {8, 9, 10, 11}})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace afx::render

BENCHMARK_MAIN();
