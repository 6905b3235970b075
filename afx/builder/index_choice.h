// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Which image colours which voxel: true colours with few index symbols.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace afx {

/// At most this many images take part in a choice.
inline constexpr unsigned kMaxChoices = 6;

/// How bad each image would be for one voxel; 0 = perfect. Only [0, images) count.
struct ChoiceCosts {
  double of[kMaxChoices] = {};
};

/// What is weighed against the costs: the price of one symbol of the index tree. In units of
/// ChoiceCosts.
inline constexpr double kSymbolPrice = 24;

/// Chooses an image for each voxel such that the sum of all costs plus kSymbolPrice for each symbol
/// of the index tree is least, by dynamic programming over the octree from the voxels to the root:
/// a node is either given to one image as a whole (one symbol) or left to its children. Ties go to
/// the whole, and to the lower image.
///
/// codes    Morton codes of all voxels, ascending, levels deep
/// images   1..kMaxChoices
/// cost     called for each voxel number, twice
/// Returns  for each voxel the image, 1..images
/// Memory   up to 57 bytes a node of the level above the voxels, 2 bytes a voxel
std::vector<uint8_t> choose_index(std::span<const uint64_t> codes, unsigned levels, unsigned images,
                                  const std::function<ChoiceCosts(size_t)>& cost);

}  // namespace afx
