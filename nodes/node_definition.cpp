// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "nodes/node_definition.h"

#include <algorithm>
#include <utility>

namespace afx::nodes {

namespace {

constexpr std::string_view kEventKinds[] = {"field", "exposedField", "eventIn", "eventOut"};

}  // namespace

std::string_view to_string(EventKind kind) { return kEventKinds[static_cast<size_t>(kind)]; }

std::optional<EventKind> find_event_kind(std::string_view name) {
  for (size_t i = 0; i < std::size(kEventKinds); ++i)
    if (kEventKinds[i] == name) return static_cast<EventKind>(i);
  return std::nullopt;
}

FieldIndex NodeDefinition::find(std::string_view field_name) const {
  const auto found = by_name_.find(field_name);
  return found == by_name_.end() ? FieldIndex{} : found->second;
}

FieldIndex NodeDefinition::find_alias(std::string_view prefix, std::string_view suffix,
                                      std::string_view field_name) const {
  const FieldIndex exact = find(field_name);
  if (exact.valid()) return exact;
  if (!field_name.starts_with(prefix) || !field_name.ends_with(suffix)) return {};
  field_name.remove_prefix(prefix.size());
  field_name.remove_suffix(std::min(suffix.size(), field_name.size()));
  const FieldIndex found = find(field_name);
  const bool exposed = found.valid() && field(found).kind == EventKind::exposed_field;
  return exposed ? found : FieldIndex{};
}

FieldIndex NodeDefinition::find_event_in(std::string_view field_name) const {
  return find_alias("set_", "", field_name);
}

FieldIndex NodeDefinition::find_event_out(std::string_view field_name) const {
  return find_alias("", "_changed", field_name);
}

std::optional<uint32_t> NodeDefinition::index_in(IndexMode mode, FieldIndex field_index) const {
  const std::vector<FieldIndex>& list = fields_in(mode);
  const auto found = std::lower_bound(list.begin(), list.end(), field_index);
  if (found == list.end() || *found != field_index) return std::nullopt;
  return static_cast<uint32_t>(found - list.begin());
}

std::optional<NodeDataType> NodeDefinition::insertion_type() const {
  for (const FieldDefinition& f : fields_)
    if (f.type == FieldType::mf_node) return f.data_type;
  return std::nullopt;
}

FieldIndex NodeDefinition::add(FieldDefinition field) {
  const FieldIndex index{fields_.size()};
  if (fields_.size() >= kMaxFields || !by_name_.emplace(field.name, index).second) return {};
  const bool in = field.kind == EventKind::event_in || field.kind == EventKind::exposed_field;
  const bool out = field.kind == EventKind::event_out || field.kind == EventKind::exposed_field;
  const bool in_mode[kIndexModes] = {true, field.has_value(), in, out,
                                     in && field.anim_category != 0};
  for (size_t mode = 0; mode < kIndexModes; ++mode)
    if (in_mode[mode]) modes_[mode].push_back(index);
  fields_.push_back(std::move(field));
  return index;
}

}  // namespace afx::nodes
