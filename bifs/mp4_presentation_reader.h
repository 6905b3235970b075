// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <string>

#include "bifs/mp4_movie.h"
#include "bifs/mp4_source.h"
#include "bifs/presentation.h"
#include "codec/bit_reader.h"
#include "codec/diagnostics.h"
#include "codec/limits.h"
#include "nodes/text_out.h"

namespace afx::bifs {

struct PresentationDecodeOptions {
  /// The name of the file, for the MediaSources of its streams: "name#track".
  std::string file_name = {};
  Limits limits = {};
  /// Leave out quantizers that only serve the coding of integers (coding_quantizer.h).
  bool drop_coding_quantizers = true;
  const codec::Trace* trace = nullptr;  ///< hears every element of every access unit
};

/// Decodes what an MP4 file presents, in the order of time, and tells it to a sink (nullptr: to
/// nobody). Returns the scene as it stands at the end.
///
/// The InitialObjectDescriptor comes in the form of streams, ES_ID = the low 16 bits of the track
/// ID. Streams that object descriptors refer to come whole, with a MediaSource. At the same time
/// the scene comes before the object descriptors. Times count from the beginning of the
/// presentation, in the timescale of each track.
///
/// Errors    malformed: no scene track, or it has no configuration; those of read_config,
///           BifsDecoder and read_od_commands, each with the track and the access unit in front of
///           the text and the place in the file; those of read_sample and the sink
/// Warnings  other_scene: a further scene stream is left out; stream_missing: a descriptor refers
/// to
///           a track that is not there; those of the decoders
Result<nodes::Scene> decode_presentation(const Mp4Source& source, const Mp4Movie& movie,
                                         const PresentationDecodeOptions& options,
                                         PresentationSink* sink, Diagnostics& diagnostics);

/// Decodes the scene stream of an MP4 file as JSON: `config`, and `accessUnits` with `time`
/// (ticks), `commands` (decoded_json.h), `bitsUsed` and `bytes`. Errors and warnings as above.
Status decode_as_json(const Mp4Source& source, const Mp4Movie& movie,
                      const PresentationDecodeOptions& options, const nodes::TextSink& sink,
                      Diagnostics& diagnostics);

/// When a sample is presented, in ticks of its track from the beginning of the presentation: its
/// time, moved by the edit list where that shows the media as a whole.
uint64_t presentation_time(const Mp4Movie& movie, const Mp4Track& track, const Mp4Sample& sample);

}  // namespace afx::bifs
