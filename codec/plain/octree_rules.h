// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The rules of the octree bitstream as data: the values are those of the text, and each can be
// broken by itself, to see which streams of the conformance suites notice it.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string_view>

#include "codec/plain/octree_plain_symmetry.h"

namespace afx::codec::plain {

/// Section 1.
struct BitRules {
  bool msb_first = true;
  bool is_signed = false;   ///< numbers are of two's complement
  unsigned align = 8;       ///< the boundary that an align goes up to
  unsigned align_with = 0;  ///< the bits that an encoder writes there
};

/// A number of the header after the field that has its width.
struct NumberRules {
  unsigned width_bits;
  unsigned spare_bits = 0;     ///< in what an encoder writes
  unsigned width_of_zero = 0;  ///< likewise
  uint32_t offset = 0;         ///< of the number coded from the one meant
};

enum class LevelsOf { ceil_log2, floor_log2, bit_width };

/// Sections 2 and 8. Warnings are named by their codes.
struct StreamRules {
  NumberRules resolution{5};
  NumberRules textures{3};
  LevelsOf levels = LevelsOf::ceil_log2;
  uint32_t most_textures = 127;
  bool powers_of_two_only = false;
  bool zero_resolution = false;  ///< is accepted and means 1
  bool missing_bits = false;     ///< a header's bits past the end of the data read as 0
  bool aligned_frames = true;
  uint32_t start_code = 0x000001C8;
  bool any_start_code = false;    ///< any 32 bits will do
  bool short_start_code = false;  ///< one that the data end in is a wrong one
  bool codes_are_searched = false;
  bool codes_end_frames = false;  ///< frame data never contain the pattern
  bool code_at_end = false;       ///< a start code ends the stream, too
  uint32_t least_frames = 1;
  uint32_t most_frames = UINT32_MAX;
  bool tables_carry = false;  ///< from frame to frame, those of node symbols
  bool texture_table_carries = false;
  std::string_view unreported;  ///< the warning that is not given
  std::string_view refused;     ///< the warning that is an error instead
  bool places_in_bytes = false;
};

enum class LevelOrder { by_parent, parents_backwards, depth_first };

/// Section 3.
struct WalkRules {
  LevelOrder order = LevelOrder::by_parent;
  bool siblings_backwards = false;
  bool bits_backwards = false;  ///< bit 7 - i is child i
  int more_node_levels = 0;     ///< levels of nodes beyond those of the resolution
  bool textures_always = false;
  bool root_texture = true;
  bool single_voxel_texture = true;
  bool voxel_textures = true;
  bool texture_first = false;  ///< before the node symbol
  bool texture_inherited = true;
  uint8_t undefined = 0;          ///< the texture symbol that leaves it undefined
  bool undefined_voxels = true;   ///< are accepted
  bool transformed_byte = false;  ///< of the parent, as context
  bool coded_octree = false;      ///< the field has the symbols as they were coded
  bool inherited_index = false;   ///< the field has the textures of all nodes
  uint64_t childless_from = 1;    ///< the first symbol that should have children
};

/// A table's frequencies and how they grow and shrink.
struct TableRules {
  uint16_t first;
  uint32_t limit;
  bool halved_at_limit = false;  ///< not only beyond it
  bool halved_upwards = true;    ///< (f + 1) / 2, not f / 2 but at least 1
};

enum class Context { none, parent_class, position, class_and_position };

struct Stage {
  uint64_t start;
  Context context;
  uint16_t step;
  bool transformed;    ///< T(symbol) is coded
  bool copies = true;  ///< its tables begin as copies of those before
};

/// Sections 4 and 5.
struct ModelRules {
  size_t node_symbols = 256;
  TableRules node{1, 8192};
  std::array<Stage, 3> stages{{{0, Context::none, 2, false},
                               {512, Context::parent_class, 3, true},
                               {512 + 2048, Context::class_and_position, 4, true}}};
  bool textures_count = false;  ///< to N, too
  bool transformed_position = true;
  bool decoder_inverts = true;     ///< or applies T once more
  bool base_to_parent = false;     ///< T goes this way
  bool own_symbol_counts = false;  ///< not the coded one
  unsigned texture_symbols = 1;    ///< beside the images
  TableRules texture{1, 512};
  uint16_t texture_step = 32;
  bool voxels_apart = false;  ///< their texture symbols have a table of their own
  std::shared_ptr<const Symmetries> symmetries = text_symmetries();
};

/// Section 6.
struct CoderRules {
  bool division_up = false;
  bool greater_lower = true;  ///< intervals of greater symbols
  uint32_t first_high = 65535;
  uint32_t length_beyond = 1;  ///< length - (high - low)
  bool high_up = false;        ///< rounded
  bool low_up = false;
  unsigned lower_bit = 0;
  unsigned upper_bit = 1;
  uint32_t middle_from = 16384;
  uint32_t middle_below = 49152;
  bool pending_complement = true;
  bool pending_spent = true;
  unsigned finish_pending = 1;
  uint32_t finish_zero_below = 16384;
  unsigned code_bits = 16;
  bool target_from_code = false;  ///< (code - low) * cum[0] / length
  unsigned past_end = 0;
  unsigned end_bits = 2;
  unsigned empty_frame_bits = 2;
  bool truncation = true;
  bool truncation_at_once = true;  ///< or tested when all is decoded
  bool truncated_at_end = true;    ///< or at the frame's beginning
  unsigned whole_bits = 16;
  uint32_t ending_low = 1;
  uint32_t ending_high = 2;
};

/// Section 7.
struct LevelRules {
  bool own_resolution = true;
  unsigned more_levels = 0;
  bool textures = true;
  bool undefined_zeros = true;
  bool all_is_whole = true;  ///< or k = levels gives 2^k
  bool none_is_all = false;
  bool childless_stay = false;  ///< as voxels of finer levels
  bool of_truncated = true;     ///< something comes of a truncated frame
  bool nodes_suffice = false;   ///< a level without all texture symbols is complete
  bool whole_voxels = true;     ///< the texture symbols of voxels that are there are kept
  bool root_at_least = false;
};

struct Rules {
  BitRules bits;
  StreamRules stream;
  WalkRules walk;
  ModelRules model;
  CoderRules coder;
  LevelRules levels;
};

/// Those of the text.
inline const Rules& text_rules() {
  static const Rules kRules;
  return kRules;
}

}  // namespace afx::codec::plain
