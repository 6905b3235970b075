// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// How far two point clouds are apart, as work on point cloud compression measures it.
// Source: Tian, Ochimizu, Feng, Cohen, Vetro, "Geometric distortion metrics for point cloud
// compression", ICIP 2017; MPEG's common test conditions for point clouds (clause not checked).
#pragma once

#include <glm/vec3.hpp>

#include "afx/builder/mesh.h"
#include "codec/error.h"
#include "codec/limits.h"

namespace afx {

/// Of distances in the units of the clouds.
struct GeometryError {
  double mean_squared = 0;
  double largest = 0;  ///< in one direction the one-sided, in both the Hausdorff distance
  double psnr = 0;     ///< 10 log10(3 peak^2 / mean_squared) in dB; infinite without any error
};

/// Of three components, each 0..255.
struct ColourError {
  glm::dvec3 mean_squared{0, 0, 0};
  glm::dvec3 psnr{0, 0, 0};  ///< 10 log10(255^2 / mean_squared) in dB; infinite when equal
};

/// What the points of one cloud miss in the other.
struct CloudError {
  /// D1: from each point to its nearest in the other cloud.
  GeometryError to_point;
  /// D2: the same lines, but of their length only the part along the normal there. (Of several
  /// equally near points, the mean of the squares.)
  GeometryError to_plane;
  /// Each point's colour against that of its nearest, the mean of equally near ones.
  ColourError ycbcr;  ///< Y' Cb Cr of Rec. ITU-R BT.709, full range
  ColourError rgb;    ///< sRGB
};

struct CloudDifference {
  double peak = 1;           ///< length, as used for PSNR
  bool has_colours = false;  ///< both clouds have; otherwise there is nothing in ycbcr and rgb
  CloudError a_to_b, b_to_a;
  CloudError both;  ///< the greater error (the lower PSNR) of the two, each number by itself
};

struct CloudCompareOptions {
  double peak = 0;       ///< 0: the longest side of the bounding box of A, or 1 where that is 0
  unsigned threads = 0;  ///< 0 = all cores; the result is the same for any number
  Limits limits = {};
};

/// Compares B, say a decoded model, with A, the reference. Normals are those of A, estimated
/// (point_normals.h) where A has none; a point of B has the mean of those of its nearest points in
/// A. Where a normal is unknown, the distance to the point stands in for that to the plane. Points
/// given twice count twice.
///
/// Memory  about 72 bytes a point, of both
/// Errors  bad_argument: a cloud without points, arrays of different lengths, a peak that is no
///         positive length; limit_exceeded: memory beyond limits.memory
[[nodiscard]] Result<CloudDifference> compare_clouds(const PointCloud& a, const PointCloud& b,
                                                     const CloudCompareOptions& options = {});

}  // namespace afx
