// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "codec/plain/octree_plain_symmetry.h"

#include <bit>
#include <utility>

namespace afx::codec::plain {
namespace {

struct Symmetry {
  unsigned flips;
  std::array<uint8_t, 3> permutation;
};

Symmetry symmetry_of(const SymmetryRules& rules, unsigned t) {
  const unsigned p = rules.permutations_first ? t / 8 : t % 6;
  return {rules.permutations_first ? t % 8 : t / 6, rules.permutations[p]};
}

using Point = std::array<unsigned, 3>;

Point flip(const SymmetryRules& rules, unsigned flips, Point c) {
  for (unsigned k = 0; k < 3; ++k) c[k] ^= flips >> (rules.flip_bits_backwards ? 2 - k : k) & 1;
  return c;
}

uint8_t moved_child(const SymmetryRules& rules, const Symmetry& t, unsigned child) {
  Point from{};
  for (unsigned k = 0; k < 3; ++k) from[k] = child >> rules.axis_bits[k] & 1;
  if (rules.flips_before) from = flip(rules, t.flips, from);
  Point to{};
  for (unsigned k = 0; k < 3; ++k) {
    if (rules.inverse_permutation) {
      to[t.permutation[k]] = from[k];
    } else {
      to[k] = from[t.permutation[k]];
    }
  }
  if (!rules.flips_before) to = flip(rules, t.flips, to);
  unsigned moved = 0;
  for (unsigned k = 0; k < 3; ++k) moved |= to[k] << rules.axis_bits[k];
  return static_cast<uint8_t>(moved);
}

/// Whether it turns a right hand into a left one.
bool is_mirror(const Symmetry& t) {
  const auto& p = t.permutation;
  const unsigned swaps =
      (p[0] > p[1] ? 1U : 0U) + (p[0] > p[2] ? 1U : 0U) + (p[1] > p[2] ? 1U : 0U);
  return (swaps + static_cast<unsigned>(std::popcount(t.flips))) % 2 != 0;
}

void add_maps(Symmetries& made, unsigned t, bool inverse) {
  for (unsigned s = 0; s < 256; ++s) {
    unsigned moved = 0;
    for (unsigned i = 0; i < 8; ++i) {
      const unsigned to = t == Symmetries::kIdentity ? i : made.child[t][i];
      moved |= inverse ? (s >> to & 1) << i : (s >> i & 1) << to;
    }
    made.forward[t][s] = static_cast<uint8_t>(moved);
    made.inverse[t][moved] = static_cast<uint8_t>(s);
  }
}

/// The symmetry that takes a symbol to the base of its class.
unsigned to_base(const Symmetries& made, const SymmetryRules& rules, unsigned symbol) {
  unsigned best = Symmetries::kIdentity;  // which takes no symbol further than symmetry 0 does
  for (unsigned n = 0; n < 48; ++n) {
    const unsigned t = rules.greatest_symmetry ? 47 - n : n;
    if (!rules.mirrors && is_mirror(symmetry_of(rules, t))) continue;
    const unsigned moved = made.forward[t][symbol];
    const unsigned least = made.forward[best][symbol];
    if (best == Symmetries::kIdentity || (rules.greatest_base ? moved > least : moved < least))
      best = t;
  }
  return best;
}

}  // namespace

std::shared_ptr<const Symmetries> make_symmetries(const SymmetryRules& rules) {
  auto made = std::make_shared<Symmetries>();
  for (unsigned t = 0; t < 48; ++t) {
    for (unsigned child = 0; child < 8; ++child)
      made->child[t][child] = moved_child(rules, symmetry_of(rules, t), child);
    add_maps(*made, t, rules.symbols_inverse);
  }
  add_maps(*made, Symmetries::kIdentity, false);
  std::array<uint8_t, 256> base{};
  for (unsigned s = 0; s < 256; ++s) {
    made->symmetry[s] = static_cast<uint8_t>(to_base(*made, rules, s));
    base[s] = made->forward[made->symmetry[s]][s];
  }
  for (unsigned s = 0; s < 256; ++s)
    if (base[s] == s) made->number[s] = static_cast<uint8_t>(made->classes++);
  for (unsigned s = 0; s < 256; ++s) made->number[s] = made->number[base[s]];
  return made;
}

const std::shared_ptr<const Symmetries>& text_symmetries() {
  static const std::shared_ptr<const Symmetries> kMade = make_symmetries({});
  return kMade;
}

}  // namespace afx::codec::plain
