// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <algorithm>
#include <unordered_map>

#include "nodes/scene.h"

namespace afx::nodes {

namespace {

/// Walks two scenes in step. Nodes and PROTOs that met at the same place stay partners from then
/// on.
class SceneComparison {
 public:
  SceneComparison(const Scene& a, const Scene& b) : a_(a), b_(b) {}

  bool scopes(ScopeId a_id, ScopeId b_id) {
    const Scope& a = a_.scope(a_id);
    const Scope& b = b_.scope(b_id);
    if (a.protos.size() != b.protos.size() || a.roots.size() != b.roots.size() ||
        a.routes.size() != b.routes.size())
      return false;
    for (size_t i = 0; i < a.protos.size(); ++i)
      if (!protos(a.protos[i], b.protos[i])) return false;
    return node_lists(a.roots, b.roots) &&
           std::equal(a.routes.begin(), a.routes.end(), b.routes.begin(),
                      [this](const Route& x, const Route& y) { return routes(x, y); });
  }

 private:
  bool protos(ProtoId a_id, ProtoId b_id) {
    const Proto& a = a_.proto(a_id);
    const Proto& b = b_.proto(b_id);
    proto_partner_[a_id.value] = b_id;
    return a.external == b.external && a.urls == b.urls &&
           interfaces(a.interface, b.interface, 0) && scopes(a.body, b.body);
  }

  /// Fields from number `first` on.
  bool interfaces(const NodeDefinition& a, const NodeDefinition& b, size_t first) {
    if (a.name != b.name || a.fields().size() != b.fields().size()) return false;
    for (size_t i = first; i < a.fields().size(); ++i) {
      const FieldDefinition& x = a.fields()[i];
      const FieldDefinition& y = b.fields()[i];
      if (x.name != y.name || x.kind != y.kind || x.type != y.type ||
          x.quant_category != y.quant_category || x.quant_bits != y.quant_bits ||
          x.anim_category != y.anim_category || x.bounds != y.bounds ||
          !values(x.default_value, y.default_value))
        return false;
    }
    return true;
  }

  bool nodes(NodeId a_id, NodeId b_id) {
    if (!a_id.valid() || !b_id.valid()) return a_id.valid() == b_id.valid();
    const auto [partner, is_new] = partner_.emplace(a_id.value, b_id);
    const auto [back, back_is_new] = back_partner_.emplace(b_id.value, a_id);
    if (!is_new || !back_is_new) return partner->second == b_id && back->second == a_id;
    const Node& a = a_.node(a_id);
    const Node& b = b_.node(b_id);
    if (a.name != b.name || !same_type(a, b)) return false;
    return all_values(a_id, b_id) && links(a.links, b.links);
  }

  bool same_type(const Node& a, const Node& b) {
    if (a.proto.valid() != b.proto.valid()) return false;
    if (a.proto.valid()) {
      const auto partner = proto_partner_.find(a.proto.value);
      return partner != proto_partner_.end() && partner->second == b.proto;
    }
    if (!a.own_definition && !b.own_definition) return a.definition == b.definition;
    return interfaces(*a.definition, *b.definition, 0);
  }

  bool all_values(NodeId a_id, NodeId b_id) {
    // Fields that neither has given are equal already; so only given ones are looked at.
    const auto same_as_given = [&](const Node& given) {
      return std::all_of(given.values.begin(), given.values.end(), [&](const FieldEntry& entry) {
        return values(a_.value(a_id, entry.field), b_.value(b_id, entry.field));
      });
    };
    return same_as_given(a_.node(a_id)) && same_as_given(b_.node(b_id));
  }

  bool values(const FieldValue& a, const FieldValue& b) {
    if (a.index() != b.index()) return false;
    if (const auto* node = std::get_if<NodeId>(&a)) return nodes(*node, *std::get_if<NodeId>(&b));
    if (const auto* list = std::get_if<std::vector<NodeId>>(&a))
      return node_lists(*list, *std::get_if<std::vector<NodeId>>(&b));
    return same_bits(a, b);
  }

  bool node_lists(const std::vector<NodeId>& a, const std::vector<NodeId>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [this](NodeId x, NodeId y) { return nodes(x, y); });
  }

  static bool links(std::vector<IsLink> a, std::vector<IsLink> b) {
    const auto by_field = [](const IsLink& x, const IsLink& y) { return x.field < y.field; };
    std::stable_sort(a.begin(), a.end(), by_field);
    std::stable_sort(b.begin(), b.end(), by_field);
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const IsLink& x, const IsLink& y) {
      return x.field == y.field && x.interface_field == y.interface_field;
    });
  }

  bool routes(const Route& a, const Route& b) {
    return a.name == b.name && a.from_field == b.from_field && a.to_field == b.to_field &&
           nodes(a.from, b.from) && nodes(a.to, b.to);
  }

  const Scene& a_;
  const Scene& b_;
  std::unordered_map<uint32_t, NodeId> partner_, back_partner_;
  std::unordered_map<uint32_t, ProtoId> proto_partner_;
};

}  // namespace

bool equal(const Scene& a, const Scene& b) {
  return SceneComparison(a, b).scopes(Scene::kMain, Scene::kMain);
}

}  // namespace afx::nodes
