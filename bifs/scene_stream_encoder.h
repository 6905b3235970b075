// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <optional>
#include <vector>

#include "bifs/config.h"
#include "bifs/encoder.h"
#include "bifs/presentation.h"

namespace afx::bifs {

/// Encodes the scene stream of a presentation that is told to a sink. The parts that writers of
/// files (mp4_presentation_writer.h, raw_bifs_writer.h) share.
class SceneStreamEncoder {
 public:
  explicit SceneStreamEncoder(const EncodeOptions& options) : options_(options) {}

  /// Errors: malformed: the scene stream has no BIFS configuration (set_up_encoding gives it one).
  Status begin(const InitialObjectDescriptor& initial);
  Status add(const Command& command, const nodes::Scene& before);
  /// The bytes of the access unit.
  Result<std::vector<uint8_t>> end_frame();

  [[nodiscard]] const EsDescriptor& stream() const { return stream_; }
  [[nodiscard]] const BifsConfig& config() const { return config_; }

 private:
  EncodeOptions options_;
  EsDescriptor stream_;
  BifsConfig config_;
  std::optional<BifsEncoder> encoder_;
};

}  // namespace afx::bifs
