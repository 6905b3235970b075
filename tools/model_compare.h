// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// How far apart two models are, whatever they are made of.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "codec/error.h"
#include "tools/session.h"

namespace afx::tools {

/// What is measured, and what may be.
struct ModelCompareOptions {
  unsigned views = 8;      ///< of the ring of pictures; 0: none
  uint32_t size = 512;     ///< width and height of these
  size_t points = 500000;  ///< that a mesh is sampled at
  std::string shade = "auto";
  std::vector<std::string> limits;  ///< "d1=0.5": see check_limits
};

/// The distances of two models. Lengths in parts of the longest side of A.
struct ModelDistance {
  nlohmann::ordered_json json;
  std::vector<std::string> lines;  ///< for people
};

/// Checks the form of limits, NAME=NUMBER with a name of those that are measured: d1, d2 (root mean
/// squares) and hausdorff may be at most so large, colour, psnr (dB) and ssim must be at least so
/// large. Returns a sentence about what is wrong; empty: nothing.
std::string check_limits(const std::vector<std::string>& limits);

/// The limits that a distance breaks, each in words.
std::vector<std::string> broken_limits(const std::vector<std::string>& limits,
                                       const nlohmann::ordered_json& json);

/// Compares model B with A, the reference: points of both (D1, D2, colours of matching points) and
/// pictures of both from a ring of views.
/// Errors  those of reading and drawing, with the file
Result<ModelDistance> compare_models(const std::string& a, const std::string& b,
                                     const ModelCompareOptions& options, const Session& session,
                                     Diagnostics (&diagnostics)[2]);

}  // namespace afx::tools
