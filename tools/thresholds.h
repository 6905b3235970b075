// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// How large errors may be for two models or pictures to count as near enough: --max-error.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace afx::tools {

/// Checks the form of thresholds, NAME=NUMBER with a name of those that are measured: d1, d2 (root
/// mean squares) and hausdorff may be at most so large, colour, psnr (dB) and ssim must be at least
/// so large. Returns a sentence about what is wrong; empty: nothing.
std::string check_thresholds(const std::vector<std::string>& thresholds);

/// The thresholds that measured errors are beyond, each in words. Null is an infinite PSNR.
std::vector<std::string> broken_thresholds(const std::vector<std::string>& thresholds,
                                           const nlohmann::ordered_json& measured);

}  // namespace afx::tools
