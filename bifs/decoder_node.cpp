// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Source: ISO/IEC 14496-11, SFNode and node descriptions (clauses not checked); spec/bifs.md 6, 7.
#include <algorithm>
#include <utility>

#include "bifs/command_codes.h"
#include "bifs/decoder_frame.h"
#include "bifs/node_codes.h"

namespace afx::bifs {

using nodes::FieldDefinition;
using nodes::FieldIndex;
using nodes::IndexMode;
using nodes::NodeDefinition;
using nodes::NodeId;
using nodes::ProtoId;

NodeId FrameDecoder::read_node(nodes::NodeDataType type) {
  const Depth depth(*this);
  if (u(1, "isReused") != 0) return read_reused(type);
  const NodeId node = read_node_type(type);
  if (!ok()) return {};
  const NodeDefinition& layout = node_layout(*state_.scene.node(node).definition);
  const Part part(*this, layout.name);
  uint32_t id = 0;
  if (u(1, "isUpdateable") != 0) {
    id = u(state_.config.node_id_bits, "nodeID") + 1;
    if (id == uint32_t{1} << state_.config.node_id_bits)
      fail(Errc::malformed, "the node has the ID that means the NULL node");
    if (state_.use_names) {
      const std::string name = read_name("nodeName");
      if (ok() && !state_.scene.set_name(node, name).ok())
        warn("name_twice", "a second node of the name '" + name + "', which stays without");
    }
  }
  state_.scene.node(node).id = id;  // its lists are read in the knowledge of it
  read_fields(layout, {node, nullptr}, proto_.valid());
  if (id != 0) register_node(node, id);
  return node;
}

NodeId FrameDecoder::read_reused(nodes::NodeDataType type) {
  const uint32_t stored = u(state_.config.node_id_bits, "nodeID");
  const uint32_t null_node = (uint32_t{1} << state_.config.node_id_bits) - 1;
  if (!ok() || stored == null_node) return {};
  const auto& known = ids().nodes;
  const auto found = known.find(stored + 1);
  if (found == known.end()) {
    fail(Errc::malformed, "no node before this has the ID " + std::to_string(stored + 1));
    return {};
  }
  const nodes::Node& node = state_.scene.node(found->second);
  if (!node.proto.valid() && !contains(node.definition->data_types, type)) {
    fail(Errc::malformed, "a " + node.definition->name +
                              " may not stand here [expected a node of type " +
                              std::string(nodes::definitions().data_type_name(type)) + "]");
    return {};
  }
  return found->second;
}

/// Walks through the versions until a code is not the escape.
NodeId FrameDecoder::read_node_type(nodes::NodeDataType type) {
  for (unsigned version = 1; version <= kVersions && ok(); ++version) {
    const uint32_t code = u(node_code_bits(type, version), "nodeType");
    if (code == kEscapeCode) continue;
    if (version == kProtoVersion && code == kProtoCode) return read_instance();
    const NodeDefinition* definition = node_of_code(type, version, code);
    const std::string type_name(nodes::definitions().data_type_name(type));
    if (definition == nullptr) {
      fail(Errc::malformed, "there is no " + type_name + " of version " + std::to_string(version) +
                                " and code " + std::to_string(code));
    } else if (state_.config.use_3d_mesh_coding && definition->name == "IndexedFaceSet") {
      fail(Errc::unsupported,
           "an IndexedFaceSet as 3D mesh bitstream (use3DMeshCoding), which is not read");
    } else if (take(1, sizeof(nodes::Node))) {
      return state_.scene.add(*definition, scope_);
    }
    return {};
  }
  fail(Errc::unsupported, "a node of a version above 9");
  return {};
}

NodeId FrameDecoder::read_instance() {
  const uint32_t id = u(state_.config.proto_id_bits, "protoID");
  if (!take(1, sizeof(nodes::Node))) return {};
  // The innermost declaration counts. IDs should differ within a file, those of the peer do not.
  for (nodes::ScopeId at = scope_; at.valid(); at = state_.scene.scope(at).parent) {
    const auto& known = state_.ids[at].protos;
    const auto found = known.find(id);
    if (found != known.end()) return state_.scene.add_instance(found->second, scope_);
  }
  fail(Errc::malformed, "no PROTO has the ID " + std::to_string(id));
  return {};
}

/// A node becomes known when it is complete, so that it cannot stand inside itself.
void FrameDecoder::register_node(NodeId node, uint32_t id) {
  if (!ok()) return;
  know(&ScopeIds::nodes, id, node);
}

void FrameDecoder::read_fields(const NodeDefinition& layout, const FieldTarget& target,
                               bool in_body) {
  if (u(1, "isMask") != 0) {
    read_mask(layout, target, in_body);
  } else {
    read_list(layout, target, in_body);
  }
}

void FrameDecoder::read_mask(const NodeDefinition& layout, const FieldTarget& target,
                             bool in_body) {
  for (const FieldIndex field : layout.fields_in(in_body ? IndexMode::all : IndexMode::def)) {
    if (u(1, "mask") == 0) continue;
    if (!ok()) return;
    if (in_body && u(1, "isIS") != 0) {
      read_link(layout, field, target);
    } else {
      read_field(layout, field, target);
    }
  }
}

void FrameDecoder::read_list(const NodeDefinition& layout, const FieldTarget& target,
                             bool in_body) {
  while (u(1, "endFlag") == 0 && ok()) {
    const bool is_link = in_body && u(1, "isIS") != 0;
    const IndexMode mode = is_link ? IndexMode::all : IndexMode::def;
    const uint32_t count = field_count(layout, mode);
    const uint32_t index = count > 0 ? u(field_index_bits(layout, mode), "fieldRef") : 0;
    if (index >= count)
      return fail(Errc::malformed, "field " + std::to_string(index) + " of a " + layout.name +
                                       ", which has " + std::to_string(count));
    const FieldIndex field = layout.fields_in(mode)[index];
    if (is_link) {
      read_link(layout, field, target);
    } else {
      read_field(layout, field, target);
    }
  }
}

/// `field IS interface field`.
void FrameDecoder::read_link(const NodeDefinition& layout, FieldIndex index,
                             const FieldTarget& target) {
  const NodeDefinition& interface = state_.scene.proto(proto_).interface;
  const uint32_t count = field_count(interface, IndexMode::all);
  const uint32_t number = count > 0 ? u(bits_for(count - 1), "interfaceField") : 0;
  if (!take(1, sizeof(nodes::IsLink))) return;
  const FieldDefinition& field = layout.field(index);
  if (number >= count)
    return fail(Errc::malformed, field.name + " IS field " + std::to_string(number) +
                                     " of a PROTO that has " + std::to_string(count));
  const FieldDefinition& interface_field = interface.field(FieldIndex{number});
  if (field.type != interface_field.type)
    return fail(Errc::malformed, field.name + " IS an " +
                                     std::string(to_string(interface_field.type)) +
                                     " [expected an " + std::string(to_string(field.type)) + "]");
  if (target.node.valid())
    state_.scene.node(target.node).links.push_back({index, FieldIndex{number}});
}

void FrameDecoder::read_field(const NodeDefinition& layout, FieldIndex index,
                              const FieldTarget& target) {
  const FieldDefinition& field = layout.field(index);
  const Part part(*this, field.name);
  if (!field.has_value()) return fail(Errc::malformed, "a value for an event [expected IS]");
  const auto& before =
      target.node.valid() ? state_.scene.node(target.node).values : *target.entries;
  const ElementCoding coding = coding_of(field, layout, before);
  if (!take(1, sizeof(nodes::FieldEntry))) return;
  nodes::FieldValue value = read_value(field, coding, target.node);
  if (!ok()) return;
  if (target.node.valid()) {
    state_.scene.set_unchecked(target.node, index, std::move(value));
    return;
  }
  std::vector<nodes::FieldEntry>& entries = *target.entries;
  const auto known = std::find_if(entries.begin(), entries.end(),
                                  [&](const auto& entry) { return entry.field == index; });
  if (known != entries.end())
    known->value = std::move(value);  // a repeated field overrides
  else
    entries.push_back({index, std::move(value)});
}

}  // namespace afx::bifs
