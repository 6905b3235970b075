// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/voxelize.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <mutex>
#include <span>

#include "afx/builder/surface_colour.h"
#include "afx/builder/triangle_cells.h"
#include "afx/srgb.h"
#include "codec/octree_voxels.h"
#include "codec/parallel.h"

namespace afx {
namespace {

// Work is done in blocks of 32^3 voxels: their table stays in the processor's cache, and they
// follow each other in the order of Morton codes.
constexpr int kBlockBits = 5;
constexpr size_t kBlockVoxels = size_t{1} << (3 * kBlockBits);

std::array<glm::ivec3, 3> fixed_corners(const Mesh& mesh, const Grid& grid, size_t triangle) {
  const glm::uvec3 v = mesh.triangles[triangle];
  return {grid.to_fixed(mesh.positions[v.x]), grid.to_fixed(mesh.positions[v.y]),
          grid.to_fixed(mesh.positions[v.z])};
}

// A triangle in a block: block << 32 | triangle, so that sorting gathers blocks, triangles in
// order.
Result<std::vector<uint64_t>> triangles_by_block(const Mesh& mesh, const Grid& grid,
                                                 const Limits& limits) {
  constexpr int kBits = kSubvoxelBits + kBlockBits;
  const uint64_t most = limits.memory / sizeof(uint64_t);
  const CellRange everything{glm::ivec3(0), glm::ivec3(1 << 19)};
  std::vector<uint64_t> pairs;
  pairs.reserve(mesh.triangles.size() + mesh.triangles.size() / 4);
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto corners = fixed_corners(mesh, grid, t);
    const auto push = [&](int x, int y, int z) {
      const Voxel block{static_cast<uint32_t>(x), static_cast<uint32_t>(y),
                        static_cast<uint32_t>(z)};
      pairs.push_back(codec::morton_code(block) << 32 | t);
    };
    const glm::ivec3 a = corners[0] >> kBits, b = corners[1] >> kBits, c = corners[2] >> kBits;
    if (a == b && b == c)
      push(a.x, a.y, a.z);
    else
      TriangleCells(corners, kBits).for_each(everything, push);
    if (pairs.size() > most)
      return Error{Errc::limit_exceeded,
                   {},
                   "so many large triangles take more memory than the limit",
                   {},
                   {}};
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

glm::vec3 unit_or_zero(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 1e-9 ? glm::vec3(v / length) : glm::vec3(0);
}

// The voxels of one block.
class BlockBuilder {
 public:
  BlockBuilder(const Mesh& mesh, const Grid& grid, const SurfaceColour& colour, uint64_t block)
      : mesh_(mesh), grid_(grid), colour_(colour), block_(block), slot_of_(kBlockVoxels, 0) {
    const Voxel v = codec::morton_decode(block);
    range_.low = glm::ivec3(glm::uvec3(v.x, v.y, v.z)) << kBlockBits;
    range_.high = range_.low + ((1 << kBlockBits) - 1);
  }

  SurfaceVoxels build(std::span<const uint64_t> pairs) {
    for (const uint64_t pair : pairs) add_triangle(pair & 0xFFFFFFFF, 0);
    // Voxels that are only touched have no area to speak of: they get the colour of what is next to
    // them.
    constexpr double kMargin = 1.0 / 32;
    touched_ = std::vector<bool>(sums_.size());
    bool any = false;
    for (size_t i = 0; i < sums_.size(); ++i) any = (touched_[i] = is_touched(sums_[i])) || any;
    if (any)
      for (const uint64_t pair : pairs) add_triangle(pair & 0xFFFFFFFF, kMargin);
    return collect();
  }

 private:
  static constexpr double kLeastArea = 1e-5;

  static bool is_touched(const SurfaceSum& sum) {
    return (sum.has_opaque ? sum.weight : sum.area) < kLeastArea;
  }

  void add_triangle(size_t triangle, double margin) {
    const TriangleCells cells(fixed_corners(mesh_, grid_, triangle), kSubvoxelBits);
    const SurfaceColour::Piece piece = colour_.piece(triangle);
    cells.for_each(range_, [&](int x, int y, int z) {
      const glm::ivec3 low(x, y, z);
      const glm::uvec3 local(low - range_.low);
      uint32_t& slot = slot_of_[codec::morton_code({local.x, local.y, local.z})];
      if (slot == 0) {
        sums_.emplace_back();
        slot = static_cast<uint32_t>(sums_.size());
      }
      SurfaceSum& sum = sums_[slot - 1];
      if (margin > 0 && !touched_[slot - 1]) return;
      const double before = sum.area;
      colour_.add(piece, low, margin, sum);
      // A touch counts for next to nothing beside surface that has an area.
      if (margin > 0 && !(sum.area - before > kLeastArea))
        colour_.add_touch(piece, kLeastArea, sum);
    });
  }

  [[nodiscard]] SurfaceVoxels collect() const {
    SurfaceVoxels voxels;
    voxels.codes.reserve(sums_.size());
    voxels.colours.reserve(sums_.size());
    voxels.normals.reserve(sums_.size());
    for (size_t local = 0; local < kBlockVoxels; ++local) {
      if (slot_of_[local] == 0) continue;
      const SurfaceSum& sum = sums_[slot_of_[local] - 1];
      if (!sum.is_there()) continue;
      voxels.codes.push_back(block_ << (3 * kBlockBits) | local);
      voxels.colours.push_back(to_srgb(sum.light / sum.weight));
      voxels.normals.push_back(unit_or_zero(sum.normal / sum.weight));
    }
    return voxels;
  }

  const Mesh& mesh_;
  const Grid& grid_;
  const SurfaceColour& colour_;
  uint64_t block_;
  CellRange range_;
  std::vector<uint32_t> slot_of_;  // by local Morton code: number in sums_ plus one, 0 = not set
  std::vector<SurfaceSum> sums_;
  std::vector<bool> touched_;
};

Error too_many_voxels() {
  return Error{Errc::limit_exceeded,
               {},
               "the surface has more voxels than the limit (a lower resolution has fewer)",
               {},
               {}};
}

template <class T>
void append(std::vector<T>& to, std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
  from = std::vector<T>();  // memory given back at once
}

SurfaceVoxels join(std::vector<SurfaceVoxels>& parts, uint64_t count) {
  SurfaceVoxels all;
  all.codes.reserve(count);
  all.colours.reserve(count);
  all.normals.reserve(count);
  for (SurfaceVoxels& part : parts) {
    append(all.codes, part.codes);
    append(all.colours, part.colours);
    append(all.normals, part.normals);
  }
  return all;
}

}  // namespace

Result<SurfaceVoxels> voxelize(const Mesh& mesh, const Grid& grid, unsigned threads,
                               const Limits& limits, const std::function<void(double)>& done) {
  if (mesh.triangles.size() > 0xFFFFFFFF)
    return Error{Errc::limit_exceeded, {}, "the mesh has more than 2^32 triangles", {}, {}};
  const Result<std::vector<uint64_t>> pairs = triangles_by_block(mesh, grid, limits);
  if (!pairs.ok()) return pairs.error();
  const SurfaceColour colour(mesh, grid);
  std::vector<std::span<const uint64_t>> blocks;
  for (std::span<const uint64_t> rest(pairs.value()); !rest.empty();) {
    const uint64_t block = rest[0] >> 32;
    const auto end = std::partition_point(rest.begin(), rest.end(),
                                          [&](uint64_t p) { return p >> 32 == block; });
    blocks.emplace_back(rest.begin(), end);
    rest = rest.subspan(blocks.back().size());
  }
  constexpr uint64_t kVoxelBytes = 2 * (sizeof(uint64_t) + sizeof(Rgba8) + sizeof(glm::vec3));
  const uint64_t most = std::min(limits.octree_nodes, limits.memory / kVoxelBytes);
  std::vector<SurfaceVoxels> parts(blocks.size());
  std::atomic<uint64_t> count{0};
  std::mutex reporting;
  size_t finished = 0;
  parallel_for(blocks.size(), threads, [&](size_t i) {
    if (count > most) return;
    parts[i] = BlockBuilder(mesh, grid, colour, blocks[i][0] >> 32).build(blocks[i]);
    count += parts[i].codes.size();
    const std::lock_guard lock(reporting);
    ++finished;
    if (done) done(static_cast<double>(finished) / static_cast<double>(blocks.size()));
  });
  if (count > most) return too_many_voxels();
  if (count == 0 && !blocks.empty())
    return Error{Errc::bad_argument, {}, "all of the surface is transparent", {}, {}};
  return join(parts, count);
}

Result<SurfaceVoxels> voxelize(const PointCloud& cloud, const Grid& grid, const Limits& limits) {
  struct Entry {
    uint64_t code;
    size_t point;
    bool operator<(const Entry& other) const {
      return code != other.code ? code < other.code : point < other.point;
    }
  };
  if (cloud.positions.size() > limits.memory / sizeof(Entry))
    return Error{Errc::limit_exceeded, {}, "the points take more memory than the limit", {}, {}};
  std::vector<Entry> entries(cloud.positions.size());
  for (size_t i = 0; i < entries.size(); ++i) {
    const glm::uvec3 v(grid.to_fixed(cloud.positions[i]) >> kSubvoxelBits);
    entries[i] = {codec::morton_code({v.x, v.y, v.z}), i};
  }
  std::sort(entries.begin(), entries.end());
  SurfaceVoxels voxels;
  for (size_t i = 0; i < entries.size();) {
    SurfaceSum sum;
    const uint64_t code = entries[i].code;
    for (; i < entries.size() && entries[i].code == code; ++i) {
      const size_t point = entries[i].point;
      const Rgba8 c = cloud.colours.empty() ? Rgba8{255, 255, 255, 255} : cloud.colours[point];
      sum.light += linear_light(c);
      if (!cloud.normals.empty()) sum.normal += glm::dvec3(unit_or_zero(cloud.normals[point]));
      sum.area += 1;
    }
    if (voxels.codes.size() >= limits.octree_nodes) return too_many_voxels();
    voxels.codes.push_back(code);
    voxels.colours.push_back(to_srgb(sum.light / sum.area));
    voxels.normals.push_back(unit_or_zero(sum.normal));
  }
  return voxels;
}

}  // namespace afx
