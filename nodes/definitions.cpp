// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "nodes/definitions.h"

#include <cassert>
#include <utility>

#include "nodes/interface_reader.h"

namespace afx::nodes {

namespace {

constexpr size_t kMaxDataTypes = 64;  // bits of NodeDataTypes

/// Reads one definition file.
class DefinitionReader {
 public:
  DefinitionReader(Definitions& out, const DefinitionText& file)
      : out_(out), in_(file.text, diagnostics_), values_(in_, limits_) {
    const std::string_view name = file.name;  // "v5.nodes"
    version_ = name.size() > 1 ? static_cast<uint8_t>(name[1] - '0') : uint8_t{0};
    rules_.data_type = [this](std::string_view type) { return out_.intern_data_type(type); };
    rules_.read_nodes = [this](const FieldDefinition& field) { return read_no_nodes(field); };
  }

  Status read() {
    while (!in_.at_end()) read_node();
    if (!in_.ok()) return in_.error();
    return {};
  }

 private:
  void read_node() {
    if (!in_.accept_word("NODE")) return in_.fail_expected("NODE");
    const size_t begin = (in_.skip_space(), in_.offset());
    NodeDefinition node;
    node.version = version_;
    node.name = std::string(in_.take_word());
    read_classes(node);
    InterfaceReader(in_, values_, rules_).read_interface(node);
    const std::string name = node.name;
    if (in_.ok() && !out_.add(std::move(node)))
      in_.fail(Errc::malformed, begin, "a second NODE " + quoted(name));
  }

  void read_classes(NodeDefinition& node) {
    if (!in_.expect('{', "the name of the node")) return;
    if (!in_.accept_word("NDT")) return in_.fail_expected("NDT");
    while (!in_.accept('}')) {
      const std::string_view word = in_.take_word();
      if (word.empty()) return in_.fail_expected("a node data type, WITHDRAWN, SCRIPT or '}'");
      if (word == "WITHDRAWN") {
        node.withdrawn = true;
      } else if (word == "SCRIPT") {
        node.script = true;
      } else if (const auto type = out_.intern_data_type(word)) {
        node.data_types |= NodeDataTypes{1} << type->number;
      } else {
        in_.fail_expected("no more than 64 node data types");
      }
    }
  }

  /// The definitions have no nodes in defaults: NULL and [] only.
  FieldValue read_no_nodes(const FieldDefinition& field) {
    const bool read =
        is_multiple(field.type) ? in_.accept('[') && in_.accept(']') : in_.accept_word("NULL");
    if (!read) in_.fail_expected(is_multiple(field.type) ? "[]" : "NULL");
    return zero_value(field.type);
  }

  Definitions& out_;
  Diagnostics diagnostics_;
  Limits limits_;
  TextCursor in_;
  ValueReader values_;
  InterfaceRules rules_;
  uint8_t version_ = 0;
};

Definitions read_compiled_in() {
  Result<Definitions> read = read_definitions({kDefinitionTexts, kDefinitionTextCount});
  assert(read.ok());
  return read.ok() ? std::move(read).value() : Definitions{};
}

}  // namespace

const NodeDefinition* Definitions::find(std::string_view name) const {
  const auto found = by_name_.find(name);
  return found == by_name_.end() ? nullptr : found->second;
}

std::optional<NodeDataType> Definitions::find_data_type(std::string_view name) const {
  for (size_t i = 0; i < data_types_.size(); ++i)
    if (data_types_[i] == name) return NodeDataType{static_cast<uint8_t>(i)};
  return std::nullopt;
}

std::optional<NodeDataType> Definitions::intern_data_type(std::string_view name) {
  if (const auto known = find_data_type(name)) return known;
  if (data_types_.size() == kMaxDataTypes) return std::nullopt;
  data_types_.emplace_back(name);
  return NodeDataType{static_cast<uint8_t>(data_types_.size() - 1)};
}

bool Definitions::add(NodeDefinition node) {
  const auto [entry, added] = by_name_.emplace(node.name, nullptr);
  if (!added) return false;
  nodes_.push_back(std::move(node));
  entry->second = &nodes_.back();
  return true;
}

Result<Definitions> read_definitions(std::span<const DefinitionText> texts) {
  Definitions out;
  for (const DefinitionText& file : texts) {
    Status status = DefinitionReader(out, file).read();
    if (status.ok()) continue;
    status.error().file = file.name;
    return std::move(status).error();
  }
  return out;
}

const Definitions& definitions() {
  static const Definitions table = read_compiled_in();
  return table;
}

}  // namespace afx::nodes
