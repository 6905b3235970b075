// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// A plain coder for octree frames, as the text reads: a list of nodes for each level, tables of
// frequencies that are searched one by one, renormalisation bit by bit. It is the truth that the
// fast coder is tested and measured against, and part of no library. Its rules are data, so that
// they can be broken one by one (octree_rules.h).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "codec/octree.h"
#include "codec/plain/octree_plain_model.h"
#include "codec/plain/octree_rules.h"

namespace afx::codec::plain {

/// The bits of the frame. The fields must fit (check_octree_fields); `model` is as for a frame that
/// begins.
std::vector<bool> encode_frame(const OctreeFields& fields, unsigned levels, unsigned textures,
                               const Rules& rules, Model& model);

/// How far a frame is when a level begins.
struct Mark {
  size_t octree = 0;       ///< node symbols
  size_t index = 0;        ///< texture symbols
  uint64_t undefined = 0;  ///< nodes of the level that have a texture symbol
  uint64_t childless = 0;  ///< nodes above it that have no children but would have a texture symbol
};

struct Frame {
  OctreeFields fields;
  uint64_t bits = 0;       ///< used; of a whole frame its length
  bool truncated = false;  ///< then fields hold the symbols up to the one where it was noticed
  bool too_many = false;   ///< nodes
  uint64_t whole = 0;      ///< symbols decoded from 16 bits of code that were all there
  bool ends_well = false;  ///< as an encoder leaves it
  uint64_t childless = 0;  ///< nodes below the root
  bool undefined_voxel = false;
  std::vector<Mark> levels;  ///< those that were begun
};

/// Decodes a frame; stops where it is truncated or has more nodes than `most_nodes`.
Frame decode_frame(const std::vector<bool>& data, unsigned levels, unsigned textures,
                   uint64_t most_nodes, const Rules& rules, Model& model);

/// By the text, in bytes, zeros behind.
std::vector<uint8_t> encode_frame(const OctreeFields& fields, unsigned levels, unsigned textures);
Frame decode_frame(std::span<const uint8_t> data, unsigned levels, unsigned textures,
                   uint64_t most_nodes);

}  // namespace afx::codec::plain
