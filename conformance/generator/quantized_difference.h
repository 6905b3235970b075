// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "bifs/quantize_scene.h"

namespace afx::conformance {

/// Where two lists of told commands differ by more than quantization may change them, in a few
/// words; empty if nowhere. The numbers of a field that the report names may be off by the greatest
/// bound of a field of that name; directions are not compared.
std::string quantized_difference(const nlohmann::json& expected, const nlohmann::json& found,
                                 const bifs::QuantizeReport& report);

}  // namespace afx::conformance
