// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/image_candidates.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <glm/geometric.hpp>
#include <utility>

#include "afx/builder/reference_views.h"

namespace afx {
namespace {

// How the colour difference of a voxel becomes a cost: the squared difference, and more than that
// once it can be seen, so that a single wrong voxel is never cheaper than a few symbols.
constexpr double kVisible = 40;
// Among images that show the same, the one that the surface faces: only a hint, a million voxels of
// it weigh less than a symbol.
constexpr double kFacing = 1e-8;
// Voxels that nobody outside can see should have their colour too, but not at the price of many
// symbols.
constexpr double kHiddenWeight = 1.0 / 64;
// An image from elsewhere than the sides shows few voxels that others do not, in patches, which
// take many bytes for a pixel: it must be better by this, in squared difference, at each voxel that
// takes it.
constexpr double kSlanting = 24;

// What the bytes of such an image are worth: so much squared difference less, over all exposed
// voxels, for the image and for each pixel of the object in it. Measured with JPEG of quality 90:
// the image takes 600 bytes and 0.1 for each of these pixels, and higher quality of all images
// takes a byte for some 28.
constexpr double kImageWorth = 17000;
constexpr double kPixelWorth = 3;

bool is_slanting(const ImageCandidate& candidate) { return candidate.view >= kSideViews; }

// The upper half of a float: eight bits of precision are enough for costs.
uint16_t pack(double cost) {
  return static_cast<uint16_t>(std::bit_cast<uint32_t>(static_cast<float>(cost)) >> 16);
}

// How much squared difference each image spares the exposed voxels: how much worse they are
// shown by the best of the others.
std::vector<double> savings(std::span<const ImageCandidate> candidates,
                            std::span<const uint8_t> exposed) {
  std::vector<double> saved(candidates.size());
  for (size_t i = 0; i < exposed.size(); ++i) {
    if (exposed[i] == 0) continue;
    size_t best = 0;
    uint16_t least = 0xFFFF, second = 0xFFFF;
    for (size_t k = 0; k < candidates.size(); ++k) {
      const uint16_t squared = candidates[k].squared[i];
      if (squared < least) {
        second = std::exchange(least, squared);
        best = k;
      } else {
        second = std::min(second, squared);
      }
    }
    saved[best] += second - least;
  }
  return saved;
}

}  // namespace

double ImageCandidate::cost(size_t voxel) const {
  return double{std::bit_cast<float>(uint32_t{packed_costs[voxel]} << 16)};
}

int squared_difference(const uint8_t* pixel, Rgba8 colour) {
  const int r = pixel[0] - colour.r, g = pixel[1] - colour.g, b = pixel[2] - colour.b;
  return r * r + g * g + b * b;
}

void weigh(ImageCandidate& candidate, const JudgedVoxels& voxels) {
  const ReferenceView view(candidate.camera, voxels.levels);
  DrawnView drawn = draw_view(view, voxels.coordinates, voxels.colours);
  const glm::vec3 to_camera(view.to_camera());
  candidate.squared.resize(voxels.coordinates.size());
  candidate.packed_costs.resize(voxels.coordinates.size());
  for (size_t i = 0; i < voxels.coordinates.size(); ++i) {
    const auto [x, y] = view.pixel(voxels.coordinates[i]);
    const int squared = squared_difference(drawn.picture.pixel(x, y), voxels.colours[i]);
    const double facing = 1 - glm::dot(voxels.normals[i], to_camera);
    const double unseen = drawn.seen[i] ? 0 : 2;
    const double wrong = squared + static_cast<double>(squared) * squared / kVisible +
                         (is_slanting(candidate) ? kSlanting : 0);
    const double weight = voxels.exposed[i] != 0 ? 1 : kHiddenWeight;
    candidate.squared[i] = static_cast<uint16_t>(std::min(squared, 0xFFFF));
    candidate.packed_costs[i] = pack(weight * wrong + kFacing * (facing + unseen));
  }
  const auto pixels = std::count(drawn.drawn.begin(), drawn.drawn.end(), true);
  candidate.worth = kImageWorth + kPixelWorth * static_cast<double>(pixels);
  candidate.seen = std::move(drawn.seen);
}

void drop_dear_images(std::vector<ImageCandidate>& candidates, std::span<const uint8_t> exposed) {
  while (true) {
    const std::vector<double> saved = savings(candidates, exposed);
    size_t worst = candidates.size();
    double worst_gain = 0;
    for (size_t k = 0; k < candidates.size(); ++k) {
      const double gain = saved[k] - candidates[k].worth;
      if (is_slanting(candidates[k]) && gain < worst_gain) worst = k, worst_gain = gain;
    }
    if (worst == candidates.size()) return;
    candidates.erase(candidates.begin() + static_cast<std::ptrdiff_t>(worst));
  }
}

double least_difference(std::span<const ImageCandidate> candidates,
                        std::span<const uint8_t> exposed) {
  double sum = 0, count = 0;
  for (size_t i = 0; i < exposed.size(); ++i) {
    if (exposed[i] == 0) continue;
    uint16_t least = 0xFFFF;
    for (const ImageCandidate& candidate : candidates)
      least = std::min(least, candidate.squared[i]);
    sum += least;
    count += 1;
  }
  return sum / count;
}

}  // namespace afx
