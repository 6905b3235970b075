// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// From the nodes of an octree to discs on the grid of samples, from parent to child.
#pragma once

#include <array>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "render/lens.h"
#include "render/renderer.h"
#include "render/scene.h"

namespace afx::render {

/// The eight children of a node as discs: element i is child i, whether it is there or not. Places
/// and radii in samples; the radius is negative where there is nothing to be seen.
struct EightDiscs {
  float x[8], y[8], depth[8], radius[8];
};

/// The nodes of one cloud as one camera sees them.
///
/// The radius of a node's disc is half the longest of its four space diagonals as projected, with
/// the depth of its nearest corner, so that the disc holds the whole projection of the node; times
/// RenderOptions::splat_scale. A node nearer than its own size is drawn as its enclosing sphere.
/// This is the paper's rule (section VI) for every node by itself instead of for cells.
class OctreeView {
 public:
  /// What the nodes of a level have in common.
  struct Size {
    glm::dvec3 offsets[8];      ///< from the centre of a node of the level above to its children's
    float x[8], y[8], z[8];     ///< the same
    glm::dvec3 diagonals[4];    ///< from the centre to a corner
    float dx[4], dy[4], dz[4];  ///< the same
    double side;                ///< the longest
    double reach;               ///< the longest of the diagonals
    double half_depth;          ///< the largest part of them along z
    double flat_radius;         ///< parallel projection: of every node, in samples
    float bulge, tolerance;     ///< see Splat
  };

  /// cloud, options   checked; all must outlive it
  OctreeView(const VoxelCloud& cloud, const Lens& lens, const RenderOptions& options);

  [[nodiscard]] const VoxelTree& tree() const { return *tree_; }
  /// The finest level that is drawn.
  [[nodiscard]] unsigned last_level() const { return last_; }
  [[nodiscard]] const Size& size(unsigned level) const { return sizes_[level]; }
  /// The centre of the root in the camera's system.
  [[nodiscard]] const glm::dvec3& root() const { return root_; }
  [[nodiscard]] const Lens& lens() const { return lens_; }

  /// Whether nodes of a level, with their parent's centre there, are to be drawn as they are.
  [[nodiscard]] bool is_last(unsigned level, const glm::dvec3& parent) const;
  /// Bit k: the half of a node with the larger coordinate k is the nearer one for whoever looks
  /// along `ray` (in the camera's system).
  [[nodiscard]] unsigned nearest_child(const glm::dvec3& ray) const;

  /// The children of a node, of `level`.
  void project(const glm::dvec3& parent, unsigned level, EightDiscs& out) const;
  /// A node by itself, as element 0.
  void project_one(const glm::dvec3& centre, unsigned level, EightDiscs& out) const {
    project_exactly(centre, level, 0, out);
  }

  /// How much each side of the nodes around a place counts as it is seen from the eye, in the order
  /// of VoxelTree::Sides: the squares of the cosines, 0 for those turned away.
  struct SideWeights {
    float of[6];
  };
  [[nodiscard]] SideWeights side_weights(const glm::dvec3& centre) const;
  /// The colour of a node, linear. weights   for levels above the tree's last
  [[nodiscard]] glm::vec3 light(unsigned level, uint32_t number, const SideWeights& weights) const;

  /// A square on the screen that holds the discs of a node's descendants, and a depth that none of
  /// these is nearer than, less their tolerance.
  struct Bound {
    float x, y, reach;  ///< samples; infinite reach: no bound is known
    float depth;
  };
  [[nodiscard]] Bound bound(const glm::dvec3& centre, unsigned level) const;

 private:
  [[nodiscard]] bool is_far(const glm::dvec3& parent, unsigned level) const;
  void project_exactly(const glm::dvec3& centre, unsigned level, int child, EightDiscs& out) const;
  [[nodiscard]] double radius(const glm::dvec3& centre, const Size& size) const;

  const VoxelTree* tree_;
  const Lens& lens_;
  const std::array<float, 256>& linear_;  // of sRGB
  unsigned last_;
  double scale_;
  bool points_;
  double coarseness_;
  glm::dmat3 axes_;     // of the cube, in the camera's system
  glm::dmat3 to_cube_;  // the other way round; not finite where the cube is flat
  glm::dvec3 root_;
  std::vector<Size> sizes_;  // by level
};

}  // namespace afx::render
