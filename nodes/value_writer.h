// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <string>
#include <string_view>

#include "nodes/field_value.h"
#include "nodes/text_out.h"

namespace afx::nodes {

/// Appends a value of any type but nodes as scene text has it. Long lists are broken into lines,
/// each beginning with `indent` blanks.
void append_value(std::string& out, const FieldValue& value, size_t indent = 0);
/// The same, handing on what has been written while a long list is at work.
void append_value(TextOut& out, const FieldValue& value, size_t indent = 0);

/// Numbers in the shortest form that reads back exactly; inf, -inf, nan, nan(0xBITS).
void append_number(std::string& out, float value);
void append_number(std::string& out, double value);
void append_number(std::string& out, int32_t value);

/// A string in quotes.
void append_string(std::string& out, std::string_view text);

}  // namespace afx::nodes
