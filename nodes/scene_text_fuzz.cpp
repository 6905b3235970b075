// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Any text is a scene or an error; a scene that is written reads back equal, and is written the
// same again.
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "nodes/scene_reader.h"
#include "nodes/scene_writer.h"
#include "nodes/traversal.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace afx;
  Limits limits;
  limits.memory = 64 << 20;
  limits.scene_depth = 64;
  Diagnostics diagnostics;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto scene = nodes::read_scene_text(text, limits, diagnostics);
  if (!scene.ok()) return 0;
  const std::string written = nodes::write_scene_text(scene.value());
  limits = {};
  const auto again = nodes::read_scene_text(written, limits, diagnostics);
  const bool same = again.ok() && nodes::equal(scene.value(), again.value()) &&
                    nodes::write_scene_text(again.value()) == written;
  if (!same) {
    std::fprintf(stderr, "not the same after writing:\n%s\n", written.c_str());
    if (!again.ok()) std::fprintf(stderr, "%s\n", to_string(again.error()).c_str());
    std::abort();
  }
  nodes::TraversalOptions options;
  options.max_visits = 1000;
  (void)nodes::find_dibr_objects(scene.value(), options);
  return 0;
}
