// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/renderer.h"

#include <atomic>
#include <cmath>
#include <string>

#include "codec/octree_voxels.h"
#include "codec/parallel.h"
#include "render/splat_tiles.h"
#include "render/tile_painter.h"

namespace afx::render {
namespace {

Error bad(const std::string& text) { return {Errc::bad_argument, Place::none(), text}; }

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
  return {};
}

bool is_affine(const glm::dmat4& m) {
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 3; ++row) {
      if (!std::isfinite(m[column][row])) return false;
    }
    if (m[column][3] != (column == 3 ? 1 : 0)) return false;
  }
  return true;
}

Status check_cloud(const VoxelCloud& cloud) {
  if (cloud.level > codec::kMortonLevels) {
    return bad("voxels of level " + std::to_string(cloud.level) + " (expected at most " +
               std::to_string(codec::kMortonLevels) + ")");
  }
  if (cloud.codes.size() != cloud.colours.size()) {
    return bad(std::to_string(cloud.codes.size()) + " voxels with " +
               std::to_string(cloud.colours.size()) + " colours (expected as many)");
  }
  if (!is_affine(cloud.local_to_world)) {
    return bad("the matrix of a voxel cloud is not affine or not finite");
  }
  return {};
}

Status check_cloud(const SurfelCloud& cloud) {
  if (cloud.surfels == nullptr) return bad("a surfel cloud without surfels");
  const Surfels& s = *cloud.surfels;
  if (s.u.size() != s.size() || s.v.size() != s.size() || s.colours.size() != s.size()) {
    return bad(std::to_string(s.size()) + " surfels with " + std::to_string(s.u.size()) + " and " +
               std::to_string(s.v.size()) + " sides and " + std::to_string(s.colours.size()) +
               " colours (expected as many)");
  }
  if (!is_affine(cloud.local_to_world)) {
    return bad("the matrix of a surfel cloud is not affine or not finite");
  }
  return {};
}

Status check_sizes(const Scene& scene, const RenderOptions& options, const Limits& limits) {
  uint64_t voxels = 0, surfels = 0;
  for (const VoxelCloud& cloud : scene.voxels) voxels += cloud.codes.size();
  for (const SurfelCloud& cloud : scene.surfels) surfels += cloud.surfels->size();
  const uint64_t pixels = uint64_t{options.width} * options.height;
  // A splat and one to four places in cells.
  const uint64_t bytes = (voxels + surfels) * (sizeof(Splat) + 16) + surfels * sizeof(Slant) +
                         pixels * (options.depth ? 8 : 4);
  if (voxels + surfels < uint64_t{1} << 30 && bytes <= limits.memory &&
      pixels <= limits.picture_pixels) {
    return {};
  }
  return Error{Errc::limit_exceeded, Place::none(),
               "drawing " + std::to_string(voxels) + " voxels and " + std::to_string(surfels) +
                   " surfels into " + std::to_string(pixels) +
                   " pixels needs more than the limits allow"};
}

Status check(const Scene& scene, const Camera& camera, const RenderOptions& options,
             const Limits& limits) {
  if (Status s = check_options(options); !s.ok()) return s;
  if (Status s = check_camera(camera); !s.ok()) return s;
  for (const VoxelCloud& cloud : scene.voxels) {
    if (Status s = check_cloud(cloud); !s.ok()) return s;
  }
  for (const SurfelCloud& cloud : scene.surfels) {
    if (Status s = check_cloud(cloud); !s.ok()) return s;
  }
  return check_sizes(scene, options, limits);
}

}  // namespace

Result<RenderedImage> render(const Scene& scene, const Camera& camera, const RenderOptions& options,
                             const Limits& limits) {
  if (const Status s = check(scene, camera, options, limits); !s.ok()) return s.error();
  const SplatTiles tiles(scene, camera, options);
  RenderedImage image;
  image.picture = Picture(options.width, options.height, 4);
  if (options.depth) image.depth.resize(size_t{options.width} * options.height);
  // Painters are costly to make, so each thread keeps one; which tiles it paints is open.
  const uint32_t count = tiles.columns() * tiles.rows();
  const unsigned threads = thread_count(options.threads);
  std::atomic<uint32_t> next{0};
  parallel_for(threads, threads, [&](size_t) {
    TilePainter painter(options);
    for (uint32_t tile = next++; tile < count; tile = next++) {
      painter.paint(tiles, tile % tiles.columns(), tile / tiles.columns(), image);
    }
  });
  return image;
}

}  // namespace afx::render
