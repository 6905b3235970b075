// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "conformance/generator/told_commands.h"

#include <utility>

namespace afx::conformance {

using nlohmann::json;

namespace {

bool is_image(const json& value) { return value.is_object() && value.contains("pixels"); }

/// Whether `object` has the name that its ID stands for.
bool has_made_name(const json& object) {
  const auto id = object.find("id");
  const auto name = object.find("name");
  if (id == object.end() || name == object.end()) return false;
  const char letter = object.contains("from") ? 'R' : 'N';
  return *name == letter + std::to_string(id->get<uint64_t>() - 1);
}

void drop(json& value, const Forgiven& forgiven) {
  if (value.is_object()) {
    if (forgiven.names && has_made_name(value)) value.erase("name");
    if (forgiven.positions && value.value("position", json()) == 0) value["position"] = "first";
    if (forgiven.images && value.contains("node") && value["node"].is_string()) {
      json& fields = value["fields"];
      for (auto at = fields.begin(); at != fields.end();)
        at = is_image(*at) || (value["node"] == "Script" && *at == json::array()) ? fields.erase(at)
                                                                                  : std::next(at);
    }
  }
  for (auto& inner : value)
    if (inner.is_structured()) drop(inner, forgiven);
}

}  // namespace

Status ToldCommands::begin_frame(uint64_t time, bool random_access) {
  text_ += text_.empty() ? "" : ",\n";
  text_ += R"({"time": )" + std::to_string(time) +
           (random_access ? R"(, "random_access": true)" : "") + R"(, "commands": [)";
  first_ = true;
  return {};
}

Status ToldCommands::add(const bifs::Command& command, const nodes::Scene& before) {
  if (!std::exchange(first_, false)) text_ += ", ";
  text_ += writer_.write(command, before);
  return {};
}

Status ToldCommands::end_frame() {
  text_ += "]}";
  return {};
}

json without(json commands, const Forgiven& forgiven) {
  drop(commands, forgiven);
  return commands;
}

}  // namespace afx::conformance
