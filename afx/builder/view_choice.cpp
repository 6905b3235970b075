// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/view_choice.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>

#include "afx/builder/exposure.h"
#include "afx/builder/reference_views.h"
#include "codec/octree_voxels.h"
#include "codec/parallel.h"

namespace afx {
namespace {

constexpr unsigned kLevels = 8;
constexpr unsigned kMostThreads = 4;  // each has pictures of its own

// All directions (x, y, z) of coordinates -2..2 without those that are twice another, and without
// the axes.
std::vector<glm::dvec3> candidates() {
  std::vector<glm::dvec3> directions;
  for (int x = -2; x <= 2; ++x)
    for (int y = -2; y <= 2; ++y)
      for (int z = -2; z <= 2; ++z) {
        if (std::gcd(std::gcd(x, y), z) != 1) continue;
        if ((x != 0) + (y != 0) + (z != 0) < 2) continue;
        directions.push_back(glm::normalize(glm::dvec3(x, y, z)));
      }
  return directions;
}

std::vector<Voxel> coarse_voxels(std::span<const uint64_t> codes, unsigned shift) {
  std::vector<Voxel> voxels;
  for (size_t i = 0; i < codes.size(); ++i)
    if (i == 0 || codes[i] >> shift != codes[i - 1] >> shift)
      voxels.push_back(codec::morton_decode(codes[i] >> shift));
  return voxels;
}

// Those that can be seen from outside; no others hide them.
std::vector<Voxel> exposed_of(const std::vector<Voxel>& voxels, unsigned levels, unsigned threads) {
  const std::vector<uint8_t> exposed = exposed_voxels(voxels, levels, threads);
  std::vector<Voxel> result;
  for (size_t i = 0; i < voxels.size(); ++i)
    if (exposed[i] != 0) result.push_back(voxels[i]);
  return result;
}

// For each camera, which of some voxels among all it sees.
using SeenByView = std::vector<std::vector<bool>>;
SeenByView seen_by_all(std::span<const ReferenceCamera> cameras, unsigned levels,
                       std::span<const Voxel> all, std::span<const Voxel> some, unsigned threads) {
  SeenByView seen(cameras.size(), std::vector<bool>(some.size()));
  parallel_for(cameras.size(), std::min(thread_count(threads), kMostThreads), [&](size_t k) {
    const ReferenceView view(cameras[k], levels);
    const FirstSeen first = first_seen(view, all);
    for (size_t i = 0; i < some.size(); ++i) seen[k][i] = is_seen(view, view.sight(some[i]), first);
  });
  return seen;
}

// The voxels that none of the views shows.
std::vector<Voxel> unseen_of(std::span<const Voxel> voxels, const SeenByView& seen) {
  std::vector<Voxel> rest;
  for (size_t i = 0; i < voxels.size(); ++i)
    if (std::none_of(seen.begin(), seen.end(), [&](const auto& by) { return by[i]; }))
      rest.push_back(voxels[i]);
  return rest;
}

size_t gain_of(const std::vector<bool>& seen, const std::vector<bool>& open) {
  size_t gain = 0;
  for (size_t i = 0; i < open.size(); ++i) gain += open[i] && seen[i] ? 1 : 0;
  return gain;
}

// Numbers of views, greedily; ties go to the lower.
std::vector<size_t> choose(const SeenByView& seen, size_t voxels, unsigned most, size_t least) {
  std::vector<size_t> chosen;
  std::vector<bool> open(voxels, true);
  while (chosen.size() < most) {
    size_t best = 0, best_gain = 0;
    for (size_t k = 0; k < seen.size(); ++k) {
      const size_t gain = gain_of(seen[k], open);
      if (gain > best_gain) best = k, best_gain = gain;
    }
    if (best_gain == 0 || best_gain < least) break;
    chosen.push_back(best);
    for (size_t i = 0; i < voxels; ++i) open[i] = open[i] && !seen[best][i];
  }
  return chosen;
}

}  // namespace

std::vector<glm::dvec3> choose_directions(std::span<const uint64_t> codes, unsigned levels,
                                          const ViewChoice& choice) {
  const unsigned coarse = std::min(levels, kLevels);
  const std::vector<Voxel> voxels =
      exposed_of(coarse_voxels(codes, 3 * (levels - coarse)), coarse, choice.threads);
  std::vector<ReferenceCamera> cameras;
  for (unsigned view = 0; view < kSideViews; ++view)
    cameras.push_back(side_camera(view, 1U << coarse));
  const std::vector<Voxel> rest =
      unseen_of(voxels, seen_by_all(cameras, coarse, voxels, voxels, choice.threads));
  const auto least = static_cast<size_t>(choice.least_gain * static_cast<double>(voxels.size()));
  if (rest.empty() || rest.size() < least || choice.most == 0) return {};
  const std::vector<glm::dvec3> directions = candidates();
  cameras.clear();
  for (const glm::dvec3& direction : directions)
    cameras.push_back(slanting_camera(direction, 1U << coarse));
  std::vector<glm::dvec3> result;
  for (const size_t k : choose(seen_by_all(cameras, coarse, voxels, rest, choice.threads),
                               rest.size(), choice.most, least))
    result.push_back(directions[k]);
  return result;
}

}  // namespace afx
