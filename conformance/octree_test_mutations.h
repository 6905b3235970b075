// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The rules of conformance/suites/rules/octree.json, each broken in the plain coder.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "codec/plain/octree_rules.h"

namespace afx::conformance {

using codec::plain::Rules;

struct Mutation {
  std::string rule;  ///< without "octree."
  std::string text;  ///< what is done instead
  void (*apply)(Rules&);
};

inline void set_symmetries(Rules& r, const codec::plain::SymmetryRules& symmetries) {
  r.model.symmetries = codec::plain::make_symmetries(symmetries);
}

inline auto permutations_with_exchanged(size_t a, size_t b) {
  auto permutations = codec::plain::SymmetryRules{}.permutations;
  std::swap(permutations[a], permutations[b]);
  return permutations;
}

inline std::vector<Mutation> octree_mutations() {
  using codec::plain::Context;
  using codec::plain::LevelOrder;
  using codec::plain::LevelsOf;
  return {
      {"1.msb-first", "least significant bit of a byte first",
       [](Rules& r) { r.bits.msb_first = false; }},
      {"1.unsigned", "numbers of two's complement", [](Rules& r) { r.bits.is_signed = true; }},
      {"1.align-to-byte", "align to 16 bits", [](Rules& r) { r.bits.align = 16; }},
      {"1.align-to-byte", "align to 4 bits", [](Rules& r) { r.bits.align = 4; }},
      {"1.align-zeros", "align with ones", [](Rules& r) { r.bits.align_with = 1; }},
      {"1.division", "division rounds up", [](Rules& r) { r.coder.division_up = true; }},

      {"2.resolution-bits", "u(6)", [](Rules& r) { r.stream.resolution.width_bits = 6; }},
      {"2.resolution", "octreeResolution - 1 is coded",
       [](Rules& r) { r.stream.resolution.offset = 1; }},
      {"2.resolution-least-width", "a bit more than it takes",
       [](Rules& r) { r.stream.resolution.spare_bits = 1; }},
      {"2.texture-bits", "u(4)", [](Rules& r) { r.stream.textures.width_bits = 4; }},
      {"2.textures", "numOfTextures - 1 is coded", [](Rules& r) { r.stream.textures.offset = 1; }},
      {"2.textures-least-width", "a bit more than it takes",
       [](Rules& r) { r.stream.textures.spare_bits = 1; }},
      {"2.no-textures-width", "one bit for 0",
       [](Rules& r) { r.stream.textures.width_of_zero = 1; }},
      {"2.align-before-frame", "no align before start codes",
       [](Rules& r) { r.stream.aligned_frames = false; }},
      {"2.start-code", "0x000001C7", [](Rules& r) { r.stream.start_code = 0x000001C7; }},
      {"2.levels", "rounded down", [](Rules& r) { r.stream.levels = LevelsOf::floor_log2; }},
      {"2.levels", "the width of octreeResolution",
       [](Rules& r) { r.stream.levels = LevelsOf::bit_width; }},
      {"2.most-textures", "at most 126", [](Rules& r) { r.stream.most_textures = 126; }},
      {"2.wide-widths-accepted", "they are an error",
       [](Rules& r) { r.stream.refused = "non_minimal_width"; }},
      {"2.wide-widths-warning", "no warning",
       [](Rules& r) { r.stream.unreported = "non_minimal_width"; }},
      {"2.another-frame", "one frame only", [](Rules& r) { r.stream.most_frames = 1; }},
      {"2.end", "a start code is expected at the end",
       [](Rules& r) { r.stream.code_at_end = true; }},
      {"2.trailing-accepted", "it is an error",
       [](Rules& r) { r.stream.refused = "trailing_bytes"; }},
      {"2.trailing-warning", "no warning",
       [](Rules& r) { r.stream.unreported = "trailing_bytes"; }},
      {"2.align-warning", "no warning", [](Rules& r) { r.stream.unreported = "align_bits"; }},
      {"2.align-accepted", "they are an error", [](Rules& r) { r.stream.refused = "align_bits"; }},
      {"2.no-searching", "the next start code is searched for",
       [](Rules& r) { r.stream.codes_are_searched = true; }},
      {"2.pattern-in-frame", "the pattern ends the frame",
       [](Rules& r) { r.stream.codes_end_frames = true; }},
      {"2.one-frame", "none will do", [](Rules& r) { r.stream.least_frames = 0; }},
      {"2.root-texture", "the root has none, its children do",
       [](Rules& r) { r.walk.root_texture = false; }},
      {"2.voxel-texture", "a single voxel has none",
       [](Rules& r) { r.walk.single_voxel_texture = false; }},
      {"2.outside-voxels", "only powers of two",
       [](Rules& r) { r.stream.powers_of_two_only = true; }},
      {"2.frames-independent", "the tables go on", [](Rules& r) { r.stream.tables_carry = true; }},
      {"2.frames-independent-textures", "the table goes on",
       [](Rules& r) { r.stream.texture_table_carries = true; }},

      {"3.byte-per-node", "the last level of nodes has none",
       [](Rules& r) { r.walk.more_node_levels = -1; }},
      {"3.voxels-have-no-byte", "voxels have one", [](Rules& r) { r.walk.more_node_levels = 1; }},
      {"3.child-bits", "bit 7 - i", [](Rules& r) { r.walk.bits_backwards = true; }},
      {"3.child-index", "i = 4x + 2y + z",
       [](Rules& r) {
         set_symmetries(r, {.axis_bits = {2, 1, 0}});
       }},
      {"3.breadth-first", "depth first", [](Rules& r) { r.walk.order = LevelOrder::depth_first; }},
      {"3.order-of-parents", "the last parent's children first",
       [](Rules& r) { r.walk.order = LevelOrder::parents_backwards; }},
      {"3.order-of-siblings", "the last child first",
       [](Rules& r) { r.walk.siblings_backwards = true; }},
      {"3.texture-zero", "1 is undefined", [](Rules& r) { r.walk.undefined = 1; }},
      {"3.texture-inherited", "every node has one",
       [](Rules& r) { r.walk.texture_inherited = false; }},
      {"3.texture-after-node", "before it", [](Rules& r) { r.walk.texture_first = true; }},
      {"3.voxel-textures", "voxels have none", [](Rules& r) { r.walk.voxel_textures = false; }},
      {"3.no-textures", "symbols of a table of one",
       [](Rules& r) { r.walk.textures_always = true; }},
      {"3.parents-own-byte", "the transformed one",
       [](Rules& r) { r.walk.transformed_byte = true; }},
      {"3.field-octree", "the symbols as coded", [](Rules& r) { r.walk.coded_octree = true; }},
      {"3.field-index", "the textures of all nodes",
       [](Rules& r) { r.walk.inherited_index = true; }},
      {"3.undefined-voxel", "it is an error", [](Rules& r) { r.walk.undefined_voxels = false; }},
      {"3.empty-object", "it is warned of", [](Rules& r) { r.walk.childless_from = 0; }},
      {"3.childless-accepted", "it is an error",
       [](Rules& r) { r.stream.refused = "octree_childless_node"; }},
      {"3.childless-warning", "no warning",
       [](Rules& r) { r.stream.unreported = "octree_childless_node"; }},

      {"4.1.node-symbols", "257", [](Rules& r) { r.model.node_symbols = 257; }},
      {"4.1.count", "texture symbols, too", [](Rules& r) { r.model.textures_count = true; }},
      {"4.1.stage0-table", "one for each class",
       [](Rules& r) { r.model.stages[0].context = Context::parent_class; }},
      {"4.1.stage0-symbol", "T(node symbol)",
       [](Rules& r) { r.model.stages[0].transformed = true; }},
      {"4.1.stage0-step", "1", [](Rules& r) { r.model.stages[0].step = 1; }},
      {"4.1.stage0-step", "3", [](Rules& r) { r.model.stages[0].step = 3; }},
      {"4.1.stage1-start", "511", [](Rules& r) { r.model.stages[1].start = 511; }},
      {"4.1.stage1-start", "513", [](Rules& r) { r.model.stages[1].start = 513; }},
      {"4.1.stage1-copies", "fresh tables", [](Rules& r) { r.model.stages[1].copies = false; }},
      {"4.1.stage1-tables", "one table",
       [](Rules& r) { r.model.stages[1].context = Context::none; }},
      {"4.1.stage1-symbol", "the node symbol itself",
       [](Rules& r) { r.model.stages[1].transformed = false; }},
      {"4.1.stage1-step", "2", [](Rules& r) { r.model.stages[1].step = 2; }},
      {"4.1.stage1-step", "4", [](Rules& r) { r.model.stages[1].step = 4; }},
      {"4.1.stage2-start", "2559", [](Rules& r) { r.model.stages[2].start = 2559; }},
      {"4.1.stage2-start", "2561", [](Rules& r) { r.model.stages[2].start = 2561; }},
      {"4.1.stage2-copies", "fresh tables", [](Rules& r) { r.model.stages[2].copies = false; }},
      {"4.1.stage2-class", "by position alone",
       [](Rules& r) { r.model.stages[2].context = Context::position; }},
      {"4.1.stage2-position", "by class alone",
       [](Rules& r) { r.model.stages[2].context = Context::parent_class; }},
      {"4.1.stage2-position-transformed", "the position itself",
       [](Rules& r) { r.model.transformed_position = false; }},
      {"4.1.stage2-symbol", "the node symbol itself",
       [](Rules& r) { r.model.stages[2].transformed = false; }},
      {"4.1.stage2-step", "3", [](Rules& r) { r.model.stages[2].step = 3; }},
      {"4.1.stage2-step", "5", [](Rules& r) { r.model.stages[2].step = 5; }},
      {"4.1.inverse", "T once more", [](Rules& r) { r.model.decoder_inverts = false; }},
      {"4.1.symmetry-of-parent", "from the base to the parent symbol",
       [](Rules& r) { r.model.base_to_parent = true; }},
      {"4.1.start-at-one", "2", [](Rules& r) { r.model.node.first = 2; }},
      {"4.1.counted-symbol", "that of the node symbol itself",
       [](Rules& r) { r.model.own_symbol_counts = true; }},
      {"4.1.limit", "16384", [](Rules& r) { r.model.node.limit = 16384; }},
      {"4.1.limit", "4096", [](Rules& r) { r.model.node.limit = 4096; }},
      {"4.1.limit-exceeded", "it is", [](Rules& r) { r.model.node.halved_at_limit = true; }},
      {"4.1.halving", "f / 2, at least 1", [](Rules& r) { r.model.node.halved_upwards = false; }},
      {"4.2.texture-symbols", "one more", [](Rules& r) { r.model.texture_symbols = 2; }},
      {"4.2.one-table", "voxels have their own", [](Rules& r) { r.model.voxels_apart = true; }},
      {"4.2.start-at-one", "2", [](Rules& r) { r.model.texture.first = 2; }},
      {"4.2.step", "16", [](Rules& r) { r.model.texture_step = 16; }},
      {"4.2.step", "31", [](Rules& r) { r.model.texture_step = 31; }},
      {"4.2.limit", "1024", [](Rules& r) { r.model.texture.limit = 1024; }},
      {"4.2.limit", "256", [](Rules& r) { r.model.texture.limit = 256; }},
      {"4.2.limit-exceeded", "it is", [](Rules& r) { r.model.texture.halved_at_limit = true; }},
      {"4.2.halving", "f / 2, at least 1",
       [](Rules& r) { r.model.texture.halved_upwards = false; }},

      {"5.numbering", "t = 8 * p + flips",
       [](Rules& r) { set_symmetries(r, {.permutations_first = true}); }},
      {"5.permutations", "P_0 and P_1 exchanged",
       [](Rules& r) { set_symmetries(r, {.permutations = permutations_with_exchanged(0, 1)}); }},
      {"5.permutations", "P_1 and P_3 exchanged",
       [](Rules& r) { set_symmetries(r, {.permutations = permutations_with_exchanged(1, 3)}); }},
      {"5.permutations", "P_2 and P_4 exchanged",
       [](Rules& r) { set_symmetries(r, {.permutations = permutations_with_exchanged(2, 4)}); }},
      {"5.permutations", "P_4 and P_5 exchanged",
       [](Rules& r) { set_symmetries(r, {.permutations = permutations_with_exchanged(4, 5)}); }},
      {"5.flips-after", "before it", [](Rules& r) { set_symmetries(r, {.flips_before = true}); }},
      {"5.flip-bits", "bit 2 - k",
       [](Rules& r) { set_symmetries(r, {.flip_bits_backwards = true}); }},
      {"5.symbols", "bit i of T(s) is bit T(i) of s",
       [](Rules& r) { set_symmetries(r, {.symbols_inverse = true}); }},
      {"5.classes", "rotations alone", [](Rules& r) { set_symmetries(r, {.mirrors = false}); }},
      {"5.base", "the greatest", [](Rules& r) { set_symmetries(r, {.greatest_base = true}); }},
      {"5.smallest-symmetry", "the greatest",
       [](Rules& r) { set_symmetries(r, {.greatest_symmetry = true}); }},

      {"6.cumulative", "intervals of greater symbols lie higher",
       [](Rules& r) { r.coder.greater_lower = false; }},
      {"6.initial-interval", "high = 65534", [](Rules& r) { r.coder.first_high = 65534; }},
      {"6.length", "high - low", [](Rules& r) { r.coder.length_beyond = 0; }},
      {"6.narrow-high", "the quotient rounded up", [](Rules& r) { r.coder.high_up = true; }},
      {"6.narrow-low", "the quotient rounded up", [](Rules& r) { r.coder.low_up = true; }},
      {"6.lower-half", "a 1 is out", [](Rules& r) { r.coder.lower_bit = 1; }},
      {"6.upper-half", "a 0 is out", [](Rules& r) { r.coder.upper_bit = 0; }},
      {"6.middle", "only if high < 40960", [](Rules& r) { r.coder.middle_below = 40960; }},
      {"6.middle-from-quarter", "only if low > Q1", [](Rules& r) { r.coder.middle_from = 16385; }},
      {"6.pending", "b as often", [](Rules& r) { r.coder.pending_complement = false; }},
      {"6.pending-spent", "they stay", [](Rules& r) { r.coder.pending_spent = false; }},
      {"6.finish-pending", "none more", [](Rules& r) { r.coder.finish_pending = 0; }},
      {"6.finish", "0 where low <= Q1", [](Rules& r) { r.coder.finish_zero_below = 16385; }},
      {"6.finish", "always 1", [](Rules& r) { r.coder.finish_zero_below = 0; }},
      {"6.decoder-start", "with 15 bits", [](Rules& r) { r.coder.code_bits = 15; }},
      {"6.target", "(code - low) * cum[0] / length",
       [](Rules& r) { r.coder.target_from_code = true; }},
      {"6.zeros-past-end", "they read as 1", [](Rules& r) { r.coder.past_end = 1; }},
      {"6.frame-length", "S + 16 bits, as far as was read",
       [](Rules& r) { r.coder.end_bits = 16; }},
      {"6.frame-length", "S + 1 bits", [](Rules& r) { r.coder.end_bits = 1; }},
      {"6.truncated", "it is read on as zeros", [](Rules& r) { r.coder.truncation = false; }},
      {"6.truncated-when", "when the frame is decoded",
       [](Rules& r) { r.coder.truncation_at_once = false; }},
      {"6.truncated-place", "where the frame begins",
       [](Rules& r) { r.coder.truncated_at_end = false; }},
      {"6.no-symbols", "no bit long", [](Rules& r) { r.coder.empty_frame_bits = 0; }},
      {"6.whole-symbols", "those of S + 2 bits", [](Rules& r) { r.coder.whole_bits = 2; }},
      {"6.ending-accepted", "it is an error",
       [](Rules& r) { r.stream.refused = "octree_bad_ending"; }},
      {"6.ending-low", "it is 0", [](Rules& r) { r.coder.ending_low = 0; }},
      {"6.ending-low", "no warning", [](Rules& r) { r.stream.unreported = "octree_bad_ending"; }},
      {"6.ending-high", "it is 1", [](Rules& r) { r.coder.ending_high = 1; }},
      {"6.ending-high", "it is 3", [](Rules& r) { r.coder.ending_high = 3; }},

      {"7.levels-resolution", "that of the stream",
       [](Rules& r) { r.levels.own_resolution = false; }},
      {"7.levels-nodes", "those of level k, too", [](Rules& r) { r.levels.more_levels = 1; }},
      {"7.levels-textures", "none", [](Rules& r) { r.levels.textures = false; }},
      {"7.levels-undefined", "nothing", [](Rules& r) { r.levels.undefined_zeros = false; }},
      {"7.levels-all", "k = levels gives 2^k", [](Rules& r) { r.levels.all_is_whole = false; }},
      {"7.levels-none", "k = 0 is all", [](Rules& r) { r.levels.none_is_all = true; }},
      {"7.childless-coarser", "it stays as a voxel",
       [](Rules& r) { r.levels.childless_stay = true; }},
      {"7.truncated-level", "nothing comes", [](Rules& r) { r.levels.of_truncated = false; }},
      {"7.complete-level", "when its node symbols are",
       [](Rules& r) { r.levels.nodes_suffice = true; }},
      {"7.truncated-voxels", "0 for all voxels", [](Rules& r) { r.levels.whole_voxels = false; }},
      {"7.truncated-root", "one voxel comes", [](Rules& r) { r.levels.root_at_least = true; }},

      {"8.place", "in bytes", [](Rules& r) { r.stream.places_in_bytes = true; }},
      {"8.resolution-zero", "it means 1", [](Rules& r) { r.stream.zero_resolution = true; }},
      {"8.missing-start-code", "any 32 bits will do",
       [](Rules& r) { r.stream.any_start_code = true; }},
      {"8.truncated-header", "its missing bits are 0",
       [](Rules& r) { r.stream.missing_bits = true; }},
      {"8.truncated-start-code", "it is a wrong one",
       [](Rules& r) { r.stream.short_start_code = true; }},
  };
}

struct Unbroken {
  std::string rule;
  std::string why;
};

/// Rules that no mutation of a decoder or encoder of streams can break in sight of a suite.
inline std::vector<Unbroken> octree_rules_without_mutation() {
  const std::string encoder = "an encoder's refusal, of what no stream can hold: ";
  return {
      {"2.too-many-images", encoder + "OctreeStream.EncoderSaysWhatCannotBeCoded"},
      {"2.no-frames-refused", encoder + "OctreeStream.EncoderSaysWhatCannotBeCoded"},
      {"3.larger-half", "places voxels in space: no bit or field of a stream depends on it"},
      {"3.texture-names-image", "is the renderer's: no bit or field of a stream depends on it"},
      {"5.permutation", "its inverse makes the same streams: only P_3 and P_4 change places"},
      {"5.class-numbers", "name tables that are alike: no bit of a stream depends on it"},
      {"7.stopping", "leaves the choice to the decoder"},
      {"8.texture-beyond", encoder + "OctreeCoder tests of codec"},
      {"8.octree-does-not-fit", encoder + "OctreeStream.EncoderSaysWhatCannotBeCoded"},
      {"8.index-does-not-fit", encoder + "OctreeCoder tests of codec"},
      {"8.no-endless-work", "is a promise of time and memory; the judge's time limit holds it"},
      {"8.node-limit",
       "the case limit-nodes takes the plain coder too long; the library passes it"},
  };
}

}  // namespace afx::conformance
