// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/picture_compare.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include "afx/psnr.h"

namespace afx {
namespace {

std::string size_text(const Picture& p) {
  return std::to_string(p.width) + " x " + std::to_string(p.height) + " with " +
         std::to_string(p.components) + " components";
}

Status check(const Picture& a, const Picture& b) {
  if (a.width != b.width || a.height != b.height || a.components != b.components) {
    return Error{Errc::bad_argument, Place::none(),
                 "pictures of different size: " + size_text(a) + " and " + size_text(b)};
  }
  const size_t samples = size_t{a.width} * a.height * a.components;
  if (samples == 0) return Error{Errc::bad_argument, Place::none(), "pictures without pixels"};
  if (a.samples.size() != samples || b.samples.size() != samples) {
    return Error{
        Errc::bad_argument, Place::none(),
        "a picture of " + size_text(a) + " does not hold " + std::to_string(samples) + " samples"};
  }
  return {};
}

/// The sums over all samples.
void compare_samples(const Picture& a, const Picture& b, PictureDifference& result) {
  uint64_t absolute = 0;
  uint64_t squared = 0;  // 2^16 a sample: good for 2^48 samples
  for (size_t i = 0; i < a.samples.size(); i += a.components) {
    bool differs = false;
    for (size_t c = i; c < i + a.components; ++c) {
      const auto d = static_cast<uint32_t>(std::abs(int{a.samples[c]} - int{b.samples[c]}));
      absolute += d;
      squared += uint64_t{d} * d;
      result.max_abs = std::max(result.max_abs, d);
      differs |= d != 0;
    }
    if (differs) ++result.differing_pixels;
  }
  const auto count = static_cast<double>(a.samples.size());
  result.mean_abs = static_cast<double>(absolute) / count;
  result.mean_squared = static_cast<double>(squared) / count;
  result.psnr = psnr_of(result.mean_squared);
}

constexpr size_t kWindow = 11;

/// Weights of a window of min(kWindow, size) places; their sum is 1.
std::vector<double> window(size_t size) {
  std::vector<double> weights(std::min(kWindow, size));
  const double middle = static_cast<double>(weights.size() - 1) / 2;
  double sum = 0;
  for (size_t i = 0; i < weights.size(); ++i) {
    const double x = (static_cast<double>(i) - middle) / 1.5;
    weights[i] = std::exp(-x * x / 2);
    sum += weights[i];
  }
  for (double& w : weights) w /= sum;
  return weights;
}

/// Weighted means of a, b, a^2, b^2, a b.
struct Moments {
  double a = 0, b = 0, aa = 0, bb = 0, ab = 0;

  void add(double weight, const Moments& m) {
    a += weight * m.a;
    b += weight * m.b;
    aa += weight * m.aa;
    bb += weight * m.bb;
    ab += weight * m.ab;
  }
};

double similarity(const Moments& m) {
  constexpr double kC1 = 0.01 * 255 * 0.01 * 255;
  constexpr double kC2 = 0.03 * 255 * 0.03 * 255;
  const double variance_a = m.aa - m.a * m.a;
  const double variance_b = m.bb - m.b * m.b;
  const double covariance = m.ab - m.a * m.b;
  return (2 * m.a * m.b + kC1) * (2 * covariance + kC2) /
         ((m.a * m.a + m.b * m.b + kC1) * (variance_a + variance_b + kC2));
}

/// The horizontal part: for each place of the window in row y the moments of one component.
void filter_row(const Picture& a, const Picture& b, uint32_t y, uint32_t component,
                const std::vector<double>& weights, std::vector<Moments>& row) {
  for (size_t x = 0; x < row.size(); ++x) {
    Moments sum;
    for (size_t k = 0; k < weights.size(); ++k) {
      const double va = a.pixel(static_cast<uint32_t>(x + k), y)[component];
      const double vb = b.pixel(static_cast<uint32_t>(x + k), y)[component];
      sum.add(weights[k], {va, vb, va * va, vb * vb, va * vb});
    }
    row[x] = sum;
  }
}

/// The sum of the similarity of one component over all places; rows are kept in a ring.
double component_similarity(const Picture& a, const Picture& b, uint32_t component,
                            const std::vector<double>& across, const std::vector<double>& down) {
  const size_t columns = a.width - across.size() + 1;
  std::vector<std::vector<Moments>> ring(down.size(), std::vector<Moments>(columns));
  double sum = 0;
  for (uint32_t y = 0; y < a.height; ++y) {
    filter_row(a, b, y, component, across, ring[y % down.size()]);
    if (y + 1 < down.size()) continue;
    for (size_t x = 0; x < columns; ++x) {
      Moments m;
      for (size_t k = 0; k < down.size(); ++k) m.add(down[k], ring[(y + 1 + k) % down.size()][x]);
      sum += similarity(m);
    }
  }
  return sum;
}

}  // namespace

Result<PictureDifference> compare_pictures(const Picture& a, const Picture& b) {
  if (const Status status = check(a, b); !status.ok()) return status.error();
  PictureDifference result;
  compare_samples(a, b, result);
  if (result.differing_pixels == 0) return result;
  const std::vector<double> across = window(a.width);
  const std::vector<double> down = window(a.height);
  double sum = 0;
  for (uint32_t c = 0; c < a.components; ++c) sum += component_similarity(a, b, c, across, down);
  const double places = static_cast<double>(a.width - across.size() + 1) *
                        static_cast<double>(a.height - down.size() + 1) * a.components;
  result.ssim = sum / places;
  return result;
}

}  // namespace afx
