// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <array>
#include <cstdint>
#include <memory>

namespace afx::codec::plain {

/// Section 5 as data, see octree_rules.h.
struct SymmetryRules {
  std::array<unsigned, 3> axis_bits{0, 1, 2};  ///< of x, y, z in a child's index
  bool permutations_first = false;             ///< t = 8 * p + flips
  std::array<std::array<uint8_t, 3>, 6> permutations{
      {{0, 1, 2}, {1, 0, 2}, {0, 2, 1}, {2, 0, 1}, {1, 2, 0}, {2, 1, 0}}};
  bool inverse_permutation = false;  ///< coordinate k goes to P(k)
  bool flips_before = false;
  bool flip_bits_backwards = false;
  bool symbols_inverse = false;  ///< bit i of T(s) is bit T(i) of s
  bool mirrors = true;           ///< or rotations alone
  bool greatest_base = false;
  bool greatest_symmetry = false;
};

/// The 48 symmetries, acting on children and symbols, and the classes that they make.
struct Symmetries {
  static constexpr unsigned kIdentity = 48;
  std::array<std::array<uint8_t, 8>, 48> child{};
  std::array<std::array<uint8_t, 256>, 49> forward{};  ///< T(s); row kIdentity: s
  std::array<std::array<uint8_t, 256>, 49> inverse{};
  std::array<uint8_t, 256> symmetry{};  ///< that takes a symbol to its base
  std::array<uint8_t, 256> number{};    ///< of a symbol's class
  unsigned classes = 0;
};

std::shared_ptr<const Symmetries> make_symmetries(const SymmetryRules& rules);
/// Those of the text, made once.
const std::shared_ptr<const Symmetries>& text_symmetries();

}  // namespace afx::codec::plain
