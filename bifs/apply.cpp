// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/apply.h"

#include <algorithm>
#include <unordered_set>
#include <utility>

namespace afx::bifs {

namespace {

using nodes::FieldDefinition;
using nodes::FieldIndex;
using nodes::FieldType;
using nodes::FieldValue;
using nodes::NodeDefinition;
using nodes::NodeId;
using nodes::Scene;

Error refuse(std::string text) { return {Errc::bad_argument, {}, std::move(text)}; }

template <class T>
concept List = requires(T list, typename T::value_type element) {
  list.push_back(element);
}
&&!std::same_as<T, std::string>;

/// Calls `visit` for each node in a value.
template <class Visit>
void for_each_node(const FieldValue& value, Visit visit) {
  if (const auto* one = std::get_if<NodeId>(&value)) visit(*one);
  if (const auto* many = std::get_if<std::vector<NodeId>>(&value))
    for (const NodeId node : *many) visit(node);
}

/// Whether `wanted` stands in a value or below it.
bool reaches(const Scene& scene, const FieldValue& value, NodeId wanted) {
  std::vector<NodeId> open;
  std::unordered_set<uint32_t> seen;
  const auto add = [&](NodeId node) {
    if (node.valid() && seen.insert(node.value).second) open.push_back(node);
  };
  for_each_node(value, add);
  while (!open.empty()) {
    const NodeId node = open.back();
    open.pop_back();
    if (node == wanted) return true;
    for (const nodes::FieldEntry& entry : scene.node(node).values) for_each_node(entry.value, add);
  }
  return false;
}

class Applier {
 public:
  explicit Applier(Scene& scene) : scene_(scene) {}

  Status operator()(const NodeInsertion& c) {
    const NodeDefinition& definition = *scene_.node(c.target).definition;
    for (size_t i = 0; i < definition.fields().size(); ++i)
      if (definition.fields()[i].type == FieldType::mf_node && definition.fields()[i].has_value())
        return insert({c.target, FieldIndex{i}}, c.position, c.node);
    return refuse(definition.name + " has no list of nodes");
  }
  Status operator()(const IndexedValueInsertion& c) {
    return insert(c.target, c.position, c.value);
  }
  Status operator()(const RouteInsertion& c) {
    scene_.scope().routes.push_back(c.route);
    return {};
  }
  Status operator()(const NodeDeletion& c) {
    replace_everywhere(c.target, {});
    std::erase_if(scene_.scope().routes, [&](const nodes::Route& route) {
      return route.from == c.target || route.to == c.target;
    });
    return {};
  }
  Status operator()(const IndexedValueDeletion& c) {
    return change_list(c.target, [&](auto& list) -> Status {
      const std::optional<size_t> at = find(list.size(), c.position);
      if (!at) return refuse("a deletion behind the end of a list");
      list.erase(list.begin() + static_cast<ptrdiff_t>(*at));
      return {};
    });
  }
  Status operator()(const RouteDeletion& c) {
    const size_t gone = std::erase_if(scene_.scope().routes, [&](const nodes::Route& route) {
      return route.id == c.route_id && route.id != 0;
    });
    return gone > 0 ? Status{} : refuse("no ROUTE has the ID " + std::to_string(c.route_id));
  }
  Status operator()(const NodeReplacement& c) {
    if (!c.node.valid()) return (*this)(NodeDeletion{c.target, false});
    for (size_t i = 0; i < scene_.node_count(); ++i)
      if (refers(NodeId{i}, c.target) && reaches(scene_, c.node, NodeId{i}))
        return refuse("the new node would stand inside itself");
    replace_everywhere(c.target, c.node);
    return {};
  }
  Status operator()(const FieldReplacement& c) { return set(c.target, c.value); }
  Status operator()(const IndexedValueReplacement& c) {
    return replace_element(c.target, c.position, c.value);
  }
  Status operator()(const RouteReplacement& c) {
    for (nodes::Route& route : scene_.scope().routes) {
      if (route.id != c.route_id || route.id == 0) continue;
      route.from = c.from.node;
      route.from_field = c.from.field;
      route.to = c.to.node;
      route.to_field = c.to.field;
      return {};
    }
    return refuse("no ROUTE has the ID " + std::to_string(c.route_id));
  }
  Status operator()(const SceneReplacement& c) {
    scene_.scope().roots.clear();
    if (c.root.valid()) scene_.add_root(c.root);
    scene_.scope().routes = c.routes;
    return {};
  }
  Status operator()(const ProtoInsertion&) { return {}; }
  Status operator()(const ProtoDeletion& c) {
    for (const uint32_t id : c.proto_ids)
      forget_protos([&](const nodes::Proto& proto) { return proto.id == id; });
    return {};
  }
  Status operator()(const AllProtoDeletion&) {
    forget_protos([](const nodes::Proto&) { return true; });
    return {};
  }
  Status operator()(const MultipleIndexedReplacement& c) {
    for (const IndexedValue& value : c.values) {
      const Status done =
          replace_element(c.target, {Position::Kind::index, value.index}, value.value);
      if (!done.ok()) return done;
    }
    return {};
  }
  Status operator()(const MultipleFieldReplacement& c) {
    for (const nodes::FieldEntry& entry : c.values) {
      const Status done = set({c.target, entry.field}, entry.value);
      if (!done.ok()) return done;
    }
    return {};
  }
  Status operator()(const GlobalQuantizer&) { return {}; }
  Status operator()(const XReplace& c) {
    const FieldValue value =
        c.value_from ? scene_.value(c.value_from->node, c.value_from->field) : c.value;
    std::optional<Position> position = c.position;
    if (c.index_from) {
      const auto* index =
          std::get_if<int32_t>(&scene_.value(c.index_from->node, c.index_from->field));
      if (index == nullptr || *index < 0) return refuse("the index of an XReplace is no number");
      position = Position{Position::Kind::index, static_cast<uint32_t>(*index)};
    }
    if (!position) return set(c.target, value);
    if (!c.child_field) return replace_element(c.target, *position, value);
    const auto* list = std::get_if<std::vector<NodeId>>(&current(c.target));
    const NodeId child = list != nullptr ? xreplace_element(scene_, c, *list) : NodeId{};
    if (!child.valid() ||
        scene_.node(child).definition != scene_.node(c.child_field->node).definition)
      return refuse("the node of an XReplace is not there, or another");
    return set({child, c.child_field->field}, value);
  }

 private:
  /// The field with a value that a field stands for: set_x goes to x.
  FieldIndex stored(const FieldRef& target) {
    const NodeDefinition& definition = *scene_.node(target.node).definition;
    const FieldDefinition& field = definition.field(target.field);
    if (field.has_value()) return target.field;
    if (!field.name.starts_with("set_")) return {};
    const FieldIndex stem = definition.find(field.name.substr(4));
    const bool fits = stem.valid() && definition.field(stem).has_value() &&
                      definition.field(stem).type == field.type;
    return fits ? stem : FieldIndex{};
  }

  const FieldValue& current(const FieldRef& target) {
    static const FieldValue kNothing = false;
    const FieldIndex field = stored(target);
    return field.valid() ? scene_.value(target.node, field) : kNothing;
  }

  Status set(const FieldRef& target, FieldValue value) {
    const FieldIndex field = stored(target);
    if (!field.valid()) return {};  // an event: nothing keeps it
    const FieldDefinition& definition = scene_.node(target.node).definition->field(field);
    if (!holds(definition.type, value))
      return refuse(definition.name + ": a value of another type [expected " +
                    std::string(to_string(definition.type)) + "]");
    if (reaches(scene_, value, target.node))
      return refuse(definition.name + ": the node would stand inside itself");
    scene_.set_unchecked(target.node, field, std::move(value));
    return {};
  }

  /// Where a position lies in a list; none if there is no such element.
  static std::optional<size_t> find(size_t size, const Position& position) {
    if (size == 0) return std::nullopt;
    if (position.kind == Position::Kind::first) return 0;
    if (position.kind == Position::Kind::last) return size - 1;
    return position.index < size ? std::optional<size_t>(position.index) : std::nullopt;
  }

  /// Changes the list in a field, in place.
  template <class Change>
  Status change_list(const FieldRef& target, Change change) {
    const FieldIndex field = stored(target);
    if (!field.valid()) return {};
    if (scene_.given(target.node, field) == nullptr)
      scene_.set_unchecked(target.node, field, scene_.value(target.node, field));
    for (nodes::FieldEntry& entry : scene_.node(target.node).values) {
      if (entry.field != field) continue;
      return std::visit(
          [&]<class T>(T& list) -> Status {
            if constexpr (List<T>) {
              return change(list);
            } else {
              return refuse("the field is no list");
            }
          },
          entry.value);
    }
    return {};
  }

  /// An element of a list of T; none if it is of another type.
  template <class T>
  static const T* element(const FieldValue& value) {
    return std::get_if<T>(&value);
  }

  template <class Place>
  Status change_element(const FieldRef& target, const FieldValue& value, Place place) {
    if (reaches(scene_, value, target.node)) return refuse("the node would stand inside itself");
    return change_list(target, [&]<class T>(T& list) -> Status {
      using Element = typename T::value_type;
      if constexpr (std::is_same_v<Element, uint8_t>) {  // MFBool
        const bool* one = std::get_if<bool>(&value);
        return one != nullptr ? place(list, static_cast<uint8_t>(*one)) : wrong_type();
      } else {
        const auto* one = std::get_if<Element>(&value);
        return one != nullptr ? place(list, *one) : wrong_type();
      }
    });
  }
  static Status wrong_type() { return refuse("an element of another type than the list"); }

  Status insert(const FieldRef& target, const Position& position, const FieldValue& value) {
    return change_element(target, value, [&](auto& list, const auto& one) -> Status {
      const bool at_end = position.kind == Position::Kind::last ||
                          (position.kind == Position::Kind::index && position.index >= list.size());
      const size_t at = at_end ? list.size() : position.index;
      list.insert(list.begin() + static_cast<ptrdiff_t>(at), one);
      return {};
    });
  }

  Status replace_element(const FieldRef& target, const Position& position,
                         const FieldValue& value) {
    return change_element(target, value, [&](auto& list, const auto& one) -> Status {
      const std::optional<size_t> at = find(list.size(), position);
      if (!at) return refuse("a replacement behind the end of a list");
      list[*at] = one;
      return {};
    });
  }

  [[nodiscard]] bool refers(NodeId holder, NodeId target) const {
    bool found = false;
    for (const nodes::FieldEntry& entry : scene_.node(holder).values)
      for_each_node(entry.value, [&](NodeId node) { found = found || node == target; });
    return found;
  }

  /// Puts another node in every place of a node; no node: it goes from lists.
  void replace_everywhere(NodeId target, NodeId other) {
    const auto replace = [&](std::vector<NodeId>& list) {
      if (other.valid()) {
        std::replace(list.begin(), list.end(), target, other);
      } else {
        std::erase(list, target);
      }
    };
    for (size_t i = 0; i < scene_.node_count(); ++i) {
      for (nodes::FieldEntry& entry : scene_.node(NodeId{i}).values) {
        if (auto* one = std::get_if<NodeId>(&entry.value); one != nullptr && *one == target)
          *one = other;
        if (auto* many = std::get_if<std::vector<NodeId>>(&entry.value)) replace(*many);
      }
    }
    replace(scene_.scope().roots);
  }

  template <class Which>
  void forget_protos(Which which) {
    nodes::Scope& scope = scene_.scope();
    std::erase_if(scope.protos, [&](nodes::ProtoId id) { return which(scene_.proto(id)); });
    std::erase_if(scope.proto_names,
                  [&](const auto& entry) { return which(scene_.proto(entry.second)); });
  }

  Scene& scene_;
};

}  // namespace

Status apply_command(Scene& scene, const Command& command) {
  return std::visit(Applier(scene), command);
}

std::string_view command_name(const Command& command) {
  struct Name {
    std::string_view operator()(const NodeInsertion&) { return "NodeInsertion"; }
    std::string_view operator()(const IndexedValueInsertion&) { return "IndexedValueInsertion"; }
    std::string_view operator()(const RouteInsertion&) { return "ROUTEInsertion"; }
    std::string_view operator()(const NodeDeletion& c) {
      return c.extended ? "NodeDeletionEx" : "NodeDeletion";
    }
    std::string_view operator()(const IndexedValueDeletion&) { return "IndexedValueDeletion"; }
    std::string_view operator()(const RouteDeletion&) { return "ROUTEDeletion"; }
    std::string_view operator()(const NodeReplacement&) { return "NodeReplacement"; }
    std::string_view operator()(const FieldReplacement&) { return "FieldReplacement"; }
    std::string_view operator()(const IndexedValueReplacement&) {
      return "IndexedValueReplacement";
    }
    std::string_view operator()(const RouteReplacement&) { return "ROUTEReplacement"; }
    std::string_view operator()(const SceneReplacement&) { return "SceneReplacement"; }
    std::string_view operator()(const ProtoInsertion&) { return "PROTOListInsertion"; }
    std::string_view operator()(const ProtoDeletion&) { return "PROTODeletion"; }
    std::string_view operator()(const AllProtoDeletion&) { return "AllPROTODeletion"; }
    std::string_view operator()(const MultipleIndexedReplacement&) {
      return "MultipleIndexedReplacement";
    }
    std::string_view operator()(const MultipleFieldReplacement&) {
      return "MultipleFieldReplacement";
    }
    std::string_view operator()(const GlobalQuantizer&) { return "GlobalQuantizer"; }
    std::string_view operator()(const XReplace&) { return "XReplace"; }
  };
  return std::visit(Name{}, command);
}

NodeId xreplace_element(const Scene& scene, const XReplace& command,
                        const std::vector<NodeId>& list) {
  size_t at = 0;
  if (command.index_from) {
    const auto* index =
        std::get_if<int32_t>(&scene.value(command.index_from->node, command.index_from->field));
    if (index == nullptr || *index < 0) return {};
    at = static_cast<size_t>(*index);
  } else if (command.position && !list.empty()) {
    at = command.position->kind == Position::Kind::last ? list.size() - 1 : command.position->index;
  }
  return at < list.size() ? list[at] : NodeId{};
}

}  // namespace afx::bifs
