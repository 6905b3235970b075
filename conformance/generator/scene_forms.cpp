// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "conformance/generator/scene_forms.h"

#include <memory>

#include "bifs/bt_reader.h"
#include "bifs/bt_writer.h"
#include "bifs/mp4_presentation_reader.h"
#include "bifs/mp4_presentation_writer.h"
#include "bifs/mp4_reader.h"
#include "bifs/raw_bifs_writer.h"
#include "bifs/xmt_reader.h"
#include "bifs/xmt_writer.h"
#include "conformance/generator/told_commands.h"

namespace afx::conformance {

using bifs::EncodingChoices;
using bifs::Presentation;
using nlohmann::json;
using Bytes = std::vector<uint8_t>;

namespace {

Result<bifs::Mp4Movie> movie_of(const Bytes& bytes, bool raw) {
  Diagnostics ignored;
  if (!raw) return bifs::read_mp4(bifs::mp4_source(bytes), {}, ignored);
  const auto scene = bifs::read_raw_bifs(bytes, {});
  if (!scene.ok()) return scene.error();
  return movie_of_raw_bifs(scene.value());
}

}  // namespace

std::string told(Presentation& presentation) {
  ToldCommands told;
  Diagnostics ignored;
  (void)bifs::play(presentation, told, ignored);
  return told.text();
}

Result<Bytes> encode(Presentation& presentation, const EncodingChoices& choices) {
  Diagnostics ignored;
  if (Status set = set_up_encoding(presentation, choices, ignored); !set.ok()) return set.error();
  bifs::RawBifsWriter writer(encode_options(choices), ignored);
  if (Status played = play(presentation, writer, ignored); !played.ok()) return played.error();
  return write_raw_bifs(writer.scene());
}

Result<Bytes> encode_mp4(Presentation& presentation, const EncodingChoices& choices) {
  Diagnostics ignored;
  if (Status set = set_up_encoding(presentation, choices, ignored); !set.ok()) return set.error();
  Bytes bytes;
  const auto add = [&bytes](std::span<const uint8_t> piece) {
    bytes.insert(bytes.end(), piece.begin(), piece.end());
    return Status();
  };
  bifs::Mp4PresentationWriter writer(add, {encode_options(choices), {}});
  if (Status played = play(presentation, writer, ignored); !played.ok()) return played.error();
  return bytes;
}

Status decode(const Bytes& bytes, bool raw, bifs::PresentationSink& sink) {
  Diagnostics ignored;
  const auto movie = movie_of(bytes, raw);
  if (!movie.ok()) return movie.error();
  const auto decoded =
      bifs::decode_presentation(bifs::mp4_source(bytes), movie.value(), {}, &sink, ignored);
  return decoded.ok() ? Status{} : Status(decoded.error());
}

json decoded_document(const Bytes& bytes, bool raw) {
  Diagnostics ignored;
  const auto movie = movie_of(bytes, raw);
  if (!movie.ok()) return {};
  std::string text;
  const auto add = [&text](std::string_view piece) {
    text += piece;
    return Status();
  };
  const Status decoded =
      bifs::decode_as_json(bifs::mp4_source(bytes), movie.value(), {}, add, ignored);
  return decoded.ok() ? json::parse(text) : json();
}

Result<Bytes> encode_again(const Bytes& bytes, const EncodingChoices& choices) {
  Diagnostics ignored;
  bifs::RawBifsWriter writer(encode_options(choices), ignored);
  if (Status decoded = decode(bytes, true, writer); !decoded.ok()) return decoded.error();
  return write_raw_bifs(writer.scene());
}

Result<std::string> write_text(Presentation& presentation, bool xml) {
  std::string text;
  const auto add = [&text](std::string_view piece) {
    text += piece;
    return Status();
  };
  std::unique_ptr<bifs::PresentationSink> writer;
  if (xml)
    writer = std::make_unique<bifs::XmtWriter>(add);
  else
    writer = std::make_unique<bifs::BtWriter>(add);
  Diagnostics ignored;
  if (Status played = play(presentation, *writer, ignored); !played.ok()) return played.error();
  return text;
}

Result<Presentation> read_text(const std::string& text, bool xml) {
  Diagnostics ignored;
  return xml ? bifs::read_xmt(text, {}, ignored) : bifs::read_bt(text, {}, ignored);
}

}  // namespace afx::conformance
