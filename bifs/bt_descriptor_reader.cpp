// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Object descriptors and their commands in BT. Source: the dialect of the peer (spec/bifs.md 17).
#include <algorithm>
#include <utility>

#include "bifs/bt_text_reader.h"
#include "bifs/descriptor_fields.h"
#include "nodes/byte_text.h"
#include "nodes/nearest_name.h"

namespace afx::bifs {

using nodes::quoted;
using nodes::TextCursor;

namespace {

constexpr uint32_t kMostId = 1023;

/// A pass over the fields of a descriptor that reads the one of that name.
class FieldReader {
 public:
  FieldReader(TextCursor& in, std::string_view name, nodes::NearestName& nearest)
      : in_(in), name_(name), nearest_(nearest) {}

  [[nodiscard]] bool found() const { return found_; }

  /// Whether the field of this name is the one; offers the name for a hint otherwise.
  bool is(std::string_view name) {
    nearest_.offer(name);
    if (found_ || name != name_) return false;
    return found_ = true;
  }

  template <class T>
  void number(std::string_view name, T& value, unsigned bits, uint64_t) {
    if (is(name)) value = static_cast<T>(read_number(bits));
  }
  void flag(std::string_view name, bool& value, bool) {
    if (is(name)) value = in_.boolean();
  }
  template <class T>
  void optional_number(std::string_view name, std::optional<T>& value, unsigned bits) {
    if (is(name)) value = static_cast<T>(read_number(bits));
  }
  void optional_text(std::string_view name, std::optional<std::string>& value) {
    if (is(name)) value = in_.string();
  }

 private:
  uint64_t read_number(unsigned bits) {
    in_.skip_space();
    const size_t begin = in_.offset();
    const uint64_t number = in_.uint64();
    if (bits < 64 && number >> bits != 0)
      in_.fail(Errc::malformed, begin,
               std::to_string(number) + " does not fit " + std::to_string(bits) + " bits");
    return number;
  }

  TextCursor& in_;
  std::string_view name_;
  nodes::NearestName& nearest_;
  bool found_ = false;
};

/// Bytes as GPAC writes them: %00%14.
std::string bytes_of_percents(std::string_view token) {
  std::string hex;
  for (size_t i = 0; i < token.size(); ++i)
    if (token[i] != '%') hex += token[i];
  return hex;
}

}  // namespace

/// `{ name value ... }`: calls `read_one` with a FieldReader for each name.
template <class Field>
void BtTextReader::read_block(std::string_view name, Field read_one) {
  const TextCursor::Context outer = std::exchange(in_.context, {name, {}});
  const size_t opened = (in_.skip_space(), in_.offset());
  if (!in_.expect('{', name)) return;
  while (!in_.accept('}')) {
    if (in_.at_end()) return in_.fail_unclosed(opened, "'}'");
    if (in_.peek_word().empty()) return in_.fail_expected("a field or '}'");
    const size_t begin = in_.offset();
    const std::string_view field = in_.take_word();
    nodes::NearestName nearest(field);
    FieldReader reader(in_, field, nearest);
    if (!values_.budget().take(in_, 1, sizeof(Descriptor))) return;
    read_one(reader);
    if (!reader.found() && in_.ok())
      return in_.fail(Errc::malformed, begin, "no field " + quoted(field) + nearest.hint());
    in_.context = {name, {}};
  }
  in_.context = outer;
}

/// `[ ... ]`, or one without brackets.
template <class Read>
void BtTextReader::read_bracketed(Read read_one) {
  const size_t opened = (in_.skip_space(), in_.offset());
  if (!in_.accept('[')) return read_one();
  while (!in_.accept(']')) {
    if (in_.at_end()) return in_.fail_unclosed(opened, "']'");
    read_one();
  }
}

InitialObjectDescriptor BtTextReader::read_initial_object() {
  InitialObjectDescriptor initial;
  initial.in_file = false;
  initial.od_profile = initial.scene_profile = initial.audio_profile = 0xFF;
  initial.visual_profile = initial.graphics_profile = 0xFF;
  const auto append = [&](Descriptors parts) {
    std::move(parts.begin(), parts.end(), std::back_inserter(initial.parts));
  };
  read_block("InitialObjectDescriptor", [&](FieldReader& field) {
    initial_object_fields(initial, field);
    profile_fields(initial, field);
    if (field.is("esDescr")) append(read_es_descriptors());
    if (field.is("otherDescr")) append(read_other_descriptors());
  });
  return initial;
}

ObjectDescriptor BtTextReader::read_object_descriptor() {
  ObjectDescriptor object;
  object.in_file = false;
  const auto append = [&](Descriptors parts) {
    std::move(parts.begin(), parts.end(), std::back_inserter(object.parts));
  };
  read_block("ObjectDescriptor", [&](FieldReader& field) {
    object_descriptor_fields(object, field);
    if (field.is("esDescr")) append(read_es_descriptors());
    if (field.is("otherDescr")) append(read_other_descriptors());
  });
  return object;
}

Descriptors BtTextReader::read_es_descriptors() {
  Descriptors list;
  read_bracketed([&] {
    if (in_.accept_word("UnknownDescriptor")) {
      list.emplace_back().body = read_unknown_descriptor();
    } else if (expect_word("ES_Descriptor")) {
      list.emplace_back().body = read_es_descriptor();
    }
  });
  return list;
}

EsDescriptor BtTextReader::read_es_descriptor() {
  EsDescriptor es;
  read_block("ES_Descriptor", [&](FieldReader& field) {
    es_descriptor_fields(es, field);
    if (field.is("decConfigDescr") && expect_word("DecoderConfigDescriptor"))
      es.parts.emplace_back().body = read_decoder_config();
    if (field.is("slConfigDescr") && expect_word("SLConfigDescriptor"))
      es.parts.emplace_back().body = read_sl_config();
    if (field.is("muxInfo") && expect_word("MuxInfo")) es.source = read_mux_info();
    if (!field.is("otherDescr")) return;
    Descriptors others = read_other_descriptors();
    std::move(others.begin(), others.end(), std::back_inserter(es.parts));
  });
  return es;
}

DecoderConfig BtTextReader::read_decoder_config() {
  DecoderConfig config;
  read_block("DecoderConfigDescriptor", [&](FieldReader& field) {
    decoder_config_fields(config, field);
    if (field.is("decSpecificInfo")) config.parts.emplace_back().body = read_specific_info(config);
    if (!field.is("otherDescr")) return;
    Descriptors others = read_other_descriptors();
    std::move(others.begin(), others.end(), std::back_inserter(config.parts));
  });
  return config;
}

/// `BIFSConfig { ... }` or bytes.
DecoderSpecificInfo BtTextReader::read_specific_info(DecoderConfig& config) {
  DecoderSpecificInfo info;
  for (const auto& [word, version] : {std::pair("BIFSConfig", 1), std::pair("BIFSv2Config", 2)}) {
    in_.skip_space();
    const size_t begin = in_.offset();
    if (!in_.accept_word(word)) continue;
    if (config.object_type == 0) config.object_type = static_cast<uint8_t>(version);
    const BifsConfig bifs = read_bifs_config(static_cast<uint8_t>(version));
    const auto bytes = write_config(bifs);
    if (!bytes.ok()) return in_.fail(Errc::malformed, begin, bytes.error().text), info;
    info.bytes = bytes.value();
    return info;
  }
  if (!expect_word("DecoderSpecificInfo")) return info;
  read_block("DecoderSpecificInfo", [&](FieldReader& field) {
    if (!field.is("info")) return;
    if (in_.peek() == '"') {
      const std::string bytes = values_.read_bytes();
      info.bytes.assign(bytes.begin(), bytes.end());
      return;
    }
    in_.skip_space();
    const size_t begin = in_.offset();
    const auto bytes = nodes::bytes_of_text(bytes_of_percents(in_.take_token()));
    if (!bytes.ok()) return in_.fail(bytes.error().code, begin, bytes.error().text);
    info.bytes.assign(bytes.value().begin(), bytes.value().end());
  });
  return info;
}

BifsConfig BtTextReader::read_bifs_config(uint8_t version) {
  BifsConfig config;
  config.version = version;
  config.node_id_bits = 0;
  config.pixel_metric = false;
  DisplaySize size;
  read_block("BIFSConfig", [&](FieldReader& field) {
    bifs_config_widths(config, field);
    field.flag("pixelMetric", config.pixel_metric, false);
    field.number("pixelWidth", size.width, 16, 0);
    field.number("pixelHeight", size.height, 16, 0);
    if (!field.is("isCommandStream")) return;
    in_.skip_space();
    const size_t begin = in_.offset();
    if (!in_.boolean()) in_.fail(Errc::unsupported, begin, "an animation stream (BIFS-Anim)");
  });
  if (size.width != 0 || size.height != 0) config.size = size;
  return config;
}

SlConfig BtTextReader::read_sl_config() {
  SlConfig sl;
  SlFields fields;
  fields.time_stamp_resolution = 0;  // unsaid, as in XMT-A
  sl.predefined = 0;
  read_block("SLConfigDescriptor", [&](FieldReader& field) {
    field.number("predefined", sl.predefined, 8, 0);
    sl_config_fields(fields, field);
  });
  if (sl.predefined == 0) sl.fields = fields;
  return sl;
}

/// What the file is and what is in it counts; how the peer is to import it is left out.
MediaSource BtTextReader::read_mux_info() {
  MediaSource source;
  read_block("MuxInfo", [&](FieldReader& field) {
    if (field.is("fileName")) source.file = in_.string();
    if (field.is("streamFormat")) source.format = in_.string();
    for (const std::string_view name : {"GroupID", "startTime", "duration", "carouselPeriod"}) {
      if (!field.is(name)) continue;
      in_.warn("mux_info", in_.offset(), "MuxInfo." + std::string(name) + " is left out");
      in_.take_token();
    }
  });
  return source;
}

/// Descriptors that have no form of their own here, as bytes.
Descriptors BtTextReader::read_other_descriptors() {
  Descriptors list;
  read_bracketed([&] {
    if (expect_word("UnknownDescriptor")) list.emplace_back().body = read_unknown_descriptor();
  });
  return list;
}

UnknownDescriptor BtTextReader::read_unknown_descriptor() {
  UnknownDescriptor unknown;
  read_block("UnknownDescriptor", [&](FieldReader& field) {
    field.number("tag", unknown.tag, 8, 0);
    if (!field.is("data")) return;
    const std::string bytes = values_.read_bytes();
    unknown.payload.assign(bytes.begin(), bytes.end());
  });
  return unknown;
}

/// Reads a command if `word` begins one of object descriptors.
bool BtTextReader::read_descriptor_command(std::string_view word, OdCommands& out) {
  if (word == "UPDATE") return in_.take_word(), read_update(out), true;
  if (word == "REMOVE") return in_.take_word(), read_remove(out), true;
  if (word == "UnknownCommand") return in_.take_word(), read_unknown_command(out), true;
  return false;
}

void BtTextReader::read_update(OdCommands& out) {
  if (in_.accept_word("OD")) {
    OdUpdate update;
    read_bracketed([&] {
      if (in_.accept_word("UnknownDescriptor")) {
        update.objects.emplace_back().body = read_unknown_descriptor();
      } else if (expect_word("ObjectDescriptor")) {
        update.objects.emplace_back().body = read_object_descriptor();
      }
    });
    out.emplace_back().body = std::move(update);
    return;
  }
  if (!in_.accept_word("ESD")) return in_.fail_expected("OD or ESD");
  if (!in_.accept_word("in") && !expect_word("IN")) return;
  EsUpdate update;
  update.od_id = static_cast<uint16_t>(read_number("an object descriptor ID", kMostId));
  if (expect_word("esDescr")) update.streams = read_es_descriptors();
  out.emplace_back().body = std::move(update);
}

void BtTextReader::read_remove(OdCommands& out) {
  if (in_.accept_word("OD")) {
    out.emplace_back().body = OdRemove{read_ids(kMostId)};
    return;
  }
  if (!in_.accept_word("ESD")) return in_.fail_expected("OD or ESD");
  if (!expect_word("FROM")) return;
  EsRemove remove;
  remove.references = false;
  remove.od_id = static_cast<uint16_t>(read_number("an object descriptor ID", kMostId));
  remove.streams = read_ids(0xFFFF);
  out.emplace_back().body = std::move(remove);
}

void BtTextReader::read_unknown_command(OdCommands& out) {
  UnknownOdCommand unknown;
  read_block("UnknownCommand", [&](FieldReader& field) {
    field.number("tag", unknown.tag, 8, 0);
    if (!field.is("data")) return;
    const std::string bytes = values_.read_bytes();
    unknown.payload.assign(bytes.begin(), bytes.end());
  });
  out.emplace_back().body = std::move(unknown);
}

uint32_t BtTextReader::read_number(std::string_view what, uint64_t most) {
  in_.skip_space();
  const size_t begin = in_.offset();
  const uint64_t number = in_.uint64();
  if (number <= most) return static_cast<uint32_t>(number);
  in_.fail(Errc::malformed, begin,
           std::string(what) + " of " + std::to_string(number) + " [expected at most " +
               std::to_string(most) + "]");
  return 0;
}

std::vector<uint16_t> BtTextReader::read_ids(uint32_t most) {
  std::vector<uint16_t> ids;
  read_bracketed([&] {
    if (values_.budget().take(in_, 1, sizeof(uint16_t)))
      ids.push_back(static_cast<uint16_t>(read_number("an ID", most)));
  });
  return ids;
}

}  // namespace afx::bifs
