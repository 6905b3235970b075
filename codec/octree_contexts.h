// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The context model that encoder and decoder of an octree frame share: which table codes a symbol
// and under which symmetry.
// Source: ISO/IEC 14496-16, OctreeImage (clause not checked); the paper, section V.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "codec/adaptive_table.h"
#include "codec/octree_symmetry.h"

namespace afx::codec {

// Node symbols go through three stages, by the number of node symbols coded before in the frame.
inline constexpr uint64_t kStage1Start = 512;
inline constexpr uint64_t kStage2Start = 512 + 2048;
inline constexpr int kNodeSteps[3] = {2, 3, 4};
inline constexpr int kNodeLimit = 8192;
inline constexpr int kTextureStep = 32;
inline constexpr int kTextureLimit = 512;

/// The context of a node, packed: bits 0..7 class of the parent symbol * 8 + T(position in the
/// parent), bits 8..13 the symmetry T, bit 15 set where a texture symbol follows the node symbol.
using NodeContext = uint16_t;
inline constexpr NodeContext kTextured = 0x8000;

/// Row s: the contexts of the children of a node with symbol s, in order, then zeros.
inline constexpr std::array<std::array<NodeContext, 8>, 256> kChildContexts = [] {
  std::array<std::array<NodeContext, 8>, 256> rows{};
  for (unsigned symbol = 0; symbol < 256; ++symbol) {
    const unsigned t = kSymbolClasses.symmetry[symbol];
    unsigned n = 0;
    for (unsigned child = 0; child < 8; ++child) {
      if ((symbol >> child & 1) == 0) continue;
      const unsigned table = kSymbolClasses.number[symbol] * 8U + kSymmetryNumbering[t][child];
      rows[symbol][n++] = static_cast<NodeContext>(t << 8 | table);
    }
  }
  return rows;
}();

/// The tables of one frame: 176 for node symbols, one for texture symbols; 100 KB, asked for once.
class OctreeContexts {
 public:
  explicit OctreeContexts(unsigned textures);

  /// Moves on to the stage of the node symbol that comes after `coded` of them, and returns how
  /// many more belong to that stage.
  uint64_t enter_stage(uint64_t coded);

  AdaptiveTable& node_table(NodeContext context) {
    return tables_[(context & 0xffU) >> kTableShift[stage_]];
  }
  /// Row of SymbolMaps for the node's symbol: stage 0 codes it as it is.
  [[nodiscard]] unsigned symmetry(NodeContext context) const {
    return stage_ == 0 ? SymbolMaps::kIdentity : context >> 8 & 63U;
  }
  AdaptiveTable& texture_table() { return texture_; }

 private:
  static constexpr unsigned kTableShift[3] = {
      8, 3, 0};  // one table; one a class; one a class and position

  unsigned stage_ = 0;
  std::vector<AdaptiveTable> tables_;
  AdaptiveTable texture_;
};

}  // namespace afx::codec
