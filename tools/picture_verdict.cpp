// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/picture_verdict.h"

#include <cmath>
#include <string>

#include "afx/picture_compare.h"
#include "afx/picture_io.h"
#include "tools/session.h"

namespace afx::tools {

Result<Verdict> compare_two_pictures(const Input& a, const Input& b, const Limits& limits) {
  const auto first = decode_picture(a.file.bytes(), a.path, limits);
  if (!first.ok()) return first.error();
  const auto second = decode_picture(b.file.bytes(), b.path, limits);
  if (!second.ok()) return second.error();
  return compare_two_pictures(first.value(), second.value());
}

Result<Verdict> compare_two_pictures(const Picture& x, const Picture& y) {
  if (x.width != y.width || x.height != y.height || x.components != y.components) {
    const auto size = [](const Picture& p) {
      return std::to_string(p.width) + " x " + std::to_string(p.height) + " x " +
             std::to_string(p.components);
    };
    return differ("the pictures are " + size(x) + " and " + size(y));
  }
  const auto difference = compare_pictures(x, y);
  if (!difference.ok()) return difference.error();
  const PictureDifference& d = difference.value();
  nlohmann::ordered_json json{{"differingPixels", d.differing_pixels},
                              {"maxAbs", d.max_abs},
                              {"meanAbs", d.mean_abs},
                              {"meanSquared", d.mean_squared},
                              {"ssim", d.ssim}};
  if (std::isfinite(d.psnr)) json["psnr"] = d.psnr;
  if (d.differing_pixels == 0) return same("the pictures are the same", json);
  return differ("the pictures differ in " + counted(d.differing_pixels, "pixel") + ": PSNR " +
                    fixed(d.psnr, 2) + " dB, SSIM " + fixed(d.ssim, 4) + ", mean difference " +
                    fixed(d.mean_abs, 4) + ", greatest " + std::to_string(d.max_abs),
                json);
}

}  // namespace afx::tools
