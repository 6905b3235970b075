// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/raw_bifs_writer.h"

#include <utility>

namespace afx::bifs {

Status RawBifsWriter::begin(const InitialObjectDescriptor& initial) {
  if (Status begun = encoder_.begin(initial); !begun.ok()) return begun;
  scene_.object_type = encoder_.config().version;
  scene_.config = decoder_specific_info(encoder_.stream());
  scene_.timescale = timestamp_resolution(&encoder_.stream());
  return {};
}

Status RawBifsWriter::begin_frame(uint64_t time, bool random_access) {
  scene_.units.push_back({time, random_access, {}});
  return {};
}

Status RawBifsWriter::end_frame() {
  Result<std::vector<uint8_t>> bytes = encoder_.end_frame();
  if (!bytes.ok()) return bytes.error();
  scene_.units.back().bytes = std::move(bytes).value();
  return {};
}

Status RawBifsWriter::object_descriptors(uint64_t, bool, const OdCommands& commands) {
  lost_commands_ += commands.size();
  return {};
}

Status RawBifsWriter::end() {
  if (lost_commands_ > 0)
    diagnostics_.warn(
        "lost_descriptors", Place::none(),
        "a raw scene has no place for object descriptors: " + std::to_string(lost_commands_) +
            (lost_commands_ == 1 ? " command is" : " commands are") + " left out");
  return {};
}

}  // namespace afx::bifs
