// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/descriptor.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace afx::bifs {
namespace {

struct TagOf {
  uint8_t operator()(const UnknownDescriptor& unknown) const { return unknown.tag; }
  uint8_t operator()(const ObjectDescriptor& object) const {
    return object.in_file ? descriptor_tag::kObjectInFile : descriptor_tag::kObject;
  }
  uint8_t operator()(const InitialObjectDescriptor& object) const {
    return object.in_file ? descriptor_tag::kInitialObjectInFile : descriptor_tag::kInitialObject;
  }
  uint8_t operator()(const EsDescriptor&) const { return descriptor_tag::kEs; }
  uint8_t operator()(const DecoderConfig&) const { return descriptor_tag::kDecoderConfig; }
  uint8_t operator()(const DecoderSpecificInfo&) const {
    return descriptor_tag::kDecoderSpecificInfo;
  }
  uint8_t operator()(const SlConfig&) const { return descriptor_tag::kSlConfig; }
  uint8_t operator()(const EsIdInc&) const { return descriptor_tag::kEsIdInc; }
  uint8_t operator()(const EsIdRef&) const { return descriptor_tag::kEsIdRef; }
};

}  // namespace

uint8_t tag_of(const Descriptor& descriptor) { return std::visit(TagOf{}, descriptor.body); }

std::vector<uint8_t> decoder_specific_info(const EsDescriptor& es) {
  const auto* config = find_part<DecoderConfig>(es.parts);
  const auto* info = config != nullptr ? find_part<DecoderSpecificInfo>(config->parts) : nullptr;
  return info != nullptr ? info->bytes : std::vector<uint8_t>();
}

EsDescriptor es_descriptor_in_file(DecoderConfig config, std::vector<uint8_t> info) {
  // In place: g++ 12 warns falsely of a variant that is moved as a temporary.
  if (!info.empty()) {
    Descriptors parts(1);
    parts[0].body.emplace<DecoderSpecificInfo>().bytes = std::move(info);
    std::move(config.parts.begin(), config.parts.end(), std::back_inserter(parts));
    config.parts = std::move(parts);
  }
  EsDescriptor es;
  es.parts.emplace_back().body.emplace<DecoderConfig>(std::move(config));
  es.parts.emplace_back().body.emplace<SlConfig>();
  return es;
}

}  // namespace afx::bifs
