// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/bt_descriptor_writer.h"

#include "bifs/config.h"
#include "bifs/descriptor_fields.h"
#include "nodes/byte_text.h"
#include "nodes/value_writer.h"

namespace afx::bifs {
namespace {

class BtDescriptorWriter {
 public:
  explicit BtDescriptorWriter(size_t indent) : depth_(indent) {}
  [[nodiscard]] std::string done() { return std::move(out_); }

  // The members of a pass over the fields (descriptor_fields.h).
  template <class T>
  void number(std::string_view name, const T& value, unsigned, uint64_t unsaid) {
    if (value != unsaid) line(name, std::to_string(value));
  }
  void flag(std::string_view name, bool value, bool unsaid) {
    if (value != unsaid) line(name, value ? "true" : "false");
  }
  template <class T>
  void optional_number(std::string_view name, const std::optional<T>& value, unsigned) {
    if (value) line(name, std::to_string(*value));
  }
  void optional_text(std::string_view name, const std::optional<std::string>& value) {
    if (value) text(name, *value);
  }

  void write(const InitialObjectDescriptor& initial) {
    block("InitialObjectDescriptor", [&] {
      initial_object_fields(initial, *this);
      profile_fields(initial, *this);
      parts(initial.parts);
    });
  }

  void write(const OdUpdate& update) { list("UPDATE OD", update.objects); }
  void write(const OdRemove& remove) { line("REMOVE OD", ids(remove.ids)); }
  void write(const EsUpdate& update) {
    line("UPDATE ESD IN", std::to_string(update.od_id));
    list("esDescr", update.streams);
  }
  void write(const EsRemove& remove) {
    line("REMOVE ESD FROM", std::to_string(remove.od_id) + ' ' + ids(remove.streams));
  }
  void write(const UnknownOdCommand& command) {
    block("UnknownCommand", [&] { tag_and_data(command.tag, command.payload); });
  }

 private:
  void begin_line() { out_.append(2 * depth_, ' '); }
  void line(std::string_view name, std::string_view value) {
    begin_line();
    ((out_ += name) += ' ') += value;
    out_ += '\n';
  }
  void text(std::string_view name, std::string_view value) {
    std::string quoted;
    nodes::append_string(quoted, value);
    line(name, quoted);
  }
  template <class Content>
  void block(std::string_view name, Content content) {
    line(name, "{");
    ++depth_;
    content();
    --depth_;
    begin_line();
    out_ += "}\n";
  }
  void list(std::string_view name, const Descriptors& descriptors) {
    line(name, "[");
    ++depth_;
    for (const Descriptor& descriptor : descriptors) one(descriptor);
    --depth_;
    begin_line();
    out_ += "]\n";
  }
  static std::string ids(const std::vector<uint16_t>& list) {
    std::string out = "[";
    for (const uint16_t id : list) out += ' ' + std::to_string(id);
    return out + " ]";
  }

  void one(const Descriptor& descriptor) {
    if (const auto* object = std::get_if<ObjectDescriptor>(&descriptor.body)) {
      block("ObjectDescriptor", [&] {
        object_descriptor_fields(*object, *this);
        parts(object->parts);
      });
    } else if (const auto* es = std::get_if<EsDescriptor>(&descriptor.body)) {
      block("ES_Descriptor", [&] { stream(*es); });
    } else if (const auto* unknown = std::get_if<UnknownDescriptor>(&descriptor.body)) {
      block("UnknownDescriptor", [&] { tag_and_data(unknown->tag, unknown->payload); });
    }
  }

  void stream(const EsDescriptor& es) {
    es_descriptor_fields(es, *this);
    for (const Descriptor& part : es.parts) {
      if (const auto* config = std::get_if<DecoderConfig>(&part.body))
        block("decConfigDescr DecoderConfigDescriptor", [&] { decoder_config(*config); });
      if (const auto* sl = std::get_if<SlConfig>(&part.body))
        block("slConfigDescr SLConfigDescriptor", [&] { sl_config(*sl); });
    }
    if (es.source) {
      block("muxInfo MuxInfo", [&] {
        text("fileName", es.source->file);
        if (!es.source->format.empty()) text("streamFormat", es.source->format);
      });
    }
    others(es.parts);
  }

  void decoder_config(const DecoderConfig& config) {
    decoder_config_fields(config, *this);
    const bool scene = config.stream_type == stream_type::kScene &&
                       (config.object_type == kOtiBifs || config.object_type == kOtiBifsV2);
    for (const Descriptor& part : config.parts) {
      const auto* info = std::get_if<DecoderSpecificInfo>(&part.body);
      if (info == nullptr || (scene && bifs_config(info->bytes, config.object_type))) continue;
      block("decSpecificInfo DecoderSpecificInfo", [&] {
        text("info", nodes::text_of_bytes(
                         {reinterpret_cast<const char*>(info->bytes.data()), info->bytes.size()}));
      });
    }
    others(config.parts);
  }

  /// False, and nothing is written, if the bytes are not what that configuration is written as.
  bool bifs_config(const std::vector<uint8_t>& bytes, uint8_t object_type) {
    Diagnostics diagnostics;
    const auto config = read_config(bytes, object_type, diagnostics);
    if (!config.ok() || config.value().version != object_type) return false;
    const auto again = write_config(config.value());
    if (!again.ok() || again.value() != bytes) return false;
    const BifsConfig& bifs = config.value();
    block(bifs.version == 2 ? "decSpecificInfo BIFSv2Config" : "decSpecificInfo BIFSConfig", [&] {
      bifs_config_widths(bifs, *this);
      line("isCommandStream", "true");
      line("pixelMetric", bifs.pixel_metric ? "true" : "false");
      if (bifs.size) line("pixelWidth", std::to_string(bifs.size->width));
      if (bifs.size) line("pixelHeight", std::to_string(bifs.size->height));
    });
    return true;
  }

  void sl_config(const SlConfig& sl) {
    number("predefined", sl.predefined, 8, 0);
    if (sl.fields) sl_config_fields(*sl.fields, *this);
  }

  void parts(const Descriptors& list_of) {
    Descriptors streams;
    for (const Descriptor& part : list_of)
      if (std::holds_alternative<EsDescriptor>(part.body)) streams.push_back(part);
    if (!streams.empty()) list("esDescr", streams);
    others(list_of);
  }

  /// Descriptors without a form of their own.
  void others(const Descriptors& list_of) {
    Descriptors unknown;
    for (const Descriptor& part : list_of)
      if (std::holds_alternative<UnknownDescriptor>(part.body)) unknown.push_back(part);
    if (!unknown.empty()) list("otherDescr", unknown);
  }

  void tag_and_data(uint8_t tag, const std::vector<uint8_t>& data) {
    line("tag", std::to_string(tag));
    text("data", nodes::text_of_bytes({reinterpret_cast<const char*>(data.data()), data.size()}));
  }

  std::string out_;
  size_t depth_;
};

}  // namespace

std::string bt_text(const InitialObjectDescriptor& initial) {
  BtDescriptorWriter writer(0);
  writer.write(initial);
  return writer.done();
}

std::string bt_text(const OdCommand& command, size_t indent) {
  BtDescriptorWriter writer(indent);
  std::visit([&](const auto& body) { writer.write(body); }, command.body);
  return writer.done();
}

}  // namespace afx::bifs
