// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// A million pieces of surface: from a depth image, and into one.
#include <benchmark/benchmark.h>

#include "afx/surfel_drawing.h"
#include "afx/surfel_layers.h"
#include "afx/surfel_sources.h"
#include "afx/surfel_test_models.h"

namespace afx {
namespace {

const DepthImage& source() {
  static const DepthImage image{test_camera(false), rough_texture(1100, 1100, 16, 3, 1)};
  return image;
}

const Surfels& pieces() {
  static const Surfels surfels = surfels_of(source(), 0, {}).value();
  return surfels;
}

// Beside the source's camera, so that pieces fall between pixels.
DepthCamera other_camera() {
  DepthCamera camera = test_camera(false);
  camera.position.x += 0.05;
  return camera;
}

void count(benchmark::State& state) {
  state.SetItemsProcessed(static_cast<int64_t>(state.iterations() * pieces().size()));
}

void from_a_depth_image(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(surfels_of(source(), 1, {}));
  count(state);
}
BENCHMARK(from_a_depth_image)->Unit(benchmark::kMillisecond);

void drawn(benchmark::State& state) {
  const auto threads = static_cast<unsigned>(state.range(0));
  for (auto _ : state)
    benchmark::DoNotOptimize(draw_surfels(pieces(), {other_camera(), 1024, 1024}, 16, threads, {}));
  count(state);
}
BENCHMARK(drawn)->Arg(1)->Arg(0)->UseRealTime()->Unit(benchmark::kMillisecond);

void layered(benchmark::State& state) {
  for (auto _ : state)
    benchmark::DoNotOptimize(layer_surfels(pieces(), {other_camera(), 1024, 1024}, 16, {}));
  count(state);
}
BENCHMARK(layered)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace afx

BENCHMARK_MAIN();
