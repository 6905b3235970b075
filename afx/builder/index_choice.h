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

/// Tells how bad each image would be for one voxel; 0 = perfect. Fills all of `costs`.
using ChoiceCosts = std::function<void(size_t voxel, std::span<double> costs)>;

/// What is weighed against the costs: the greatest price of one symbol of the index tree that makes
/// sense. In units of ChoiceCosts.
inline constexpr double kSymbolPrice = 24;

/// Chooses an image for each voxel such that the sum of all costs plus `price` for each symbol of
/// the index tree is least, by dynamic programming over the octree from the voxels to the root: a
/// node is either given to one image as a whole (one symbol) or left to its children. Ties go to
/// the whole, and to the lower image.
///
/// codes    Morton codes of all voxels, ascending, levels deep
/// images   1..255
/// cost     called for each voxel number, in ascending order, once and for some again
/// Returns  for each voxel the image, 1..images
/// Memory   a byte a node and two a voxel
std::vector<uint8_t> choose_index(std::span<const uint64_t> codes, unsigned levels, unsigned images,
                                  const ChoiceCosts& cost, double price);

}  // namespace afx
