// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What the free pixels of reference images cost JPEG: filled by fill_unused(), with the mean of
// their block as in the paper (section VII.A), and left black. The images are those of the bust of
// conformance/suites/octree-model at 256, shaded, or of the mesh or cloud that AFX_BENCH_MODEL names. The time
// is that of filling; the figures are counters:
//   q90       bytes with quality 90
//   psnr90    of the used pixels then
//   equal     bytes at 42 dB over the used pixels, between two qualities in proportion
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <variant>
#include <vector>

#include "afx/builder/image_fill.h"
#include "afx/builder/image_target.h"
#include "afx/builder/model_reader.h"
#include "afx/builder/octree_builder.h"
#include "afx/octree_stream.h"
#include "afx/reference_projection.h"
#include "codec/octree_voxels.h"

namespace afx {
namespace {

constexpr double kPsnr = 42;

// The centres of the voxels of a stream.
PointCloud bust() {
  std::ifstream in(AFX_SOURCE_DIR "/conformance/suites/octree-model/nefertiti-256.afx", std::ios::binary);
  const std::vector<uint8_t> file{std::istreambuf_iterator<char>(in),
                                  std::istreambuf_iterator<char>()};
  Diagnostics diagnostics;
  const DecodedOctreeStream decoded = decode_octree_stream(file, {}, diagnostics);
  const unsigned levels = octree_levels(decoded.stream.resolution);
  PointCloud cloud;
  const auto codes = codec::octree_morton(decoded.stream.frames.at(0).octree, levels, levels);
  for (const uint64_t code : codes.value())
    cloud.positions.emplace_back(voxel_centre(code, levels));
  return cloud;
}

SourceModel source() {
  const char* path = std::getenv("AFX_BENCH_MODEL");
  if (path == nullptr) return bust();
  Diagnostics diagnostics;
  return read_source_model(path, {}, diagnostics).value();
}

const BuiltOctree& built() {
  static const BuiltOctree model = [] {
    Diagnostics diagnostics;
    const BuildOptions options{.resolution = 256};
    return std::visit(
        [&](const auto& input) { return build_octree(input, options, diagnostics).value(); },
        source());
  }();
  return model;
}

using Fill = void (*)(Picture&, const std::vector<bool>&);

void fill_for_jpeg(Picture& picture, const std::vector<bool>& used) {
  fill_unused(picture, used, ImageCoder::jpeg);
}

void leave_black(Picture& picture, const std::vector<bool>& used) {
  for (size_t i = 0; i < used.size(); ++i)
    if (!used[i]) std::fill_n(picture.samples.begin() + static_cast<std::ptrdiff_t>(3 * i), 3, 0);
}

// Means of blocks of 8 x 8 pixels; those that have no used pixel take the mean of the blocks around
// that have a mean, again and again until all have.
class BlockMeans {
 public:
  BlockMeans(Picture& picture, const std::vector<bool>& used)
      : picture_(picture), used_(used), columns_((picture.width + 7) / 8) {
    means_.resize(size_t{columns_} * ((picture.height + 7) / 8));
  }

  void run() {
    for (uint32_t y = 0; y < picture_.height; ++y)
      for (uint32_t x = 0; x < picture_.width; ++x)
        if (is_used(x, y)) block(x / 8, y / 8).add(picture_.pixel(x, y));
    while (spread()) {
    }
    for (uint32_t y = 0; y < picture_.height; ++y)
      for (uint32_t x = 0; x < picture_.width; ++x)
        for (size_t c = 0; c < 3 && !is_used(x, y); ++c)
          picture_.pixel(x, y)[c] = static_cast<uint8_t>(block(x / 8, y / 8).of(c) + 0.5);
  }

 private:
  struct Mean {
    double sum[3] = {};
    double count = 0;
    void add(const uint8_t* pixel) {
      for (size_t c = 0; c < 3; ++c) sum[c] += pixel[c];
      count += 1;
    }
    [[nodiscard]] double of(size_t c) const { return count > 0 ? sum[c] / count : 128; }
  };

  [[nodiscard]] bool is_used(uint32_t x, uint32_t y) const {
    return used_[size_t{y} * picture_.width + x];
  }
  Mean& block(uint32_t column, uint32_t row) { return means_[size_t{row} * columns_ + column]; }

  bool spread() {
    const std::vector<Mean> before = means_;
    const auto rows = static_cast<int>(means_.size() / columns_);
    const auto columns = static_cast<int>(columns_);
    bool any = false;
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column) {
        Mean& mean = means_[static_cast<size_t>(row * columns + column)];
        if (mean.count > 0) continue;
        for (int y = std::max(row - 1, 0); y <= std::min(row + 1, rows - 1); ++y)
          for (int x = std::max(column - 1, 0); x <= std::min(column + 1, columns - 1); ++x) {
            const Mean& near = before[static_cast<size_t>(y * columns + x)];
            if (near.count == 0) continue;
            for (size_t c = 0; c < 3; ++c) mean.sum[c] += near.of(c);
            mean.count += 1;
          }
        any = any || mean.count > 0;
      }
    return any;
  }

  Picture& picture_;
  const std::vector<bool>& used_;
  uint32_t columns_;
  std::vector<Mean> means_;
};

void take_block_means(Picture& picture, const std::vector<bool>& used) {
  BlockMeans(picture, used).run();
}

double bytes_at_equal_psnr(const std::vector<ReferenceImage>& images,
                           const std::vector<std::vector<bool>>& used) {
  const auto above = code_images_to_psnr(images, used, kPsnr, 0);
  if (!above.ok() || above.value().quality == 1) return 0;
  const auto below = code_images(images, used, above.value().quality - 1, 0).value();
  const double part = (kPsnr - below.psnr) / (above.value().psnr - below.psnr);
  return static_cast<double>(below.bytes) +
         part * (static_cast<double>(above.value().bytes) - static_cast<double>(below.bytes));
}

void fill(benchmark::State& state, Fill how) {
  const BuiltOctree& model = built();
  std::vector<ReferenceImage> images;
  for (auto _ : state) {
    images = model.model.images;
    for (size_t k = 0; k < images.size(); ++k) how(images[k].picture, model.used[k]);
  }
  const auto coded = code_images(images, model.used, 90, 0).value();
  state.counters["q90"] = static_cast<double>(coded.bytes);
  state.counters["psnr90"] = coded.psnr;
  state.counters["equal"] = bytes_at_equal_psnr(images, model.used);
}
BENCHMARK_CAPTURE(fill, fill_unused, fill_for_jpeg)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(fill, block_means, take_block_means)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(fill, black, leave_black)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace afx

BENCHMARK_MAIN();
