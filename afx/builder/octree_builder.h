// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Meshes and point clouds to OctreeImages: voxels, octree, reference images, image indices.
// Source: the paper, section VII.A.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "afx/builder/grid.h"
#include "afx/builder/image_fill.h"
#include "afx/builder/index_choice.h"
#include "afx/builder/mesh.h"
#include "afx/builder/reference_cameras.h"
#include "afx/builder/shading.h"
#include "afx/octree_model.h"
#include "afx/surfels.h"
#include "codec/diagnostics.h"
#include "codec/error.h"
#include "codec/limits.h"

namespace afx {

/// The greatest resolution that the builder builds.
inline constexpr uint32_t kMaxBuildResolution = 2048;

struct BuildOptions {
  uint32_t resolution = 256;  ///< voxels along the longest side of the object, 1..2048
  /// Pixels along a side of the reference images, 1..4096; 0 = 2^levels. To draw one takes up to 81
  /// bytes for each pixel of a square of that side.
  uint32_t image_size = 0;
  /// Reference images at most: 6 = one from each side, to 127 = from elsewhere too, as long as
  /// they show more of the outside; 0 = as long as they show so much more that it is worth their
  /// bytes. Those that no voxel takes are left out.
  unsigned images = 0;
  /// What a symbol of voxelImageIndex may cost in squared difference of colour, see
  /// index_choice.h; 0 = each voxel has its best image. Without it what loses 0.2 dB at most;
  /// kSymbolPrice suits images that are then coded as JPEG of quality 90.
  std::optional<double> symbol_price = {};
  ImageCoder coder = ImageCoder::png;  ///< that the images are meant for: what free pixels show
  unsigned threads = 0;                ///< 0 = all cores; the result is the same for any number
  /// The cube to build in, in the coordinates of the input: 2^levels voxels a side, levels those of
  /// the resolution; what lies outside is left out and counted in a warning ("outside_cube").
  /// Without it the object is fitted in.
  std::optional<Cube> cube = {};
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
  uint64_t pixels = 0;         ///< of all images
  uint64_t used_pixels = 0;    ///< of those, the ones that exposed voxels take their colours from
  /// dB, of the exposed voxels: colours by their images against their own; 99 = equal
  double psnr = 0;
  /// The same if each took the image that shows it best as it is seen.
  double best_psnr = 0;
  uint32_t worst = 0;   ///< of the same, the greatest difference of one component, 0..255
  uint64_t off = 0;     ///< of the same, voxels with a component that differs by more than 16
  bool shaded = false;  ///< the light was painted in
  glm::dvec3 centre{0, 0, 0};  ///< of the octree's cube, in the coordinates of the input
  double side = 1;             ///< of the cube, in units of the input
};

struct BuiltOctree {
  /// Images RGB, image_size pixels for a length of the cube's side, cropped to what voxels take
  /// their colours from.
  OctreeModel model;
  std::vector<std::string> names;       ///< of the images, see reference_name()
  std::vector<std::vector<bool>> used;  ///< for each image its used pixels, row by row from the top
  BuildStatistics statistics;
};

/// Builds an OctreeImage. The object is centred in the cube, its longest side `resolution` voxels;
/// a voxel is set where the surface passes through it (a surface just between two voxels sets one
/// of them). Pixels of the images carry colours filtered over the surface in a voxel, in linear
/// light.
/// Errors  bad_argument: an option out of range, no triangles, points or pieces, nothing of them in
///         the cube, or all of it transparent;
///         limit_exceeded: more voxels than limits.octree_nodes or memory than limits.memory
Result<BuiltOctree> build_octree(const Mesh& mesh, const BuildOptions& options,
                                 Diagnostics& diagnostics);
Result<BuiltOctree> build_octree(const PointCloud& cloud, const BuildOptions& options,
                                 Diagnostics& diagnostics);
Result<BuiltOctree> build_octree(const Surfels& surfels, const BuildOptions& options,
                                 Diagnostics& diagnostics);

}  // namespace afx
