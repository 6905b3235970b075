// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <functional>

#include "afx/octree_stream.h"
#include "conformance/generator/generator.h"

namespace afx::conformance {

/// The coder of OctreeImage streams that is checked.
struct OctreeCoder {
  std::function<Result<std::vector<uint8_t>>(const OctreeStream& stream, unsigned threads)> encode;
  std::function<DecodedOctreeStream(std::span<const uint8_t> data,
                                    const OctreeDecodeOptions& options, Diagnostics& diagnostics)>
      decode;
};
/// This project's.
const OctreeCoder& own_octree_coder();

/// That a random stream (random_octree.h) holds: on 1 and 3 threads it encodes to the bytes of the
/// plain coder and decodes to itself; it encodes again to the same bytes; every number of levels
/// decodes to what coarsen_octree makes of the whole; cut at a random byte it is refused as
/// truncated, with the frames before, and of the cut one no more than is right.
Property octree_property(const OctreeCoder& coder = own_octree_coder());

}  // namespace afx::conformance
