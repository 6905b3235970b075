// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <filesystem>
#include <functional>

#include "afx/builder/json_text.h"
#include "afx/media_store.h"
#include "bifs/bt_writer.h"
#include "bifs/descriptor_writer.h"
#include "bifs/encoding_setup.h"
#include "bifs/mp4_presentation_writer.h"
#include "bifs/mp4_reader.h"
#include "bifs/raw_bifs_writer.h"
#include "bifs/xmt_writer.h"
#include "conformance/sha256.h"
#include "tools/own_answers.h"
#include "tools/scene_input.h"

namespace afx::tools {
namespace {

using conformance::Answer;
using conformance::Form;
using conformance::Question;
using nlohmann::json;

std::string hex(std::span<const uint8_t> bytes) {
  std::string text;
  for (const uint8_t byte : bytes) {
    text += "0123456789abcdef"[byte >> 4];
    text += "0123456789abcdef"[byte & 15];
  }
  return text;
}

Result<json> track_json(const bifs::Mp4Source& source, const bifs::Mp4Track& track,
                        const Limits& limits) {
  json references = json::object();
  for (const bifs::Mp4Reference& reference : track.references)
    references[bifs::to_string(reference.type)] = reference.tracks;
  json out{{"id", track.id},
           {"handler", bifs::to_string(track.handler)},
           {"timescale", track.timescale},
           {"refs", std::move(references)},
           {"times", json::array()},
           {"samples", json::array()}};
  if (!track.entries.empty()) {
    out["sampleEntry"] = bifs::to_string(track.entries[0].type);
    if (const auto* config = bifs::decoder_config_of(track.entries[0])) {
      out["objectTypeIndication"] = config->object_type;
      out["streamType"] = config->stream_type;
      out["config"] = hex(bifs::decoder_specific_info(*bifs::es_of(track.entries[0])));
    }
  }
  for (size_t i = 0; i < track.samples.size(); ++i) {
    const auto bytes = bifs::read_sample(source, track, i, limits);
    if (!bytes.ok()) return bytes.error();
    out["times"].push_back(track.samples[i].time);
    out["samples"].push_back(conformance::sha256(bytes.value()));
  }
  return out;
}

Answer answer_tracks(const CodedScene& scene, const Limits& limits) {
  json tracks = json::array();
  for (const bifs::Mp4Track& track : scene.movie.tracks) {
    auto one = track_json(scene.source, track, limits);
    if (!one.ok()) return answer_of_error(one.error());
    tracks.push_back(std::move(one).value());
  }
  json values{{"iodsDescriptor", nullptr}, {"tracks", std::move(tracks)}};
  if (scene.movie.initial_object) {
    const auto bytes = bifs::write_descriptors({*scene.movie.initial_object});
    if (!bytes.ok()) return answer_of_error(bytes.error());
    values["iodsDescriptor"] = hex(bytes.value());
  }
  return {.values = std::move(values)};
}

Answer answer_commands(const CodedScene& scene, const Limits& limits, bool of_text,
                       Diagnostics& diagnostics) {
  std::string text;
  bifs::PresentationDecodeOptions how;
  how.limits = limits;
  how.drop_coding_quantizers = of_text;  // our encoder's own; otherwise the stream as it is
  const auto add = [&text](std::string_view piece) {
    text += piece;
    return Status();
  };
  const Status decoded = bifs::decode_as_json(scene.source, scene.movie, how, add, diagnostics);
  if (!decoded.ok()) return answer_of_error(decoded.error());
  auto values = parse_json({reinterpret_cast<const uint8_t*>(text.data()), text.size()}, limits);
  if (!values.ok()) return conformance::failed("the answer: " + to_string(values.error()));
  return {.values = std::move(values).value()};
}

/// The input again, from its MP4 file.
Answer rewritten_mp4(const CodedScene& scene, const Input& input, const Limits& limits,
                     Diagnostics& diagnostics) {
  Answer answer;
  const auto add = [&answer](std::span<const uint8_t> piece) {
    answer.bytes.insert(answer.bytes.end(), piece.begin(), piece.end());
    return Status();
  };
  const MediaStore store;
  bifs::PresentationDecodeOptions how;
  how.file_name = std::filesystem::path(input.path).filename().string();
  how.limits = limits;
  bifs::Mp4PresentationWriter writer(add, {{}, store.loader(input.folder(), limits, diagnostics)});
  const auto decoded =
      bifs::decode_presentation(scene.source, scene.movie, how, &writer, diagnostics);
  return decoded.ok() ? answer : answer_of_error(decoded.error());
}

Answer rewritten_bifs(const CodedScene& scene, const Limits& limits, Diagnostics& diagnostics) {
  bifs::PresentationDecodeOptions how;
  how.limits = limits;
  bifs::RawBifsWriter writer({}, diagnostics);
  const auto decoded =
      bifs::decode_presentation(scene.source, scene.movie, how, &writer, diagnostics);
  if (!decoded.ok()) return answer_of_error(decoded.error());
  auto bytes = bifs::write_raw_bifs(writer.scene());
  if (!bytes.ok()) return answer_of_error(bytes.error());
  return {.bytes = std::move(bytes).value()};
}

Answer rewritten_text(bifs::Presentation& presentation, bool xml, Diagnostics& diagnostics) {
  Answer answer;
  const auto add = [&answer](std::string_view piece) {
    answer.bytes.insert(answer.bytes.end(), piece.begin(), piece.end());
    return Status();
  };
  std::unique_ptr<bifs::PresentationSink> writer;
  if (xml)
    writer = std::make_unique<bifs::XmtWriter>(add);
  else
    writer = std::make_unique<bifs::BtWriter>(add);
  const Status played = bifs::play(presentation, *writer, diagnostics);
  return played.ok() ? answer : answer_of_error(played.error());
}

/// The scene stream that is encoded of a text, decoded again.
Answer commands_of_text(bifs::Presentation& presentation, const Limits& limits,
                        Diagnostics& diagnostics) {
  const bifs::EncodingChoices choices{.names = bifs::EncodingChoices::Names::never};
  if (Status set = bifs::set_up_encoding(presentation, choices, diagnostics); !set.ok())
    return answer_of_error(set.error());
  bifs::RawBifsWriter writer(bifs::encode_options(choices), diagnostics);
  if (Status played = bifs::play(presentation, writer, diagnostics); !played.ok())
    return answer_of_error(played.error());
  const auto bytes = bifs::write_raw_bifs(writer.scene());
  if (!bytes.ok()) return answer_of_error(bytes.error());
  const auto raw = bifs::read_raw_bifs(bytes.value(), limits);
  if (!raw.ok()) return conformance::failed("encoded: " + to_string(raw.error()));
  const CodedScene coded{bifs::movie_of_raw_bifs(raw.value()), bifs::mp4_source(bytes.value())};
  return answer_commands(coded, limits, true, diagnostics);
}

Answer answer_text(const Question& question, const Input& input, const Limits& limits,
                   Diagnostics& diagnostics) {
  auto presentation = read_presentation(input, limits, diagnostics);
  if (!presentation.ok()) return answer_of_error(presentation.error());
  if (question.form == Form::stream)
    return rewritten_text(presentation.value(), input.kind == Kind::scene_xml, diagnostics);
  if (question.form == Form::commands)
    return commands_of_text(presentation.value(), limits, diagnostics);
  return conformance::not_run("scene texts are answered as commands, stream and image alone");
}

}  // namespace

Answer answer_scene(const Question& question, const Input& input, const Limits& limits,
                    Diagnostics& diagnostics) {
  if (is_text_scene(input.kind)) return answer_text(question, input, limits, diagnostics);
  const auto scene = open_coded_scene(input, limits, diagnostics);
  if (!scene.ok()) return answer_of_error(scene.error());
  if (question.form == Form::commands)
    return answer_commands(scene.value(), limits, false, diagnostics);
  if (question.form == Form::tracks) return answer_tracks(scene.value(), limits);
  if (question.form != Form::stream)
    return conformance::not_run("scenes are answered as commands, tracks, stream and image alone");
  return input.kind == Kind::mp4 ? rewritten_mp4(scene.value(), input, limits, diagnostics)
                                 : rewritten_bifs(scene.value(), limits, diagnostics);
}

}  // namespace afx::tools
