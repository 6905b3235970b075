// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The numbers of the token tree in which BIFS codes the text of scripts, for decoder and encoder.
// Source: ISO/IEC 14496-11, SFScript (clauses not checked); spec/bifs.md 13.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace afx::bifs {

/// What the text of a script that is coded in the scene begins with.
inline constexpr std::string_view kScriptPrefix = "javascript:";

enum class ScriptStatement : uint8_t {
  if_else,
  for_loop,
  while_loop,
  return_value,
  compound,
  break_loop,
  continue_loop,
  switch_case
};

/// How tightly an expression binds; a part that binds less than its place wants has parentheses.
enum ScriptBinding : int {
  kBindComma = 0,
  kBindAssignment = 1,
  kBindConditional = 2,
  kBindOr = 3,
  kBindUnary = 13,
  kBindPostfix = 14,
  kBindMember = 15,
};

/// Expressions that are more than an operator between two.
enum class ScriptExpression : uint8_t {
  parentheses = 0,
  negate = 1,
  logical_not = 2,
  bit_not = 3,
  pre_increment = 4,
  pre_decrement = 5,
  post_increment = 6,
  post_decrement = 7,
  conditional = 8,
  string = 9,
  number = 10,
  identifier = 11,
  call = 12,
  create = 13,
  member = 14,
  member_call = 15,
  element = 16,
  first_binary = 17,
  last_binary = 47,
  boolean = 48,
  variables = 49,
  function = 50,
};

/// An operator between two expressions; code = first_binary + position in the table.
struct ScriptOperator {
  std::string_view text;
  int binding;
};
std::span<const ScriptOperator> script_operators();

/// Whether an operator of that binding groups from the right: assignments.
constexpr bool groups_from_right(int binding) { return binding == kBindAssignment; }

/// Characters of a number that is no integer, by their codes.
inline constexpr std::string_view kNumberCharacters = "0123456789.E-";
inline constexpr uint32_t kNumberEnd = 15;  ///< the standard's may be 13; unsure

}  // namespace afx::bifs
