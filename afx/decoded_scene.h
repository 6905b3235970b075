// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include "afx/scene_files.h"
#include "bifs/mp4_presentation_reader.h"
#include "codec/diagnostics.h"
#include "codec/error.h"

namespace afx {

/// What an MP4 file presents, as it is at the end.
struct DecodedScene {
  nodes::Scene scene;
  ObjectStreams streams;  ///< of object descriptors: the first stream of each
  uint64_t frames = 0;    ///< access units of the scene
  uint64_t commands = 0;  ///< in them
};

/// Decodes an MP4 file and keeps the scene and the streams. An object descriptor that was removed
/// keeps its stream here: the scene may still speak of it. `source` and `movie` must live as long
/// as the streams. Errors and warnings: those of bifs::decode_presentation.
Result<DecodedScene> decode_scene(const bifs::Mp4Source& source, const bifs::Mp4Movie& movie,
                                  const bifs::PresentationDecodeOptions& options,
                                  Diagnostics& diagnostics);

}  // namespace afx
