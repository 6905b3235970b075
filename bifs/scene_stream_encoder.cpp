// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/scene_stream_encoder.h"

namespace afx::bifs {

Status SceneStreamEncoder::begin(const InitialObjectDescriptor& initial) {
  const EsDescriptor* const es = scene_stream(initial);
  const auto* decoder = es != nullptr ? find_part<DecoderConfig>(es->parts) : nullptr;
  if (decoder == nullptr)
    return Error{Errc::malformed, Place::none(), "there is no scene stream (expected one)"};
  Diagnostics diagnostics;
  const auto config = read_config(decoder_specific_info(*es), decoder->object_type, diagnostics);
  if (!config.ok()) return config.error();
  stream_ = *es;
  config_ = config.value();
  encoder_.emplace(config_, options_);
  return {};
}

Status SceneStreamEncoder::add(const Command& command, const nodes::Scene& before) {
  return encoder_->add(command, before);
}

Result<std::vector<uint8_t>> SceneStreamEncoder::end_frame() { return encoder_->finish(); }

}  // namespace afx::bifs
