// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <benchmark/benchmark.h>

#include "render/renderer.h"
#include "render/test_scenes.h"

namespace afx::render {
namespace {

/// A full sphere shell, about 840,000 voxels, filling a picture of 1024 x 1024.
/// Arguments: samples each way, threads.
void draw_sphere(benchmark::State& state) {
  TestModelMaker maker(9);
  add_sphere(maker, 9, 0.423, {200, 150, 90, 255});
  const TestModel model = maker.make();
  const Scene scene = model.scene();
  const auto camera = fit_camera(outline(scene), View{}, 1);
  if (!camera.ok()) return state.SkipWithError("no camera");
  const RenderOptions options{.samples = static_cast<unsigned>(state.range(0)),
                              .threads = static_cast<unsigned>(state.range(1))};
  for (auto _ : state) {
    auto image = render(scene, camera.value(), options);
    benchmark::DoNotOptimize(image);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(model.codes.size()));
  state.counters["voxels"] = static_cast<double>(model.codes.size());
}
BENCHMARK(draw_sphere)
    ->Args({1, 1})
    ->Args({1, 2})
    ->Args({3, 1})
    ->Args({3, 2})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace afx::render

BENCHMARK_MAIN();
