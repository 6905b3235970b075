// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Any text is read or gives an error with a place; what was read can be written, is read again, and
// is then written the same.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "bifs/xmt_reader.h"
#include "bifs/xmt_writer.h"

namespace {

using namespace afx;

std::string write(bifs::Presentation& presentation) {
  std::string text;
  Diagnostics warnings;
  bifs::XmtWriter writer([&](std::string_view piece) {
    text += piece;
    return Status{};
  });
  const Status told = play(presentation, writer, warnings);
  if (told.ok()) return text;
  std::fprintf(stderr, "read, and not written: %s\n", to_string(told.error()).c_str());
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  Limits limits;
  limits.memory = 1 << 21;
  limits.scene_values = 1 << 14;
  limits.scene_depth = 64;
  Diagnostics warnings;
  auto first = bifs::read_xmt({reinterpret_cast<const char*>(data), size}, limits, warnings);
  if (!first.ok()) {
    if (first.error().place.kind != Place::Kind::text) std::abort();
    return 0;
  }
  const std::string text = write(first.value());
  auto second = bifs::read_xmt(text, {}, warnings);
  if (!second.ok()) {
    std::fprintf(stderr, "written, and not read: %s\n%s\n", to_string(second.error()).c_str(),
                 text.c_str());
    std::abort();
  }
  const std::string again = write(second.value());
  if (again == text) return 0;
  std::fprintf(stderr, "not written the same:\n%s\n%s\n", text.c_str(), again.c_str());
  std::abort();
}
