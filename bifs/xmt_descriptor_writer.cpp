// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/xmt_descriptor_writer.h"

#include <optional>
#include <string>
#include <vector>

#include "bifs/config.h"
#include "bifs/descriptor_fields.h"
#include "bifs/xmt_values.h"
#include "nodes/byte_text.h"

namespace afx::bifs {

namespace {

std::string_view bytes_view(const std::vector<uint8_t>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// A pass of descriptor_fields.h that writes attributes. IDs stand as names, od10, and as numbers.
class FieldPass {
 public:
  explicit FieldPass(XmtOutput& out) : out_(out) {}

  void number(std::string_view name, uint64_t value, unsigned, uint64_t unsaid) {
    if (value == unsaid) return;
    const bool is_object = name == "objectDescriptorID";
    if (!is_object && name != "ES_ID") return out_.attribute(name, value);
    out_.attribute(name, (is_object ? "od" : "es") + std::to_string(value));
    out_.attribute("binaryID", value);
  }
  void flag(std::string_view name, bool value, bool unsaid) {
    if (value != unsaid) out_.attribute(name, value ? "true" : "false");
  }
  template <class T>
  void optional_number(std::string_view name, const std::optional<T>& value, unsigned) {
    if (value) out_.attribute(name, "es" + std::to_string(*value));
  }
  void optional_text(std::string_view name, const std::optional<std::string>& value) {
    if (value) url_ = {std::string(name), *value};
  }
  /// The element for a URL, behind all attributes.
  void write_url() {
    if (url_.first.empty()) return;
    out_.open("URL");
    out_.attribute(url_.first, url_.second);
    out_.close();
  }

 private:
  XmtOutput& out_;
  std::pair<std::string, std::string> url_;
};

class DescriptorWriter {
 public:
  explicit DescriptorWriter(XmtOutput& out) : out_(out) {}

  /// Descriptors of one role after the other stand in one element for it.
  void write_all(const Descriptors& parts) {
    std::string_view open;
    for (const Descriptor& part : parts) {
      const std::string_view role = role_of(part);
      if (role != open && !open.empty()) out_.close();
      if (role != open && !role.empty()) out_.open(role);
      open = role;
      std::visit([&](const auto& body) { write(body); }, part.body);
    }
    if (!open.empty()) out_.close();
  }

  void write(const InitialObjectDescriptor& initial) {
    out_.open("InitialObjectDescriptor");
    FieldPass pass(out_);
    object_descriptor_fields(initial, pass);
    pass.write_url();
    out_.open("Profiles");
    FieldPass profiles(out_);
    profiles.flag("includeInlineProfileLevelFlag", initial.inline_profiles, false);
    profile_fields(initial, profiles);
    out_.close();
    write_parts(initial.parts);
  }
  void write(const ObjectDescriptor& object) {
    out_.open("ObjectDescriptor");
    FieldPass pass(out_);
    object_descriptor_fields(object, pass);
    pass.write_url();
    write_parts(object.parts);
  }
  void write(const EsDescriptor& es) {
    out_.open("ES_Descriptor");
    FieldPass pass(out_);
    es_descriptor_fields(es, pass);
    pass.write_url();
    write_all(es.parts);
    if (es.source) write_source(*es.source);
    out_.close();
  }
  void write(const DecoderConfig& config) {
    out_.open("DecoderConfigDescriptor");
    FieldPass pass(out_);
    decoder_config_fields(config, pass);
    config_of_ = config.stream_type == stream_type::kScene ? &config : nullptr;
    write_all(config.parts);
    config_of_ = nullptr;
    out_.close();
  }
  void write(const DecoderSpecificInfo& info) {
    if (config_of_ != nullptr && write_bifs_config(info, config_of_->object_type)) return;
    out_.open("DecoderSpecificInfo");
    out_.attribute("type", "auto");
    out_.attribute("src", xmt_text_of_bytes(bytes_view(info.bytes)));
    out_.close();
  }
  void write(const SlConfig& sl) {
    out_.open("SLConfigDescriptor");
    if (!sl.rest.empty()) out_.attribute("src", nodes::text_of_bytes(bytes_view(sl.rest)));
    if (sl.fields) {
      out_.open("custom");
      FieldPass pass(out_);
      sl_config_fields(*sl.fields, pass);
    } else {
      out_.open("predefined");
      out_.attribute("value", sl.predefined);
    }
    out_.close();
    out_.close();
  }
  void write(const EsIdInc& es) {
    out_.open("ES_ID_Inc");
    out_.attribute("trackID", es.track_id);
    out_.close();
  }
  void write(const EsIdRef& es) {
    out_.open("ES_ID_Ref");
    out_.attribute("refIndex", es.index);
    out_.close();
  }
  void write(const UnknownDescriptor& unknown) {
    write_bytes("UnknownDescriptor", unknown.tag, unknown.payload);
  }

  void write(const OdUpdate& update) {
    out_.open("ObjectDescriptorUpdate");
    out_.open("OD");
    for (const Descriptor& object : update.objects)
      std::visit([&](const auto& body) { write(body); }, object.body);
    out_.close();
    out_.close();
  }
  void write(const OdRemove& remove) {
    out_.open("ObjectDescriptorRemove");
    out_.attribute("objectDescriptorId", list_of(remove.ids, "od"));
    out_.close();
  }
  void write(const EsUpdate& update) {
    out_.open("ES_DescriptorUpdate");
    out_.attribute("objectDescriptorId", "od" + std::to_string(update.od_id));
    write_all(update.streams);
    out_.close();
  }
  void write(const EsRemove& remove) {
    out_.open("ES_DescriptorRemove");
    out_.attribute("objectDescriptorId", "od" + std::to_string(remove.od_id));
    out_.attribute(remove.references ? "refIndex" : "ES_ID",
                   list_of(remove.streams, remove.references ? "" : "es"));
    out_.close();
  }
  void write(const UnknownOdCommand& unknown) {
    write_bytes("UnknownODCommand", unknown.tag, unknown.payload);
  }

 private:
  static std::string_view role_of(const Descriptor& part) {
    if (std::holds_alternative<EsDescriptor>(part.body)) return "esDescr";
    if (std::holds_alternative<DecoderConfig>(part.body)) return "decConfigDescr";
    if (std::holds_alternative<DecoderSpecificInfo>(part.body)) return "decSpecificInfo";
    if (std::holds_alternative<SlConfig>(part.body)) return "slConfigDescr";
    return {};
  }

  void write_parts(const Descriptors& parts) {
    out_.open("Descr");
    write_all(parts);
    out_.close();
    out_.close();
  }

  void write_source(const MediaSource& source) {
    out_.open("StreamSource");
    out_.attribute("url", source.file);
    if (!source.format.empty()) out_.attribute("streamFormat", source.format);
    out_.close();
  }

  /// A BIFS configuration as such; false if the bytes are none, or would not come back the same.
  bool write_bifs_config(const DecoderSpecificInfo& info, uint8_t object_type) {
    Diagnostics warnings;
    const auto config = read_config(info.bytes, object_type, warnings);
    if (!config.ok()) return false;
    const auto again = write_config(config.value());
    if (!again.ok() || again.value() != info.bytes) return false;
    out_.open(config.value().version == 1 ? "BIFSConfig" : "BIFSv2Config");
    FieldPass pass(out_);
    bifs_config_widths(config.value(), pass);
    out_.open("commandStream");
    pass.flag("pixelMetric", config.value().pixel_metric, false);
    if (const auto size = config.value().size) {
      out_.open("size");
      out_.attribute("pixelWidth", size->width);
      out_.attribute("pixelHeight", size->height);
      out_.close();
    }
    out_.close();
    out_.close();
    return true;
  }

  void write_bytes(std::string_view name, uint8_t tag, const std::vector<uint8_t>& bytes) {
    out_.open(name);
    out_.attribute("tag", tag);
    out_.attribute("src", nodes::text_of_bytes(bytes_view(bytes)));
    out_.close();
  }

  static std::string list_of(const std::vector<uint16_t>& ids, const std::string& prefix) {
    std::string list;
    for (const uint16_t id : ids) list += (list.empty() ? "" : " ") + prefix + std::to_string(id);
    return list;
  }

  XmtOutput& out_;
  const DecoderConfig* config_of_ = nullptr;  ///< a scene stream's, while its parts are written
};

}  // namespace

void write_xmt_initial(XmtOutput& out, const InitialObjectDescriptor& initial) {
  DescriptorWriter(out).write(initial);
}

void write_xmt_od_command(XmtOutput& out, const OdCommand& command) {
  std::visit([&](const auto& body) { DescriptorWriter(out).write(body); }, command.body);
}

}  // namespace afx::bifs
