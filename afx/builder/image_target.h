// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The JPEG quality of reference images that meets a size or a fidelity.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "afx/octree_model.h"
#include "codec/error.h"

namespace afx {

/// Reference images coded as JPEG files, all with one quality.
struct CodedImages {
  int quality = 0;                          ///< 1..100
  uint64_t bytes = 0;                       ///< of all files
  double psnr = 0;                          ///< dB, over the used pixels of all images; 99 = equal
  std::vector<std::vector<uint8_t>> files;  ///< in the order of the images
};

/// Which pixels of each image count, row by row from the top: BuiltOctree::used.
using UsedPixels = std::span<const std::vector<bool>>;

/// Codes images with a quality, and decodes them again to see what became of the used pixels.
/// Errors  bad_argument: quality out of range, an image without picture, as many lists of pixels
///         as there are not images, of other lengths than the pictures have pixels; those of
///         encode_picture
Result<CodedImages> code_images(std::span<const ReferenceImage> images, UsedPixels used,
                                int quality, unsigned threads);

/// The greatest quality at which the files have no more than `bytes` together, found by halving the
/// range: where bytes do not grow with quality, the greatest up to where they do.
/// Errors  bad_argument: they are larger even with quality 1 (the text says how large); those of
///         code_images
Result<CodedImages> code_images_to_size(std::span<const ReferenceImage> images, UsedPixels used,
                                        uint64_t bytes, unsigned threads);

/// The least quality at which the used pixels have `psnr` or more.
/// Errors  bad_argument: not reached even with quality 100 (the text says what is); those of
///         code_images
Result<CodedImages> code_images_to_psnr(std::span<const ReferenceImage> images, UsedPixels used,
                                        double psnr, unsigned threads);

}  // namespace afx
