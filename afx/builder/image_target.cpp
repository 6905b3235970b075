// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/image_target.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <utility>

#include "afx/picture_io.h"
#include "afx/psnr.h"
#include "codec/parallel.h"

namespace afx {
namespace {

constexpr int kLeastQuality = 1, kGreatestQuality = 100;

Error refused(const std::string& text) { return Error{Errc::bad_argument, {}, text, {}, {}}; }

Status check(std::span<const ReferenceImage> images, UsedPixels used) {
  if (images.size() != used.size())
    return refused(std::to_string(used.size()) + " lists of used pixels for " +
                   std::to_string(images.size()) + " images");
  for (size_t k = 0; k < images.size(); ++k) {
    const Picture& picture = images[k].picture;
    if (picture.empty()) return refused("images[" + std::to_string(k) + "] has no picture");
    if (used[k].size() != size_t{picture.width} * picture.height)
      return refused("images[" + std::to_string(k) + "] has not as many pixels as are listed");
  }
  return {};
}

// Squared differences over used pixels.
struct Loss {
  double squared = 0;
  uint64_t samples = 0;
};

Loss loss_of(const Picture& original, const Picture& coded, const std::vector<bool>& used) {
  Loss loss;
  for (size_t i = 0; i < used.size(); ++i) {
    if (!used[i]) continue;
    for (size_t c = i * original.components; c < (i + 1) * original.components; ++c) {
      const int difference = original.samples[c] - coded.samples[c];
      loss.squared += difference * difference;
    }
    loss.samples += original.components;
  }
  return loss;
}

// One image: its file, and what that makes of it.
Status code(const ReferenceImage& image, const std::vector<bool>& used, int quality,
            std::vector<uint8_t>& file, Loss& loss) {
  auto encoded = encode_picture(image.picture, "jpeg", {.jpeg_quality = quality});
  if (!encoded.ok()) return encoded.error();
  file = std::move(encoded).value();
  const auto decoded = decode_picture(file);
  if (!decoded.ok()) return decoded.error();
  loss = loss_of(image.picture, decoded.value(), used);
  return {};
}

std::string in_db(double psnr) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f dB", psnr);
  return text;
}

// The first quality of those that `is_enough` or, if there is none, one beyond the last; it holds
// from some quality on.
Result<int> first_quality(const std::function<Result<bool>(int)>& is_enough) {
  int low = kLeastQuality, end = kGreatestQuality + 1;
  while (low < end) {
    const int middle = (low + end) / 2;
    const Result<bool> enough = is_enough(middle);
    if (!enough.ok()) return enough.error();
    if (enough.value())
      end = middle;
    else
      low = middle + 1;
  }
  return low;
}

}  // namespace

Result<CodedImages> code_images(std::span<const ReferenceImage> images, UsedPixels used,
                                int quality, unsigned threads) {
  if (Status status = check(images, used); !status.ok()) return status.error();
  CodedImages coded;
  coded.quality = quality;
  coded.files.resize(images.size());
  std::vector<Loss> losses(images.size());
  std::vector<Status> states(images.size());
  parallel_for(images.size(), threads, [&](size_t k) {
    states[k] = code(images[k], used[k], quality, coded.files[k], losses[k]);
  });
  Loss all;
  for (size_t k = 0; k < images.size(); ++k) {
    if (!states[k].ok()) return states[k].error();
    coded.bytes += coded.files[k].size();
    all.squared += losses[k].squared;
    all.samples += losses[k].samples;
  }
  const double mean = all.samples == 0 ? 0 : all.squared / static_cast<double>(all.samples);
  coded.psnr = std::min(99.0, psnr_of(mean));
  return coded;
}

Result<CodedImages> code_images_to_size(std::span<const ReferenceImage> images, UsedPixels used,
                                        uint64_t bytes, unsigned threads) {
  const Result<int> too_large = first_quality([&](int quality) -> Result<bool> {
    const auto coded = code_images(images, used, quality, threads);
    if (!coded.ok()) return coded.error();
    return coded.value().bytes > bytes;
  });
  if (!too_large.ok()) return too_large.error();
  auto coded = code_images(images, used, std::max(kLeastQuality, too_large.value() - 1), threads);
  if (!coded.ok() || too_large.value() > kLeastQuality) return coded;
  return refused("the images take " + std::to_string(coded.value().bytes) +
                 " bytes even as JPEG of quality 1 (" + std::to_string(bytes) + " are asked for)");
}

Result<CodedImages> code_images_to_psnr(std::span<const ReferenceImage> images, UsedPixels used,
                                        double psnr, unsigned threads) {
  const Result<int> quality = first_quality([&](int tried) -> Result<bool> {
    const auto coded = code_images(images, used, tried, threads);
    if (!coded.ok()) return coded.error();
    return coded.value().psnr >= psnr;
  });
  if (!quality.ok()) return quality.error();
  auto coded = code_images(images, used, std::min(kGreatestQuality, quality.value()), threads);
  if (!coded.ok() || quality.value() <= kGreatestQuality) return coded;
  return refused("the images reach " + in_db(coded.value().psnr) + " as JPEG of quality 100 (" +
                 in_db(psnr) + " is asked for)");
}

}  // namespace afx
