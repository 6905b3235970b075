// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The OctreeImage stream: AFX object code 6.
// Source: ISO/IEC 14496-16, OctreeImage bitstream (clause not checked); the paper, section V. Exact
// among all programs that number the symmetries by the same rule, see codec/octree_symmetry.h.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "codec/bit_reader.h"
#include "codec/diagnostics.h"
#include "codec/error.h"
#include "codec/limits.h"
#include "codec/octree.h"
#include "codec/octree_decoder.h"

namespace afx {

/// The greatest numOfTextures that the stream can hold; a node in memory can have 255 images.
inline constexpr uint32_t kMaxStreamTextures = 127;

/// What an OctreeImage stream carries. Frames are independent of each other.
struct OctreeStream {
  uint32_t resolution = 1;           ///< octreeResolution, 1 .. 2^31 - 1
  uint32_t textures = 0;             ///< numOfTextures, 0..127; 0: no frame has indices
  std::vector<OctreeFields> frames;  ///< at least one
};

/// Encodes a stream; frames are coded on up to `threads` threads (0 = all cores), which changes no
/// byte. Errors  bad_argument: resolution 0 or beyond 31 bits, more than 127 textures (text says
/// so), no frame,
///         fields of a frame that do not fit (the text names frame, field, position and expected
///         count)
Result<std::vector<uint8_t>> encode_octree_stream(const OctreeStream& stream, unsigned threads = 1);

struct OctreeDecodeOptions {
  unsigned levels = 32;                ///< give coarser models of at most so many levels
  std::optional<uint32_t> frame = {};  ///< decode only this frame (from 0) and read no further
  unsigned threads = 1;                ///< 0 = all cores; changes nothing that comes out
  Limits limits = {};
  const codec::Trace* trace = nullptr;  ///< hears every header element
};

/// Where a frame stands in its stream and what it cost.
struct OctreeFrameInfo {
  uint32_t number = 0;        ///< from 0
  uint64_t byte = 0;          ///< of its first bit, after the start code
  uint64_t bits = 0;          ///< used; where `whole`, its exact length
  bool whole = false;         ///< decoded to its end
  uint32_t resolution = 0;    ///< of the fields given: octreeResolution, or 2^k of a coarser model
  uint64_t node_symbols = 0;  ///< decoded
  uint64_t texture_symbols = 0;  ///< decoded
  std::vector<codec::OctreeLevelStats> stats;
};

/// A decoded stream, or as much of it as is whole.
struct DecodedOctreeStream {
  Status status;            ///< ok, or why it ends early; what is whole before that is given
  bool has_header = false;  ///< stream.resolution and stream.textures were read
  OctreeStream stream;      ///< as coded, but frames may be coarser: see their infos
  std::vector<OctreeFrameInfo> infos;  ///< one for each of stream.frames
};

/// Decodes a stream.
///
/// Of a truncated frame its deepest complete level is given as the last frame, if it has one (then
/// infos.back().whole is false).
/// Errors    truncated: the data end inside header or frame; malformed: octreeResolution 0, no
/// start
///           code; limit_exceeded; bad_argument: options.frame is not there. Places count from the
///           start of `data`
/// Warnings  non_minimal_width, align_bits, trailing_bytes, octree_childless_node,
/// octree_bad_ending
DecodedOctreeStream decode_octree_stream(std::span<const uint8_t> data,
                                         const OctreeDecodeOptions& options,
                                         Diagnostics& diagnostics);

/// Whether the data can be an OctreeImage stream: a legal header and the first start code.
bool looks_like_octree_stream(std::span<const uint8_t> data);

}  // namespace afx
