// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Source: ISO/IEC 14496-11, BIFS commands (clauses not checked); spec/bifs.md 3 to 5 and 11.
#include <algorithm>
#include <type_traits>
#include <utility>

#include "bifs/command_codes.h"
#include "bifs/encoder_frame.h"
#include "bifs/node_codes.h"
#include "bifs/top_node.h"

namespace afx::bifs {

using nodes::FieldDefinition;
using nodes::FieldType;
using nodes::FieldValue;
using nodes::IndexMode;
using nodes::NodeDefinition;
using nodes::NodeId;
using nodes::Route;

namespace {

/// What the coding of a value has besides its elements: more than enough of it.
constexpr size_t kAround = 16;

size_t size_in_memory(const auto&) { return 0; }
size_t size_in_memory(const std::string& v) { return v.size(); }
size_t size_in_memory(const nodes::Url& v) { return v.text.size(); }
size_t size_in_memory(const nodes::Image& v) { return v.samples.size(); }
template <class T>
size_t size_in_memory(const std::vector<T>& list) {
  if constexpr (std::is_trivially_copyable_v<T>) return list.size() * sizeof(T);
  size_t size = list.size() * kAround;
  for (const T& element : list) size += size_in_memory(element);
  return size;
}

/// Bytes that are enough for the value in most frames, and not far too many: elements take no more
/// bits than in memory, but for the list form.
size_t expected_bytes(const FieldValue& value) {
  return kAround + std::visit([](const auto& v) { return size_in_memory(v); }, value);
}

/// The same for the values that a command itself has.
size_t expected_bytes(const Command& command) {
  return std::visit(
      [](const auto& c) {
        size_t size = 0;
        if constexpr (requires { c.value; }) size += expected_bytes(c.value);
        if constexpr (requires { c.values; })
          for (const auto& entry : c.values) size += expected_bytes(entry.value);
        return size;
      },
      command);
}

}  // namespace

/// Asks for the memory of what a command will take, so that a frame does not grow by copying while
/// all its values are held. Memory that is not written to costs nothing.
void FrameEncoder::reserve(const Command& written) {
  size_t size = out_->bytes.size() + expected_bytes(written);
  for (const uint32_t node : fresh_) {
    size += kAround;
    for (const nodes::FieldEntry& entry : scene_->node(NodeId{node}).values)
      size += expected_bytes(entry.value);
  }
  const size_t capacity = out_->bytes.capacity();
  if (size > capacity) out_->bytes.reserve(std::max(size, 2 * capacity));
}

void FrameEncoder::command(const Command& written) {
  if (!ok()) return;
  if (out_->commands++ > 0) put_flag(true);  // moreCommands
  const Part part(*this, command_name(written));
  if (std::holds_alternative<SceneReplacement>(written) && out_ == &frame_) known_.clear();
  NodeSet outer = std::exchange(fresh_, new_nodes(*scene_, written, known_));
  reserve(written);
  std::visit([&](const auto& c) { write(c); }, written);
  fresh_ = std::move(outer);
}

void FrameEncoder::write(const NodeInsertion& c) {
  put_command(kInsertionCommand, kNodeSubtype);
  put_node_id(c.target);
  put_position(c.position, kNodePositionBits);
  const NodeDefinition& definition = *scene_->node(c.target).definition;
  const auto type = definition.insertion_type();
  if (!type) return fail(Errc::bad_argument, "a " + definition.name + " has no children");
  node(c.node, *type);
}

void FrameEncoder::write(const IndexedValueInsertion& c) {
  put_command(kInsertionCommand, kValueSubtype);
  put_target(c.target, IndexMode::in);
  put_position(c.position, kValuePositionBits);
  target_value(c.target, c.value, true);
}

void FrameEncoder::write(const RouteInsertion& c) {
  put_command(kInsertionCommand, kRouteSubtype);
  route(c.route);
}

void FrameEncoder::write(const NodeDeletion& c) {
  if (c.extended) {
    put_extended(kNodeDeletionEx);
  } else {
    put_command(kDeletionCommand, kNodeSubtype);
  }
  put_node_id(c.target);
}

void FrameEncoder::write(const IndexedValueDeletion& c) {
  put_command(kDeletionCommand, kValueSubtype);
  put_target(c.target, IndexMode::in);
  put_position(c.position, kValuePositionBits);
}

void FrameEncoder::write(const RouteDeletion& c) {
  put_command(kDeletionCommand, kRouteSubtype);
  put_route_id(c.route_id);
}

void FrameEncoder::write(const NodeReplacement& c) {
  put_command(kReplacementCommand, kNodeSubtype);
  put_node_id(c.target);
  node(c.node, nodes::kWorldNode);
}

void FrameEncoder::write(const FieldReplacement& c) {
  put_command(kReplacementCommand, kFieldSubtype);
  put_target(c.target, IndexMode::in);
  target_value(c.target, c.value, false);
}

void FrameEncoder::write(const IndexedValueReplacement& c) {
  put_command(kReplacementCommand, kValueSubtype);
  put_target(c.target, IndexMode::in);
  put_position(c.position, kValuePositionBits);
  target_value(c.target, c.value, true);
}

void FrameEncoder::write(const RouteReplacement& c) {
  put_command(kReplacementCommand, kRouteSubtype);
  put_route_id(c.route_id);
  put_target(c.from, IndexMode::out);
  put_target(c.to, IndexMode::in);
}

void FrameEncoder::write(const SceneReplacement& c) {
  put(kSceneReplacementCommand, 2);
  put(0, 6);  // reserved
  put_flag(c.use_names);
  use_names_ = c.use_names;
  if (out_ == &frame_) {
    global_quantizer_.reset();
    quantizer_ = nullptr;
  }
  protos(c.protos);
  node(c.root, top_node_type());
  put_flag(!c.routes.empty());
  if (!c.routes.empty()) routes(c.routes);
}

void FrameEncoder::write(const ProtoInsertion& c) {
  put_extended(kProtoListInsertion);
  protos(c.protos);
}

void FrameEncoder::write(const ProtoDeletion& c) {
  put_extended(kProtoListDeletion);
  put_flag(true);  // isList
  for (const uint32_t id : c.proto_ids) {
    put_flag(true);
    put(id, config_.proto_id_bits);
  }
  put_flag(false);
}

void FrameEncoder::write(const AllProtoDeletion&) { put_extended(kAllProtoDeletion); }

void FrameEncoder::write(const MultipleIndexedReplacement& c) {
  put_extended(kMultipleIndexedReplacement);
  put_target(c.target, IndexMode::in);
  uint32_t greatest = 0;
  for (const IndexedValue& value : c.values) greatest = std::max(greatest, value.index);
  put(bits_for(greatest), 5);
  put_sized(c.values.size());
  for (const IndexedValue& value : c.values) {
    put(value.index, bits_for(greatest));
    target_value(c.target, value.value, true);
  }
}

void FrameEncoder::write(const MultipleFieldReplacement& c) {
  put_extended(kMultipleFieldReplacement);
  put_node_id(c.target);
  const NodeDefinition& layout = node_layout(*scene_->node(c.target).definition);
  std::vector<WrittenField> list;
  for (const nodes::FieldIndex index : layout.fields_in(IndexMode::def))
    for (const nodes::FieldEntry& entry : c.values)
      if (entry.field == index) list.push_back({entry.field, &entry.value, std::nullopt});
  if (list.size() != c.values.size())
    return fail(Errc::bad_argument, "a field without a value, or one that comes twice");
  fields(layout, {}, list, false, true);
}

void FrameEncoder::write(const GlobalQuantizer& c) {
  put_extended(kGlobalQuantizer);
  if (c.node.valid() && !is_quantizer(*scene_, c.node))
    return fail(Errc::bad_argument, "a node that is no QuantizationParameter");
  node(c.node, nodes::kWorldNode);
  if (out_ != &frame_) return fail(Errc::unsupported, "a global quantizer in a command buffer");
  global_quantizer_.reset();
  if (c.node.valid()) global_quantizer_ = Quantizer::from_node(*scene_, c.node);
  quantizer_ = global_quantizer_ ? &*global_quantizer_ : nullptr;
}

void FrameEncoder::write(const XReplace& c) {
  put_extended(kXReplace);
  put_target(c.target, IndexMode::in);
  const NodeDefinition& definition = *scene_->node(c.target.node).definition;
  const bool is_indexed = c.position || c.index_from;
  if (is_multiple(definition.field(c.target.field).type)) {
    put_flag(is_indexed);
    if (is_indexed) put_flag(c.index_from.has_value());
    if (c.index_from) {
      put_target(*c.index_from, IndexMode::def);
    } else if (c.position) {
      put_position(*c.position, kValuePositionBits);
    }
    const bool is_node_list = definition.field(c.target.field).type == FieldType::mf_node;
    if (is_indexed && is_node_list) put_flag(c.child_field.has_value());
    if (c.child_field) put_field_ref(*c.child_field, IndexMode::in);
  } else if (is_indexed || c.child_field) {
    return fail(Errc::bad_argument, "an index into a field that is no list");
  }
  put_flag(c.value_from.has_value());
  if (c.value_from) return put_target(*c.value_from, IndexMode::def);
  if (c.child_field) return target_value(*c.child_field, c.value, false);
  target_value(c.target, c.value, is_indexed);
}

void FrameEncoder::put_command(uint32_t type, uint32_t subtype) {
  put(type, 2);
  put(subtype, 2);
}

void FrameEncoder::put_extended(uint32_t type) {
  put_command(kInsertionCommand, kExtendedSubtype);
  put(type, 8);
}

/// IDs are stored minus 1; the greatest stored one means the NULL node.
void FrameEncoder::put_node_id(NodeId id) {
  const uint32_t number = id.valid() ? scene_->node(id).id : 0;
  const uint64_t greatest = (uint64_t{1} << config_.node_id_bits) - 1;
  if (number == 0)
    return fail(Errc::bad_argument,
                id.valid() ? "the " + scene_->type_name(id) + " has no ID [expected one]"
                           : "no node [expected one with an ID]");
  if (out_ == &frame_ && !known_.contains(id.value))  // a buffer may speak of what comes later
    return fail(Errc::bad_argument,
                "the " + scene_->type_name(id) + " with the ID " + std::to_string(number) +
                    " is not in the stream [expected a node that stands there]");
  if (number > greatest)
    return fail(Errc::bad_argument, "the node ID " + std::to_string(number) + " does not fit " +
                                        std::to_string(int{config_.node_id_bits}) + " bits");
  put(number - 1, config_.node_id_bits);
}

void FrameEncoder::put_route_id(uint32_t id) {
  if (id == 0) return fail(Errc::bad_argument, "a ROUTE without ID [expected one]");
  put(id - 1, config_.route_id_bits);
}

void FrameEncoder::put_field_ref(const FieldRef& ref, IndexMode mode) {
  const NodeDefinition& definition = *scene_->node(ref.node).definition;
  const auto index = definition.index_in(mode, ref.field);
  if (!index)
    return fail(Errc::bad_argument, definition.name + "." + definition.field(ref.field).name +
                                        " cannot be addressed here [expected an event or "
                                        "exposedField of the direction]");
  put(*index, field_index_bits(definition, mode));
}

void FrameEncoder::put_target(const FieldRef& ref, IndexMode mode) {
  put_node_id(ref.node);
  if (ok()) put_field_ref(ref, mode);
}

void FrameEncoder::put_position(const Position& position, unsigned bits) {
  switch (position.kind) {
    case Position::Kind::index:
      put(kPositionIndex, 2);
      return put(position.index, bits);
    case Position::Kind::first:
      return put(kPositionFirst, 2);
    case Position::Kind::last:
      return put(kPositionLast, 2);
  }
}

void FrameEncoder::target_value(const FieldRef& target, const FieldValue& written,
                                bool is_element) {
  if (!ok()) return;
  const NodeDefinition& definition = *scene_->node(target.node).definition;
  const FieldDefinition& field = definition.field(target.field);
  const Part part(*this, field.name);
  const ElementCoding coding = coding_of(field, definition, scene_->node(target.node).values);
  if (is_element) {
    element(field, coding, written);
  } else {
    value(field, coding, written);
  }
}

void FrameEncoder::routes(const std::vector<Route>& list) {
  const size_t count = list.size();
  const bool as_vector =
      options_.lists == EncodeOptions::Form::compact ||
      (options_.lists == EncodeOptions::Form::shorter && bits_for(count) + 5 <= count);
  put_flag(!as_vector);
  if (as_vector) put_sized(count);
  for (size_t i = 0; i < count; ++i) {
    route(list[i]);
    if (!as_vector) put_flag(i + 1 < count);
  }
}

void FrameEncoder::route(const Route& written) {
  put_flag(written.id != 0);
  if (written.id != 0) {
    put_route_id(written.id);
    if (use_names_) put_name(written.name);
  }
  route_ends(written);
}

void FrameEncoder::route_ends(const Route& written) {
  put_target({written.from, written.from_field}, IndexMode::out);
  put_target({written.to, written.to_field}, IndexMode::in);
}

}  // namespace afx::bifs
