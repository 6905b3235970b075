// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "nodes/node_view.h"

#include <utility>

namespace afx::nodes {

NodeView::NodeView(const Scene& scene, NodeId node, std::shared_ptr<const Instance> inside)
    : scene_(&scene), id_(node), inside_(std::move(inside)) {
  // A PROTO instance is seen as the first node of the body.
  while (id_.valid() && scene.node(id_).proto.valid()) {
    const Proto& proto = scene.proto(scene.node(id_).proto);
    const std::vector<NodeId>& roots = scene.scope(proto.body).roots;
    const uint32_t depth = inside_ ? inside_->depth + 1 : 1;
    const bool nothing = proto.external || roots.empty() || depth > kMaxInstances;
    if (!nothing) inside_ = std::make_shared<const Instance>(Instance{id_, inside_, depth});
    id_ = nothing ? NodeId{} : roots[0];
  }
}

std::string_view NodeView::type() const {
  return valid() ? std::string_view(node().definition->name) : std::string_view("NULL");
}

std::string NodeView::label() const {
  std::string out(type());
  if (valid() && !node().name.empty()) out += " \"" + node().name + '"';
  return out;
}

std::vector<uint32_t> NodeView::path() const {
  std::vector<uint32_t> out;
  if (!valid()) return out;
  out.push_back(id_.value);
  for (const Instance* at = inside_.get(); at != nullptr; at = at->outer.get())
    out.push_back(at->node.value);
  return out;
}

NodeView::Resolved NodeView::resolve(FieldIndex field) const {
  NodeId id = id_;
  const std::shared_ptr<const Instance>* inside = &inside_;
  // An IS link leads to the field of the instance around; that may be linked itself.
  for (;;) {
    const Node& at = scene_->node(id);
    const IsLink* link = nullptr;
    for (const IsLink& candidate : at.links)
      if (candidate.field == field) link = &candidate;
    if (link == nullptr || *inside == nullptr) break;
    const Instance& instance = **inside;
    const FieldIndex outer_field = link->interface_field;
    const bool given = scene_->given(instance.node, outer_field) != nullptr;
    const bool linked = !given && is_linked(instance.node, outer_field);
    // The nodes of an interface's default stand in the body, those that the instance gives outside.
    if (!given && !linked) return {&scene_->value(instance.node, outer_field), inside};
    id = instance.node;
    field = outer_field;
    inside = &instance.outer;
  }
  return {&scene_->value(id, field), inside};
}

bool NodeView::is_linked(NodeId id, FieldIndex field) const {
  for (const IsLink& link : scene_->node(id).links)
    if (link.field == field) return true;
  return false;
}

NodeView NodeView::child(std::string_view field) const {
  if (!valid()) return {};
  const FieldIndex index = node().definition->find(field);
  if (!index.valid()) return {};
  const Resolved resolved = resolve(index);
  const auto* id = std::get_if<NodeId>(resolved.value);
  return id != nullptr && id->valid() ? NodeView(*scene_, *id, *resolved.inside) : NodeView();
}

NodeView::Nodes NodeView::nodes_in(std::string_view field) const {
  const FieldIndex index = valid() ? node().definition->find(field) : FieldIndex{};
  if (!index.valid()) return {};
  const Resolved resolved = resolve(index);
  return {std::get_if<std::vector<NodeId>>(resolved.value), resolved.inside};
}

size_t NodeView::child_count(std::string_view field) const {
  const Nodes nodes = nodes_in(field);
  return nodes.ids == nullptr ? 0 : nodes.ids->size();
}

NodeView NodeView::child_at(std::string_view field, size_t index) const {
  const Nodes nodes = nodes_in(field);
  if (nodes.ids == nullptr || index >= nodes.ids->size()) return {};
  const NodeId id = (*nodes.ids)[index];
  return id.valid() ? NodeView(*scene_, id, *nodes.inside) : NodeView();
}

std::vector<NodeView> NodeView::children(std::string_view field) const {
  std::vector<NodeView> out;
  const Nodes nodes = nodes_in(field);
  if (nodes.ids == nullptr) return out;
  out.reserve(nodes.ids->size());
  for (const NodeId id : *nodes.ids) {
    out.push_back(id.valid() ? NodeView(*scene_, id, *nodes.inside) : NodeView());
  }
  return out;
}

}  // namespace afx::nodes
