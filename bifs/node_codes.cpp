// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/node_codes.h"

#include <array>
#include <bit>
#include <map>
#include <utility>
#include <vector>

namespace afx::bifs {

namespace {

using nodes::NodeDataType;
using nodes::NodeDefinition;

/// The nodes of one data type and version, in order of their codes from the first.
using CodeTable = std::vector<const NodeDefinition*>;

constexpr uint32_t first_code(unsigned version) {
  return version == kProtoVersion ? kProtoCode + 1 : 1;
}

/// All code tables: one pass over the definitions.
class CodeTables {
 public:
  CodeTables() {
    const size_t types = nodes::definitions().data_types().size();
    tables_.resize(types);
    for (const NodeDefinition& node : nodes::definitions().nodes()) {
      if (node.version == 0 || node.version > kVersions) continue;
      for (size_t t = 0; t < types; ++t) {
        const NodeDataType type{static_cast<uint8_t>(t)};
        if (!contains(node.data_types, type)) continue;
        CodeTable& table = tables_[t][node.version - 1];
        codes_[{&node, type.number}] =
            first_code(node.version) + static_cast<uint32_t>(table.size());
        table.push_back(&node);
      }
    }
  }

  [[nodiscard]] const CodeTable& table(NodeDataType type, unsigned version) const {
    static const CodeTable kNone;
    const bool known = type.number < tables_.size() && version >= 1 && version <= kVersions;
    return known ? tables_[type.number][version - 1] : kNone;
  }

  [[nodiscard]] std::optional<uint32_t> code(const NodeDefinition& node, NodeDataType type) const {
    const auto found = codes_.find({&node, type.number});
    if (found == codes_.end()) return std::nullopt;
    return found->second;
  }

 private:
  std::vector<std::array<CodeTable, kVersions>> tables_;
  std::map<std::pair<const NodeDefinition*, uint8_t>, uint32_t> codes_;
};

const CodeTables& code_tables() {
  static const CodeTables tables;
  return tables;
}

}  // namespace

unsigned bits_for(uint64_t x) { return static_cast<unsigned>(std::bit_width(x)); }

unsigned node_code_bits(NodeDataType type, unsigned version) {
  const CodeTable& table = code_tables().table(type, version);
  return bits_for(first_code(version) + table.size() - 1);
}

std::optional<uint32_t> node_code(const NodeDefinition& node, NodeDataType type) {
  return code_tables().code(node, type);
}

const NodeDefinition* node_of_code(NodeDataType type, unsigned version, uint32_t code) {
  const CodeTable& table = code_tables().table(type, version);
  const uint32_t first = first_code(version);
  return code < first || code - first >= table.size() ? nullptr : table[code - first];
}

uint32_t field_count(const NodeDefinition& node, nodes::IndexMode mode) {
  return static_cast<uint32_t>(node.fields_in(mode).size());
}

unsigned field_index_bits(const NodeDefinition& node, nodes::IndexMode mode) {
  const uint32_t count = field_count(node, mode);
  return count == 0 ? 0 : bits_for(count - 1);
}

}  // namespace afx::bifs
