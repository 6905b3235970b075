// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/mesh_look.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <utility>

#include "afx/srgb.h"
#include "afx/voxel_shading.h"
#include "codec/parallel.h"

namespace afx {
namespace {

constexpr uint64_t kPixelBytes = 16;  // of pictures and distances, and room
// A surface seen from the side covers many texels for each pixel, but smearing over all of them
// would blur it across the pixel too.
constexpr double kMostStretch = 4;

Error refused(const std::string& text) { return {Errc::bad_argument, Place::none(), text}; }

// How much surface a pixel covers, in texels of the surface's texture.
class PixelFootprint {
 public:
  PixelFootprint(const MeshLook& look, const Shot& shot, const MeshRaster& raster)
      : look_(look), projection_(shot.camera), raster_(raster) {}

  [[nodiscard]] double texels(const SeenSurface& seen) const {
    const double density = look_.texel_density(seen.triangle);
    if (!(density > 0)) return 0;
    const glm::dvec2 size = projection_.extent(seen.distance);
    const double area = size.x / raster_.width() * (size.y / raster_.height());
    const glm::uvec3 v = look_.mesh().triangles[seen.triangle];
    const glm::dvec3 view = projection_.towards_viewer(glm::dvec3(look_.mesh().positions[v.x]));
    const double facing = std::abs(glm::dot(look_.normal(seen.triangle), view));
    return density * area * std::min(kMostStretch, facing > 0 ? 1 / facing : kMostStretch);
  }

 private:
  const MeshLook& look_;
  CameraProjection projection_;
  const MeshRaster& raster_;
};

// Takes the samples of one row of pixels, samples * samples for each, to their mean.
class PixelMean {
 public:
  explicit PixelMean(Rgba8 background)
      : background_{linear_light(background)}, alpha_(background.a / 255.0) {}

  void add(Rgba8 colour) {
    light_ += linear_light(colour);
    ++count_;
  }
  [[nodiscard]] Rgba8 over_background(unsigned places) const {
    const double covered = static_cast<double>(count_) / places;
    const double alpha = covered + (1 - covered) * alpha_;
    if (!(alpha > 0)) return {0, 0, 0, 0};
    const glm::dvec3 sum =
        light_ / static_cast<double>(places) + background_ * ((1 - covered) * alpha_);
    Rgba8 colour = to_srgb(sum / alpha);
    colour.a = static_cast<uint8_t>(std::lround(alpha * 255));
    return colour;
  }

 private:
  glm::dvec3 background_;
  double alpha_;
  glm::dvec3 light_{0, 0, 0};
  unsigned count_ = 0;
};

}  // namespace

MeshLook::MeshLook(const Mesh& mesh, Shade shade)
    : mesh_(mesh),
      paint_(mesh),
      coloured_(colouring_of(mesh) != Colouring::none),
      shaded_(is_to_be_shaded(colouring_of(mesh), shade)) {}

void MeshLook::see(const MeshRaster& raster, uint32_t band, std::vector<SeenSurface>& seen) const {
  const uint32_t rows = raster.end_row(band) - raster.first_row(band);
  seen.assign(size_t{raster.width()} * rows, {});
  raster.for_each(band, [&](const Fragment& f) {
    SeenSurface& at = seen[size_t{f.y - raster.first_row(band)} * raster.width() + f.x];
    if (f.distance >= at.distance) return;
    const SeenSurface nearer{f.distance, f.triangle, static_cast<float>(f.b),
                             static_cast<float>(f.c)};
    if (is_there(nearer)) at = nearer;
  });
}

bool MeshLook::is_there(const SeenSurface& seen) const {
  const float cutoff = paint_.material(seen.triangle).alpha_cutoff;
  return !(cutoff > 0) ||
         paint_.at(seen.triangle, {seen.b, seen.c}, 1).alpha >= static_cast<double>(cutoff);
}

Rgba8 MeshLook::colour(const SeenSurface& seen, double texels) const {
  const glm::vec3 facing(normal(seen.triangle));
  if (!coloured_ && shaded_) return shaded_grey(facing);
  const Paint paint = paint_.at(seen.triangle, {seen.b, seen.c}, texels);
  const Rgba8 own = to_srgb(paint.alpha > 0 ? paint.light / paint.alpha : paint.light);
  return shaded_ ? shaded_colour(own, facing) : own;
}

double MeshLook::texel_density(uint32_t triangle) const {
  const glm::uvec3 v = mesh_.triangles[triangle];
  const glm::dvec3 a(mesh_.positions[v.x]), b(mesh_.positions[v.y]), c(mesh_.positions[v.z]);
  const double area = 0.5 * glm::length(glm::cross(b - a, c - a));
  return area > 0 ? paint_.texels(triangle) / area : 0;
}

glm::dvec3 MeshLook::normal(uint32_t triangle) const {
  const glm::uvec3 v = mesh_.triangles[triangle];
  const glm::dvec3 a(mesh_.positions[v.x]), b(mesh_.positions[v.y]), c(mesh_.positions[v.z]);
  const glm::dvec3 across = glm::cross(b - a, c - a);
  const double length = glm::length(across);
  return length > 0 ? across / length : glm::dvec3(0);
}

Result<DepthImage> draw_depth_image(const MeshLook& look, const Shot& shot, unsigned depth_bits,
                                    unsigned threads, const Limits& limits) {
  if (depth_bits != 8 && depth_bits != 16)
    return refused("the depths have " + std::to_string(depth_bits) + " bits (expected 8 or 16)");
  if (Status right = check_shot(shot, kPixelBytes, limits); !right.ok()) return right.error();
  const auto rastered =
      MeshRaster::of(look.mesh(), shot.camera, shot.width, shot.height, threads, limits);
  if (!rastered.ok()) return rastered.error();
  const MeshRaster& raster = rastered.value();
  const PixelFootprint footprint(look, shot, raster);
  const size_t pixels = size_t{shot.width} * shot.height;
  SimpleTexture texture{Picture(shot.width, shot.height, 3),
                        {shot.width, shot.height, 1, depth_bits, std::vector<uint16_t>(pixels)}};
  parallel_for(raster.bands(), threads, [&](size_t band) {
    std::vector<SeenSurface> seen;
    look.see(raster, static_cast<uint32_t>(band), seen);
    size_t place = size_t{raster.first_row(static_cast<uint32_t>(band))} * shot.width;
    for (const SeenSurface& surface : seen) {
      const size_t at = place++;
      if (!std::isfinite(surface.distance)) continue;
      const uint64_t depth = distance_to_depth(surface.distance, texture.dmax(), shot.camera);
      if (depth == 0) continue;
      const Rgba8 colour = look.colour(surface, footprint.texels(surface));
      texture.depth.samples[at] = static_cast<uint16_t>(depth);
      texture.colour.samples[at * 3] = colour.r;
      texture.colour.samples[at * 3 + 1] = colour.g;
      texture.colour.samples[at * 3 + 2] = colour.b;
    }
  });
  return DepthImage{shot.camera, std::move(texture)};
}

Result<std::vector<float>> draw_distances(const MeshLook& look, const Shot& shot, unsigned threads,
                                          const Limits& limits) {
  if (Status right = check_shot(shot, kPixelBytes, limits); !right.ok()) return right.error();
  const auto rastered =
      MeshRaster::of(look.mesh(), shot.camera, shot.width, shot.height, threads, limits);
  if (!rastered.ok()) return rastered.error();
  const MeshRaster& raster = rastered.value();
  std::vector<float> distances(size_t{shot.width} * shot.height);
  parallel_for(raster.bands(), threads, [&](size_t band) {
    std::vector<SeenSurface> seen;
    look.see(raster, static_cast<uint32_t>(band), seen);
    size_t place = size_t{raster.first_row(static_cast<uint32_t>(band))} * shot.width;
    for (const SeenSurface& surface : seen)
      distances[place++] = static_cast<float>(surface.distance);
  });
  return distances;
}

Result<Picture> draw_picture(const MeshLook& look, const Shot& shot, unsigned samples,
                             Rgba8 background, unsigned threads, const Limits& limits) {
  if (samples < 1 || samples > 8 || MeshRaster::kBandRows % samples != 0)
    return refused("there are " + std::to_string(samples) +
                   " samples along a pixel (expected 1, 2, 3, 4, 6 or 8)");
  if (Status right = check_shot(shot, kPixelBytes, limits); !right.ok()) return right.error();
  const uint64_t longest = uint64_t{std::max(shot.width, shot.height)} * samples;
  if (longest > kMostPixelsAlong)
    return refused("there are " + std::to_string(longest) +
                   " samples along a side of the picture (expected at most 65535)");
  const auto rastered = MeshRaster::of(look.mesh(), shot.camera, shot.width * samples,
                                       shot.height * samples, threads, limits);
  if (!rastered.ok()) return rastered.error();
  const MeshRaster& raster = rastered.value();
  const PixelFootprint footprint(look, shot, raster);
  Picture picture(shot.width, shot.height, 4);
  parallel_for(raster.bands(), threads, [&](size_t number) {
    const auto band = static_cast<uint32_t>(number);
    std::vector<SeenSurface> seen;
    look.see(raster, band, seen);
    std::vector<PixelMean> row;
    for (uint32_t y = raster.first_row(band); y < raster.end_row(band); ++y) {
      if (y % samples == 0) row.assign(shot.width, PixelMean(background));
      const SeenSurface* at = &seen[size_t{y - raster.first_row(band)} * raster.width()];
      for (uint32_t x = 0; x < raster.width(); ++x)
        if (std::isfinite(at[x].distance))
          row[x / samples].add(look.colour(at[x], footprint.texels(at[x])));
      if (y % samples + 1 != samples) continue;
      for (uint32_t x = 0; x < shot.width; ++x) {
        const Rgba8 c = row[x].over_background(samples * samples);
        std::copy_n(std::initializer_list<uint8_t>{c.r, c.g, c.b, c.a}.begin(), 4,
                    picture.pixel(x, y / samples));
      }
    }
  });
  return picture;
}

}  // namespace afx
