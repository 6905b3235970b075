// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "codec/octree_decoder.h"

#include <algorithm>
#include <bit>
#include <string>

#include "codec/arithmetic_decoder.h"
#include "codec/octree_contexts.h"
#include "codec/octree_walk.h"

namespace afx::codec {
namespace {

// Renormalisation shifts at most 16 bits for a symbol; a node has one or two symbols.
constexpr uint64_t kMostBitsOfNode = 32;
// The least that a node symbol can cost is log2(8192 / (8192 - 255)) = 0.0456 bits, so this many
// symbols to a bit are the most there can be: what a level claims beyond it is not reserved ahead.
constexpr uint64_t kMostSymbolsOfBit = 22;

class FrameDecoder {
 public:
  FrameDecoder(std::span<const uint8_t> data, const OctreeFrameOptions& options,
               Diagnostics& diagnostics)
      : options_(options),
        diagnostics_(diagnostics),
        data_bytes_(data.size()),
        bits_present_(uint64_t{data.size()} * 8),
        decoder_(data),
        contexts_(options.textures),
        walk_(frame_.fields, options.textures > 0) {}

  OctreeFrame run();

 private:
  void decode_level();
  size_t decode_batch(const NodeContext* contexts, size_t count);
  void decode_nodes(const NodeContext* contexts, size_t count);
  bool decode_node_near_end(NodeContext context);
  void decode_voxels();
  uint8_t decode_checked(AdaptiveTable& table, const uint8_t* map);
  void fail_truncated();
  void reserve_level();
  void check_limits();
  void end_level(uint64_t textures_before);
  void warn();
  void keep_what_is_whole();

  [[nodiscard]] bool ok() const { return frame_.status.ok(); }
  [[nodiscard]] uint64_t symbols() const { return frame_.node_symbols + frame_.texture_symbols; }
  /// How many nodes can be decoded without asking after each symbol whether the data have ended.
  [[nodiscard]] uint64_t unchecked_nodes() const {
    const uint64_t used = decoder_.shifts() + 16;
    return bits_present_ > used ? (bits_present_ - used) / kMostBitsOfNode : 0;
  }

  const OctreeFrameOptions& options_;
  Diagnostics& diagnostics_;
  const uint64_t data_bytes_;
  const uint64_t bits_present_;
  OctreeFrame frame_;
  ArithmeticDecoder decoder_;
  OctreeContexts contexts_;
  OctreeWalk walk_;
  uint64_t children_ = 0;       // of the nodes of this level decoded so far
  uint64_t nodes_known_ = 1;    // in all levels whose size is known
  uint64_t whole_symbols_ = 0;  // counted near the end only: those that rest on no bit past the end
  bool past_end_ = false;       // whether whole_symbols_ has stopped
};

OctreeFrame FrameDecoder::run() {
  const unsigned stop = std::min(options_.stop_level, options_.levels);
  while (ok() && walk_.level() < stop) decode_level();
  if (ok() && stop == options_.levels) decode_voxels();
  frame_.bits = decoder_.shifts() + 2;
  if (ok() && frame_.bits > bits_present_)
    fail_truncated();  // a frame without symbols has two bits, too
  keep_what_is_whole();
  warn();
  return std::move(frame_);
}

void FrameDecoder::decode_level() {
  const uint64_t textures_before = frame_.texture_symbols;
  uint64_t done = 0;
  children_ = 0;
  reserve_level();
  while (ok() && walk_.remaining() > 0) {
    const OctreeWalk::Batch batch = walk_.next_contexts();
    done += decode_batch(batch.contexts, batch.count);
    check_limits();
  }
  if (done == walk_.nodes()) end_level(textures_before);
}

/// Returns how many nodes were decoded with all their symbols: all, unless the data end before.
size_t FrameDecoder::decode_batch(const NodeContext* contexts, size_t count) {
  for (size_t done = 0; done < count;) {
    const uint64_t in_stage = contexts_.enter_stage(frame_.node_symbols);
    const uint64_t in_data = unchecked_nodes();
    if (in_data > 0) {
      const auto now = static_cast<size_t>(std::min({uint64_t{count - done}, in_stage, in_data}));
      decode_nodes(contexts + done, now);
      done += now;
    } else if (decode_node_near_end(contexts[done])) {
      ++done;
      if (!ok()) return done;
    } else {
      return done;
    }
  }
  return count;
}

/// The loop that costs the time. All nodes belong to one stage, and their bits are there.
void FrameDecoder::decode_nodes(const NodeContext* contexts, size_t count) {
  OctreeFields& fields = frame_.fields;
  const size_t first = fields.octree.size();
  fields.octree.resize(first + count);
  uint8_t* out = fields.octree.data() + first;
  ArithmeticDecoder decoder = decoder_;  // a copy of our own stays in registers
  uint64_t children = 0;
  for (size_t i = 0; i < count; ++i) {
    const NodeContext context = contexts[i];
    const uint32_t mapped = decoder.decode(contexts_.node_table(context));
    const uint8_t symbol = kSymbolMaps.inverse[contexts_.symmetry(context)][mapped];
    out[i] = symbol;
    children += static_cast<unsigned>(std::popcount(symbol));
    if ((context & kTextured) != 0) {
      fields.voxel_image_index.push_back(
          static_cast<uint8_t>(decoder.decode(contexts_.texture_table())));
    }
  }
  decoder_ = decoder;
  children_ += children;
  frame_.node_symbols += count;
  frame_.texture_symbols = fields.voxel_image_index.size();
}

/// Returns whether the node got all its symbols.
bool FrameDecoder::decode_node_near_end(NodeContext context) {
  const auto& map = kSymbolMaps.inverse[contexts_.symmetry(context)];
  const uint8_t symbol = decode_checked(contexts_.node_table(context), map.data());
  frame_.fields.octree.push_back(symbol);
  children_ += static_cast<unsigned>(std::popcount(symbol));
  ++frame_.node_symbols;
  if ((context & kTextured) == 0) return true;
  if (!ok()) return false;
  frame_.fields.voxel_image_index.push_back(decode_checked(contexts_.texture_table(), nullptr));
  ++frame_.texture_symbols;
  return true;
}

void FrameDecoder::decode_voxels() {
  if (options_.textures == 0) return;
  const uint64_t textures_before = frame_.texture_symbols;
  uint64_t in_data = 0;
  while (ok() && walk_.remaining() > 0) {
    const OctreeWalk::Run run = walk_.next_run();
    if (!run.textured) continue;
    for (uint64_t n = 0; n < run.nodes && ok(); ++n) {
      if (in_data == 0) in_data = unchecked_nodes();
      const bool checked = in_data == 0;
      AdaptiveTable& table = contexts_.texture_table();
      frame_.fields.voxel_image_index.push_back(
          checked ? decode_checked(table, nullptr) : static_cast<uint8_t>(decoder_.decode(table)));
      ++frame_.texture_symbols;
      if (!checked) --in_data;
    }
    check_limits();
  }
  if (ok()) end_level(textures_before);
}

/// Decodes a symbol where the data may end, and maps it where a map is given. A symbol is whole if
/// the 16 bits of code that it rests on are there; the frame is truncated where its bits so far are
/// not.
uint8_t FrameDecoder::decode_checked(AdaptiveTable& table, const uint8_t* map) {
  if (!past_end_) {
    whole_symbols_ = symbols();
    past_end_ = decoder_.shifts() + 16 > bits_present_;
  }
  const uint32_t symbol = decoder_.decode(table);
  if (!past_end_) whole_symbols_ = symbols() + 1;
  if (decoder_.shifts() + 2 > bits_present_) fail_truncated();
  return map != nullptr ? map[symbol] : static_cast<uint8_t>(symbol);
}

void FrameDecoder::fail_truncated() {
  const Place place = Place::at_byte(options_.base_byte + data_bytes_);
  const uint64_t nodes = nodes_known_ - (walk_.level() == options_.levels ? walk_.nodes() : 0);
  if (nodes == 0 && options_.textures == 0) {
    frame_.status = Error{Errc::truncated, place,
                          "the data end where the octree frame begins (expected its 2 bits)"};
    return;
  }
  const uint64_t number = symbols() + 1;
  const uint64_t known = std::max(number, nodes + frame_.texture_symbols);  // with the one at hand
  frame_.status =
      Error{Errc::truncated, place,
            "the data end inside the octree frame, at symbol " + std::to_string(number) + " of " +
                std::to_string(known) + " known so far (" + std::to_string(nodes) + " nodes, " +
                std::to_string(known - nodes) + " image indices)"};
}

void FrameDecoder::reserve_level() {
  const uint64_t used = decoder_.shifts();
  const uint64_t bits = bits_present_ > used ? bits_present_ - used : 0;
  const uint64_t symbols = std::min(walk_.nodes(), (bits + 64) * kMostSymbolsOfBit);
  frame_.fields.octree.reserve(frame_.fields.octree.size() + static_cast<size_t>(symbols));
}

void FrameDecoder::check_limits() {
  if (!ok()) return;
  const Place place = Place::at_bit(options_.base_byte * 8 + decoder_.shifts() + 2);
  const uint64_t bytes = frame_.fields.octree.size() + frame_.fields.voxel_image_index.size();
  if (nodes_known_ + children_ > options_.limits.octree_nodes) {
    frame_.status = Error{Errc::limit_exceeded, place,
                          "octree has more nodes than the limit of " +
                              std::to_string(options_.limits.octree_nodes) + " (in level " +
                              std::to_string(walk_.level() + 1) + " of " +
                              std::to_string(options_.levels) + ")"};
  } else if (bytes > options_.limits.memory) {
    frame_.status = Error{Errc::limit_exceeded, place,
                          "octree fields need more memory than the limit of " +
                              std::to_string(options_.limits.memory) + " bytes"};
  }
}

void FrameDecoder::end_level(uint64_t textures_before) {
  frame_.stats.push_back(
      {walk_.nodes(), frame_.texture_symbols - textures_before, decoder_.shifts() + 2});
  if (walk_.level() == options_.levels) return;
  walk_.descend(children_, frame_.fields.voxel_image_index.size());
  nodes_known_ += children_;
  children_ = 0;
}

void FrameDecoder::warn() {
  const auto& octree = frame_.fields.octree;
  const auto childless =
      octree.empty() ? 0 : std::count(octree.begin() + 1, octree.end(), uint8_t{0});
  if (childless > 0) {
    diagnostics_.warn(
        "octree_childless_node", Place::at_byte(options_.base_byte),
        std::to_string(childless) + " nodes below the root have no children (symbol 0)");
  }
  const bool whole = ok() && walk_.level() == options_.levels;
  if (whole && !decoder_.ends_well()) {
    diagnostics_.warn("octree_bad_ending", Place::at_bit(options_.base_byte * 8 + frame_.bits),
                      "the octree frame does not end as an encoder leaves it: it may be damaged");
  }
}

void cut_octree(OctreeFields& fields, bool textured, unsigned level, uint64_t whole_textures);

void FrameDecoder::keep_what_is_whole() {
  unsigned levels = walk_.level();
  uint64_t whole_textures = frame_.texture_symbols;
  if (!ok()) {
    // The deepest level above which every symbol is whole; the voxels' own symbols may be missing.
    uint64_t before = 0;
    for (levels = 0; levels < walk_.level() && levels < frame_.stats.size(); ++levels) {
      const OctreeLevelStats& level = frame_.stats[levels];
      before += level.nodes + level.texture_symbols;
      if (before > whole_symbols_) break;
    }
    if (levels == 0 || frame_.status.error().code != Errc::truncated) {
      frame_.fields = {};
      return;
    }
    whole_textures = whole_symbols_ - std::min(whole_symbols_, frame_.node_symbols);
  }
  frame_.usable = true;
  frame_.levels = levels;
  if (!ok() || levels < options_.levels) {
    const bool voxels_reached = levels == options_.levels;
    cut_octree(frame_.fields, options_.textures > 0, levels, voxels_reached ? whole_textures : 0);
  }
}

/// Keeps the symbols of the levels above `level`, and of those after them in voxel_image_index as
/// many as make `whole_textures` in all; the other voxels whose image is undefined get 0.
void cut_octree(OctreeFields& fields, bool textured, unsigned level, uint64_t whole_textures) {
  OctreeWalk walk(fields, textured);
  size_t nodes = 0;     // of the levels above
  size_t textures = 0;  // of the levels above
  for (unsigned l = 0;; ++l) {
    size_t symbols = 0;
    while (textured && walk.remaining() > 0) {
      const OctreeWalk::Run run = walk.next_run();
      symbols += run.textured ? static_cast<size_t>(run.nodes) : 0;
    }
    if (l == level) {
      fields.octree.resize(nodes);
      fields.voxel_image_index.resize(
          std::clamp(static_cast<size_t>(whole_textures), textures, textures + symbols));
      fields.voxel_image_index.resize(textures + symbols, 0);
      return;
    }
    const uint64_t children =
        count_children(std::span(fields.octree).subspan(nodes, static_cast<size_t>(walk.nodes())));
    nodes += static_cast<size_t>(walk.nodes());
    textures += symbols;
    walk.descend(children, textures);
  }
}

}  // namespace

OctreeFrame decode_octree_frame(std::span<const uint8_t> data, const OctreeFrameOptions& options,
                                Diagnostics& diagnostics) {
  return FrameDecoder(data, options, diagnostics).run();
}

void coarsen_octree(OctreeFields& fields, unsigned levels, unsigned level) {
  if (level < levels) cut_octree(fields, !fields.voxel_image_index.empty(), level, 0);
}

}  // namespace afx::codec
