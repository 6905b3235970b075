// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The pictures that a camera has of a mesh, without any model in between.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "afx/builder/mesh.h"
#include "afx/builder/mesh_raster.h"
#include "afx/builder/shading.h"
#include "afx/builder/surface_paint.h"
#include "afx/builder/view_source.h"
#include "afx/depth_image.h"
#include "codec/error.h"
#include "codec/limits.h"

namespace afx {

/// The nearest surface at the centre of a pixel.
struct SeenSurface {
  double distance = std::numeric_limits<double>::infinity();  ///< infinite: none
  uint32_t triangle = 0;
  float b = 0, c = 0;  ///< weights of its corners 1 and 2
};

/// A mesh ready to be looked at: its textures, and whether light is painted on it. The mesh must
/// stay as it is. For use by several threads at once.
class MeshLook {
 public:
  MeshLook(const Mesh& mesh, Shade shade);

  [[nodiscard]] const Mesh& mesh() const { return mesh_; }

  /// What the rows of a band of `raster`, which is of this mesh, see: width * rows of the band, the
  /// top row first. Transparent surface (Material::alpha_cutoff) is looked through.
  void see(const MeshRaster& raster, uint32_t band, std::vector<SeenSurface>& seen) const;

  /// Whether there is surface at a place of a triangle: opaque, or not too transparent.
  [[nodiscard]] bool is_there(const SeenSurface& seen) const;

  /// The colour of a piece of surface, opaque.
  /// texels   of the texture, the area to take the mean over
  [[nodiscard]] Rgba8 colour(const SeenSurface& seen, double texels) const;

  /// The texels on one square unit of a triangle.
  [[nodiscard]] double texel_density(uint32_t triangle) const;
  /// The unit normal of a triangle, zero where it has no area.
  [[nodiscard]] glm::dvec3 normal(uint32_t triangle) const;

 private:
  const Mesh& mesh_;
  SurfacePaint paint_;
  bool coloured_;
  bool shaded_;
};

/// The mesh as a DepthImage with a SimpleTexture, RGB: the colour and the depth of the nearest
/// surface at the centre of each pixel, the colour the mean over what the pixel covers. Pixels that
/// see nothing have depth 0 and are black.
///
/// depth_bits   8 or 16
/// threads      0 = all cores; the result is the same for any number
/// Errors       bad_argument: camera, size or bits; limit_exceeded: more pixels or memory than
/// limits
Result<DepthImage> draw_depth_image(const MeshLook& look, const Shot& shot, unsigned depth_bits,
                                    unsigned threads, const Limits& limits);

/// The distances alone, rows from the top; infinite where nothing is.
Result<std::vector<float>> draw_distances(const MeshLook& look, const Shot& shot, unsigned threads,
                                          const Limits& limits);

/// A picture for people: RGBA, edges smoothed by samples * samples places in each pixel, mixed in
/// linear light over the background.
///
/// samples      1, 2, 3, 4, 6 or 8
/// background   sRGB, not premultiplied
/// Errors       as draw_depth_image
Result<Picture> draw_picture(const MeshLook& look, const Shot& shot, unsigned samples,
                             Rgba8 background, unsigned threads, const Limits& limits);

}  // namespace afx
