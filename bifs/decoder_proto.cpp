// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Source: ISO/IEC 14496-11, PROTO declarations (clauses not checked); spec/bifs.md 12.
#include <utility>

#include "bifs/decoder_frame.h"
#include "nodes/text_cursor.h"

namespace afx::bifs {

using nodes::FieldDefinition;
using nodes::FieldType;
using nodes::NodeDefinition;
using nodes::ProtoId;

std::vector<ProtoId> FrameDecoder::read_protos() {
  std::vector<ProtoId> protos;
  while (u(1, "morePROTOs") != 0 && ok()) protos.push_back(read_proto());
  return protos;
}

ProtoId FrameDecoder::read_proto() {
  const Depth depth(*this);
  const Part part(*this, "PROTO");
  const uint32_t id = u(state_.config.proto_id_bits, "protoID");
  const ProtoId proto = declare_proto(id);
  if (!ok()) return {};
  const nodes::ScopeId outer = std::exchange(scope_, state_.scene.proto(proto).body);
  const ProtoId outer_proto = std::exchange(proto_, proto);
  read_interface(proto);
  if (u(1, "isExtern") != 0) {
    FieldDefinition url;
    url.type = FieldType::mf_url;
    nodes::FieldValue urls = read_value(url, {}, {}, false);
    state_.scene.proto(proto).external = true;
    state_.scene.proto(proto).urls = std::move(std::get<std::vector<nodes::Url>>(urls));
  } else {
    read_proto_body(proto);
  }
  read_interface_coding(proto);
  ended_bodies_.push_back(scope_);
  scope_ = outer;
  proto_ = outer_proto;
  if (!ok()) return {};
  state_.scene.settle_data_types(proto);
  know(&ScopeIds::protos, id, proto);  // known when it is complete: it cannot stand inside itself
  return proto;
}

/// Names are made up where the stream has none, or one that could not be told from others.
ProtoId FrameDecoder::declare_proto(uint32_t id) {
  const std::string made =
      proto_.valid() ? state_.scene.proto(proto_).interface.name + "_" : std::string("Proto");
  std::string name = made + std::to_string(id);
  if (state_.use_names) take_name("protoName", name, true);
  if (!take(1, sizeof(nodes::Proto) + sizeof(nodes::Scope) + 2 * name.size())) return {};
  Result<ProtoId> proto = state_.scene.add_proto(name, false, scope_);
  if (!proto.ok() && state_.use_names)
    warn("name_twice", "a second PROTO of the name '" + name + "'");
  // The number of PROTOs so far, so that few names are tried however many are alike.
  for (size_t copy = state_.scene.proto_count(); !proto.ok(); ++copy)
    proto = state_.scene.add_proto(name + "_" + std::to_string(copy), false, scope_);
  state_.scene.proto(proto.value()).id = id;
  return proto.value();
}

/// Reads a name into `name`, which stays as it is, with a warning, if scenes and texts cannot hold
/// what is read: no identifier, or, for a type of nodes, the name of another.
void FrameDecoder::take_name(std::string_view what, std::string& name, bool of_type) {
  const std::string read = read_name(what);
  if (!ok()) return;
  const bool taken = of_type && nodes::definitions().find(read) != nullptr;
  if (nodes::is_identifier(read) && !taken) {
    name = read;
  } else {
    warn("name_changed", "the name '" + read + "' cannot be used; it is '" + name + "' here");
  }
}

void FrameDecoder::read_interface(ProtoId proto) {
  size_t number = 0;
  while (u(1, "moreFields") != 0 && take(1, sizeof(FieldDefinition))) {
    FieldDefinition field = read_interface_field(number++);
    if (!ok()) return;
    const std::string name = field.name;
    if (!state_.scene.proto(proto).interface.add(std::move(field)).valid())
      return fail(Errc::malformed, "a second field '" + name + "', or more than 65535 fields");
  }
}

FieldDefinition FrameDecoder::read_interface_field(size_t number) {
  FieldDefinition field;
  field.kind = static_cast<nodes::EventKind>(u(2, "eventType"));
  const uint32_t code = u(6, "fieldType");
  const auto type = nodes::field_type_of_code(code);
  if (!type) fail(Errc::unsupported, "a field of type " + std::to_string(code));
  if (!ok()) return field;
  field.type = *type;
  field.name = "_field" + std::to_string(number);
  if (state_.use_names) take_name("fieldName", field.name, false);
  field.default_value = zero_value(field.type);
  if (!field.has_value()) return field;
  // Defaults are never quantized, but efficient floats count.
  const Part part(*this, field.name);
  ElementCoding coding;
  coding.efficient_floats = quantizer_ != nullptr && quantizer_->efficient_floats();
  field.default_value = read_value(field, coding, {}, false);
  return field;
}

void FrameDecoder::read_proto_body(ProtoId proto) {
  const nodes::ScopeId body = state_.scene.proto(proto).body;
  read_protos();
  do {
    if (!take(1, sizeof(nodes::NodeId))) return;
    const nodes::NodeId node = read_node(nodes::kWorldNode);
    if (ok()) state_.scene.add_root(node, body);
  } while (u(1, "moreNodes") != 0 && ok());
  if (u(1, "hasROUTEs") == 0) return;
  std::vector<nodes::Route> routes = read_routes();
  if (ok()) state_.scene.scope(body).routes = std::move(routes);
}

/// Quantization and animation of the interface fields stand behind the body, so the interface is
/// built anew with them.
void FrameDecoder::read_interface_coding(ProtoId proto) {
  const bool has_quantization = u(1, "hasQuantization") != 0;
  const bool has_animation = u(1, "hasAnimation") != 0;
  if (!ok() || (!has_quantization && !has_animation)) return;
  NodeDefinition& interface = state_.scene.proto(proto).interface;
  NodeDefinition coded;
  coded.name = interface.name;
  coded.data_types = interface.data_types;
  for (FieldDefinition field : interface.fields()) {
    const Part part(*this, field.name);
    const bool is_animatable =
        field.kind == nodes::EventKind::event_in || field.kind == nodes::EventKind::exposed_field;
    if (has_quantization && field.has_value()) read_quantization(field);
    if (has_animation && is_animatable && u(1, "isAnimated") != 0)
      field.anim_category = static_cast<uint8_t>(u(4, "animCategory"));
    if (!ok()) return;
    coded.add(std::move(field));
  }
  interface = std::move(coded);
}

void FrameDecoder::read_quantization(FieldDefinition& field) {
  field.quant_category = static_cast<uint8_t>(u(4, "quantCategory"));
  if (field.quant_category == kCategoryLinearScalar)
    field.quant_bits = static_cast<uint8_t>(u(5, "nbBits"));
  if (u(1, "hasBounds") == 0) return;
  nodes::Bounds bounds;
  bounds.lower = read_bound(field.type);
  bounds.upper = read_bound(field.type);
  field.bounds = bounds;
}

double FrameDecoder::read_bound(FieldType type) {
  ElementCoding coding;
  coding.efficient_floats = quantizer_ != nullptr && quantizer_->efficient_floats();
  if (element_type(type) == FieldType::sf_int32) {
    int32_t value = 0;
    read_one(value, coding);
    return value;
  }
  if (element_type(type) == FieldType::sf_time) {
    double value = 0;
    read_one(value, coding);
    return value;
  }
  return read_float(coding, 0);
}

}  // namespace afx::bifs
