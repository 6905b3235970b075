// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "conformance/generator/scene_property.h"

#include <utility>

#include "bifs/quantize_scene.h"
#include "conformance/generator/quantized_difference.h"
#include "conformance/generator/random_scene.h"
#include "conformance/generator/scene_forms.h"
#include "conformance/generator/told_commands.h"
#include "conformance/json_difference.h"

namespace afx::conformance {

namespace {

using bifs::EncodingChoices;
using bifs::Presentation;
using nlohmann::json;
using Bytes = std::vector<uint8_t>;
using Names = EncodingChoices::Names;

/// A way to encode.
struct Way {
  const char* text;
  SceneNames names;
  EncodingChoices choices;
};
const Way kWays[] = {
    {"names always", SceneNames::own, {.names = Names::always}},
    {"names automatic", SceneNames::own, {}},
    {"names never", SceneNames::made, {.names = Names::never}},
    {"made names automatic", SceneNames::made, {}},
    {"made names always", SceneNames::made, {.names = Names::always}},
    {"predictive", SceneNames::own, {.predictive = true}},
    {"like GPAC", SceneNames::made, {.like_gpac = true}},
    {"like GPAC with names", SceneNames::own, {.like_gpac = true, .names = Names::always}},
};

/// Checks one case, given by its draws: each form needs a presentation of its own, for encoding
/// carries its commands out.
class SceneCheck {
 public:
  SceneCheck(const std::vector<uint32_t>& draws, const SceneFault& fault)
      : draws_(draws), fault_(fault) {}

  std::optional<Failure> run() {
    for (const Way& way : kWays)
      if (auto failure = check_raw(way)) return failure;
    if (auto failure = check_mp4()) return failure;
    for (const SceneNames names : {SceneNames::made, SceneNames::own}) {
      if (auto failure = check_text(names, false)) return failure;
      if (auto failure = check_text(names, true)) return failure;
    }
    for (const bool predictive : {false, true})
      if (auto failure = check_quantized(predictive)) return failure;
    return std::nullopt;
  }

 private:
  [[nodiscard]] Presentation make(SceneNames names) const {
    Choices again(draws_);
    return random_scene(again, names);
  }

  /// There is no stream that could be kept: the text stands for it.
  [[nodiscard]] Failure broken(const std::string& what, const Error& error) const {
    Presentation presentation = make(SceneNames::own);
    const auto written = write_text(presentation, false);
    const std::string text = written.ok() ? written.value() : std::string();
    const json check = {{"check", "reencode"}, {"equal", "commands"}};
    return {what + ": " + to_string(error), {"bt", {text.begin(), text.end()}, {{check, {}}}}};
  }

  /// What the stream is to tell: the presentation after set_up_encoding. Where the names are not
  /// coded, they are those that decoders make.
  [[nodiscard]] Result<std::string> told_for(const Way& way) const {
    Presentation presentation = make(way.names);
    Diagnostics ignored;
    if (Status set = set_up_encoding(presentation, way.choices, ignored); !set.ok())
      return set.error();
    if (way.names == SceneNames::own && !codes_names(presentation))
      return told_for({way.text, SceneNames::made, way.choices});
    return told(presentation);
  }

  static bool codes_names(const Presentation& presentation) {
    for (const bifs::AccessUnit& unit : presentation.units)
      for (const bifs::Command& command : std::get<std::vector<bifs::Command>>(unit.commands))
        if (const auto* scene = std::get_if<bifs::SceneReplacement>(&command); scene != nullptr)
          return scene->use_names;
    return false;
  }

  /// In a few words where two documents differ; empty if they do not.
  static std::string difference(const std::string& expected, const std::string& found,
                                const Forgiven& forgiven) {
    if (expected == found) return {};
    const auto differing = first_difference(without(json::parse(expected), forgiven),
                                            without(json::parse(found), forgiven), {});
    if (!differing) return {};
    return "at " + differing->path + " " + differing->found + " (expected " + differing->expected +
           ")";
  }

  /// Whether the PROTO IDs that GPAC gives can be told apart: no PROTO stands in another.
  static bool can_be_like_gpac(const Presentation& presentation) {
    for (size_t i = 0; i < presentation.scene.proto_count(); ++i)
      if (presentation.scene.proto(nodes::ProtoId{i}).scope != nodes::Scene::kMain) return false;
    return true;
  }

  [[nodiscard]] std::optional<Failure> check_raw(const Way& way) const {
    Presentation presentation = make(way.names);
    if (way.choices.like_gpac && !can_be_like_gpac(presentation)) return std::nullopt;
    const std::string what = std::string("raw scene, ") + way.text;
    const auto bytes = encode(presentation, way.choices);
    if (!bytes.ok()) return broken(what + ": encode", bytes.error());
    const auto expected = told_for(way);
    if (!expected.ok()) return broken(what, expected.error());
    ToldCommands decoded;
    if (Status done = decode(bytes.value(), true, decoded); !done.ok())
      return decode_failure(what + ": decode: " + to_string(done.error()), "bifs", bytes.value(),
                            expected.value());
    const std::string wrong =
        difference(expected.value(), damaged(decoded.text()), {.images = way.choices.like_gpac});
    if (!wrong.empty())
      return decode_failure(what + ": decode: " + wrong, "bifs", bytes.value(), expected.value());
    const auto again = encode_again(bytes.value(), way.choices);
    if (!again.ok()) return broken(what + ": encode again", again.error());
    if (again.value() != bytes.value())
      return Failure{what + ": encode again: other bytes",
                     {"bifs", bytes.value(), {{{{"check", "reencode"}}, {}}}}};
    return std::nullopt;
  }

  [[nodiscard]] std::optional<Failure> check_mp4() const {
    const Way& way = kWays[1];
    Presentation presentation = make(way.names);
    const auto bytes = encode_mp4(presentation, way.choices);
    if (!bytes.ok()) return broken("MP4: encode", bytes.error());
    const auto expected = told_for(way);
    if (!expected.ok()) return broken("MP4", expected.error());
    ToldCommands decoded;
    const Status done = decode(bytes.value(), false, decoded);
    const std::string wrong = done.ok() ? difference(expected.value(), damaged(decoded.text()), {})
                                        : to_string(done.error());
    if (wrong.empty()) return std::nullopt;
    return decode_failure("MP4: decode: " + wrong, "mp4", bytes.value(), expected.value());
  }

  /// The answer of the form `commands` for a text without names: that of the stream encoded of it.
  [[nodiscard]] json document_of_text() const {
    const EncodingChoices choices{.names = Names::never};
    Presentation presentation = make(SceneNames::made);
    const auto bytes = encode(presentation, choices);
    return bytes.ok() ? decoded_document(bytes.value(), true) : json();
  }

  [[nodiscard]] std::optional<Failure> check_text(SceneNames names, bool xml) const {
    const std::string what = std::string(xml ? "XMT" : "BT") +
                             (names == SceneNames::made ? " without names" : " with names");
    Presentation presentation = make(names);
    const auto text = write_text(presentation, xml);
    if (!text.ok()) return broken(what + ": write", text.error());
    const std::string kind = xml ? "xmt" : "bt";
    const auto failure = [&](const std::string& wrong) -> Failure {
      const Bytes bytes(text.value().begin(), text.value().end());
      Failure found{what + ": " + wrong, {kind, bytes, {{{{"check", "reencode"}}, {}}}}};
      const json document = document_of_text();
      if (names == SceneNames::made && !document.is_null())
        found.kept.checks.push_back({{{"check", "decode"}, {"as", "commands"}}, document});
      return found;
    };
    auto read = read_text(text.value(), xml);
    if (!read.ok()) return failure("read: " + to_string(read.error()));
    auto second = read_text(text.value(), xml);
    const std::string found = damaged(told(read.value()));
    // BT has no IDs: those of nodes with a name come out as they may. That it says the same is
    // checked by its text then.
    if (xml || names == SceneNames::made) {
      Presentation original = make(names);
      const std::string wrong =
          difference(told(original), found, {.names = true, .positions = !xml});
      if (!wrong.empty()) return failure("read: " + wrong);
    }
    const auto again = write_text(second.value(), xml);
    if (!again.ok()) return failure("write again: " + to_string(again.error()));
    if (again.value() != text.value()) return failure("write again: another text");
    return std::nullopt;
  }

  [[nodiscard]] std::optional<Failure> check_quantized(bool predictive) const {
    const std::string what = predictive ? "quantized, predictive" : "quantized";
    const EncodingChoices choices{.predictive = predictive};
    Presentation presentation = make(SceneNames::own);
    const auto report = quantize_scene(presentation);
    if (!report.ok()) return std::nullopt;  // it says why it cannot
    const auto bytes = encode(presentation, choices);
    if (!bytes.ok()) return broken(what + ": encode", bytes.error());
    Presentation original = make(SceneNames::own);
    (void)quantize_scene(original);
    Diagnostics ignored;
    (void)set_up_encoding(original, choices, ignored);
    const std::string expected = told(original);
    ToldCommands decoded;
    if (Status done = decode(bytes.value(), true, decoded); !done.ok())
      return decode_failure(what + ": decode: " + to_string(done.error()), "bifs", bytes.value(),
                            expected);
    const std::string wrong = quantized_difference(
        without(json::parse(expected), {.names = true}),
        without(json::parse(damaged(decoded.text())), {.names = true}), report.value());
    if (!wrong.empty())
      return decode_failure(what + ": decode: " + wrong, "bifs", bytes.value(), expected);
    // A value that has become the default is left out from here on; nothing else changes again.
    const auto again = encode_again(bytes.value(), choices);
    if (!again.ok()) return broken(what + ": encode again", again.error());
    const auto third = encode_again(again.value(), choices);
    if (!third.ok() || third.value() != again.value())
      return Failure{what + ": encode again: other bytes",
                     {"bifs", again.value(), {{{{"check", "reencode"}}, {}}}}};
    return std::nullopt;
  }

  [[nodiscard]] std::string damaged(std::string commands) const {
    if (fault_.told) fault_.told(commands);
    return commands;
  }

  /// The case as it is to decode: what was meant, in the form `commands`.
  static Failure decode_failure(const std::string& text, const std::string& kind,
                                const Bytes& bytes, const std::string& expected);

  const std::vector<uint32_t>& draws_;
  const SceneFault& fault_;
};

Failure SceneCheck::decode_failure(const std::string& text, const std::string& kind,
                                   const Bytes& bytes, const std::string& expected) {
  json document = decoded_document(bytes, kind == "bifs");
  const json units = json::parse(expected);
  if (document.is_null() || document["accessUnits"].size() != units.size())
    return {text, {kind, bytes, {{{{"check", "reencode"}}, {}}}}};
  for (size_t i = 0; i < units.size(); ++i)
    document["accessUnits"][i]["commands"] = units[i]["commands"];
  return {text, {kind, bytes, {{{{"check", "decode"}, {"as", "commands"}}, document}}}};
}

}  // namespace

Property scene_property(const SceneFault& fault) {
  return [fault](Choices& choices) {
    (void)random_scene(choices, SceneNames::own);
    return SceneCheck(choices.draws(), fault).run();
  };
}

}  // namespace afx::conformance
