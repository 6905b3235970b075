// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Which images an OctreeImage should have: what each would be for every voxel, and whether it is
// worth its bytes.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "afx/builder/reference_cameras.h"
#include "afx/octree_model.h"
#include "codec/octree.h"

namespace afx {

/// An image that may become one of an OctreeImage's. The lists are by voxel.
struct ImageCandidate {
  unsigned view = 0;  ///< see reference_name()
  ReferenceCamera camera = {};
  double worth = 0;             ///< the squared difference that it must spare, in all
  std::vector<bool> seen = {};  ///< it shows the voxel
  /// From the voxel's colour, of the pixel that it would take, components summed up; 65535 stands
  /// for more, too.
  std::vector<uint16_t> squared = {};
  std::vector<uint16_t> packed_costs = {};
  /// What taking the image costs a voxel in choose_index().
  [[nodiscard]] double cost(size_t voxel) const;
};

/// The voxels that images are judged by; parallel lists.
struct JudgedVoxels {
  std::span<const Voxel> coordinates;
  std::span<const Rgba8> colours;
  std::span<const glm::vec3> normals;  ///< unit or zero
  std::span<const uint8_t> exposed;    ///< 1: can be seen from outside
  unsigned levels = 0;
};

/// Bytes that weigh() gives a candidate for each voxel, and some bits.
inline constexpr uint64_t kCandidateBytes = 2 * sizeof(uint16_t);

/// Draws what the camera of a candidate sees and fills in all the rest.
void weigh(ImageCandidate& candidate, const JudgedVoxels& voxels);

/// Leaves out the images, but for those of the six sides, that are not worth their bytes: all the
/// exposed voxels are not shown so much better than by the best of the others. One after the other,
/// the worst first.
void drop_dear_images(std::vector<ImageCandidate>& candidates, std::span<const uint8_t> exposed);

/// The mean over the exposed voxels (one at least) of the squared differences from the images that
/// show them best.
double least_difference(std::span<const ImageCandidate> candidates,
                        std::span<const uint8_t> exposed);

/// Squared difference, in sRGB, of a pixel and a colour; components summed up.
int squared_difference(const uint8_t* pixel, Rgba8 colour);

}  // namespace afx
