// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Any bytes as an OctreeImage stream: one thread and several agree, whether somebody listens or
// not; the last frame alone is the last of all; and what decodes without a warning encodes to the
// same bytes.
#include <algorithm>
#include <cstdint>
#include <vector>

#include "afx/octree_stream.h"
#include "codec/fuzz_test_support.h"

namespace {

using afx::require;

void check_last_frame(std::span<const uint8_t> bytes, afx::OctreeDecodeOptions options,
                      const afx::OctreeStream& all) {
  options.frame = static_cast<uint32_t>(all.frames.size() - 1);
  afx::Diagnostics diagnostics;
  const auto last = decode_octree_stream(bytes, options, diagnostics);
  require(last.status.ok() && last.stream.frames.size() == 1);
  require(last.stream.frames[0] == all.frames.back());
  options.frame = *options.frame + 1;
  require(decode_octree_stream(bytes, options, diagnostics).status.error().code ==
          afx::Errc::bad_argument);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace afx;
  const std::span<const uint8_t> bytes(data, size);
  OctreeDecodeOptions options;
  options.limits.octree_nodes = 200000;
  const codec::Trace trace = [&](const codec::TraceElement& element) {
    require(element.bit <= uint64_t{8} * size && !element.path.empty());
  };
  options.trace = &trace;
  Diagnostics diagnostics;
  const DecodedOctreeStream one = decode_octree_stream(bytes, options, diagnostics);
  options.trace = nullptr;
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
  require(looks_like_octree_stream(bytes));
  check_last_frame(bytes, options, one.stream);
  const auto encoded = encode_octree_stream(one.stream);
  require(encoded.ok());
  if (diagnostics.count() == 0) {
    require(std::equal(encoded.value().begin(), encoded.value().end(), data, data + size));
  }
  return 0;
}
