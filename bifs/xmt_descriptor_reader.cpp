// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Descriptors in XMT-A: an element for each, and elements around them that say their role (Descr,
// esDescr, decConfigDescr and so on), which mean nothing more.
#include "bifs/xmt_descriptor_reader.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "bifs/config.h"
#include "bifs/descriptor_fields.h"
#include "nodes/nearest_name.h"
#include "nodes/text_cursor.h"

namespace afx::bifs {

namespace {

using nodes::quoted;

constexpr unsigned kMaxDepth = 64;  ///< of elements

constexpr std::string_view kRoles[] = {"Descr",           "esDescr",       "decConfigDescr",
                                       "decSpecificInfo", "slConfigDescr", "OD"};
constexpr std::string_view kDescriptors[] = {
    "ObjectDescriptor", "ES_Descriptor",    "DecoderConfigDescriptor", "DecoderSpecificInfo",
    "BIFSConfig",       "BIFSv2Config",     "SLConfigDescriptor",      "ES_ID_Inc",
    "ES_ID_Ref",        "UnknownDescriptor"};
constexpr std::string_view kCommands[] = {"ObjectDescriptorUpdate", "ObjectDescriptorRemove",
                                          "ES_DescriptorUpdate", "ES_DescriptorRemove",
                                          "UnknownODCommand"};

bool contains(const auto& names, std::string_view name) {
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

/// The number in a name as GPAC makes them: od10, es3.
std::string_view id_prefix(std::string_view field) {
  if (field == "objectDescriptorID") return "od";
  return field.ends_with("ES_ID") ? "es" : "";
}

/// A pass of descriptor_fields.h over the attributes of an element.
class FieldPass {
 public:
  FieldPass(XmtDocument& document, XmtAttributes& attributes, pugi::xml_node element)
      : document_(document), attributes_(attributes), element_(element) {}

  template <class T>
  void number(const char* name, T& value, unsigned bits, uint64_t unsaid) {
    const uint64_t largest = bits == 64 ? UINT64_MAX : (uint64_t{1} << bits) - 1;
    const bool is_id =
        name == std::string_view("objectDescriptorID") || name == std::string_view("ES_ID");
    std::optional<uint64_t> said;
    if (is_id) said = attributes_.number("binaryID", largest);
    if (said) {
      attributes_.find(name);  // a name for people
    } else {
      said = attributes_.number(name, largest, id_prefix(name));
    }
    if (!said && unsaid > largest)
      return document_.fail(attributes_.where(), std::string(attributes_.where()) + " without " +
                                                     name + " [expected that attribute]");
    value = static_cast<T>(said.value_or(unsaid));
  }
  void flag(const char* name, bool& value, bool unsaid) {
    value = attributes_.flag(name).value_or(unsaid);
  }
  template <class T>
  void optional_number(const char* name, std::optional<T>& value, unsigned bits) {
    const auto said = attributes_.number(name, (uint64_t{1} << bits) - 1, id_prefix(name));
    if (said) value = static_cast<T>(*said);
  }
  void optional_text(const char* name, std::optional<std::string>& value) {
    if (const pugi::xml_node url = element_.child("URL")) {
      XmtAttributes inner(document_, url);
      value = inner.need(name);
      inner.finish();
    } else if (attributes_.find(name)) {
      value = attributes_.text(name);
    }
  }

 private:
  XmtDocument& document_;
  XmtAttributes& attributes_;
  pugi::xml_node element_;
};

}  // namespace

template <class T, class Fields>
void XmtDescriptorReader::read_fields(Element element, T& descriptor, Fields fields) {
  XmtAttributes attributes(document_, element);
  FieldPass pass(document_, attributes, element);
  fields(descriptor, pass);
  attributes.finish();
}

InitialObjectDescriptor XmtDescriptorReader::read_initial(Element element) {
  InitialObjectDescriptor initial;
  initial.in_file = false;
  const Element profiles = element.child("Profiles");
  read_fields(element, initial,
              [](auto& object, auto& pass) { object_descriptor_fields(object, pass); });
  if (profiles)
    read_fields(profiles, initial, [](auto& object, auto& pass) {
      pass.flag("includeInlineProfileLevelFlag", object.inline_profiles, false);
      profile_fields(object, pass);
    });
  read_parts(element, initial.parts, {"Profiles", "URL"});
  return initial;
}

/// The descriptors in an element; `own`: elements that say something of `parent` itself.
void XmtDescriptorReader::read_parts(Element parent, Descriptors& parts,
                                     std::initializer_list<std::string_view> own) {
  if (++depth_ > kMaxDepth)
    document_.fail(document_.name(parent), "descriptors nested too deep", Errc::limit_exceeded);
  for (const Element child : parent.children()) {
    if (!document_.ok()) break;
    const std::string_view name = document_.name(child);
    if (contains(own, name)) continue;
    if (!contains(kRoles, name)) {
      read_descriptor(child, parts);
      continue;
    }
    XmtAttributes(document_, child).finish();
    read_parts(child, parts, {});
  }
  --depth_;
}

void XmtDescriptorReader::read_descriptor(Element element, Descriptors& parts) {
  const std::string_view name = document_.name(element);
  if (!values_.take(name, 1, sizeof(Descriptor))) return;
  XmtAttributes attributes(document_, element);
  if (name == "ObjectDescriptor") {
    parts.push_back({read_object(element)});
  } else if (name == "InitialObjectDescriptor") {
    parts.push_back({read_initial(element)});
  } else if (name == "ES_Descriptor") {
    parts.push_back({read_es(element)});
  } else if (name == "DecoderConfigDescriptor") {
    parts.push_back({read_decoder_config(element)});
  } else if (name == "DecoderSpecificInfo") {
    attributes.find("type");  // GPAC: how the bytes are told
    parts.push_back({DecoderSpecificInfo{read_bytes(attributes)}});
  } else if (name == "BIFSConfig" || name == "BIFSv2Config") {
    parts.push_back({DecoderSpecificInfo{read_bifs_config(element, name == "BIFSConfig" ? 1 : 2)}});
  } else if (name == "SLConfigDescriptor") {
    parts.push_back({read_sl_config(element)});
  } else if (name == "ES_ID_Inc") {
    const auto track = attributes.number("trackID", UINT32_MAX);
    parts.push_back({EsIdInc{static_cast<uint32_t>(track.value_or(0))}});
    attributes.finish();
  } else if (name == "ES_ID_Ref") {
    const auto index = attributes.number("refIndex", UINT16_MAX);
    parts.push_back({EsIdRef{static_cast<uint16_t>(index.value_or(0))}});
    attributes.finish();
  } else if (name == "UnknownDescriptor") {
    const auto tag = attributes.number("tag", UINT8_MAX);
    parts.push_back(
        {UnknownDescriptor{static_cast<uint8_t>(tag.value_or(0)), read_bytes(attributes)}});
  } else {
    nodes::NearestName nearest(name);
    for (const std::string_view known : kRoles) nearest.offer(known);
    for (const std::string_view known : kDescriptors) nearest.offer(known);
    document_.fail(name, "no descriptor " + quoted(name) + nearest.hint());
  }
}

ObjectDescriptor XmtDescriptorReader::read_object(Element element) {
  ObjectDescriptor object;
  object.in_file = false;
  read_fields(element, object, [](auto& of, auto& pass) { object_descriptor_fields(of, pass); });
  read_parts(element, object.parts, {"URL"});
  return object;
}

EsDescriptor XmtDescriptorReader::read_es(Element element) {
  EsDescriptor es;
  read_fields(element, es, [](auto& of, auto& pass) { es_descriptor_fields(of, pass); });
  read_parts(element, es.parts, {"URL", "StreamSource"});
  const Element source = element.child("StreamSource");
  if (!source || !document_.ok()) return es;
  XmtAttributes attributes(document_, source);
  es.source = MediaSource{attributes.need("url"), attributes.text("streamFormat")};
  attributes.finish();
  return es;
}

DecoderConfig XmtDescriptorReader::read_decoder_config(Element element) {
  DecoderConfig config;
  read_fields(element, config, [](auto& of, auto& pass) { decoder_config_fields(of, pass); });
  read_parts(element, config.parts, {});
  return config;
}

SlConfig XmtDescriptorReader::read_sl_config(Element element) {
  XmtAttributes attributes(document_, element);
  SlConfig sl;
  if (attributes.find("src")) sl.rest = read_bytes(attributes);
  attributes.finish();
  sl.predefined = 0;
  if (const Element predefined = element.child("predefined")) {
    XmtAttributes value(document_, predefined);
    sl.predefined = static_cast<uint8_t>(value.number("value", UINT8_MAX).value_or(0));
    value.finish();
    return sl;
  }
  sl.fields.emplace();
  if (const Element custom = element.child("custom"))
    read_fields(custom, *sl.fields, [](auto& of, auto& pass) { sl_config_fields(of, pass); });
  return sl;
}

std::vector<uint8_t> XmtDescriptorReader::read_bifs_config(Element element, uint8_t version) {
  BifsConfig config;
  config.version = version;
  read_fields(element, config, [](auto& of, auto& pass) { bifs_config_widths(of, pass); });
  const Element stream = element.child("commandStream");
  XmtAttributes attributes(document_, stream);
  config.pixel_metric = stream && attributes.flag("pixelMetric").value_or(false);
  attributes.finish();
  if (const Element size = stream.child("size")) {
    XmtAttributes pixels(document_, size);
    const auto width = pixels.number("pixelWidth", UINT16_MAX);
    const auto height = pixels.number("pixelHeight", UINT16_MAX);
    pixels.finish();
    config.size = DisplaySize{static_cast<uint16_t>(width.value_or(0)),
                              static_cast<uint16_t>(height.value_or(0))};
  }
  auto bytes = write_config(config);
  if (bytes.ok()) return std::move(bytes).value();
  document_.fail(document_.name(element), bytes.error().text);
  return {};
}

std::vector<uint8_t> XmtDescriptorReader::read_bytes(XmtAttributes& attributes) {
  const auto source = attributes.find("src");
  attributes.finish();
  if (!source) return {};
  const std::string bytes = values_.read_bytes(*source);
  return {bytes.begin(), bytes.end()};
}

bool XmtDescriptorReader::is_command(std::string_view name) { return contains(kCommands, name); }

std::vector<uint16_t> XmtDescriptorReader::read_ids(XmtAttributes& attributes, const char* name,
                                                    std::string_view prefix, uint64_t largest) {
  std::vector<uint16_t> ids;
  for (std::string_view word : words_of(attributes.find(name).value_or(std::string_view{}))) {
    const std::string_view whole = word;
    if (word.starts_with(prefix)) word.remove_prefix(prefix.size());
    const auto id = xmt_number(word, largest);
    if (!id)
      document_.fail(whole, std::string(name) + " " + quoted(whole) + " [expected " +
                                std::string(prefix) + "0 to " + std::to_string(largest) + "]");
    if (!id || !values_.take(whole, 1, sizeof(uint16_t))) break;
    ids.push_back(static_cast<uint16_t>(*id));
  }
  return ids;
}

OdCommand XmtDescriptorReader::read_command(Element element) {
  constexpr uint64_t kLargestId = 1023;
  const std::string_view name = document_.name(element);
  XmtAttributes attributes(document_, element);
  if (!values_.take(name, 1, sizeof(OdCommand))) return {};
  if (name == "ObjectDescriptorUpdate") {
    attributes.finish();
    OdUpdate update;
    read_parts(element, update.objects, {});
    return {update};
  }
  if (name == "UnknownODCommand") {
    const auto tag = attributes.number("tag", UINT8_MAX);
    return {UnknownOdCommand{static_cast<uint8_t>(tag.value_or(0)), read_bytes(attributes)}};
  }
  const auto objects = read_ids(attributes, "objectDescriptorId", "od", kLargestId);
  const uint16_t object = objects.empty() ? uint16_t{0} : objects[0];
  if (name == "ObjectDescriptorRemove") {
    attributes.finish();
    return {OdRemove{objects}};
  }
  if (objects.size() != 1)
    document_.fail(attributes.where(), std::string(name) + ": " + std::to_string(objects.size()) +
                                           " objects in objectDescriptorId [expected one]");
  if (name == "ES_DescriptorUpdate") {
    attributes.finish();
    EsUpdate update{object, false, {}};
    read_parts(element, update.streams, {});
    return {update};
  }
  EsRemove remove{object, attributes.find("refIndex").has_value(), {}};
  remove.streams = remove.references ? read_ids(attributes, "refIndex", "", UINT16_MAX)
                                     : read_ids(attributes, "ES_ID", "es", UINT16_MAX);
  attributes.finish();
  return {remove};
}

}  // namespace afx::bifs
