// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <vector>

#include "afx/octree_model.h"
#include "afx/picture.h"
#include "codec/error.h"
#include "codec/limits.h"
#include "render/camera.h"
#include "render/scene.h"

namespace afx::render {

inline constexpr uint32_t kMaxSide = 16384;

/// How a scene becomes a picture.
struct RenderOptions {
  uint32_t width = 1024;         ///< 1..kMaxSide
  uint32_t height = 1024;        ///< 1..kMaxSide
  Rgba8 background{0, 0, 0, 0};  ///< sRGB, not premultiplied; a = 0 is a transparent background
  /// Splat diameter as a multiple of the longest projected space diagonal of its voxel. At 1 or
  /// more a splat covers the projection of its voxel, so closed surfaces have no holes; the paper's
  /// 1.3 also closes gaps between voxels that touch at corners only, and makes outlines
  /// fatter. The sides of a surfel are longer by this and a tenth. 1..8
  double splat_scale = 1.05;
  unsigned samples = 3;  ///< n x n samples in each pixel, 1..8: smoothness of the edges
  bool depth = false;    ///< fill RenderedImage::depth
  unsigned threads = 0;  ///< 0 = all cores; the picture is the same for any number
};

/// A picture of a scene.
struct RenderedImage {
  Picture picture;           ///< RGBA, sRGB, straight alpha, top row first
  std::vector<float> depth;  ///< where asked for: height * width distances to the plane through the
                             ///< camera, the nearest in the pixel; infinite where nothing is
};

/// Draws the scene on the CPU: the reference for every other way of drawing it.
///
/// Each voxel is a round splat, large enough to hold the projection of its cube, that bulges
/// towards the viewer: its centre has the depth of the voxel's, its rim lies half a voxel side
/// deeper. Where splats meet, the one whose centre is closer wins, so neighbours part evenly
/// instead of covering each other like scales. The colour of a sample is the mean, in linear light,
/// of the splats not more than 0.4 voxel sides behind the nearest one there, weighted towards their
/// centres: enough to soften the border between neighbours, too little for the next layer of voxels
/// to show. A pixel is the mean of its samples.
///
/// Each surfel is the parallelogram that it is, with its own depth at every sample, a little longer
/// than it is so that neighbours overlap, and not narrower than a sample. It is mixed in where it
/// lies not more than 0.4 of its shorter side behind the nearest splat, of whatever kind. The more
/// it is stretched the less it counts: then it comes from a picture that saw the surface from
/// aside.
///
/// Source  the paper, section VI (splat size); bulge and mixing are ours, their constants found by
///         trying (hole_test.cpp holds them to it)
///
/// The background shows through by the part of the pixel that no splat covers. Voxels and surfels
/// whose centre lies nearer than the near plane are left out. Towards the sides of very wide views
/// (beyond about 120 degrees) splats are larger than they should be. Time grows with the number of
/// splats and the pixels they cover; memory is at most 44 bytes a voxel, 76 a surfel and 4 (with
/// depth 8) a pixel.
///
/// Errors  bad_argument: the camera, the options or a cloud is out of range (the text names it);
///         limit_exceeded: more pixels or memory than `limits`
[[nodiscard]] Result<RenderedImage> render(const Scene& scene, const Camera& camera,
                                           const RenderOptions& options, const Limits& limits = {});

}  // namespace afx::render
