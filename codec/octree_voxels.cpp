// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "codec/octree_voxels.h"

#include <algorithm>
#include <array>
#include <bit>
#include <string>

namespace afx::codec {
namespace {

constexpr uint64_t kEveryThird = 0x1249249249249249;  // bits 0, 3, 6 ... 60

/// Moves bit k of a 21-bit value to bit 3k.
constexpr uint64_t spread(uint64_t v) {
  v &= 0x1fffff;
  v = (v | v << 32) & 0x001f00000000ffff;
  v = (v | v << 16) & 0x001f0000ff0000ff;
  v = (v | v << 8) & 0x100f00f00f00f00f;
  v = (v | v << 4) & 0x10c30c30c30c30c3;
  return (v | v << 2) & kEveryThird;
}

constexpr uint32_t gather(uint64_t v) {
  v &= kEveryThird;
  v = (v | v >> 2) & 0x10c30c30c30c30c3;
  v = (v | v >> 4) & 0x100f00f00f00f00f;
  v = (v | v >> 8) & 0x001f0000ff0000ff;
  v = (v | v >> 16) & 0x001f00000000ffff;
  return static_cast<uint32_t>((v | v >> 32) & 0x1fffff);
}

/// Row b: the children of a node of symbol b in order, then zeros. A node is expanded by storing
/// the whole row and advancing by the number of its children, which needs no branch.
template <class T>
constexpr std::array<std::array<T, 8>, 256> child_rows() {
  std::array<std::array<T, 8>, 256> rows{};
  for (unsigned symbol = 0; symbol < 256; ++symbol) {
    unsigned n = 0;
    for (unsigned child = 0; child < 8; ++child) {
      if ((symbol >> child & 1) != 0) rows[symbol][n++] = static_cast<T>(child);
    }
  }
  return rows;
}
constexpr auto kChildren = child_rows<uint64_t>();
constexpr size_t kSlack =
    8;  // entries that storing a whole row may write behind a node without children

Error too_few_bytes(size_t have, uint64_t start, uint64_t count, unsigned level) {
  return {Errc::bad_argument, Place::none(),
          "field octree has " + std::to_string(have) + " bytes, too few for its structure (level " +
              std::to_string(level) + " begins at byte " + std::to_string(start) + " and has " +
              std::to_string(count) + " nodes)"};
}

Error too_many_bytes(size_t have, uint64_t end, unsigned levels) {
  return {Errc::bad_argument, Place::none(),
          "field octree has " + std::to_string(have) +
              " bytes, too many for its structure (expected " + std::to_string(end) +
              " bytes for " + std::to_string(levels) + " levels)"};
}

Error too_many_nodes(const Limits& limits) {
  return {Errc::limit_exceeded, Place::none(),
          "octree has more nodes than the limit of " + std::to_string(limits.octree_nodes)};
}

Error index_length(size_t have, uint64_t expected, bool exact) {
  return {Errc::bad_argument, Place::none(),
          "field voxelImageIndex has " + std::to_string(have) + " symbols, too " +
              (have < expected ? "few" : "many") + " for the octree (expected " +
              (exact ? "" : "at least ") + std::to_string(expected) + ")"};
}

}  // namespace

uint64_t morton_code(Voxel voxel) {
  return spread(voxel.x) | spread(voxel.y) << 1 | spread(voxel.z) << 2;
}

Voxel morton_decode(uint64_t code) { return {gather(code), gather(code >> 1), gather(code >> 2)}; }

Result<std::vector<uint64_t>> octree_level_counts(std::span<const uint8_t> octree, unsigned levels,
                                                  const Limits& limits) {
  std::vector<uint64_t> counts{1};
  uint64_t at = 0;
  uint64_t nodes = 1;
  for (unsigned level = 0; level < levels; ++level) {
    const uint64_t count = counts[level];
    if (octree.size() - at < count) return too_few_bytes(octree.size(), at, count, level);
    counts.push_back(count_children(octree.subspan(at, count)));
    at += count;
    nodes += counts.back();
    if (nodes > limits.octree_nodes) return too_many_nodes(limits);
  }
  if (at != octree.size()) return too_many_bytes(octree.size(), at, levels);
  return counts;
}

Result<std::vector<uint64_t>> octree_morton(std::span<const uint8_t> octree, unsigned levels,
                                            unsigned level, const Limits& limits) {
  if (level > kMortonLevels) {
    return Error{Errc::unsupported, Place::none(),
                 "Morton codes hold " + std::to_string(kMortonLevels) + " levels, not " +
                     std::to_string(level)};
  }
  const auto counts = octree_level_counts(octree, levels, limits);
  if (!counts.ok()) return counts.error();
  std::vector<uint64_t> codes{0};
  const uint8_t* symbol = octree.data();
  for (unsigned l = 0; l < std::min(level, levels); ++l) {
    std::vector<uint64_t> below(counts.value()[l + 1] + kSlack);
    uint64_t* out = below.data();
    for (const uint64_t code : codes) {
      const auto& row = kChildren[*symbol];
      for (unsigned k = 0; k < 8; ++k) out[k] = code << 3 | row[k];
      out += std::popcount(*symbol++);
    }
    below.resize(counts.value()[l + 1]);
    codes = std::move(below);
  }
  return codes;
}

Result<std::vector<Voxel>> octree_voxels(std::span<const uint8_t> octree, unsigned levels,
                                         unsigned level, const Limits& limits) {
  const auto counts = octree_level_counts(octree, levels, limits);
  if (!counts.ok()) return counts.error();
  std::vector<Voxel> voxels{{0, 0, 0}};
  const uint8_t* symbol = octree.data();
  for (unsigned l = 0; l < std::min(level, levels); ++l) {
    std::vector<Voxel> below(counts.value()[l + 1] + kSlack);
    Voxel* out = below.data();
    for (const Voxel voxel : voxels) {
      const auto& row = kChildren[*symbol];
      for (unsigned k = 0; k < 8; ++k) {
        const auto child = static_cast<uint32_t>(row[k]);
        out[k] = {voxel.x << 1 | (child & 1), voxel.y << 1 | (child >> 1 & 1),
                  voxel.z << 1 | child >> 2};
      }
      out += std::popcount(*symbol++);
    }
    below.resize(counts.value()[l + 1]);
    voxels = std::move(below);
  }
  return voxels;
}

std::vector<uint8_t> octree_from_morton(std::span<const uint64_t> codes, unsigned levels) {
  if (levels == 0) return {};
  if (codes.empty()) return {0};
  std::vector<std::vector<uint8_t>> symbols(levels);  // a level each
  std::vector<uint64_t> nodes;                        // the codes of the level below
  std::span<const uint64_t> below = codes;
  for (unsigned level = levels; level-- > 0;) {
    std::vector<uint8_t>& here = symbols[level];
    std::vector<uint64_t> parents;
    for (size_t i = 0; i < below.size();) {
      const uint64_t parent = below[i] >> 3;
      unsigned symbol = 0;
      for (; i < below.size() && below[i] >> 3 == parent; ++i) symbol |= 1U << (below[i] & 7);
      here.push_back(static_cast<uint8_t>(symbol));
      parents.push_back(parent);
    }
    nodes = std::move(parents);
    below = nodes;
  }
  std::vector<uint8_t> octree;
  size_t total = 0;
  for (const auto& level : symbols) total += level.size();
  octree.reserve(total);
  for (const auto& level : symbols) octree.insert(octree.end(), level.begin(), level.end());
  return octree;
}

Result<std::vector<uint8_t>> octree_voxel_images(const OctreeFields& fields, unsigned levels,
                                                 unsigned level, const Limits& limits) {
  const auto counts = octree_level_counts(fields.octree, levels, limits);
  if (!counts.ok()) return counts.error();
  level = std::min(level, levels);
  const std::vector<uint8_t>& index = fields.voxel_image_index;
  if (index.empty()) return std::vector<uint8_t>(counts.value()[level], 0);

  std::vector<uint8_t> images{index[0]};  // of the nodes of a level; 0 = undefined
  std::vector<uint8_t> result = images;
  size_t next = 1;
  const uint8_t* symbol = fields.octree.data();
  for (unsigned l = 0; l < levels; ++l) {
    std::vector<uint8_t> below;
    below.reserve(counts.value()[l + 1]);
    for (const uint8_t image : images) {
      const auto children = static_cast<size_t>(std::popcount(*symbol++));
      if (image != 0) {
        below.insert(below.end(), children, image);
        continue;
      }
      if (index.size() - next < children) return index_length(index.size(), next + children, false);
      below.insert(below.end(), index.begin() + static_cast<ptrdiff_t>(next),
                   index.begin() + static_cast<ptrdiff_t>(next + children));
      next += children;
    }
    images = std::move(below);
    if (l + 1 == level) result = images;
  }
  if (next != index.size()) return index_length(index.size(), next, true);
  return result;
}

std::vector<uint8_t> octree_image_index(std::span<const uint8_t> octree, unsigned levels,
                                        std::span<const uint8_t> voxel_images) {
  const auto counts = octree_level_counts(octree, levels);
  if (!counts.ok() || counts.value()[levels] != voxel_images.size()) return {};
  // Bottom up: the image that all voxels below a node share, 0 if they differ, kNone if there are
  // none.
  constexpr uint16_t kNone = 256;
  std::vector<std::vector<uint16_t>> shared(levels + 1);
  shared[levels].assign(voxel_images.begin(), voxel_images.end());
  size_t start = octree.size();
  for (unsigned level = levels; level-- > 0;) {
    start -= counts.value()[level];
    const uint16_t* child = shared[level + 1].data();
    shared[level].reserve(counts.value()[level]);
    for (size_t node = 0; node < counts.value()[level]; ++node) {
      uint16_t image = kNone;
      for (int n = std::popcount(octree[start + node]); n > 0; --n, ++child) {
        if (image == kNone) image = *child;
        if (*child != kNone && *child != image) image = 0;
      }
      shared[level].push_back(image);
    }
  }
  // Top down: a symbol for each node whose parent is undefined.
  std::vector<uint8_t> index;
  std::vector<bool> coded{true};
  const uint8_t* symbol = octree.data();
  for (unsigned level = 0; level <= levels; ++level) {
    std::vector<bool> below;
    for (size_t node = 0; node < shared[level].size(); ++node) {
      const uint16_t image = shared[level][node];
      if (coded[node]) index.push_back(image == kNone ? uint8_t{0} : static_cast<uint8_t>(image));
      if (level < levels) {
        below.insert(below.end(), static_cast<size_t>(std::popcount(*symbol++)),
                     coded[node] && (image == 0 || image == kNone));
      }
    }
    coded = std::move(below);
  }
  return index;
}

}  // namespace afx::codec
