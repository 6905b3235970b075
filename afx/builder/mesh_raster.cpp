// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/mesh_raster.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "codec/parallel.h"

namespace afx {
namespace {

constexpr size_t kChunk = 16384;  // vertices or triangles that one task does
constexpr double kUnits = 256;    // of a pixel
// Corners farther off the screen than this many pixels are drawn as if they lay there: no product
// of two lengths leaves 64 bits.
constexpr double kFarthest = 1 << 20;

int64_t fixed(double pixels) {
  return std::llround(std::clamp(pixels, -kFarthest, kFarthest) * kUnits);
}

// From where up to, not with, where.
struct BandRange {
  uint32_t first = 0, end = 0;
};

uint64_t bytes_of(const Mesh& mesh) {
  return mesh.positions.size() * sizeof(glm::dvec3) + mesh.triangles.size() * sizeof(BandRange);
}

Status check_memory(uint64_t bytes, const Limits& limits) {
  if (bytes <= limits.memory) return {};
  return Error{Errc::limit_exceeded, Place::none(),
               "the triangles on the rows of the picture take " + std::to_string(bytes) +
                   " bytes (expected at most " + std::to_string(limits.memory) + ")"};
}

}  // namespace

Result<MeshRaster> MeshRaster::of(const Mesh& mesh, const DepthCamera& camera, uint32_t width,
                                  uint32_t height, unsigned threads, const Limits& limits) {
  if (Status fits = check_memory(bytes_of(mesh), limits); !fits.ok()) return fits.error();
  MeshRaster raster(mesh, camera, width, height);
  raster.see_vertices(camera, threads);
  if (Status sorted = raster.sort_into_bands(threads, limits); !sorted.ok()) return sorted.error();
  return raster;
}

MeshRaster::MeshRaster(const Mesh& mesh, const DepthCamera& camera, uint32_t width, uint32_t height)
    : mesh_(mesh),
      perspective_(!camera.orthographic),
      near_(camera.near_plane),
      extent_(CameraProjection(camera).extent(1)),
      width_(width),
      height_(height) {}

void MeshRaster::see_vertices(const DepthCamera& camera, unsigned threads) {
  const CameraProjection projection(camera);
  const size_t count = mesh_.positions.size();
  seen_.resize(count);
  parallel_for((count + kChunk - 1) / kChunk, threads, [&](size_t chunk) {
    for (size_t i = chunk * kChunk; i < std::min(count, (chunk + 1) * kChunk); ++i)
      seen_[i] = projection.to_camera(glm::dvec3(mesh_.positions[i]));
  });
}

uint32_t MeshRaster::end_row(uint32_t band) const {
  return std::min(height_, (band + 1) * kBandRows);
}

// What the near plane leaves of a triangle: up to two triangles.
int MeshRaster::cut(uint32_t triangle, Parts& parts) const {
  const glm::uvec3 v = mesh_.triangles[triangle];
  const std::array<Corner, 3> whole{Corner{seen_[v.x], 0, 0}, Corner{seen_[v.y], 1, 0},
                                    Corner{seen_[v.z], 0, 1}};
  std::array<Corner, 4> kept;
  size_t count = 0;
  for (size_t i = 0; i < 3; ++i) {
    const Corner& here = whole[i];
    const Corner& next = whole[(i + 1) % 3];
    const double h = -here.seen.z - near_, n = -next.seen.z - near_;
    if (h >= 0) kept[count++] = here;
    if ((h < 0) == (n < 0)) continue;
    const double t = h / (h - n);
    kept[count++] = {here.seen + (next.seen - here.seen) * t, here.b + (next.b - here.b) * t,
                     here.c + (next.c - here.c) * t};
  }
  if (count < 3) return 0;
  parts[0] = {kept[0], kept[1], kept[2]};
  if (count == 4) parts[1] = {kept[0], kept[2], kept[3]};
  return static_cast<int>(count) - 2;
}

MeshRaster::Placed MeshRaster::place(const std::array<Corner, 3>& corners) const {
  Placed placed;
  for (size_t k = 0; k < 3; ++k) {
    const Corner& corner = corners[k];
    const double distance = -corner.seen.z;
    const glm::dvec2 size = perspective_ ? extent_ * distance : extent_;
    placed.x[k] = fixed((corner.seen.x / size.x + 0.5) * width_);
    placed.y[k] = fixed((0.5 - corner.seen.y / size.y) * height_);
    placed.distance[k] = distance;
    placed.b[k] = corner.b;
    placed.c[k] = corner.c;
  }
  const auto doubled_area = [&placed] {
    return (placed.x[1] - placed.x[0]) * (placed.y[2] - placed.y[0]) -
           (placed.x[2] - placed.x[0]) * (placed.y[1] - placed.y[0]);
  };
  if (doubled_area() < 0) {
    std::swap(placed.x[1], placed.x[2]);
    std::swap(placed.y[1], placed.y[2]);
    std::swap(placed.distance[1], placed.distance[2]);
    std::swap(placed.b[1], placed.b[2]);
    std::swap(placed.c[1], placed.c[2]);
  }
  placed.doubled_area = doubled_area();
  return placed;
}

MeshRaster::Rows MeshRaster::rows_of(uint32_t triangle) const {
  Parts parts;
  const int count = cut(triangle, parts);
  Rows rows{height_, -1};
  for (int part = 0; part < count; ++part) {
    const Placed p = place(parts[static_cast<size_t>(part)]);
    if (p.doubled_area == 0) continue;
    const auto [left, right] = std::minmax({p.x[0], p.x[1], p.x[2]});
    if (right < 0 || left > int64_t{width_} * 256) continue;
    const auto [top, bottom] = std::minmax({p.y[0], p.y[1], p.y[2]});
    rows.first = std::min(rows.first, std::max<int64_t>((top + 127) >> 8, 0));
    rows.last = std::max(rows.last, std::min<int64_t>((bottom - 128) >> 8, int64_t{height_} - 1));
  }
  return rows;
}

Status MeshRaster::sort_into_bands(unsigned threads, const Limits& limits) {
  const size_t count = mesh_.triangles.size();
  std::vector<BandRange> of(count);
  parallel_for((count + kChunk - 1) / kChunk, threads, [&](size_t chunk) {
    for (size_t t = chunk * kChunk; t < std::min(count, (chunk + 1) * kChunk); ++t) {
      const Rows rows = rows_of(static_cast<uint32_t>(t));
      if (rows.first > rows.last) continue;
      of[t] = {static_cast<uint32_t>(rows.first) / kBandRows,
               static_cast<uint32_t>(rows.last) / kBandRows + 1};
    }
  });
  uint64_t entries = 0;
  for (const BandRange& met : of) entries += met.end - met.first;
  if (Status fits = check_memory(bytes_of(mesh_) + entries * sizeof(uint32_t), limits); !fits.ok())
    return fits;
  starts_.assign(bands() + 1, 0);
  for (const BandRange& met : of)
    for (uint32_t band = met.first; band < met.end; ++band) ++starts_[band + 1];
  for (size_t band = 0; band < bands(); ++band) starts_[band + 1] += starts_[band];
  entries_.resize(starts_.back());
  std::vector<size_t> next(starts_.begin(), starts_.end() - 1);
  for (uint32_t t = 0; t < count; ++t)
    for (uint32_t band = of[t].first; band < of[t].end; ++band) entries_[next[band]++] = t;
  return {};
}

}  // namespace afx
