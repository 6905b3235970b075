// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/noted_lists.h"

#include <algorithm>

namespace afx::bifs {

using nodes::FieldIndex;
using nodes::FieldValue;
using nodes::NodeId;
using nodes::Scene;

namespace {

/// Where a position lies in a list; none if there is no such element.
std::optional<size_t> place_in(size_t size, const Position& position) {
  if (size == 0) return std::nullopt;
  if (position.kind == Position::Kind::first) return 0;
  if (position.kind == Position::Kind::last) return size - 1;
  return position.index < size ? std::optional<size_t>(position.index) : std::nullopt;
}

/// A short text can say that one long list is copied again and again: so many nodes altogether.
constexpr uint64_t kMostCopied = uint64_t{1} << 24;

FieldRef first_list(const Scene& scene, NodeId node) {
  const auto& fields = scene.node(node).definition->fields();
  for (size_t i = 0; i < fields.size(); ++i)
    if (fields[i].type == nodes::FieldType::mf_node && fields[i].has_value())
      return {node, FieldIndex{i}};
  return {};
}

}  // namespace

void NotedLists::clear() {
  lists_.clear();
  integers_.clear();
  gone_.clear();
  copied_ = 0;
}

const std::vector<NodeId>* NotedLists::list(const Scene& scene, const FieldRef& field) {
  const List* found = find(scene, field);
  return found != nullptr ? &found->nodes : nullptr;
}

std::optional<uint32_t> NotedLists::index(const Scene& scene, const FieldRef& field) const {
  const auto noted = integers_.find({field.node, field.field});
  const auto* index = noted != integers_.end()
                          ? &noted->second
                          : std::get_if<int32_t>(&scene.value(field.node, field.field));
  if (index == nullptr || *index < 0) return std::nullopt;
  return static_cast<uint32_t>(*index);
}

NodeId NotedLists::element(const Scene& scene, XReplace command,
                           const std::vector<NodeId>& list) const {
  if (command.index_from) {
    const auto at = index(scene, *command.index_from);
    if (!at) return {};
    command.index_from.reset();
    command.position = Position{Position::Kind::index, *at};
  }
  return xreplace_element(scene, command, list);
}

/// The list as the nodes that have gone since it was asked for leave it.
NotedLists::List* NotedLists::find(const Scene& scene, const FieldRef& field) {
  if (!field.field.valid()) return nullptr;
  const auto* first = std::get_if<std::vector<NodeId>>(&scene.value(field.node, field.field));
  if (first == nullptr) return nullptr;
  const auto [entry, fresh] = lists_.try_emplace({field.node, field.field});
  List& list = entry->second;
  if (fresh) list.nodes = *first;
  for (; list.seen < gone_.size(); ++list.seen) {
    const NodeReplacement& gone = gone_[list.seen];
    if (gone.node.valid()) {
      std::replace(list.nodes.begin(), list.nodes.end(), gone.target, gone.node);
    } else {
      std::erase(list.nodes, gone.target);
    }
  }
  return &list;
}

void NotedLists::set(const Scene& scene, const FieldRef& field, const FieldValue& value) {
  if (const auto* integer = std::get_if<int32_t>(&value))
    integers_[{field.node, field.field}] = *integer;
  const auto* nodes = std::get_if<std::vector<NodeId>>(&value);
  List* const list = nodes != nullptr ? find(scene, field) : nullptr;
  if (list != nullptr) list->nodes = *nodes;
}

void NotedLists::insert(const Scene& scene, const FieldRef& field, const Position& position,
                        const FieldValue& value) {
  const auto* node = std::get_if<NodeId>(&value);
  List* const list = node != nullptr ? find(scene, field) : nullptr;
  if (list == nullptr) return;
  const bool last = position.kind == Position::Kind::last;
  const size_t size = list->nodes.size();
  const size_t at = last ? size : std::min<size_t>(position.index, size);
  list->nodes.insert(list->nodes.begin() + static_cast<ptrdiff_t>(at), *node);
}

bool NotedLists::replace(const Scene& scene, const FieldRef& field, const Position& position,
                         const FieldValue& value) {
  const auto* node = std::get_if<NodeId>(&value);
  List* const list = node != nullptr ? find(scene, field) : nullptr;
  const auto at = list != nullptr ? place_in(list->nodes.size(), position) : std::nullopt;
  if (at) list->nodes[*at] = *node;
  return at.has_value();
}

void NotedLists::erase(const Scene& scene, const FieldRef& field, const Position& position) {
  List* const list = find(scene, field);
  const auto at = list != nullptr ? place_in(list->nodes.size(), position) : std::nullopt;
  if (at) list->nodes.erase(list->nodes.begin() + static_cast<ptrdiff_t>(*at));
}

void NotedLists::note(const Scene& scene, const XReplace& command) {
  FieldRef target = command.target;
  std::optional<Position> position = command.position;
  if (command.index_from) {
    const auto at = index(scene, *command.index_from);
    if (!at) return;
    position = Position{Position::Kind::index, *at};
  }
  if (command.child_field) {
    target = *command.child_field;
    position.reset();
  }
  FieldValue value = command.value;
  if (command.value_from) {
    value = scene.value(command.value_from->node, command.value_from->field);
    const auto integer = integers_.find({command.value_from->node, command.value_from->field});
    if (integer != integers_.end()) value = integer->second;
    if (const List* from = find(scene, *command.value_from)) {
      if ((copied_ += from->nodes.size()) > kMostCopied) return;
      value = from->nodes;
    }
  }
  if (position) {
    replace(scene, target, *position, value);
  } else {
    set(scene, target, value);
  }
}

void NotedLists::note(const Scene& scene, const Command& command) {
  if (const auto* node = std::get_if<NodeInsertion>(&command)) {
    insert(scene, first_list(scene, node->target), node->position, node->node);
  } else if (const auto* one = std::get_if<IndexedValueInsertion>(&command)) {
    insert(scene, one->target, one->position, one->value);
  } else if (const auto* other = std::get_if<IndexedValueReplacement>(&command)) {
    replace(scene, other->target, other->position, other->value);
  } else if (const auto* gone = std::get_if<IndexedValueDeletion>(&command)) {
    erase(scene, gone->target, gone->position);
  } else if (const auto* some = std::get_if<MultipleIndexedReplacement>(&command)) {
    for (const IndexedValue& value : some->values)
      if (!replace(scene, some->target, {Position::Kind::index, value.index}, value.value)) break;
  } else if (const auto* whole = std::get_if<FieldReplacement>(&command)) {
    set(scene, whole->target, whole->value);
  } else if (const auto* fields = std::get_if<MultipleFieldReplacement>(&command)) {
    for (const nodes::FieldEntry& entry : fields->values)
      set(scene, {fields->target, entry.field}, entry.value);
  } else if (const auto* deletion = std::get_if<NodeDeletion>(&command)) {
    gone_.push_back({deletion->target, {}});
  } else if (const auto* replacement = std::get_if<NodeReplacement>(&command)) {
    gone_.push_back(*replacement);
  } else if (const auto* extended = std::get_if<XReplace>(&command)) {
    note(scene, *extended);
  }
}

}  // namespace afx::bifs
