// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The 48 symmetries of the cube, acting on the children of a node and on node symbols, and the 22
// classes that they make of the 256 symbols.
// Source: ISO/IEC 14496-16, OctreeImage (clause not checked); the paper, section V.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace afx::codec {

inline constexpr unsigned kSymmetries = 48;
inline constexpr unsigned kClasses = 22;

/// The numbering of the symmetries, as data: element [t][c] is the child position that symmetry t
/// takes child c to. Everything else follows from it. It matters because several symmetries can
/// take a symbol to the base of its class and the one with the smallest number is used: the
/// numbering decides the bits of a stream. ISO's own table was not at hand; the text that this
/// project follows fixes the numbering by rule_numbering(). With another table, put it here.
using SymmetryNumbering = std::array<std::array<uint8_t, 8>, kSymmetries>;

/// Symmetry 6 * flips + p takes the child at (c0, c1, c2) = (x, y, z) to the coordinates
/// (c[P_p(0)], c[P_p(1)], c[P_p(2)]) and then complements coordinate k where bit k of flips is set.
constexpr SymmetryNumbering rule_numbering() {
  constexpr uint8_t permutations[6][3] = {{0, 1, 2}, {1, 0, 2}, {0, 2, 1},
                                          {2, 0, 1}, {1, 2, 0}, {2, 1, 0}};
  SymmetryNumbering numbering{};
  for (unsigned t = 0; t < kSymmetries; ++t) {
    for (unsigned child = 0; child < 8; ++child) {
      unsigned to = 0;
      for (unsigned k = 0; k < 3; ++k) {
        to |= ((child >> permutations[t % 6][k] ^ t / 6 >> k) & 1) << k;
      }
      numbering[t][child] = static_cast<uint8_t>(to);
    }
  }
  return numbering;
}

/// symbol[t][s] = T(s): bit T(i) of T(s) = bit i of s. Row kIdentity maps every symbol to itself.
struct SymbolMaps {
  static constexpr unsigned kIdentity = kSymmetries;
  std::array<std::array<uint8_t, 256>, kSymmetries + 1> forward{};
  std::array<std::array<uint8_t, 256>, kSymmetries + 1> inverse{};
};

constexpr SymbolMaps symbol_maps(const SymmetryNumbering& position) {
  SymbolMaps maps;
  for (unsigned t = 0; t <= kSymmetries; ++t) {
    auto& forward = maps.forward[t];
    for (unsigned s = 1; s < 256; ++s) {
      const auto child = static_cast<unsigned>(std::countr_zero(s));
      const unsigned to = t == SymbolMaps::kIdentity ? child : position[t][child];
      forward[s] =
          static_cast<uint8_t>(forward[s & (s - 1)] | 1U << to);  // one bit more than before
      maps.inverse[t][forward[s]] = static_cast<uint8_t>(s);
    }
  }
  return maps;
}

/// What the context of a child depends on: the class of its parent's symbol, the symmetry that
/// takes that symbol to the base (the smallest symbol) of the class, and its position under it.
struct SymbolClasses {
  std::array<uint8_t, 256> base{};      ///< smallest symbol of the class
  std::array<uint8_t, 256> symmetry{};  ///< smallest t with T(s) = base
  std::array<uint8_t, 256> number{};    ///< 0..21, in the order of the bases
  unsigned count = 0;                   ///< of classes
};

constexpr SymbolClasses symbol_classes(const SymbolMaps& maps) {
  SymbolClasses classes;
  for (unsigned s = 0; s < 256; ++s) {
    unsigned best = 0;
    for (unsigned t = 1; t < kSymmetries; ++t) {
      if (maps.forward[t][s] < maps.forward[best][s]) best = t;
    }
    classes.symmetry[s] = static_cast<uint8_t>(best);
    classes.base[s] = maps.forward[best][s];
    const bool is_base = classes.base[s] == s;  // reached before any other symbol of its class
    classes.number[s] =
        is_base ? static_cast<uint8_t>(classes.count++) : classes.number[classes.base[s]];
  }
  return classes;
}

inline constexpr SymmetryNumbering kSymmetryNumbering = rule_numbering();
inline constexpr SymbolMaps kSymbolMaps = symbol_maps(kSymmetryNumbering);
inline constexpr SymbolClasses kSymbolClasses = symbol_classes(kSymbolMaps);
static_assert(kSymbolClasses.count == kClasses);

}  // namespace afx::codec
