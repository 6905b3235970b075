// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <charconv>
#include <nlohmann/json.hpp>
#include <utility>

#include "afx/file.h"
#include "afx/scene_packing.h"
#include "bifs/encoding_setup.h"
#include "bifs/mp4_presentation_writer.h"
#include "bifs/quantize_scene.h"
#include "bifs/raw_bifs_writer.h"
#include "tools/encode.h"
#include "tools/scene_input.h"

namespace afx::tools {
namespace {

using Json = nlohmann::ordered_json;

/// A text that says nothing of streams and times: we choose the streams.
bool is_plain_scene(const bifs::Presentation& presentation) {
  if (!presentation.initial.parts.empty() || presentation.units.size() != 1) return false;
  const auto* commands =
      std::get_if<std::vector<bifs::Command>>(&presentation.units.front().commands);
  return commands != nullptr && commands->size() == 1 &&
         std::holds_alternative<bifs::SceneReplacement>(commands->front());
}

Status pack(const EncodeOptions& options, const std::string& format, const Input& input,
            const Session& session, bifs::Presentation& presentation, MediaStore& store,
            Diagnostics& diagnostics) {
  const bool streams = is_plain_scene(presentation) && options.choices == "own" && format == "mp4";
  const auto chosen = [&](const std::string& option) {
    return !option.empty() ? option : std::string(streams ? "stream" : "none");
  };
  const std::string octrees = chosen(options.afx);
  PackOptions how;
  how.octrees = octrees == "stream"   ? PackOptions::Octrees::stream
                : octrees == "buffer" ? PackOptions::Octrees::buffer
                                      : PackOptions::Octrees::none;
  how.pictures = chosen(options.pictures) == "stream";
  how.threads = session.options.threads;
  how.limits = session.limits;
  if (how.octrees == PackOptions::Octrees::none && !how.pictures) return {};
  return pack_scene(presentation, input.folder(), how, store, diagnostics);
}

/// "color=8" of --bits.
Status choose_bits(const std::string& text, bifs::CategoryChoices& choices) {
  const size_t mark = text.find('=');
  const std::string name = text.substr(0, mark);
  unsigned bits = 0;
  const char* const begin = mark == std::string::npos ? nullptr : text.data() + mark + 1;
  const char* const end = text.data() + text.size();
  const bool number =
      begin != nullptr && std::from_chars(begin, end, bits).ptr == end && begin != end;
  const auto known = choices.find(name);
  if (!number || bits > 31 || known == choices.end()) {
    std::string names;
    for (const auto& choice : bifs::default_choices())
      names += (names.empty() ? "" : ", ") + choice.first;
    return Error{
        Errc::bad_argument, Place::none(),
        "--bits " + text + " (expected CATEGORY=0..31, the category one of " + names + ")"};
  }
  known->second.on = bits > 0;
  if (bits > 0) known->second.bits = bits;
  return {};
}

Json json_of(const bifs::QuantizeReport& report) {
  Json fields = Json::array();
  for (const bifs::QuantizedField& field : report.fields)
    fields.push_back({{"category", field.category},
                      {"node", field.node},
                      {"field", field.field},
                      {"values", field.values},
                      {"bits", field.bits},
                      {"bound", field.bound},
                      {"largestError", field.largest_error}});
  Json left_out = Json::array();
  for (const bifs::UnquantizedCategory& category : report.left_out)
    left_out.push_back({{"category", category.category}, {"reason", category.reason}});
  return {{"fields", fields}, {"notQuantized", left_out}};
}

std::string short_number(double number) {
  char text[32];
  const auto [end, failure] =
      std::to_chars(text, text + sizeof text, number, std::chars_format::general, 3);
  return failure == std::errc{} ? std::string(text, end) : "?";
}

std::vector<std::string> lines_of(const bifs::QuantizeReport& report) {
  std::vector<std::string> lines;
  for (const bifs::QuantizedField& field : report.fields)
    lines.push_back("  " + field.node + "." + field.field + ": " + counted(field.values, "value") +
                    ", " + std::to_string(field.bits) + " bits, largest error " +
                    short_number(field.largest_error) + " (at most " + short_number(field.bound) +
                    ")");
  for (const bifs::UnquantizedCategory& category : report.left_out)
    lines.push_back("  " + category.category + ": not quantized: " + category.reason);
  if (!report.commands_left_out.empty())
    lines.push_back("  commands are not quantized: " + report.commands_left_out);
  return lines;
}

Result<bifs::QuantizeReport> quantize(const EncodeOptions& options,
                                      bifs::Presentation& presentation) {
  bifs::QuantizeOptions how;
  for (const std::string& text : options.quantize_bits)
    if (Status chosen = choose_bits(text, how.categories); !chosen.ok()) return chosen.error();
  return bifs::quantize_scene(presentation, how);
}

/// Passes bytes on and counts them.
struct Counter {
  OutputFiles::Sink sink;
  uint64_t bytes = 0;
  Status operator()(std::span<const uint8_t> piece) {
    bytes += piece.size();
    return sink(piece);
  }
};

Status write_presentation(const std::string& format, bifs::Presentation& presentation,
                          const bifs::EncodeOptions& encoding, const bifs::LoadMedia& media,
                          const bifs::Mp4Sink& sink, Diagnostics& diagnostics) {
  if (format == "mp4") {
    bifs::Mp4PresentationWriter writer(sink, {encoding, media});
    return bifs::play(presentation, writer, diagnostics);
  }
  bifs::RawBifsWriter writer(encoding, diagnostics);
  if (Status played = bifs::play(presentation, writer, diagnostics); !played.ok()) return played;
  const auto bytes = bifs::write_raw_bifs(writer.scene());
  return bytes.ok() ? sink(bytes.value()) : Status(bytes.error());
}

}  // namespace

int encode_presentation(const EncodeOptions& options, const std::string& format,
                        OutputFiles& outputs, const Session& session) {
  Diagnostics diagnostics;
  const std::string& path = options.inputs.front();
  const auto input = open_input(path, options.input_format, session.limits, diagnostics);
  if (!input.ok()) return session.fail(input.error(), path, diagnostics);
  if (!is_text_scene(input.value().kind)) {
    return session.fail({Errc::unsupported, Place::none(),
                         std::string("is ") + describe(input.value().kind) +
                             " (expected scene text: .wrl, .bt or .xmt)"},
                        path, diagnostics);
  }
  auto read =
      read_presentation(input.value(), session.limits, diagnostics, options.choices == "gpac");
  if (!read.ok()) return session.fail(read.error(), path, diagnostics);
  bifs::Presentation& presentation = read.value();

  MediaStore store;
  Status done = pack(options, format, input.value(), session, presentation, store, diagnostics);
  if (!done.ok()) return session.fail(done.error(), path, diagnostics);
  bifs::QuantizeReport report;
  if (options.quantize || !options.quantize_bits.empty()) {
    auto quantized = quantize(options, presentation);
    if (!quantized.ok())
      return session.fail_query(quantized.error(), quantized.error().text.starts_with("--bits"),
                                path);
    report = std::move(quantized).value();
  }
  using Names = bifs::EncodingChoices::Names;
  const bifs::EncodingChoices choices{.like_gpac = options.choices == "gpac",
                                      .names = options.names == "auto"     ? Names::automatic
                                               : options.names == "always" ? Names::always
                                                                           : Names::never,
                                      .predictive = options.predictive};
  done = bifs::set_up_encoding(presentation, choices, diagnostics);
  if (!done.ok()) return session.fail(done.error(), path, diagnostics);

  Counter counter{[](std::span<const uint8_t>) { return Status(); }, 0};
  if (!session.options.dry_run) {
    auto begun = outputs.begin(options.output);
    if (!begun.ok()) return session.fail(begun.error(), options.output, diagnostics);
    counter.sink = std::move(begun).value();
  }
  const bifs::LoadMedia media = store.loader(input.value().folder(), session.limits, diagnostics);
  done = write_presentation(format, presentation, bifs::encode_options(choices), media,
                            std::ref(counter), diagnostics);
  if (!done.ok()) return session.fail(done.error(), path, diagnostics);
  if (const int code = session.warn(diagnostics, path); code != kDone) return code;
  std::vector<std::string> lines = {options.output + ": " + counted(counter.bytes, "byte") + ", " +
                                    counted(presentation.units.size(), "access unit")};
  for (std::string& line : lines_of(report)) lines.push_back(std::move(line));
  Json result{{"output", options.output},
              {"bytes", counter.bytes},
              {"accessUnits", presentation.units.size()}};
  if (!report.fields.empty() || !report.left_out.empty()) result["quantized"] = json_of(report);
  return session.finish(outputs, options.output, lines, std::move(result));
}

}  // namespace afx::tools
