// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Any bytes as an OctreeImage stream: one thread and several agree, and what decodes without a
// warning encodes to the same bytes.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "afx/octree_stream.h"

namespace {

void require(bool claim) {
  if (!claim) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace afx;
  const std::span<const uint8_t> bytes(data, size);
  OctreeDecodeOptions options;
  options.limits.octree_nodes = 200000;
  Diagnostics diagnostics;
  const DecodedOctreeStream one = decode_octree_stream(bytes, options, diagnostics);
  options.threads = 3;
  Diagnostics diagnostics_many;
  const DecodedOctreeStream many = decode_octree_stream(bytes, options, diagnostics_many);
  require(one.status.ok() == many.status.ok());
  require(one.stream.frames == many.stream.frames);
  require(diagnostics.count() == diagnostics_many.count());
  if (!one.status.ok()) {
    require(to_string(one.status.error()) == to_string(many.status.error()));
    return 0;
  }
  const auto encoded = encode_octree_stream(one.stream);
  require(encoded.ok());
  if (diagnostics.count() == 0) {
    require(std::equal(encoded.value().begin(), encoded.value().end(), data, data + size));
  }
  return 0;
}
