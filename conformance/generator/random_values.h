// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include "conformance/generator/choices.h"
#include "nodes/node_definition.h"

namespace afx::conformance {

struct ValueRules {
  /// Integers of quantization category 13 are in the range of their field, so that they can be
  /// coded under any quantizer.
  bool integers_fit = false;
};

/// A value of a type that holds no nodes and no commands. All draws 0: the zero value, or nearly.
/// Numbers of every size, infinities and NaN; strings that writers of text have to be careful with.
nodes::FieldValue random_value(Choices& choices, const nodes::FieldDefinition& field,
                               nodes::FieldType type, const ValueRules& rules = {});

/// Whether an encoder takes a value for the default and leaves it out: the same numbers. Images and
/// scripts never are.
bool is_default(const nodes::FieldDefinition& field, const nodes::FieldValue& value);

}  // namespace afx::conformance
