// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/script_syntax.h"

namespace afx::bifs {

std::span<const ScriptOperator> script_operators() {
  static constexpr ScriptOperator kOperators[] = {
      {"=", 1},  {"+=", 1},  {"-=", 1},  {"*=", 1},   {"/=", 1},  {"%=", 1},  {"&=", 1},  {"|=", 1},
      {"^=", 1}, {"<<=", 1}, {">>=", 1}, {">>>=", 1}, {"==", 8},  {"!=", 8},  {"<", 9},   {"<=", 9},
      {">", 9},  {">=", 9},  {"+", 11},  {"-", 11},   {"*", 12},  {"/", 12},  {"%", 12},  {"&&", 4},
      {"||", 3}, {"&", 7},   {"|", 5},   {"^", 6},    {"<<", 10}, {">>", 10}, {">>>", 10}};
  static_assert(std::size(kOperators) == static_cast<size_t>(ScriptExpression::last_binary) -
                                             static_cast<size_t>(ScriptExpression::first_binary) +
                                             1);
  return kOperators;
}

}  // namespace afx::bifs
