// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/voxel_tree.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <string>

#include "afx/srgb.h"
#include "codec/octree_voxels.h"

namespace afx::render {
namespace {

constexpr uint64_t kMostVoxels = uint64_t{1} << 31;
constexpr float kLeastAgreement = 0.5F;  // of the normals below a node, for it to have one

/// What is seen of a node from one side: light, times the part of its face that is covered.
struct Seen {
  glm::vec3 light{0};
  float covered = 0;
};
using SeenSides = std::array<Seen, 6>;

/// The surface in a node: sums over its voxels.
struct Piece {
  glm::vec3 normal{0};
  glm::dvec3 place{0};  // in voxels of the last level, from the corner of the cube
  uint32_t voxels = 0;
};

/// The nodes of one level, from which those of the level above are made.
struct Level {
  std::vector<uint64_t> codes;
  std::vector<SeenSides> seen;  // empty: voxels, which look the same from all sides
  std::vector<Piece> pieces;
};

Error bad(const std::string& text) { return {Errc::bad_argument, Place::none(), text}; }

Status check(const VoxelSurface& surface, size_t voxels) {
  if (surface.normals.size() != voxels || surface.heights.size() != voxels ||
      surface.seen.size() != voxels) {
    return bad(std::to_string(voxels) + " voxels with " + std::to_string(surface.normals.size()) +
               " normals, " + std::to_string(surface.heights.size()) + " heights and " +
               std::to_string(surface.seen.size()) + " seen (expected as many)");
  }
  for (size_t i = 0; i < voxels; ++i) {
    if (surface.seen[i] >= voxels)
      return bad("voxel " + std::to_string(i) + " is seen as another one that is not there");
    const glm::vec3 n = surface.normals[i];
    if (!std::isfinite(n.x + n.y + n.z) || !(std::abs(surface.heights[i]) <= 1))
      return bad("the surface in voxel " + std::to_string(i) +
                 " has no finite normal, or a height beyond 1");
  }
  return {};
}

Status check(unsigned level, std::span<const uint64_t> codes, std::span<const Rgba8> colours,
             const VoxelSurface* surface) {
  if (level > codec::kMortonLevels) {
    return bad("voxels of level " + std::to_string(level) + " (expected at most " +
               std::to_string(codec::kMortonLevels) + ")");
  }
  if (codes.size() != colours.size()) {
    return bad(std::to_string(codes.size()) + " voxels with " + std::to_string(colours.size()) +
               " colours (expected as many)");
  }
  if (surface != nullptr) {
    if (Status fits = check(*surface, codes.size()); !fits.ok()) return fits;
  }
  if (codes.size() >= kMostVoxels) {
    return bad(std::to_string(codes.size()) + " voxels (expected fewer than 2^31)");
  }
  const auto unsorted = std::adjacent_find(codes.begin(), codes.end(), std::greater_equal<>());
  if (unsorted != codes.end()) {
    return bad("voxel " + std::to_string(unsorted - codes.begin()) +
               " does not come before the one after it (expected ascending codes)");
  }
  if (!codes.empty() && codes.back() >> (3 * level) != 0) {
    return bad("a voxel lies outside of the cube of level " + std::to_string(level));
  }
  return {};
}

/// How many nodes each level has. Between two codes all levels change from that of their first
/// different bits on.
std::vector<uint64_t> count_nodes(unsigned level, std::span<const uint64_t> codes) {
  std::vector<uint64_t> counts(level + 1, codes.empty() ? 0 : 1);
  for (size_t i = 1; i < codes.size(); ++i) {
    const auto bit = static_cast<unsigned>(std::bit_width(codes[i] ^ codes[i - 1])) - 1;
    for (unsigned at = level - bit / 3; at <= level; ++at) ++counts[at];
  }
  return counts;
}

/// The tree, and the two levels that are held while one is made from the other.
Status check_memory(std::span<const uint64_t> counts, const Limits& limits) {
  constexpr uint64_t kWork = sizeof(uint64_t) + sizeof(SeenSides) + sizeof(Piece);
  constexpr uint64_t kInner =
      sizeof(VoxelTree::Branch) + sizeof(VoxelTree::Sides) + sizeof(VoxelTree::Facet);
  uint64_t kept = 0, most = 0;
  for (size_t at = 0; at + 1 < counts.size(); ++at) {
    kept += counts[at] * kInner;
    most = std::max(most, (counts[at] + counts[at + 1]) * kWork);
  }
  kept += counts.back() * (sizeof(Rgba8) + sizeof(VoxelTree::Facet));
  if (kept + most <= limits.memory) return {};
  return Error{Errc::limit_exceeded, Place::none(),
               "an octree of " + std::to_string(counts.back()) +
                   " voxels needs more memory to be drawn than the limits allow"};
}

/// The nearer one before the other.
Seen over(const Seen& near, const Seen& far) {
  const float open = 1 - near.covered;
  return {near.light + open * far.light, near.covered + open * far.covered};
}

/// A node from one side, from its children: four columns of two.
Seen seen_from(int side, const std::array<SeenSides, 8>& children) {
  const unsigned axis = 1U << (side / 2);
  Seen sum;
  for (unsigned low = 0; low < 8; ++low) {
    if ((low & axis) != 0) continue;
    const unsigned near = side % 2 == 0 ? low | axis : low;
    const auto at = static_cast<size_t>(side);
    const Seen column = over(children[near][at], children[near ^ axis][at]);
    sum.light += column.light / 4.0F;
    sum.covered += column.covered / 4;
  }
  return sum;
}

SeenSides seen_of_voxel(Rgba8 colour) {
  SeenSides seen;
  seen.fill({glm::vec3(linear_light(colour)), 1});
  return seen;
}

std::vector<Piece> pieces_of(std::span<const uint64_t> codes, const VoxelSurface* surface) {
  std::vector<Piece> pieces(codes.size());
  for (size_t i = 0; i < codes.size(); ++i) {
    const Voxel v = codec::morton_decode(codes[i]);
    pieces[i] = {glm::vec3(0), glm::dvec3(v.x, v.y, v.z) + 0.5, 1};
    if (surface == nullptr) continue;
    pieces[i].normal = surface->normals[i];
    pieces[i].place += glm::dvec3(surface->normals[i] * surface->heights[i]);
  }
  return pieces;
}

void add(Piece& sum, const Piece& piece) {
  sum.normal += piece.normal;
  sum.place += piece.place;
  sum.voxels += piece.voxels;
}

/// depth   levels from the node down to the voxels
VoxelTree::Facet facet_of(const Piece& piece, uint64_t code, unsigned depth) {
  const Voxel v = codec::morton_decode(code);
  const double side = std::ldexp(1.0, static_cast<int>(depth)), count = piece.voxels;
  const glm::dvec3 centre = (glm::dvec3(v.x, v.y, v.z) + 0.5) * side;
  const glm::dvec3 shift = (piece.place / count - centre) / (side / 2);
  const float length = glm::length(piece.normal);
  const bool is_known = length > kLeastAgreement * static_cast<float>(count);
  if (!is_known) return {};
  const glm::vec3 normal = piece.normal / length;
  const auto part = [](double x) {
    return static_cast<int8_t>(std::lround(127 * std::clamp(x, -1.0, 1.0)));
  };
  VoxelTree::Facet facet{};
  for (int k = 0; k < 3; ++k) {
    facet.normal[k] = part(static_cast<double>(normal[k]));
    facet.shift[k] = part(shift[k]);
  }
  return facet;
}

std::vector<VoxelTree::Facet> facets_of(const Level& level, unsigned depth) {
  std::vector<VoxelTree::Facet> facets(level.codes.size());
  for (size_t i = 0; i < facets.size(); ++i)
    facets[i] = facet_of(level.pieces[i], level.codes[i], depth);
  return facets;
}

/// The nodes above those of `below`, and their branches.
Level parents(const Level& below, std::span<const Rgba8> colours, size_t count,
              std::vector<VoxelTree::Branch>& branches) {
  Level level;
  level.codes.reserve(count);
  level.seen.reserve(count);
  level.pieces.reserve(count);
  branches.reserve(count);
  for (size_t i = 0; i < below.codes.size();) {
    const uint64_t code = below.codes[i] >> 3;
    std::array<SeenSides, 8> children{};
    VoxelTree::Branch branch{static_cast<uint32_t>(i), 0};
    Piece piece;
    for (; i < below.codes.size() && below.codes[i] >> 3 == code; ++i) {
      const unsigned child = below.codes[i] & 7;
      branch.symbol |= static_cast<uint8_t>(1U << child);
      add(piece, below.pieces[i]);
      children[child] = below.seen.empty() ? seen_of_voxel(colours[i]) : below.seen[i];
    }
    SeenSides seen;
    for (int side = 0; side < 6; ++side)
      seen[static_cast<size_t>(side)] = seen_from(side, children);
    level.codes.push_back(code);
    level.seen.push_back(seen);
    level.pieces.push_back(piece);
    branches.push_back(branch);
  }
  return level;
}

std::vector<VoxelTree::Sides> colours_of(const Level& level) {
  std::vector<VoxelTree::Sides> colours(level.seen.size());
  for (size_t i = 0; i < colours.size(); ++i) {
    for (size_t side = 0; side < 6; ++side) {
      const Seen& seen = level.seen[i][side];
      colours[i].from[side] = to_srgb(glm::dvec3(seen.light / seen.covered));
    }
  }
  return colours;
}

}  // namespace

Result<std::shared_ptr<const VoxelTree>> VoxelTree::make(unsigned level,
                                                         std::span<const uint64_t> codes,
                                                         std::span<const Rgba8> colours,
                                                         const VoxelSurface* surface,
                                                         const Limits& limits) {
  if (Status s = check(level, codes, colours, surface); !s.ok()) return s.error();
  const std::vector<uint64_t> counts = count_nodes(level, codes);
  if (Status s = check_memory(counts, limits); !s.ok()) return s.error();
  const std::shared_ptr<VoxelTree> tree(new VoxelTree);
  tree->branches_.resize(level);
  tree->sides_.resize(level);
  tree->colours_.assign(colours.begin(), colours.end());
  if (surface != nullptr) {
    for (size_t i = 0; i < colours.size(); ++i) tree->colours_[i] = colours[surface->seen[i]];
  }
  for (Rgba8& colour : tree->colours_) colour.a = 255;
  tree->facets_.resize(level + 1);
  Level nodes{{codes.begin(), codes.end()}, {}, pieces_of(codes, surface)};
  tree->facets_[level] = facets_of(nodes, 0);
  for (unsigned at = level; at-- > 0;) {
    nodes = parents(nodes, tree->colours_, counts[at], tree->branches_[at]);
    tree->sides_[at] = colours_of(nodes);
    tree->facets_[at] = facets_of(nodes, level - at);
  }
  return std::shared_ptr<const VoxelTree>(tree);
}

std::vector<uint64_t> VoxelTree::codes(unsigned level) const {
  std::vector<uint64_t> codes;
  if (voxels() > 0) codes.push_back(0);
  for (unsigned at = 0; at < level; ++at) {
    std::vector<uint64_t> next;
    next.reserve(nodes(at + 1));
    for (size_t i = 0; i < codes.size(); ++i) {
      for (unsigned symbol = branches_[at][i].symbol; symbol != 0; symbol &= symbol - 1)
        next.push_back(codes[i] << 3 | static_cast<unsigned>(std::countr_zero(symbol)));
    }
    codes = std::move(next);
  }
  return codes;
}

uint64_t VoxelTree::bytes() const {
  uint64_t bytes = colours_.size() * sizeof(Rgba8);
  for (const auto& level : branches_) bytes += level.size() * sizeof(Branch);
  for (const auto& level : sides_) bytes += level.size() * sizeof(Sides);
  for (const auto& level : facets_) bytes += level.size() * sizeof(Facet);
  return bytes;
}

}  // namespace afx::render
