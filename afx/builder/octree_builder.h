// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Meshes and point clouds to OctreeImages: voxels, octree, six reference images, image indices.
// Source: the paper, section VII.A.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>

#include "afx/builder/mesh.h"
#include "afx/builder/placement.h"
#include "afx/builder/shading.h"
#include "afx/octree_model.h"
#include "codec/diagnostics.h"
#include "codec/error.h"
#include "codec/limits.h"

namespace afx {

/// The greatest resolution that the builder builds.
inline constexpr uint32_t kMaxBuildResolution = 2048;


struct BuildOptions {
  uint32_t resolution = 256;  ///< voxels along the longest side of the object, 1..2048
  uint32_t image_size = 0;  ///< pixels along a side of the reference images, 1..4096; 0 = 2^levels
  unsigned threads = 0;     ///< 0 = all cores; the result is the same for any number
  UpAxis up = UpAxis::y;
  Shade shade = Shade::automatic;
  /// Called as the work goes on with a stage's name and 0..1 of the whole, from any thread but from
  /// one at a time.
  std::function<void(const char* stage, double done)> progress = {};
  Limits limits = {};
};

struct BuildStatistics {
  uint64_t primitives = 0;  ///< triangles or points that were used
  uint64_t voxels = 0;
  uint64_t exposed = 0;        ///< voxels that can be seen from outside (exposure.h)
  uint64_t seen = 0;           ///< of those, the ones that at least one image shows
  uint64_t index_symbols = 0;  ///< length of voxelImageIndex
  double psnr =
      0;  ///< dB, of the exposed voxels: colours by their images against their own; 99 = equal
  uint32_t worst = 0;   ///< of the same, the greatest difference of one component, 0..255
  uint64_t off = 0;     ///< of the same, voxels with a component that differs by more than 16
  bool shaded = false;  ///< the light was painted in
  glm::dvec3 centre{0, 0, 0};  ///< of the octree's cube, in the coordinates of the input
  double side = 1;             ///< of the cube, in units of the input
};

struct BuiltOctree {
  /// Six images, in the order of kReferenceNames, RGB, image_size squared. None where the model is
  /// empty.
  OctreeModel model;
  BuildStatistics statistics;
};

/// The names of the six images, in the order of OctreeModel::images: camera on +z, -z, +x, -x, +y,
/// -y.
inline constexpr const char* kReferenceNames[6] = {"front", "back", "right",
                                                   "left",  "top",  "bottom"};
/// Distance of their cameras from the centre of the cube, and the planes that enclose the cube, in
/// lengths of the cube's side.
inline constexpr float kReferenceDistance = 1.0F;
inline constexpr float kReferenceNearPlane = 0.5F;
inline constexpr float kReferenceFarPlane = 1.5F;

/// Builds an OctreeImage. The object is centred in the cube, its longest side `resolution` voxels;
/// a voxel is set where the surface passes through it (a surface just between two voxels sets one
/// of them). Pixels of the images carry colours filtered over the surface in a voxel, in linear
/// light. Errors  bad_argument: resolution or image_size out of range, no triangles or points;
///         limit_exceeded: more voxels than limits.octree_nodes or memory than limits.memory
Result<BuiltOctree> build_octree(const Mesh& mesh, const BuildOptions& options,
                                 Diagnostics& diagnostics);
Result<BuiltOctree> build_octree(const PointCloud& cloud, const BuildOptions& options,
                                 Diagnostics& diagnostics);

}  // namespace afx
