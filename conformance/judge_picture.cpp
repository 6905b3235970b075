// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "conformance/judge_picture.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>

#include "afx/picture_compare.h"
#include "afx/picture_io.h"

namespace afx::conformance {
namespace {

constexpr int kStrength = 8;

std::vector<uint8_t> copy(std::span<const uint8_t> bytes) { return {bytes.begin(), bytes.end()}; }

std::string size_of(const Picture& picture) {
  return std::to_string(picture.width) + " x " + std::to_string(picture.height) + " pixels of " +
         std::to_string(picture.components);
}

/// Grey where all is equal; alpha is shown as the rest.
std::vector<uint8_t> difference_file(const Picture& a, const Picture& b) {
  Picture apart = a;
  for (size_t i = 0; i < apart.samples.size(); ++i)
    apart.samples[i] =
        static_cast<uint8_t>(std::min(255, kStrength * std::abs(a.samples[i] - b.samples[i])));
  if (apart.components % 2 == 0)
    for (size_t i = apart.components - 1; i < apart.samples.size(); i += apart.components)
      apart.samples[i] = 255;
  auto file = encode_picture(apart, "png");
  return file.ok() ? std::move(file).value() : std::vector<uint8_t>();
}

std::string with_two_digits(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", number);
  return text;
}

}  // namespace

Outcome judge_picture(const RenderCheck& check, std::span<const uint8_t> expected,
                      std::span<const uint8_t> found) {
  const auto fail = [](std::string text) {
    return Outcome{.verdict = Verdict::failed, .text = std::move(text)};
  };
  const auto wanted = decode_picture(expected, check.expected.path);
  if (!wanted.ok()) return fail(to_string(wanted.error(), check.expected.path));
  const auto drawn = decode_picture(found);
  if (!drawn.ok()) return fail("its picture cannot be read: " + to_string(drawn.error()));
  const auto apart = compare_pictures(wanted.value(), drawn.value());
  if (!apart.ok())
    return fail("its picture has " + size_of(drawn.value()) + " (expected " +
                size_of(wanted.value()) + ")");
  if (apart.value().mean_abs <= check.max_mean) return {};
  Outcome outcome = fail("its picture is " + with_two_digits(apart.value().mean_abs) +
                         " steps of 1/255 away in the mean (expected at most " +
                         with_two_digits(check.max_mean) + ")");
  outcome.pictures = {copy(expected), copy(found), difference_file(wanted.value(), drawn.value())};
  return outcome;
}

}  // namespace afx::conformance
