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

#include "afx/builder/exposure.h"
#include "afx/builder/index_choice.h"
#include "afx/builder/local_mean.h"
#include "afx/builder/reference_views.h"
#include "afx/builder/voxelize.h"
#include "afx/voxel_blocks.h"
#include "afx/voxel_shading.h"
#include "codec/octree_voxels.h"
#include "codec/parallel.h"

namespace afx {
namespace {

constexpr uint32_t kMaxImageSize = 4096;

// How the colour difference of a voxel becomes a cost: the squared difference, and more than that
// once it can be seen, so that a single wrong voxel is never cheaper than a few symbols.
constexpr double kVisible = 40;
// A pixel unlike its neighbours, at a silhouette or where the surface is seen from the side,
// suffers when the picture is coded with loss or smoothed: another image that shows the voxel is
// better.
constexpr double kRough = 0.02;
// Among images that show the same, the one that the surface faces: only a hint, a million voxels of
// it weigh less than a symbol.
constexpr double kFacing = 1e-5;
// Voxels that nobody outside can see should have their colour too, but not at the price of many
// symbols.
constexpr uint32_t kOff = 16;
constexpr double kHiddenWeight = 1.0 / 64;

Error refused(const std::string& text) { return Error{Errc::bad_argument, {}, text, {}, {}}; }

Status check_options(const BuildOptions& options) {
  if (options.resolution < 1 || options.resolution > kMaxBuildResolution)
    return refused("the resolution is " + std::to_string(options.resolution) +
                   " (expected 1 to 2048)");
  if (options.image_size > kMaxImageSize)
    return refused("the image size is " + std::to_string(options.image_size) +
                   " (expected at most 4096)");
  return {};
}

void report(const BuildOptions& options, const char* stage, double done) {
  if (options.progress) options.progress(stage, done);
}

// z up becomes y up: a quarter turn about x.
glm::vec3 turned(const glm::vec3& v) { return {v.x, v.z, -v.y}; }

void turn_up(Mesh& mesh) {
  for (glm::vec3& p : mesh.positions) p = turned(p);
}

void turn_up(PointCloud& cloud) {
  for (glm::vec3& p : cloud.positions) p = turned(p);
  for (glm::vec3& n : cloud.normals) n = turned(n);
}

// Of the vertices that triangles use.
Bounds bounds_of_surface(const Mesh& mesh) {
  const glm::vec3 first = mesh.positions[mesh.triangles[0].x];
  Bounds bounds{first, first};
  for (const glm::uvec3& triangle : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      bounds.low = glm::min(bounds.low, glm::dvec3(mesh.positions[triangle[k]]));
      bounds.high = glm::max(bounds.high, glm::dvec3(mesh.positions[triangle[k]]));
    }
  return bounds;
}

void shade(SurfaceVoxels& voxels, bool coloured, unsigned levels, unsigned threads) {
  const bool known = std::any_of(voxels.normals.begin(), voxels.normals.end(),
                                 [](const glm::vec3& n) { return n != glm::vec3(0); });
  if (!known && !voxels.codes.empty())
    voxels.normals = surface_normals(voxels.codes, levels, VoxelBlocks(voxels.codes), threads);
  for (size_t i = 0; i < voxels.codes.size(); ++i)
    voxels.colours[i] = coloured ? shaded_colour(voxels.colours[i], voxels.normals[i])
                                 : shaded_grey(voxels.normals[i]);
}

// From coloured voxels to the model.
class ModelBuilder {
 public:
  ModelBuilder(SurfaceVoxels voxels, const Grid& grid, const BuildOptions& options)
      : voxels_(std::move(voxels)), grid_(grid), options_(options) {
    size_ = options.image_size != 0 ? options.image_size : 1U << grid.levels;
  }

  BuiltOctree build() {
    coordinates_.reserve(voxels_.codes.size());
    for (const uint64_t code : voxels_.codes) coordinates_.push_back(codec::morton_decode(code));
    draw_images();
    exposed_ = exposed_voxels(coordinates_, grid_.levels, options_.threads);
    report(options_, "choosing images", 0.8);
    choice_ = choose_index(voxels_.codes, grid_.levels, kReferenceViews,
                           [this](size_t i) { return costs(i); });
    report(options_, "octree", 0.95);
    OctreeFields& fields = built_.model.fields;
    built_.model.resolution = grid_.resolution;
    fields.octree = codec::octree_from_morton(voxels_.codes, grid_.levels);
    fields.voxel_image_index = codec::octree_image_index(fields.octree, grid_.levels, choice_);
    take_statistics();
    report(options_, "octree", 1);
    return std::move(built_);
  }

 private:
  void draw_images() {
    for (unsigned view = 0; view < kReferenceViews; ++view) {
      views_.emplace_back(view, grid_.levels, size_);
      built_.model.images.push_back(reference_camera(view));
      seen_[view].resize(voxels_.codes.size());
    }
    parallel_for(kReferenceViews, options_.threads, [this](size_t view) {
      built_.model.images[view].picture =
          draw_view(views_[view], coordinates_, voxels_.colours, seen_[view]);
      means_[view] = local_mean(built_.model.images[view].picture);
    });
  }

  // Squared difference, in sRGB, of the pixel that voxel i has in view `view` of some pictures, and
  // its colour.
  [[nodiscard]] int difference(size_t i, unsigned view, const Picture& picture) const {
    const ReferenceView::Pixel at = views_[view].pixel(coordinates_[i]);
    const uint8_t* shown = picture.pixel(at.x, at.y);
    const Rgba8 own = voxels_.colours[i];
    const int r = shown[0] - own.r, g = shown[1] - own.g, b = shown[2] - own.b;
    return r * r + g * g + b * b;
  }
  [[nodiscard]] const Picture& picture(unsigned view) const {
    return built_.model.images[view].picture;
  }

  [[nodiscard]] ChoiceCosts costs(size_t i) const {
    ChoiceCosts result;
    for (unsigned view = 0; view < kReferenceViews; ++view) {
      const double squared = difference(i, view, picture(view));
      const double rough = difference(i, view, means_[view]);
      const double facing = 1 - glm::dot(voxels_.normals[i], direction_to_camera(view));
      const double unseen = seen_[view][i] != 0 ? 0 : 2;
      const double weight = exposed_[i] != 0 ? 1 : kHiddenWeight;
      result.of[view] = weight * (squared + squared * squared / kVisible + kRough * rough) +
                        kFacing * (facing + unseen);
    }
    return result;
  }

  void take_statistics() {
    BuildStatistics& statistics = built_.statistics;
    statistics.voxels = voxels_.codes.size();
    statistics.index_symbols = built_.model.fields.voxel_image_index.size();
    double sum = 0;
    for (size_t i = 0; i < choice_.size(); ++i) {
      if (exposed_[i] == 0) continue;
      const unsigned view = choice_[i] - 1U;
      ++statistics.exposed;
      sum += difference(i, view, picture(view));
      const uint32_t worst = worst_component(i, view);
      statistics.worst = std::max(statistics.worst, worst);
      if (worst > kOff) ++statistics.off;
      bool seen = false;
      for (const auto& by_view : seen_) seen = seen || by_view[i] != 0;
      if (seen) ++statistics.seen;
    }
    const double mean =
        statistics.exposed == 0 ? 0 : sum / (3.0 * static_cast<double>(statistics.exposed));
    statistics.psnr = mean > 0 ? std::min(99.0, 10 * std::log10(255.0 * 255.0 / mean)) : 99;
  }

  [[nodiscard]] uint32_t worst_component(size_t i, unsigned view) const {
    const ReferenceView::Pixel at = views_[view].pixel(coordinates_[i]);
    const uint8_t* shown = built_.model.images[view].picture.pixel(at.x, at.y);
    const Rgba8 own = voxels_.colours[i];
    return static_cast<uint32_t>(std::max(
        {std::abs(shown[0] - own.r), std::abs(shown[1] - own.g), std::abs(shown[2] - own.b)}));
  }

  SurfaceVoxels voxels_;
  Grid grid_;
  const BuildOptions& options_;
  uint32_t size_;
  std::vector<Voxel> coordinates_;
  std::vector<ReferenceView> views_;
  std::vector<uint8_t> seen_[kReferenceViews];
  Picture means_[kReferenceViews];  // of each picture, local means
  std::vector<uint8_t> exposed_;
  std::vector<uint8_t> choice_;
  BuiltOctree built_;
};

BuiltOctree finish(SurfaceVoxels voxels, const Grid& grid, const BuildOptions& options,
                   Colouring colouring, uint64_t primitives, const glm::dvec3& origin) {
  const bool shaded = is_to_be_shaded(colouring, options.shade);
  if (shaded) shade(voxels, colouring != Colouring::none, grid.levels, options.threads);
  report(options, "drawing images", 0.65);
  BuiltOctree built = ModelBuilder(std::move(voxels), grid, options).build();
  BuildStatistics& statistics = built.statistics;
  statistics.primitives = primitives;
  statistics.shaded = shaded;
  const double cube = static_cast<double>(1U << grid.levels);
  statistics.side = cube / grid.scale;
  statistics.centre =
      origin + grid.object_centre + glm::dvec3((cube / 2 - grid.middle) / grid.scale);
  if (options.up == UpAxis::z)
    statistics.centre = {statistics.centre.x, -statistics.centre.z, statistics.centre.y};
  return built;
}

}  // namespace

Result<BuiltOctree> build_octree(const Mesh& given, const BuildOptions& options, Diagnostics&) {
  if (Status status = check_options(options); !status.ok()) return status.error();
  if (given.triangles.empty()) return refused("the mesh has no triangles");
  Mesh copy;  // only where it must be turned
  if (options.up == UpAxis::z) turn_up(copy = given);
  const Mesh& mesh = options.up == UpAxis::z ? copy : given;
  const Grid grid(bounds_of_surface(mesh), options.resolution);
  const auto done = [&](double part) { report(options, "voxels", 0.6 * part); };
  Result<SurfaceVoxels> voxels = voxelize(mesh, grid, options.threads, options.limits, done);
  if (!voxels.ok()) return voxels.error();
  return finish(std::move(voxels).value(), grid, options, colouring_of(mesh), mesh.triangles.size(),
                {});
}

Result<BuiltOctree> build_octree(const PointCloud& given, const BuildOptions& options,
                                 Diagnostics&) {
  if (Status status = check_options(options); !status.ok()) return status.error();
  if (given.positions.empty()) return refused("the point cloud has no points");
  PointCloud copy;
  if (options.up == UpAxis::z) turn_up(copy = given);
  const PointCloud& cloud = options.up == UpAxis::z ? copy : given;
  const Grid grid(bounds_of(cloud.positions), options.resolution);
  Result<SurfaceVoxels> voxels = voxelize(cloud, grid, options.limits);
  if (!voxels.ok()) return voxels.error();
  const glm::dvec3 origin = options.up == UpAxis::z
                                ? glm::dvec3(given.origin.x, given.origin.z, -given.origin.y)
                                : given.origin;
  return finish(std::move(voxels).value(), grid, options, colouring_of(cloud),
                cloud.positions.size(), origin);
}

}  // namespace afx
