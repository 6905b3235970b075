// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The octree coder against the plain one, and octree bytes to voxels, on real surfaces of
// conformance/suites/octree-model: the water bottle at 512 without images, spot at 256 with six.
// A figure is the ratio of two rows of one run.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "codec/octree_decoder.h"
#include "codec/octree_encoder.h"
#include "codec/octree_voxels.h"
#include "codec/plain/octree_plain.h"

namespace afx::codec {
namespace {

/// A vector with one frame: its coded bits and its fields.
struct Model {
  unsigned levels;
  unsigned images;
  std::vector<uint8_t> stream;  // the frame
  OctreeFields fields;
  uint64_t voxels = 0;
};

Model load(const std::string& name, unsigned levels, unsigned images) {
  std::ifstream in(AFX_SOURCE_DIR "/conformance/suites/octree-model/" + name, std::ios::binary);
  const std::vector<uint8_t> file{std::istreambuf_iterator<char>(in),
                                  std::istreambuf_iterator<char>()};
  constexpr uint8_t start_code[] = {0x00, 0x00, 0x01, 0xC8};
  const auto at =
      std::search(file.begin(), file.end(), std::begin(start_code), std::end(start_code));
  Model model{levels, images, {at + 4, file.end()}, {}};
  Diagnostics diagnostics;
  model.fields =
      decode_octree_frame(model.stream, {.levels = levels, .textures = images}, diagnostics).fields;
  model.voxels = octree_level_counts(model.fields.octree, levels).value().back();
  return model;
}

void count_symbols(benchmark::State& state, const Model& m) {
  const auto symbols = m.fields.octree.size() + m.fields.voxel_image_index.size();
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(symbols));
}

void decode_fast(benchmark::State& state, const Model& m) {
  for (auto _ : state) {
    Diagnostics diagnostics;
    const OctreeFrame frame =
        decode_octree_frame(m.stream, {.levels = m.levels, .textures = m.images}, diagnostics);
    if (frame.fields != m.fields) state.SkipWithError("decoded wrong");
  }
  count_symbols(state, m);
}

void decode_plain(benchmark::State& state, const Model& m) {
  for (auto _ : state) {
    const plain::Frame frame = plain::decode_frame(m.stream, m.levels, m.images, UINT64_MAX);
    if (frame.fields != m.fields) state.SkipWithError("decoded wrong");
  }
  count_symbols(state, m);
}

void encode_fast(benchmark::State& state, const Model& m) {
  for (auto _ : state) {
    std::vector<uint8_t> out;
    if (!encode_octree_frame(m.fields, m.levels, m.images, out).ok() || out != m.stream) {
      state.SkipWithError("encoded wrong");
    }
  }
  count_symbols(state, m);
}

void encode_plain(benchmark::State& state, const Model& m) {
  for (auto _ : state) {
    if (plain::encode_frame(m.fields, m.levels, m.images) != m.stream)
      state.SkipWithError("encoded wrong");
  }
  count_symbols(state, m);
}

void morton_codes(benchmark::State& state, const Model& m) {
  for (auto _ : state) benchmark::DoNotOptimize(octree_morton(m.fields.octree, m.levels, m.levels));
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(m.voxels));
}

void coordinates(benchmark::State& state, const Model& m) {
  for (auto _ : state) benchmark::DoNotOptimize(octree_voxels(m.fields.octree, m.levels, m.levels));
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(m.voxels));
}

}  // namespace
}  // namespace afx::codec

int main(int argc, char** argv) {
  using namespace afx::codec;
  const Model bottle = load("waterbottle-512.afx", 9, 0);
  const Model spot = load("spot-256-textured.afx", 8, 6);
  using Run = void (*)(benchmark::State&, const Model&);
  const auto add = [](const std::string& name, Run run, const Model& m) {
    benchmark::RegisterBenchmark(name.c_str(),
                                 [run, &m](benchmark::State& state) { run(state, m); });
  };
  for (const Model* m : {&bottle, &spot}) {
    const std::string name = m == &bottle ? "bottle-512" : "spot-256-textured";
    add("decode/" + name + "/plain", decode_plain, *m);
    add("decode/" + name + "/fast", decode_fast, *m);
    add("encode/" + name + "/plain", encode_plain, *m);
    add("encode/" + name + "/fast", encode_fast, *m);
  }
  add("voxels/bottle-512/morton", morton_codes, bottle);
  add("voxels/bottle-512/coordinates", coordinates, bottle);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
