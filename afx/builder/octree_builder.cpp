// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/octree_builder.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <string>
#include <utility>

#include "afx/builder/cube_cut.h"
#include "afx/builder/grid.h"
#include "afx/builder/model_builder.h"
#include "afx/builder/placement.h"
#include "afx/builder/surfel_voxels.h"
#include "afx/builder/voxelize.h"
#include "afx/octree_stream.h"
#include "afx/voxel_blocks.h"
#include "afx/voxel_shading.h"

namespace afx {
namespace {

constexpr uint32_t kMaxImageSize = 4096;

Error refused(const std::string& text) { return Error{Errc::bad_argument, {}, text, {}, {}}; }

Status check_cube(const Cube& cube) {
  const glm::dvec3 c = cube.centre;
  if (!std::isfinite(c.x) || !std::isfinite(c.y) || !std::isfinite(c.z))
    return refused("the cube's centre is not finite");
  if (!(cube.side > 0 && std::isfinite(cube.side) && std::isfinite(1 / cube.side)))
    return refused("the cube's side is " + std::to_string(cube.side) + " (expected a length > 0)");
  return {};
}

Status check_options(const BuildOptions& options) {
  if (options.resolution < 1 || options.resolution > kMaxBuildResolution)
    return refused("the resolution is " + std::to_string(options.resolution) +
                   " (expected 1 to 2048)");
  if (options.image_size > kMaxImageSize)
    return refused("the image size is " + std::to_string(options.image_size) +
                   " (expected at most 4096)");
  if (options.images != 0 && (options.images < kSideViews || options.images > kMaxStreamTextures))
    return refused(std::to_string(options.images) +
                   " images (expected 6 to 127, or 0 for as many as are worth their bytes)");
  if (options.symbol_price && !(*options.symbol_price >= 0))
    return refused("the price of an index symbol is " + std::to_string(*options.symbol_price) +
                   " (expected 0 or more)");
  return options.cube ? check_cube(*options.cube) : Status{};
}

void report(const BuildOptions& options, const char* stage, double done) {
  if (options.progress) options.progress(stage, done);
}

void shade(SurfaceVoxels& voxels, bool coloured, unsigned levels, unsigned threads) {
  const bool known = std::any_of(voxels.normals.begin(), voxels.normals.end(),
                                 [](const glm::vec3& n) { return n != glm::vec3(0); });
  if (!known && !voxels.codes.empty())
    voxels.normals = surface_normals(voxels.codes, levels, VoxelBlocks(voxels.codes), threads);
  for (size_t i = 0; i < voxels.codes.size(); ++i)
    voxels.colours[i] = lit(coloured, voxels.colours[i], voxels.normals[i]);
}

Result<BuiltOctree> finish(SurfaceVoxels voxels, const Grid& grid, const BuildOptions& options,
                           Colouring colouring, uint64_t primitives, const glm::dvec3& origin) {
  const bool shaded = is_to_be_shaded(colouring, options.shade);
  if (shaded) shade(voxels, colouring != Colouring::none, grid.levels, options.threads);
  report(options, "outside", 0.65);
  auto built = build_model(std::move(voxels), grid.levels, grid.resolution, options);
  if (!built.ok()) return built;
  BuildStatistics& statistics = built.value().statistics;
  statistics.primitives = primitives;
  statistics.shaded = shaded;
  const double cube = static_cast<double>(1U << grid.levels);
  statistics.side = cube / grid.scale;
  statistics.centre =
      origin + grid.object_centre + glm::dvec3((cube / 2 - grid.middle) / grid.scale);
  return built;
}

Error nothing_inside() { return refused("nothing of the model lies in the cube"); }

void warn_outside(uint64_t count, const char* what, Diagnostics& diagnostics) {
  if (count == 0) return;
  diagnostics.warn("outside_cube", Place::none(),
                   std::to_string(count) + " " + what + "; what lies outside is left out");
}

Result<BuiltOctree> build_from(const Mesh& mesh, const Grid& grid, const BuildOptions& options) {
  const auto done = [&](double part) { report(options, "voxels", 0.6 * part); };
  Result<SurfaceVoxels> voxels = voxelize(mesh, grid, options.threads, options.limits, done);
  if (!voxels.ok()) return voxels.error();
  return finish(std::move(voxels).value(), grid, options, colouring_of(mesh), mesh.triangles.size(),
                {});
}

Result<BuiltOctree> build_from(const PointCloud& cloud, const Grid& grid,
                               const BuildOptions& options) {
  Result<SurfaceVoxels> voxels = voxelize(cloud, grid, options.limits);
  if (!voxels.ok()) return voxels.error();
  return finish(std::move(voxels).value(), grid, options, colouring_of(cloud),
                cloud.positions.size(), cloud.origin);
}

}  // namespace

Result<BuiltOctree> build_octree(const Mesh& mesh, const BuildOptions& options,
                                 Diagnostics& diagnostics) {
  if (Status status = check_options(options); !status.ok()) return status.error();
  if (mesh.triangles.empty()) return refused("the mesh has no triangles");
  if (!options.cube) return build_from(mesh, Grid(bounds_of(mesh), options.resolution), options);
  uint64_t outside = 0;
  const Mesh inside = inside_of_cube(mesh, *options.cube, outside);
  if (inside.triangles.empty()) return nothing_inside();
  warn_outside(outside, "triangles reach out of the cube", diagnostics);
  return build_from(inside, Grid(*options.cube, options.resolution), options);
}

Result<BuiltOctree> build_octree(const PointCloud& cloud, const BuildOptions& options,
                                 Diagnostics& diagnostics) {
  if (Status status = check_options(options); !status.ok()) return status.error();
  if (cloud.positions.empty()) return refused("the point cloud has no points");
  if (!options.cube)
    return build_from(cloud, Grid(bounds_of(cloud.positions), options.resolution), options);
  Cube cube = *options.cube;
  cube.centre -= cloud.origin;
  const Grid grid(cube, options.resolution);
  uint64_t outside = 0;
  const PointCloud inside = inside_of_cube(cloud, grid, outside);
  if (inside.positions.empty()) return nothing_inside();
  warn_outside(outside, "points lie outside of the cube", diagnostics);
  return build_from(inside, grid, options);
}

Result<BuiltOctree> build_octree(const Surfels& surfels, const BuildOptions& options,
                                 Diagnostics& diagnostics) {
  if (Status status = check_options(options); !status.ok()) return status.error();
  if (surfels.size() == 0) return refused("the model has no samples");
  const Grid grid = options.cube ? Grid(*options.cube, options.resolution)
                                 : Grid(bounds_of(surfels), options.resolution);
  uint64_t outside = 0;
  Result<SurfaceVoxels> voxels = voxelize(surfels, grid, options.threads, options.limits, outside);
  if (!voxels.ok()) return voxels.error();
  if (voxels.value().codes.empty())
    return options.cube ? nothing_inside() : refused("nothing of the model can be seen");
  if (options.cube) warn_outside(outside, "samples reach out of the cube", diagnostics);
  return finish(std::move(voxels).value(), grid, options, Colouring::painted, surfels.size(), {});
}

}  // namespace afx
