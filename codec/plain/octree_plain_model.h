// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <vector>

#include "codec/plain/octree_rules.h"

namespace afx::codec::plain {

/// A table of frequencies.
struct Table {
  std::vector<uint16_t> frequency;
  uint32_t total;
  uint16_t step;
  TableRules rules;

  Table(size_t symbols, uint16_t step_in, const TableRules& rules_in);
  void count(size_t symbol);
};

/// What a node symbol is coded with.
struct NodeTable {
  Table& table;
  unsigned symmetry;  ///< Symmetries::kIdentity where the symbol is coded as it is
};

/// The tables of a frame (section 4).
class Model {
 public:
  Model(unsigned textures, const Rules& rules);

  /// For the next node symbol.
  NodeTable node(uint8_t parent, unsigned position);
  /// For the next texture symbol.
  Table& texture(bool of_voxel);
  /// Makes ready for the next frame of a stream.
  void restart();

 private:
  void enter_stage(size_t stage);
  [[nodiscard]] size_t tables_of(Context context) const;
  [[nodiscard]] size_t table_before(size_t stage, size_t table) const;

  const Rules& rules_;
  const Symmetries& symmetries_;
  unsigned textures_;
  uint64_t coded_ = 0;  // N
  size_t stage_ = 0;
  std::vector<Table> tables_;
  std::vector<Table> texture_;  // of nodes and, where those are apart, of voxels
};

}  // namespace afx::codec::plain
