// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The OctreeImage stream around the plain coder's frames (sections 2, 7 and 8).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "codec/octree.h"
#include "codec/plain/octree_rules.h"

namespace afx::codec::plain {

/// A warning or an error. The names of errors are those of Errc.
struct Finding {
  std::string_view code;
  std::optional<uint64_t> bit;  ///< nothing: not at one place
};

struct Stream {
  uint32_t resolution = 0;
  uint32_t textures = 0;
  std::vector<OctreeFields> frames;
  std::vector<Finding> warnings;
  std::optional<Finding> error;  ///< then the frames are what is whole
};

/// levels: those asked for, as in section 7; 32 and more are all. Nodes beyond `most_nodes` are an
/// error.
Stream decode_stream(std::span<const uint8_t> data, unsigned levels, uint64_t most_nodes,
                     const Rules& rules = text_rules());

/// The resolution, textures and frames must fit each other.
std::vector<uint8_t> encode_stream(const Stream& stream, const Rules& rules = text_rules());

}  // namespace afx::codec::plain
