// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <memory>

#include "bifs/encoder.h"
#include "bifs/media.h"
#include "bifs/mp4_source.h"
#include "bifs/presentation.h"

namespace afx::bifs {

struct Mp4WriteOptions {
  EncodeOptions encoding;
  /// Finds the access units of streams that come from elsewhere; empty: such a stream is an error
  /// (unsupported).
  LoadMedia load_media;
};

/// Encodes a presentation into an MP4 file: a track for the scene, one for object descriptors, one
/// for each stream that they name, track ID = ES_ID. The file is written by end().
///
/// Errors  those of BifsEncoder, write_od_commands, write_mp4, of load_media and of the sink;
///         malformed: no scene stream, or one without configuration (see set_up_encoding), two
///         streams of one ES_ID that are not the same, a removed stream that is not there
class Mp4PresentationWriter final : public PresentationSink {
 public:
  Mp4PresentationWriter(Mp4Sink sink, Mp4WriteOptions options);
  ~Mp4PresentationWriter() override;

  Status begin(const InitialObjectDescriptor& initial) override;
  Status begin_frame(uint64_t time, bool random_access) override;
  Status add(const Command& command, const nodes::Scene& before) override;
  Status end_frame() override;
  Status object_descriptors(uint64_t time, bool random_access, const OdCommands& commands) override;
  Status end() override;

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace afx::bifs
