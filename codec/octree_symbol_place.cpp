// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "codec/octree_symbol_place.h"

#include <bit>

#include "codec/arithmetic_decoder.h"
#include "codec/octree_contexts.h"
#include "codec/octree_walk.h"

namespace afx::codec {
namespace {

/// Decodes a frame again, symbol by symbol, up to the one that is looked for.
class SymbolSearch {
 public:
  SymbolSearch(std::span<const uint8_t> data, unsigned textures, OctreeSymbol wanted)
      : decoder_(data), contexts_(textures), wanted_(wanted) {}

  /// Whether it is the next symbol; otherwise that is decoded.
  bool at_node(NodeContext context) {
    if (!wanted_.texture && wanted_.index == nodes_) return true;
    contexts_.enter_stage(nodes_++);
    const uint32_t mapped = decoder_.decode(contexts_.node_table(context));
    const uint8_t symbol = kSymbolMaps.inverse[contexts_.symmetry(context)][mapped];
    children_ += static_cast<unsigned>(std::popcount(symbol));
    return (context & kTextured) != 0 && at_texture();
  }
  bool at_texture() {
    if (wanted_.texture && wanted_.index == textures_) return true;
    ++textures_;
    decoder_.decode(contexts_.texture_table());
    return false;
  }

  [[nodiscard]] uint64_t bit() const { return decoder_.shifts(); }
  void descend(OctreeWalk& walk) {
    walk.descend(children_, textures_);
    children_ = 0;
  }

 private:
  ArithmeticDecoder decoder_;
  OctreeContexts contexts_;
  OctreeSymbol wanted_;
  uint64_t nodes_ = 0;
  size_t textures_ = 0;
  uint64_t children_ = 0;  // of the nodes of this level
};

bool find_in_level(OctreeWalk& walk, SymbolSearch& search) {
  while (walk.remaining() > 0) {
    const OctreeWalk::Batch batch = walk.next_contexts();
    for (size_t i = 0; i < batch.count; ++i)
      if (search.at_node(batch.contexts[i])) return true;
  }
  return false;
}

bool find_in_voxels(OctreeWalk& walk, SymbolSearch& search) {
  while (walk.remaining() > 0) {
    const OctreeWalk::Run run = walk.next_run();
    for (uint64_t n = 0; run.textured && n < run.nodes; ++n)
      if (search.at_texture()) return true;
  }
  return false;
}

}  // namespace

std::optional<uint64_t> octree_symbol_bit(std::span<const uint8_t> data, const OctreeFields& fields,
                                          unsigned levels, unsigned textures, OctreeSymbol symbol) {
  const size_t symbols = symbol.texture ? fields.voxel_image_index.size() : fields.octree.size();
  if (symbol.index >= symbols) return {};
  SymbolSearch search(data, textures, symbol);
  OctreeWalk walk(fields, textures > 0);
  while (walk.level() < levels) {
    if (find_in_level(walk, search)) return search.bit();
    search.descend(walk);
  }
  if (find_in_voxels(walk, search)) return search.bit();
  return {};
}

}  // namespace afx::codec
