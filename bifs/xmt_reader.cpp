// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/xmt_reader.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bifs/xmt_descriptor_reader.h"
#include "bifs/xmt_document.h"
#include "bifs/xmt_scene_reader.h"
#include "nodes/text_cursor.h"

namespace afx::bifs {

namespace {

class XmtReader {
 public:
  XmtReader(std::string_view text, const Limits& limits, Diagnostics& diagnostics)
      : document_(text, limits, diagnostics),
        scene_(document_, presentation_.scene, limits),
        descriptors_(document_, scene_.values()) {
    presentation_.initial.in_file = false;
  }

  Result<Presentation> read() {
    const pugi::xml_node root = document_.root();
    if (root && document_.name(root) != "XMT-A")
      document_.fail(document_.name(root),
                     "found " + nodes::quoted(document_.name(root)) + " [expected XMT-A]");
    read_header(root);
    for (const pugi::xml_node part : root.children()) {
      if (document_.name(part) == "Body") {
        read_body(part);
      } else if (document_.name(part) != "Header") {
        refuse(part, "Header or Body");
      }
    }
    scene_.finish();
    if (!document_.ok()) return document_.error();
    std::stable_sort(presentation_.units.begin(), presentation_.units.end(),
                     [](const AccessUnit& a, const AccessUnit& b) { return a.time < b.time; });
    return std::move(presentation_);
  }

 private:
  void refuse(pugi::xml_node element, std::string_view expected) {
    const bool is_element = element.type() == pugi::node_element;
    const std::string_view what = is_element ? document_.name(element) : document_.value(element);
    document_.fail(what,
                   "found " + nodes::quoted(what) + " [expected " + std::string(expected) + "]");
  }

  void read_header(pugi::xml_node root) {
    const pugi::xml_node header = root.child("Header");
    for (const pugi::xml_node part : header.children()) {
      if (document_.name(part) != "InitialObjectDescriptor")
        return refuse(part, "InitialObjectDescriptor");
      presentation_.initial = descriptors_.read_initial(part);
    }
    scene_stream_.ticks = timestamp_resolution(scene_stream(presentation_.initial));
    descriptor_stream_.ticks =
        timestamp_resolution(object_descriptor_stream(presentation_.initial));
  }

  struct Stream {
    uint32_t ticks = 1000;  ///< a second
    bool begun = false;     ///< it has an access unit
    uint64_t last = 0;      ///< time of its last access unit
  };

  /// An access unit of each stream, begun when the first command for it is read.
  struct Units {
    std::optional<size_t> scene, descriptors;  ///< places in Presentation::units
    double seconds = 0;
    std::optional<bool> random_access;
  };

  void read_body(pugi::xml_node body) {
    for (const pugi::xml_node part : body.children()) {
      if (!document_.ok()) return;
      if (document_.name(part) == "par") {
        read_par(part);
      } else {
        read_command(part, at_start_);
      }
    }
  }

  void read_par(pugi::xml_node par) {
    XmtAttributes attributes(document_, par);
    Units units;
    if (const auto begin = attributes.find("begin")) {
      units.seconds = scene_.values().read_double(*begin);
      if (!(units.seconds >= 0) || !std::isfinite(units.seconds))
        document_.fail(*begin, "begin " + nodes::quoted(*begin) + " [expected seconds, from 0]");
    }
    units.random_access = attributes.flag("isRAP");
    attributes.finish();
    for (const pugi::xml_node command : par.children())
      if (document_.ok()) read_command(command, units);
  }

  void read_command(pugi::xml_node element, Units& units) {
    if (element.type() != pugi::node_element) return refuse(element, "a command");
    if (XmtDescriptorReader::is_command(document_.name(element))) {
      OdCommand command = descriptors_.read_command(element);
      auto* unit = unit_of<OdCommands>(element, units, units.descriptors, descriptor_stream_);
      if (unit != nullptr) unit->push_back(std::move(command));
      return;
    }
    std::optional<Command> command = scene_.read_command(element);
    auto* unit = unit_of<std::vector<Command>>(element, units, units.scene, scene_stream_);
    if (unit != nullptr && command) unit->push_back(std::move(*command));
  }

  /// The commands of the access unit at work; nullptr after a failure.
  template <class Commands>
  Commands* unit_of(pugi::xml_node element, const Units& units, std::optional<size_t>& place,
                    Stream& stream) {
    constexpr double kLargest = 18446744073709549568.0;  // the largest double below 2^64
    const double time = std::round(units.seconds * stream.ticks);
    if (time > kLargest)
      document_.fail(document_.name(element), "a time that does not fit in 64 bits");
    if (!scene_.values().take(document_.name(element), 1, sizeof(AccessUnit))) return nullptr;
    if (static_cast<uint64_t>(time) < stream.last)
      document_.fail(document_.name(element),
                     "a command before those above [expected times that "
                     "do not go back]");
    if (!document_.ok()) return nullptr;
    stream.last = static_cast<uint64_t>(time);
    if (!place) {
      const bool first = !std::exchange(stream.begun, true);
      place = presentation_.units.size();
      presentation_.units.push_back(
          {static_cast<uint64_t>(time), units.random_access.value_or(first), Commands{}});
    }
    return std::get_if<Commands>(&presentation_.units[*place].commands);
  }

  Presentation presentation_;
  XmtDocument document_;
  XmtSceneReader scene_;
  XmtDescriptorReader descriptors_;
  Stream scene_stream_, descriptor_stream_;
  Units at_start_;
};

}  // namespace

Result<Presentation> read_xmt(std::string_view text, const Limits& limits,
                              Diagnostics& diagnostics) {
  return XmtReader(text, limits, diagnostics).read();
}

}  // namespace afx::bifs
