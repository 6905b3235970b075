// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Source: ISO/IEC 14496-11, SFScript (clauses not checked); spec/bifs.md 13.
#include "bifs/command_codes.h"
#include "bifs/encoder_frame.h"
#include "bifs/node_codes.h"
#include "bifs/script_encoder.h"
#include "bifs/script_syntax.h"

namespace afx::bifs {

using nodes::EventKind;
using nodes::FieldDefinition;
using nodes::FieldIndex;
using nodes::NodeId;

void FrameEncoder::script(NodeId holder, const std::string& text) {
  const Part part(*this, "script");
  std::vector<std::string> identifiers;
  script_fields(holder, identifiers);
  put_flag(true);  // reserved
  if (!ok()) return;
  const ScriptBits put_bits = [this](uint64_t value, unsigned bits) { put(value, bits); };
  const Status written = encode_script(text, std::move(identifiers), put_bits);
  if (!written.ok()) fail(written.error().code, written.error().text);
}

void FrameEncoder::script_fields(NodeId holder, std::vector<std::string>& identifiers) {
  std::vector<FieldIndex> own;
  if (holder.valid() && scene_->node(holder).own_definition != nullptr) {
    const nodes::NodeDefinition& definition = *scene_->node(holder).definition;
    for (size_t i = node_layout(definition).fields().size(); i < definition.fields().size(); ++i)
      own.push_back(FieldIndex{i});
    for (const FieldIndex index : own) identifiers.push_back(definition.field(index).name);
  }
  const size_t count = own.size();
  const bool as_list =
      options_.lists == EncodeOptions::Form::list ||
      (options_.lists == EncodeOptions::Form::shorter && bits_for(count) + 4 > count + 1) ||
      bits_for(count) > 15;
  put_flag(as_list);
  if (!as_list) put_sized(count, 4);
  for (const FieldIndex index : own) {
    if (as_list) put_flag(false);  // endFlag
    script_field(holder, index);
  }
  if (as_list) put_flag(true);
}

void FrameEncoder::script_field(NodeId holder, FieldIndex index) {
  const nodes::Node& n = scene_->node(holder);
  const FieldDefinition& field = n.definition->field(index);
  const Part part(*this, field.name);
  put(field.kind == EventKind::event_in ? 1 : field.kind == EventKind::event_out ? 2 : 0, 2);
  put(static_cast<unsigned>(field.type), 6);
  put_name(field.name);
  if (proto_.valid()) {
    const nodes::IsLink* link = nullptr;
    for (const nodes::IsLink& each : n.links)
      if (each.field == index) link = &each;
    put_flag(link != nullptr);
    if (link != nullptr) {
      const uint32_t count = field_count(scene_->proto(proto_).interface, nodes::IndexMode::all);
      return put(link->interface_field.value, bits_for(count > 0 ? count - 1 : 0));
    }
  }
  if (!field.has_value()) return;
  const nodes::FieldValue* given = scene_->given(holder, index);
  put_flag(given != nullptr);
  if (given == nullptr) return;
  ElementCoding coding;
  coding.efficient_floats = quantizer_ != nullptr && quantizer_->efficient_floats();
  value(field, coding, *given);
}

}  // namespace afx::bifs
