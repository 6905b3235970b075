// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Any bytes as an MP4 file that presents a scene, as `afx decode` reads it: a scene or an error
// within the file, the same whether somebody listens or not. The scene's text reads back, and its
// streams are taken apart into OctreeImages and pictures.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "afx/decoded_scene.h"
#include "afx/scene_packing.h"
#include "bifs/mp4_reader.h"
#include "codec/fuzz_test_support.h"
#include "nodes/scene_reader.h"
#include "nodes/scene_writer.h"

namespace {

using namespace afx;

Limits small_limits() {
  Limits limits;
  limits.memory = 1 << 22;
  limits.octree_nodes = 100000;
  limits.scene_values = 1 << 16;
  limits.scene_depth = 64;
  return limits;
}

Result<DecodedScene> decode(const bifs::Mp4Source& source, const bifs::Mp4Movie& movie,
                            const codec::Trace* trace) {
  Diagnostics diagnostics;
  return decode_scene(source, movie, {"fuzz.mp4", small_limits(), true, trace}, diagnostics);
}

/// What no text can say: commands put a node where it may not stand, or deleted the PROTO of an
/// instance that stays; a ROUTE goes from one type to another.
bool is_beyond_text(const Error& error) {
  return error.text.find("may not stand here") != std::string::npos ||
         error.text.find("no node type") != std::string::npos ||
         error.text.find("cannot go to") != std::string::npos;
}

void check_text(const nodes::Scene& scene) {
  const std::string text = nodes::write_scene_text(scene);
  Diagnostics diagnostics;
  const auto again = nodes::read_scene_text(text, {}, diagnostics);
  if (!again.ok() && is_beyond_text(again.error())) return;
  if (again.ok() && nodes::write_scene_text(again.value()) == text) return;
  std::fprintf(stderr, "not the same after writing: %s\n%s\n",
               again.ok() ? "" : to_string(again.error()).c_str(), text.c_str());
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const bifs::Mp4Source source = bifs::mp4_source({data, size});
  uint64_t heard = 0;
  const codec::Trace trace = [&](const codec::TraceElement& element) {
    ++heard;
    require(!element.path.empty());
  };
  Diagnostics diagnostics;
  const auto movie = bifs::read_mp4(source, small_limits(), diagnostics, &trace);
  if (!movie.ok()) return 0;
  require(heard > 0);
  const auto traced = decode(source, movie.value(), &trace);
  auto decoded = decode(source, movie.value(), nullptr);
  require(traced.ok() == decoded.ok());
  if (!decoded.ok()) {
    const Error& error = decoded.error();
    require(!error.text.empty() && to_string(error) == to_string(traced.error()));
    require(error.place.kind != Place::Kind::bit || error.place.bit <= uint64_t{size} * 8);
    return 0;
  }
  check_text(decoded.value().scene);
  UnpackOptions options;
  options.limits = small_limits();
  const auto files =
      unpack_scene(decoded.value().scene, decoded.value().streams, options, diagnostics);
  if (!files.ok()) return 0;
  for (const NamedFile& file : files.value()) require(is_plain_picture_name(file.name));
  return 0;
}
