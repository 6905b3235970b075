// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/voxel_shading.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "afx/srgb.h"
#include "codec/octree_voxels.h"
#include "codec/parallel.h"

namespace afx {
namespace {

constexpr unsigned kMostLevel = 11;  // of the grid of rows of sight; finer voxels share a row
constexpr unsigned kFreeLevel = 8;   // whose rows are always had
constexpr size_t kMostRows = 16;     // for each voxel, beyond that level
constexpr float kLeastLight = 0.06F, kAddedLight = 0.59F;
constexpr unsigned kRounds = 5;  // a neighbourhood of five voxels each way

/// The first and last voxel along one axis in every row.
class Rows {
 public:
  Rows(std::span<const uint64_t> codes, unsigned level, int axis)
      : axis_(axis),
        shift_(level - sight_level(level, codes.size())),
        side_(size_t{1} << (level - shift_)),
        first_(side_ * side_, ~uint32_t{0}),
        last_(side_ * side_, 0) {
    for (const uint64_t code : codes) {
      const Seen s = seen(code);
      first_[s.row] = std::min(first_[s.row], s.along);
      last_[s.row] = std::max(last_[s.row], s.along);
    }
  }

  /// -1: seen from the lower end, 1: from the upper end, 0: from both or neither.
  [[nodiscard]] float step(uint64_t code) const {
    const Seen s = seen(code);
    return static_cast<float>(int{s.along == last_[s.row]} - int{s.along == first_[s.row]});
  }

 private:
  struct Seen {
    size_t row;
    uint32_t along;
  };
  [[nodiscard]] Seen seen(uint64_t code) const {
    const Voxel v = codec::morton_decode(code >> (3 * shift_));
    switch (axis_) {
      case 0:
        return {v.y * side_ + v.z, v.x};
      case 1:
        return {v.z * side_ + v.x, v.y};
      default:
        return {v.x * side_ + v.y, v.z};
    }
  }

  int axis_;
  unsigned shift_;
  size_t side_;
  std::vector<uint32_t> first_, last_;
};

}  // namespace

std::vector<glm::vec3> surface_normals(std::span<const uint64_t> codes, unsigned level,
                                       const VoxelBlocks& blocks, unsigned threads) {
  std::vector<glm::vec3> steps(codes.size());
  parallel_for(3, threads, [&](size_t axis) {
    const Rows rows(codes, level, static_cast<int>(axis));
    for (size_t i = 0; i < codes.size(); ++i) {
      steps[i][static_cast<int>(axis)] = rows.step(codes[i]);
    }
  });
  std::vector<glm::vec3> normals = smooth(blocks, std::move(steps), kRounds, threads);
  for (glm::vec3& n : normals) {
    const float length = glm::length(n);
    n = length > 1e-6F ? n / length : glm::vec3(0);
  }
  return normals;
}

unsigned sight_level(unsigned level, size_t voxels) {
  unsigned sight = std::min(level, kMostLevel);
  while (sight > kFreeLevel && (size_t{1} << (2 * sight)) / kMostRows > voxels) --sight;
  return sight;
}

float shade_light(const glm::vec3& normal) {
  const glm::vec3 light = glm::normalize(glm::vec3(-0.45F, 0.7F, 0.8F));
  const float facing = 0.5F + 0.5F * glm::dot(normal, light);
  return kLeastLight + kAddedLight * facing * facing;
}

Rgba8 shaded_colour(Rgba8 colour, const glm::vec3& normal) {
  const std::array<float, 256>& linear = srgb_to_linear();
  const float light = shade_light(normal) / (kLeastLight + kAddedLight);
  return {linear_to_srgb(linear[colour.r] * light), linear_to_srgb(linear[colour.g] * light),
          linear_to_srgb(linear[colour.b] * light), colour.a};
}

Rgba8 shaded_grey(const glm::vec3& normal) {
  const uint8_t grey = linear_to_srgb(shade_light(normal));
  return {grey, grey, grey, 255};
}

}  // namespace afx
