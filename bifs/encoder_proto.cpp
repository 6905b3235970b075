// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Source: ISO/IEC 14496-11, PROTO declarations (clauses not checked); spec/bifs.md 12.
#include <algorithm>
#include <utility>

#include "bifs/encoder_frame.h"

namespace afx::bifs {

using nodes::EventKind;
using nodes::FieldDefinition;
using nodes::FieldType;
using nodes::ProtoId;

namespace {

bool is_animatable(const FieldDefinition& field) {
  return field.kind == EventKind::event_in || field.kind == EventKind::exposed_field;
}

}  // namespace

void FrameEncoder::protos(const std::vector<ProtoId>& list) {
  for (const ProtoId id : list) {
    put_flag(true);  // morePROTOs
    proto(id);
  }
  put_flag(false);
}

void FrameEncoder::proto(ProtoId id) {
  const nodes::Proto& written = scene_->proto(id);
  const Part part(*this, written.interface.name);
  put(written.id, config_.proto_id_bits);
  if (use_names_) put_name(written.interface.name);
  const ProtoId outer = std::exchange(proto_, id);
  for (const FieldDefinition& field : written.interface.fields()) {
    put_flag(true);  // moreFields
    interface_field(field);
  }
  put_flag(false);
  put_flag(written.external);
  if (written.external) {
    FieldDefinition url;
    url.type = FieldType::mf_url;
    value(url, {}, written.urls, {}, false);
  } else {
    const nodes::Scope& body = scene_->scope(written.body);
    protos(body.protos);
    if (body.roots.empty()) node({}, nodes::kWorldNode);  // a body has at least one node
    for (size_t i = 0; i < body.roots.size(); ++i) {
      if (i > 0) put_flag(true);  // moreNodes
      node(body.roots[i], nodes::kWorldNode);
    }
    put_flag(false);
    put_flag(!body.routes.empty());
    if (!body.routes.empty()) routes(body.routes);
  }
  interface_coding(written.interface);
  proto_ = outer;
}

void FrameEncoder::interface_field(const FieldDefinition& field) {
  const Part part(*this, field.name);
  put(static_cast<unsigned>(field.kind), 2);
  put(static_cast<unsigned>(field.type), 6);
  if (use_names_) put_name(field.name);
  if (!field.has_value()) return;
  ElementCoding coding;
  coding.efficient_floats = quantizer_ != nullptr && quantizer_->efficient_floats();
  value(field, coding, field.default_value, {}, false);
}

void FrameEncoder::interface_coding(const nodes::NodeDefinition& interface) {
  const auto& fields = interface.fields();
  const bool has_quantization = std::any_of(
      fields.begin(), fields.end(),
      [](const FieldDefinition& field) { return field.has_value() && field.quant_category != 0; });
  const bool has_animation =
      std::any_of(fields.begin(), fields.end(), [](const FieldDefinition& field) {
        return is_animatable(field) && field.anim_category != 0;
      });
  put_flag(has_quantization);
  put_flag(has_animation);
  for (const FieldDefinition& field : fields) {
    if (has_quantization && field.has_value()) {
      put(field.quant_category, 4);
      if (field.quant_category == kCategoryLinearScalar) put(field.quant_bits, 5);
      put_flag(field.bounds.has_value());
      if (field.bounds) bounds(field);
    }
    if (has_animation && is_animatable(field)) {
      put_flag(field.anim_category != 0);
      if (field.anim_category != 0) put(field.anim_category, 4);
    }
  }
}

void FrameEncoder::bounds(const FieldDefinition& field) {
  ElementCoding coding;
  coding.efficient_floats = quantizer_ != nullptr && quantizer_->efficient_floats();
  for (const double bound : {field.bounds->lower, field.bounds->upper}) {
    if (element_type(field.type) == FieldType::sf_int32) {
      one(static_cast<int32_t>(std::clamp(bound, double{INT32_MIN}, double{INT32_MAX})), coding);
    } else if (element_type(field.type) == FieldType::sf_time) {
      one(bound, coding);
    } else {
      one(static_cast<float>(bound), coding);
    }
  }
}

}  // namespace afx::bifs
