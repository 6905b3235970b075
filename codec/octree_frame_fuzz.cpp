// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Any bytes as an octree frame: the fast decoder does what the plain one does, and what decodes
// whole encodes and decodes to the same. The first two bytes choose levels and textures.
#include <cstdint>
#include <span>
#include <vector>

#include "codec/fuzz_test_support.h"
#include "codec/octree_decoder.h"
#include "codec/octree_encoder.h"
#include "codec/plain/octree_plain.h"

namespace {

using afx::require;

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace afx;
  using namespace afx::codec;
  if (size < 2) return 0;
  const unsigned levels = data[0] % 32;
  const unsigned textures = data[1] % 128;
  const std::span<const uint8_t> frame_data(data + 2, size - 2);
  OctreeFrameOptions options{.levels = levels, .textures = textures};
  options.limits.octree_nodes = 200000;
  Diagnostics diagnostics;
  const OctreeFrame frame = decode_octree_frame(frame_data, options, diagnostics);
  if (!frame.status.ok()) {
    const Errc code = frame.status.error().code;
    require(code == Errc::truncated || code == Errc::limit_exceeded);
    if (frame.usable) require(check_octree_fields(frame.fields, frame.levels, textures).ok());
    if (code == Errc::limit_exceeded) return 0;
  }
  const plain::Frame expected = plain::decode_frame(frame_data, levels, textures, UINT64_MAX);
  require(frame.status.ok() == !expected.truncated && frame.bits == expected.bits);
  if (!frame.status.ok()) return 0;
  require(frame.fields == expected.fields);
  std::vector<uint8_t> out;
  require(encode_octree_frame(frame.fields, levels, textures, out).ok());
  require(out == plain::encode_frame(frame.fields, levels, textures));
  const OctreeFrame again = decode_octree_frame(out, options, diagnostics);
  require(again.status.ok() && again.fields == frame.fields);
  return 0;
}
