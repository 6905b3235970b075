// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Models to sets of DepthImages: box texture, generalized box texture. Source: the paper, sections
// III and VII.A.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "afx/builder/image_fill.h"
#include "afx/builder/view_plan.h"
#include "afx/builder/view_source.h"
#include "afx/depth_image.h"
#include "codec/error.h"
#include "codec/limits.h"

namespace afx {

/// The greatest resolution of pictures that a builder makes.
inline constexpr uint32_t kMaxPictureResolution = 16384;

struct DepthImageOptions {
  uint32_t resolution = 256;  ///< pixels along the model's longest side, 1..kMaxPictureResolution
  bool orthographic = true;
  unsigned depth_bits = 8;             ///< 8 or 16
  ImageCoder coder = ImageCoder::png;  ///< that the pictures are meant for: what free pixels show
  unsigned views = 6;  ///< evenly spread, 1..kMostViews; 0: as many as show nearly everything
  std::vector<Shot> shots = {};  ///< not empty: these cameras instead, as they are
  bool coverage = false;  ///< measure it (always done for views = 0): takes the time of 128 views
  /// Called as the work goes on with a stage's name and 0..1 of the whole.
  std::function<void(const char* stage, double done)> progress = {};
  Limits limits = {};  ///< memory: of all pictures together
};

struct BuiltDepthImages {
  std::vector<DepthImage> images;    ///< in the order of the views, in the model's coordinates
  std::optional<Coverage> coverage;  ///< where it was measured
  uint64_t pixels = 0;               ///< of all pictures
  uint64_t used = 0;                 ///< of those, the ones that show the model
};

/// Takes the pictures.
/// Memory  5 bytes for each of their pixels, and what the source needs for one of them
/// Errors  bad_argument: options out of range; limit_exceeded: all pictures take more than
///         limits.memory; those of the source (a camera of `shots` that cannot be, limits)
Result<BuiltDepthImages> build_depth_images(const ViewSource& source,
                                            const DepthImageOptions& options);

}  // namespace afx
