// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include "bifs/raw_bifs.h"
#include "bifs/scene_stream_encoder.h"

namespace afx::bifs {

/// Encodes the scene stream of a presentation as a raw scene (raw_bifs.h). Object descriptors have
/// no place there: they are left out, with a warning (lost_descriptors).
class RawBifsWriter final : public PresentationSink {
 public:
  /// diagnostics must live as long as this.
  RawBifsWriter(const EncodeOptions& options, Diagnostics& diagnostics)
      : encoder_(options), diagnostics_(diagnostics) {}

  Status begin(const InitialObjectDescriptor& initial) override;
  Status begin_frame(uint64_t time, bool random_access) override;
  Status add(const Command& command, const nodes::Scene& before) override {
    return encoder_.add(command, before);
  }
  Status end_frame() override;
  Status object_descriptors(uint64_t time, bool random_access, const OdCommands& commands) override;
  Status end() override;

  /// What has been written, after end().
  [[nodiscard]] const RawBifs& scene() const { return scene_; }

 private:
  SceneStreamEncoder encoder_;
  Diagnostics& diagnostics_;
  RawBifs scene_;
  uint64_t lost_commands_ = 0;
};

}  // namespace afx::bifs
