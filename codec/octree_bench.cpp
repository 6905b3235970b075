// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The octree coder against the plain one, and octree bytes to voxels, on one synthetic surface of
// real character: a bumpy sphere, about 2.9 voxels a node, with six images.
// A figure is the ratio of two rows of one run.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "codec/octree_decoder.h"
#include "codec/octree_encoder.h"
#include "codec/octree_voxels.h"
#include "codec/plain/octree_plain.h"

namespace afx::codec {
namespace {

constexpr unsigned kLevels = 9;
constexpr unsigned kImages = 6;

/// The voxels of a closed surface: those whose corners lie on both sides of it.
std::vector<uint64_t> bumpy_sphere(unsigned levels) {
  const uint32_t side = 1U << levels;
  const auto inside = [&](uint32_t x, uint32_t y, uint32_t z) {
    const double u = x * 2.0 / side - 1;
    const double v = y * 2.0 / side - 1;
    const double w = z * 2.0 / side - 1;
    const double radius =
        0.75 + 0.05 * std::sin(9 * u) * std::sin(11 * v) + 0.04 * std::cos(13 * w + 5 * u);
    return u * u + v * v + w * w < radius * radius;
  };
  std::vector<uint64_t> codes;
  for (uint32_t z = 0; z < side; ++z) {
    for (uint32_t y = 0; y < side; ++y) {
      for (uint32_t x = 0; x < side; ++x) {
        const double u = (x + 0.5) * 2.0 / side - 1;
        const double v = (y + 0.5) * 2.0 / side - 1;
        const double w = (z + 0.5) * 2.0 / side - 1;
        const double r = u * u + v * v + w * w;
        if (r < 0.4 || r > 0.76) continue;
        int corners = 0;
        for (uint32_t c = 0; c < 8; ++c)
          corners += inside(x + (c & 1), y + (c >> 1 & 1), z + (c >> 2)) ? 1 : 0;
        if (corners > 0 && corners < 8) codes.push_back(morton_code({x, y, z}));
      }
    }
  }
  std::sort(codes.begin(), codes.end());
  return codes;
}

/// The image that faces a voxel best, as a builder would choose it.
uint8_t facing_image(Voxel voxel, unsigned levels) {
  const double half = (1U << levels) / 2.0;
  const double d[3] = {voxel.x + 0.5 - half, voxel.y + 0.5 - half, voxel.z + 0.5 - half};
  unsigned axis = 0;
  for (unsigned k = 1; k < 3; ++k) {
    if (std::abs(d[k]) > std::abs(d[axis])) axis = k;
  }
  return static_cast<uint8_t>(1 + 2 * axis + (d[axis] < 0 ? 1 : 0));
}

struct Model {
  OctreeFields plain;  // without images
  OctreeFields textured;
  std::vector<uint8_t> plain_stream;
  std::vector<uint8_t> textured_stream;
  uint64_t voxels = 0;
};

const Model& model() {
  static const Model kModel = [] {
    Model m;
    const std::vector<uint64_t> codes = bumpy_sphere(kLevels);
    m.voxels = codes.size();
    m.plain.octree = octree_from_morton(codes, kLevels);
    m.textured.octree = m.plain.octree;
    std::vector<uint8_t> images;
    for (const uint64_t code : codes) images.push_back(facing_image(morton_decode(code), kLevels));
    m.textured.voxel_image_index = octree_image_index(m.textured.octree, kLevels, images);
    (void)encode_octree_frame(m.plain, kLevels, 0, m.plain_stream);
    (void)encode_octree_frame(m.textured, kLevels, kImages, m.textured_stream);
    return m;
  }();
  return kModel;
}

void count_symbols(benchmark::State& state, const OctreeFields& fields) {
  const auto symbols = static_cast<int64_t>(fields.octree.size() + fields.voxel_image_index.size());
  state.SetItemsProcessed(state.iterations() * symbols);
}

void decode_fast(benchmark::State& state, const OctreeFields& fields,
                 const std::vector<uint8_t>& stream, unsigned images) {
  for (auto _ : state) {
    Diagnostics diagnostics;
    const OctreeFrame frame =
        decode_octree_frame(stream, {.levels = kLevels, .textures = images}, diagnostics);
    if (frame.fields != fields) state.SkipWithError("decoded wrong");
  }
  count_symbols(state, fields);
}

void decode_plain(benchmark::State& state, const OctreeFields& fields,
                  const std::vector<uint8_t>& stream, unsigned images) {
  for (auto _ : state) {
    const plain::Frame frame = plain::decode_frame(stream, kLevels, images, UINT64_MAX);
    if (frame.fields != fields) state.SkipWithError("decoded wrong");
  }
  count_symbols(state, fields);
}

void encode_fast(benchmark::State& state, const OctreeFields& fields,
                 const std::vector<uint8_t>& stream, unsigned images) {
  for (auto _ : state) {
    std::vector<uint8_t> out;
    if (!encode_octree_frame(fields, kLevels, images, out).ok() || out != stream)
      state.SkipWithError("encoded wrong");
  }
  count_symbols(state, fields);
}

void encode_plain(benchmark::State& state, const OctreeFields& fields,
                  const std::vector<uint8_t>& stream, unsigned images) {
  for (auto _ : state) {
    if (plain::encode_frame(fields, kLevels, images) != stream)
      state.SkipWithError("encoded wrong");
  }
  count_symbols(state, fields);
}

void morton_codes(benchmark::State& state) {
  for (auto _ : state)
    benchmark::DoNotOptimize(octree_morton(model().plain.octree, kLevels, kLevels));
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(model().voxels));
}

void coordinates(benchmark::State& state) {
  for (auto _ : state)
    benchmark::DoNotOptimize(octree_voxels(model().plain.octree, kLevels, kLevels));
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(model().voxels));
}

}  // namespace
}  // namespace afx::codec

int main(int argc, char** argv) {
  using namespace afx::codec;
  const Model& m = model();
  benchmark::RegisterBenchmark("decode/octree/plain",
                               [&](auto& s) { decode_plain(s, m.plain, m.plain_stream, 0); });
  benchmark::RegisterBenchmark("decode/octree/fast",
                               [&](auto& s) { decode_fast(s, m.plain, m.plain_stream, 0); });
  benchmark::RegisterBenchmark("encode/octree/plain",
                               [&](auto& s) { encode_plain(s, m.plain, m.plain_stream, 0); });
  benchmark::RegisterBenchmark("encode/octree/fast",
                               [&](auto& s) { encode_fast(s, m.plain, m.plain_stream, 0); });
  benchmark::RegisterBenchmark("decode/textured/plain", [&](auto& s) {
    decode_plain(s, m.textured, m.textured_stream, kImages);
  });
  benchmark::RegisterBenchmark("decode/textured/fast", [&](auto& s) {
    decode_fast(s, m.textured, m.textured_stream, kImages);
  });
  benchmark::RegisterBenchmark("encode/textured/plain", [&](auto& s) {
    encode_plain(s, m.textured, m.textured_stream, kImages);
  });
  benchmark::RegisterBenchmark("encode/textured/fast", [&](auto& s) {
    encode_fast(s, m.textured, m.textured_stream, kImages);
  });
  benchmark::RegisterBenchmark("voxels/morton", [](auto& s) { morton_codes(s); });
  benchmark::RegisterBenchmark("voxels/coordinates", [](auto& s) { coordinates(s); });
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
