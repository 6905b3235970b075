// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Source: ISO/IEC 14496-11, SFNode and node descriptions (clauses not checked); spec/bifs.md 6, 7.
#include <algorithm>

#include "bifs/command_codes.h"
#include "bifs/encoder_frame.h"
#include "bifs/node_codes.h"

namespace afx::bifs {

using nodes::FieldDefinition;
using nodes::FieldIndex;
using nodes::FieldType;
using nodes::FieldValue;
using nodes::IndexMode;
using nodes::NodeDefinition;
using nodes::NodeId;

namespace {

bool equal(const auto& a, const auto& b) { return a == b; }
bool equal(const nodes::Rotation& a, const nodes::Rotation& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z && a.angle == b.angle;
}
template <class T>
bool equal(const std::vector<T>& a, const std::vector<T>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const T& x, const T& y) { return equal(x, y); });
}
bool equal(const nodes::Image&, const nodes::Image&) { return false; }
bool equal(const nodes::CommandBuffer& a, const nodes::CommandBuffer&) {
  const bool blank = a.text.find_first_not_of(" \t\r\n") == std::string::npos;
  const auto* buffer = dynamic_cast<const BufferedCommands*>(a.content.get());
  return blank && (buffer == nullptr || buffer->commands.empty());
}

/// Whether a value need not be written, as the peer sees it: compared as numbers, so that a NaN is
/// never equal; images never are.
bool equals_default(const FieldValue& value, const FieldValue& default_value) {
  if (value.index() != default_value.index()) return false;
  return std::visit([&]<class T>(const T& v) { return equal(v, *std::get_if<T>(&default_value)); },
                    value);
}

}  // namespace

void FrameEncoder::node(NodeId id, nodes::NodeDataType type) {
  if (!ok()) return;
  if (!id.valid() || fresh_.erase(id.value) == 0) return reused_node(id);
  const nodes::Node& n = scene_->node(id);
  const NodeDefinition& layout = node_layout(*n.definition);
  const Part part(*this, layout.name);
  put_flag(false);  // isReused
  node_type(id, type);
  put_flag(n.id != 0);
  if (n.id != 0) {
    put_node_id(id);
    if (use_names_) put_name(n.name);
  }
  open_.insert(id.value);
  fields(layout, id, written_fields(id, layout), proto_.valid(), false);
  open_.erase(id.value);
}

void FrameEncoder::reused_node(NodeId id) {
  put_flag(true);  // isReused
  if (!id.valid()) return put((uint64_t{1} << config_.node_id_bits) - 1, config_.node_id_bits);
  if (open_.contains(id.value))
    return fail(Errc::bad_argument, "the " + scene_->type_name(id) + " stands inside itself");
  put_node_id(id);
}

/// Escapes up to the version of the node, then its code.
void FrameEncoder::node_type(NodeId id, nodes::NodeDataType type) {
  const nodes::Node& n = scene_->node(id);
  const bool instance = n.proto.valid();
  const auto code =
      instance ? std::optional(kProtoCode) : node_code(node_layout(*n.definition), type);
  if (!code)
    return fail(Errc::bad_argument, "may not stand here [expected a node of type " +
                                        std::string(nodes::definitions().data_type_name(type)) +
                                        "]");
  const unsigned version = instance ? kProtoVersion : n.definition->version;
  for (unsigned v = 1; v < version; ++v) put(kEscapeCode, node_code_bits(type, v));
  put(*code, node_code_bits(type, version));
  if (instance) put(scene_->proto(n.proto).id, config_.proto_id_bits);
}

std::vector<FrameEncoder::WrittenField> FrameEncoder::written_fields(NodeId id,
                                                                     const NodeDefinition& layout) {
  const nodes::Node& n = scene_->node(id);
  std::vector<WrittenField> list;
  for (size_t i = 0; i < layout.fields().size(); ++i) {
    WrittenField written{FieldIndex{i}, nullptr, std::nullopt};
    for (const nodes::IsLink& link : n.links)
      if (link.field == written.field) written.interface_field = link.interface_field;
    const FieldDefinition& field = layout.field(written.field);
    const FieldValue* given = scene_->given(id, written.field);
    const bool carries_fields = n.own_definition != nullptr && field.type == FieldType::mf_script;
    if (!written.interface_field && !carries_fields && !is_written(field, given)) continue;
    written.value = given != nullptr ? given : &field.default_value;
    list.push_back(written);
  }
  return list;
}

bool FrameEncoder::is_written(const FieldDefinition& field, const FieldValue* given) const {
  if (!field.has_value()) return false;
  const FieldType type = element_type(field.type);
  const bool never_equal = type == FieldType::sf_script || field.type == FieldType::sf_image;
  if (never_equal) return given != nullptr || options_.always_write_images;
  return given != nullptr && !equals_default(*given, field.default_value);
}

void FrameEncoder::fields(const NodeDefinition& layout, NodeId id,
                          const std::vector<WrittenField>& list, bool in_body, bool force_mask) {
  const IndexMode mode = in_body ? IndexMode::all : IndexMode::def;
  const std::vector<FieldIndex>& order = layout.fields_in(mode);
  // As the peer counts: with the DEF width in PROTO bodies too, and a PROTO without fields as list.
  const size_t list_bits = 1 + list.size() * (1 + field_index_bits(layout, IndexMode::def));
  const bool empty_interface = order.empty() && layout.version == 0;
  const bool as_mask = force_mask || options_.nodes == EncodeOptions::Form::compact ||
                       (options_.nodes == EncodeOptions::Form::shorter &&
                        order.size() < list_bits && !empty_interface);
  put_flag(as_mask);
  std::vector<nodes::FieldEntry> before;  // for the width of indices
  auto next = list.begin();
  for (const FieldIndex index : order) {
    const bool present = next != list.end() && next->field == index;
    if (as_mask) put_flag(present);
    if (!present) continue;
    const WrittenField& field = *next++;
    const bool is_link = field.interface_field.has_value();
    if (!as_mask) put_flag(false);  // endFlag
    if (in_body) put_flag(is_link);
    if (!as_mask) {
      const IndexMode field_mode = is_link ? IndexMode::all : IndexMode::def;
      put(layout.index_in(field_mode, index).value_or(0), field_index_bits(layout, field_mode));
    }
    field_content(layout, id, field, before);
  }
  if (!as_mask) put_flag(true);  // endFlag
}

void FrameEncoder::field_content(const NodeDefinition& layout, NodeId id,
                                 const WrittenField& written,
                                 std::vector<nodes::FieldEntry>& before) {
  const FieldDefinition& field = layout.field(written.field);
  const Part part(*this, field.name);
  if (written.interface_field) {
    if (!proto_.valid()) return fail(Errc::bad_argument, "IS outside the body of a PROTO");
    const uint32_t count = field_count(scene_->proto(proto_).interface, IndexMode::all);
    return put(written.interface_field->value, bits_for(count > 0 ? count - 1 : 0));
  }
  value(field, coding_of(field, layout, before), *written.value, id);
  if (field.type == FieldType::sf_node) before.push_back({written.field, *written.value});
}

}  // namespace afx::bifs
