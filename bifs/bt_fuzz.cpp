// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Any text is a presentation or an error. What is read is written as text that reads back and is
// written the same again; where it can be encoded, the stream decodes.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>

#include "bifs/bt_reader.h"
#include "bifs/bt_writer.h"
#include "bifs/encoding_setup.h"
#include "bifs/mp4_presentation_reader.h"
#include "bifs/raw_bifs_writer.h"

namespace {

using namespace afx;

[[noreturn]] void complain(const char* what, const Status& status, const std::string& text) {
  std::fprintf(stderr, "%s: %s\n%s\n", what, status.ok() ? "" : to_string(status.error()).c_str(),
               text.c_str());
  std::abort();
}

/// The presentation as text; none if it cannot be played.
std::optional<std::string> text_of(bifs::Presentation& presentation) {
  std::string text;
  bifs::BtWriter writer([&text](std::string_view piece) -> Status {
    text += piece;
    return {};
  });
  Diagnostics diagnostics;
  if (!bifs::play(presentation, writer, diagnostics).ok()) return std::nullopt;
  return text;
}

void check_text(std::string_view text, const Limits& limits) {
  Diagnostics diagnostics;
  auto read = bifs::read_bt(text, limits, diagnostics);
  if (!read.ok()) return;
  const auto written = text_of(read.value());
  if (!written) return;
  auto again = bifs::read_bt(*written, {}, diagnostics);
  if (!again.ok()) complain("written, and not read again", again.error(), *written);
  const auto second = text_of(again.value());
  if (second != written) complain("not the same after writing", {}, *written + second.value_or(""));
}

void check_stream(std::string_view text, const Limits& limits) {
  Diagnostics diagnostics;
  auto read = bifs::read_bt(text, limits, diagnostics);
  if (!read.ok()) return;
  const bifs::EncodingChoices choices;
  if (!bifs::set_up_encoding(read.value(), choices, diagnostics).ok()) return;
  bifs::RawBifsWriter writer(bifs::encode_options(choices), diagnostics);
  if (!bifs::play(read.value(), writer, diagnostics).ok()) return;
  const auto bytes = bifs::write_raw_bifs(writer.scene());
  if (!bytes.ok()) return;
  const auto scene =
      bifs::decode_presentation(bifs::mp4_source(bytes.value()),
                                bifs::movie_of_raw_bifs(writer.scene()), {}, nullptr, diagnostics);
  if (!scene.ok()) complain("encoded, and not decoded", scene.error(), std::string(text));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  Limits limits;
  limits.memory = 16 << 20;
  limits.scene_depth = 64;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  check_text(text, limits);
  check_stream(text, limits);
  return 0;
}
