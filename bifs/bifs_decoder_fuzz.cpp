// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Any stream decodes or gives an error with a place; what was decoded can be printed; where it can
// be encoded again, that decodes. Input: object type indication, length of the configuration, the
// configuration, then access units with 16 bits of length each.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>

#include "bifs/decoded_json.h"
#include "bifs/decoder.h"
#include "bifs/encoder.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace afx;
  std::span<const uint8_t> rest(data, size);
  if (rest.size() < 2 || rest[1] + size_t{2} > rest.size()) return 0;
  Diagnostics diagnostics;
  const auto config = bifs::read_config(rest.subspan(2, rest[1]), rest[0], diagnostics);
  rest = rest.subspan(rest[1] + size_t{2});
  if (!config.ok()) return 0;
  Limits limits;
  limits.memory = 1 << 20;
  limits.scene_values = 1 << 14;
  limits.scene_depth = 64;
  bifs::BifsDecoder decoder(config.value(), limits);
  bifs::BifsDecoder second(config.value());
  bifs::EncodeOptions options;
  options.predictive = true;
  bifs::BifsEncoder encoder(config.value(), options);
  bifs::CommandJsonWriter writer;
  bool encodable = true;
  while (rest.size() >= 2) {
    const size_t length = std::min<size_t>(rest[0] * 256U + rest[1], rest.size() - 2);
    const auto sink = [&](const bifs::Command& command, const nodes::Scene& scene) {
      (void)writer.write(command, scene);
      encodable = encodable && encoder.add(command, scene).ok();
    };
    const auto frame = decoder.decode(rest.subspan(2, length), diagnostics, sink);
    rest = rest.subspan(2 + length);
    if (!frame.ok() && frame.error().place.bit > uint64_t{8} * length) std::abort();
    const auto bytes = encoder.finish();
    encodable = encodable && frame.ok() && bytes.ok();
    if (!encodable) continue;
    const auto again = second.decode(bytes.value(), diagnostics);
    if (again.ok()) continue;
    // A field given again drops the node it had, which keeps its ID: only what stands is encoded.
    encodable = again.error().text.find("no node has the ID") == std::string::npos;
    if (!encodable) continue;
    std::fprintf(stderr, "encoded, and not decoded again: %s\n", to_string(again.error()).c_str());
    std::abort();
  }
  return 0;
}
