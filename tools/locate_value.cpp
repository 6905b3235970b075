// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/locate_value.h"

#include <charconv>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "afx/file.h"
#include "afx/octree_stream.h"
#include "bifs/mp4_presentation_reader.h"
#include "codec/octree_symbol_place.h"
#include "tools/scene_input.h"

namespace afx::tools {
namespace {

using conformance::Form;
using conformance::Question;
using Json = nlohmann::ordered_json;
using Parts = std::vector<std::string>;

Parts parts_of(const std::string& pointer) {
  Parts parts;
  for (size_t at = 0; at < pointer.size();) {
    const size_t end = std::min(pointer.find('/', at + 1), pointer.size());
    parts.push_back(pointer.substr(at + 1, end - at - 1));
    at = end;
  }
  return parts;
}

std::optional<uint64_t> number_of(const std::string& text) {
  uint64_t number = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (failure != std::errc() || end != text.data() + text.size()) return {};
  return number;
}

/// "/octreeResolution", "/frames/0/octree/12": header elements, or symbols of a frame.
std::optional<uint64_t> locate_in_octree(std::span<const uint8_t> data, const Parts& parts,
                                         const Limits& limits) {
  Diagnostics ignored;
  std::optional<uint64_t> header;
  const codec::Trace trace = [&](const codec::TraceElement& element) {
    if (element.path.substr(element.path.rfind('/') + 1) == parts[0]) header = element.bit;
  };
  OctreeDecodeOptions how;
  how.limits = limits;
  how.trace = &trace;
  const DecodedOctreeStream decoded = decode_octree_stream(data, how, ignored);
  if (parts.size() < 4 || parts[0] != "frames") return header;
  const auto frame = number_of(parts[1]), index = number_of(parts[3]);
  if (!frame || !index || *frame >= decoded.infos.size()) return {};
  const uint64_t byte = decoded.infos[*frame].byte;
  const auto bit = codec::octree_symbol_bit(
      data.subspan(byte), decoded.stream.frames[*frame], octree_levels(decoded.stream.resolution),
      decoded.stream.textures, {parts[2] == "voxelImageIndex", *index});
  return bit ? byte * 8 + *bit : bit;
}

/// An element of the command that is looked at.
struct Element {
  uint64_t bit;
  std::string path;
};

bool ends_with_part(std::string_view path, std::string_view part) {
  return path.ends_with(part) && path.size() > part.size() &&
         path[path.size() - part.size() - 1] == '/';
}

/// The elements of one command of one access unit, in order; with what follows of the unit behind
/// its last command.
std::vector<Element> command_elements(const CodedScene& scene, uint64_t unit, uint64_t command,
                                      const Limits& limits, Json& document) {
  std::vector<Element> elements;
  const std::string prefix = std::to_string(unit) + "/";
  uint64_t commands = 0;
  const codec::Trace trace = [&](const codec::TraceElement& element) {
    if (!element.path.starts_with(prefix)) return;
    if (element.path == prefix + "commandFrame/commandType") ++commands;
    if (commands == command + 1) elements.push_back({element.bit, std::string(element.path)});
  };
  bifs::PresentationDecodeOptions how;
  how.limits = limits;
  how.drop_coding_quantizers = false;
  how.trace = &trace;
  std::string text;
  Diagnostics ignored;
  const auto add = [&text](std::string_view piece) {
    text += piece;
    return Status();
  };
  if (bifs::decode_as_json(scene.source, scene.movie, how, add, ignored).ok())
    document = Json::parse(text, nullptr, false);
  return elements;
}

/// Where in a command a pointer leads: to which of its nodes, in the order of their beginnings, and
/// into which field.
struct NodePlace {
  size_t node = 0;  ///< from 0
  std::string type;
  std::string field;
  size_t value = 0;  ///< of the numbers of the field, from 0
};

/// The nodes that begin in a document, itself among them.
size_t count_nodes(const Json& document) {
  size_t count = document.is_object() && document.contains("node") && document["node"].is_string();
  if (document.is_structured())
    for (const Json& element : document) count += count_nodes(element);
  return count;
}

/// The place among the numbers of a field: "/3/1" in a list of vectors of three is 10.
size_t number_in_field(const Json& field, std::span<const std::string> rest) {
  if (rest.empty() || !field.is_array()) return 0;
  const size_t index = number_of(rest[0]).value_or(0);
  if (rest.size() == 1 || index >= field.size()) return index;
  return index * field[index].size() + number_of(rest[1]).value_or(0);
}

std::optional<NodePlace> place_in_command(const Json& command, std::span<const std::string> parts) {
  std::optional<NodePlace> place;
  const Json* at = &command;
  size_t before = 0;  // nodes that begin before `at`
  for (size_t i = 0; i < parts.size(); ++i) {
    if (at->is_object() && at->contains("node") && (*at)["node"].is_string()) {
      place = NodePlace{before++, (*at)["node"].get<std::string>(), {}, 0};
      if (i + 1 < parts.size() && parts[i] == "fields") {
        place->field = parts[i + 1];
        const auto& fields = (*at)["fields"];
        if (fields.contains(place->field))
          place->value = number_in_field(fields[place->field], parts.subspan(i + 2));
      }
    }
    const Json* next = nullptr;
    for (const auto& [name, member] : at->items()) {
      if (name == parts[i]) {
        next = &member;
        break;
      }
      before += count_nodes(member);
    }
    if (next == nullptr || !next->is_structured()) break;
    at = next;
  }
  return place;
}

/// The bit of the value, or of what holds it.
uint64_t bit_in_command(const std::vector<Element>& elements, const NodePlace& place) {
  size_t nodes = 0, at = 0;
  while (at < elements.size() &&
         !(ends_with_part(elements[at].path, "isUpdateable") && nodes++ == place.node))
    ++at;
  if (at == elements.size()) return elements.front().bit;
  const std::string node = elements[at].path.substr(0, elements[at].path.rfind('/') + 1);
  if (!ends_with_part(node.substr(0, node.size() - 1), place.type)) return elements.front().bit;
  uint64_t found = elements[at].bit;
  const std::string field = node + place.field + "/";
  size_t value = 0;
  for (bool seen = false; at < elements.size() && elements[at].path.starts_with(node); ++at) {
    if (!elements[at].path.starts_with(field)) continue;
    if (!std::exchange(seen, true)) found = elements[at].bit;
    if (elements[at].path.compare(field.size(), 2, "SF") == 0 && value++ == place.value)
      return elements[at].bit;
  }
  return found;
}

/// "/accessUnits/0/commands/1/node/fields/...".
std::optional<uint64_t> locate_in_scene(const CodedScene& scene, const Parts& parts,
                                        const Limits& limits) {
  const bifs::Mp4Track* track = bifs::scene_track(scene.movie);
  if (track == nullptr || parts.size() < 2 || parts[0] != "accessUnits") return {};
  const auto unit = number_of(parts[1]);
  if (!unit || *unit >= track->samples.size()) return {};
  const uint64_t begin = track->samples[*unit].offset * 8;
  if (parts.size() < 4 || parts[2] != "commands") return begin;
  const uint64_t command = number_of(parts[3]).value_or(0);
  Json document;
  const auto elements = command_elements(scene, *unit, command, limits, document);
  if (elements.empty()) return begin;
  const Json::json_pointer pointer("/accessUnits/" + parts[1] + "/commands/" + parts[3]);
  const auto place = document.is_object() && document.contains(pointer)
                         ? place_in_command(document[pointer], std::span(parts).subspan(4))
                         : std::nullopt;
  return begin + (place ? bit_in_command(elements, *place) : elements.front().bit);
}

}  // namespace

std::optional<uint64_t> locate_value(const Question& question, const std::string& pointer,
                                     const Limits& limits) {
  const Parts parts = parts_of(pointer);
  if (parts.empty()) return {};
  auto file = MappedFile::open_regular(question.path, limits);
  if (!file.ok()) return {};
  if (question.form == Form::octree) return locate_in_octree(file.value().bytes(), parts, limits);
  if (question.form != Form::commands) return {};
  const Input input{question.path, kind_of_format(question.kind), std::move(file).value()};
  if (!is_coded_scene(input.kind)) return {};
  Diagnostics ignored;
  const auto scene = open_coded_scene(input, limits, ignored);
  return scene.ok() ? locate_in_scene(scene.value(), parts, limits) : std::nullopt;
}

}  // namespace afx::tools
