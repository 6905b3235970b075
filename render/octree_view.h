// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// From the nodes of an octree to discs on the grid of samples, from parent to child.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "render/lens.h"
#include "render/renderer.h"
#include "render/scene.h"
#include "render/splats.h"

namespace afx::render {

/// The eight children of a node as discs: element i is child i, whether it is there or not.
struct EightDiscs {
  float x[8], y[8];              ///< in samples
  float depth[8];                ///< of the centre
  float nearest[8];              ///< no part of it is nearer
  float reach_x[8], reach_y[8];  ///< how far it is seen around (x, y); negative: not at all
  float radius[8];               ///< in scene units; facing discs: in samples
  float nx[8], ny[8], nz[8];  ///< the normal in the camera's system; (0, 0, 0): it faces the viewer
  float depth_x[8], depth_y[8], nearness[8], a[8], b[8], c[8], bulge[8];  ///< see Tilt
};

/// For each of the eight children of a node a square on the screen that holds the discs of its
/// descendants, and a depth that none of these is nearer than, less their tolerance.
struct EightBounds {
  float x[8], y[8], reach[8];  ///< samples; reach infinite: no bound is known, negative: no discs
  float depth[8];
};

/// The nodes of one cloud as one camera sees them.
///
/// A node whose facet has a normal is the disc around the facet's point at right angles to it, with
/// kFacetRadius of the node's side as radius: large enough to overlap its neighbours on any smooth
/// surface. One without is a disc that faces the viewer; its radius is half the longest of the
/// node's four space diagonals as projected, with the depth of its nearest corner, so that it holds
/// the whole projection of the node (a node nearer than its own size: its enclosing sphere). That
/// is the paper's rule (section VI) for every node by itself instead of for cells. Both radii are
/// multiplied by RenderOptions::splat_scale, and no disc is narrower than kLeastRadius.
class OctreeView {
 public:
  static constexpr double kFacetRadius = 0.75;
  /// Nodes so many of their reaches away are reckoned in floats; nearer ones are never coarser
  /// ones.
  static constexpr double kFarAway = 8;

  /// No part of a disc is nearer than its `nearest`, however depths are rounded: a part of its
  /// radius.
  static constexpr float kRounding = 1e-3F;

  /// What the nodes of a level have in common.
  struct Size {
    glm::dvec3 offsets[8];      ///< from the centre of a node of the level above to its children's
    glm::dvec3 diagonals[4];    ///< from the centre to a corner
    float x[8], y[8], z[8];     ///< the offsets
    float dx[4], dy[4], dz[4];  ///< the diagonals
    glm::dmat3 shift;           ///< takes a facet's shift to the camera's system
    double side;                ///< the longest
    double reach;               ///< the longest of the diagonals
    double half_depth;          ///< the largest part of them along z
    double radius;              ///< of a disc with a normal, in scene units
    double flat_radius;         ///< parallel projection: of every disc without, in samples
    float bulge, tolerance;     ///< see Splat, Tilt
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
  /// Takes normals of facets to the camera's system, up to their length; zero where the cube is
  /// flat.
  [[nodiscard]] const glm::dmat3& normals() const { return normals_; }
  /// No disc of that level is larger, in scene units.
  [[nodiscard]] double disc_reach(unsigned level) const {
    return std::max(sizes_[level].radius, sizes_[level].reach * scale_);
  }

  /// Whether nodes of a level, with their parent's centre there, are to be drawn as they are.
  [[nodiscard]] bool is_last(unsigned level, const glm::dvec3& parent) const {
    if (level == last_) return true;
    const double distance = -parent.z, side = sizes_[level].side;
    if (lens_.perspective && !(distance > kFarAway * side)) return false;
    return lens_.zoom_at(distance) * side <= coarseness_;
  }
  /// Bit k: the half of a node with the larger coordinate k is the nearer one for whoever looks
  /// along `ray` (in the camera's system).
  [[nodiscard]] unsigned nearest_child(const glm::dvec3& ray) const;

  /// The children of a node, of `level`. centre, branch   of the node
  void project(const glm::dvec3& centre, VoxelTree::Branch branch, unsigned level,
               EightDiscs& out) const;
  /// The root by itself, as element 0.
  void project_root(EightDiscs& out) const;

  /// A disc by itself, its light still black.
  [[nodiscard]] Splat splat(const EightDiscs& discs, unsigned i, unsigned level) const {
    return {discs.x[i],     discs.y[i],       discs.reach_x[i],        discs.reach_y[i],
            discs.depth[i], discs.nearest[i], sizes_[level].tolerance, glm::vec3(0)};
  }
  [[nodiscard]] static Tilt tilt(const EightDiscs& discs, unsigned i) {
    return {discs.depth_x[i], discs.depth_y[i], discs.nearness[i], discs.a[i],
            discs.b[i],       discs.c[i],       discs.bulge[i]};
  }

  /// How much each side of the nodes around a place counts as it is seen from the eye, in the order
  /// of VoxelTree::Sides: the squares of the cosines, 0 for those turned away.
  struct SideWeights {
    float of[6];
  };
  [[nodiscard]] SideWeights side_weights(const glm::dvec3& centre) const;
  /// The colour of a node, linear. weights   for levels above the tree's last
  [[nodiscard]] glm::vec3 light(unsigned level, uint32_t number, const SideWeights& weights) const;

  /// The children of a node, of `level`. centre   of the node
  void bounds(const glm::dvec3& centre, unsigned level, EightBounds& out) const;

 private:
  /// The facets of the children, in lanes; for those that are not there, that of another.
  struct EightFacets {
    float sx[8], sy[8], sz[8], nx[8], ny[8], nz[8];
    bool all_tilted;
  };
  [[nodiscard]] bool is_far(const glm::dvec3& parent, unsigned level) const;
  void gather(VoxelTree::Branch branch, unsigned level, EightFacets& facets) const;
  template <bool kPerspective>
  void project_far(const glm::dvec3& centre, const EightFacets& facets, unsigned level,
                   EightDiscs& out) const;
  void project_far_plain(const glm::dvec3& centre, VoxelTree::Branch branch, unsigned level,
                         EightDiscs& out) const;
  void project_far_avx2(const glm::dvec3& centre, VoxelTree::Branch branch, unsigned level,
                        EightDiscs& out) const;
  template <bool kPerspective>
  void tilt_all(unsigned level, EightDiscs& discs) const;
  void tilt_plain(unsigned level, EightDiscs& discs) const;
  template <bool kPerspective>
  void bound_all(const glm::dvec3& centre, unsigned level, EightBounds& out) const;
  void bounds_plain(const glm::dvec3& centre, unsigned level, EightBounds& out) const;
  void bounds_avx2(const glm::dvec3& centre, unsigned level, EightBounds& out) const;
  void project_exactly(const glm::dvec3& centre, const VoxelTree::Facet& facet, unsigned level,
                       unsigned i, EightDiscs& out) const;
  void project_tilted(const glm::dvec3& centre, const glm::dvec3& normal, unsigned level,
                      unsigned i, EightDiscs& out) const;
  [[nodiscard]] double facing_radius(const glm::dvec3& centre, const Size& size) const;

  const VoxelTree* tree_;
  const Lens& lens_;
  const std::array<float, 256>& linear_;  // of sRGB
  unsigned last_;
  double scale_;
  bool points_;
  double coarseness_;
  glm::dmat3 axes_;     // of the cube, in the camera's system
  glm::dmat3 to_cube_;  // the other way round; not finite where the cube is flat
  glm::dmat3 normals_;  // takes normals to the camera's system; zero where the cube is flat
  glm::dvec3 root_;
  bool all_face_;            // no disc is tilted: points, or there are no normals
  std::vector<Size> sizes_;  // by level
};

}  // namespace afx::render
