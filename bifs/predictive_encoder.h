// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "bifs/predictive_model.h"

namespace afx::bifs {

/// How to code a list predictively.
struct PredictivePlan {
  IntraMode mode = IntraMode::first;
  uint32_t period = 0;        ///< periodic: 1 or more
  unsigned window_bits = 13;  ///< flagged: values with a residual of more bits than this are intra
};

/// The bits of a predictive MF field from behind usePredictive (predictive_model.h tells the
/// structure), for values that the quantizer gave. The parameters are the narrowest for the whole
/// list; in periodic mode those of each period, renewed where the ones before do not suffice.
/// None where the plan cannot hold the values: residuals need more than 13 bits, or one is less
/// than compMin can be; an empty list; a period of 0.
std::optional<std::vector<bool>> encode_predictive(const PredictiveLayout& layout,
                                                   std::span<const QuantizedDirection> values,
                                                   const PredictivePlan& plan);

/// The shortest form of those tried: every value predicted, or intra where a residual is large.
std::optional<std::vector<bool>> shortest_predictive(const PredictiveLayout& layout,
                                                     std::span<const QuantizedDirection> values);

}  // namespace afx::bifs
