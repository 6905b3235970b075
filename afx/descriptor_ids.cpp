// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/descriptor_ids.h"

namespace afx {
namespace {

using nodes::Url;

void note(const Url& url, std::set<uint16_t>& used) {
  if (url.is_descriptor()) used.insert(static_cast<uint16_t>(url.object_descriptor));
}

void note(const nodes::FieldValue& value, std::set<uint16_t>& used) {
  if (const auto* one = std::get_if<Url>(&value)) note(*one, used);
  if (const auto* many = std::get_if<std::vector<Url>>(&value))
    for (const Url& url : *many) note(url, used);
}

}  // namespace

std::set<uint16_t> used_descriptors(const nodes::Scene& scene) {
  std::set<uint16_t> used;
  for (uint32_t i = 0; i < scene.node_count(); ++i) {
    for (const nodes::FieldEntry& entry : scene.node(nodes::NodeId(i)).values)
      note(entry.value, used);
  }
  for (uint32_t i = 0; i < scene.proto_count(); ++i) {
    const nodes::Proto& proto = scene.proto(nodes::ProtoId(i));
    for (const Url& url : proto.urls) note(url, used);
    for (const auto& field : proto.interface.fields()) note(field.default_value, used);
  }
  return used;
}

}  // namespace afx
