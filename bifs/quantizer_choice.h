// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Chooses a quantizer for given values: which categories are on, with what range and bits.
#pragma once

#include <string>
#include <vector>

#include "bifs/quantization_error.h"
#include "bifs/quantize_scene.h"
#include "bifs/quantized_values.h"

namespace afx::bifs {

/// What the fields of a category begin with; empty for categories without a rule.
std::string category_name(uint8_t category);

/// Errors: bad_argument (an unknown category; bits or an error out of range).
Status check_choices(const CategoryChoices& choices);

/// The greatest error_bound of the components that a field has.
double bound_of(const nodes::FieldDefinition& field, const ElementCoding& coding);

struct QuantizerChoice {
  bool is_any_on = false;
  std::vector<nodes::FieldEntry> fields;  ///< of the QuantizationParameter
  Quantizer quantizer;                    ///< the same
};

/// Categories with values that are left off are added to `left_out`, with the reason.
QuantizerChoice choose_quantizer(const std::vector<QuantizedValue>& values,
                                 const QuantizeOptions& options,
                                 std::vector<UnquantizedCategory>& left_out);

}  // namespace afx::bifs
