// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bifs/mp4_movie.h"
#include "bifs/mp4_source.h"
#include "codec/bit_reader.h"
#include "codec/diagnostics.h"
#include "codec/error.h"
#include "codec/limits.h"

namespace afx::bifs {

/// Reads what an MP4 file says; of the file only the headers, 'moov' and each 'moof' are read.
/// Files in fragments are read into the same form; their durations are then those of the samples.
///
/// limits.memory bounds 'moov', each 'moof' and all that is made of them. `trace`, where given,
/// hears every field.
///
/// Errors    all with the byte and the box, "moov/trak[1]/mdia/mdhd: ..." (boxes of which there may
///           be several are counted from 0).
///           truncated: the file, or a box in the box around it, ends before something does, or a
///           sample lies behind the end of the file;
///           malformed: a box that is needed is missing or there twice, tables that do not fit each
///           other, a track ID that is 0 or used twice, a timescale of 0;
///           unsupported: a version of a box that is not known, a compressed 'moov';
///           limit_exceeded; io (of the source)
/// Warnings  box_ignored: a box is not carried along; sample_table: a table describes more samples
///           than there are; sample_entry: the inside of a sample entry is kept without being
///           understood; those of read_descriptors
Result<Mp4Movie> read_mp4(const Mp4Source& source, const Limits& limits, Diagnostics& diagnostics,
                          const codec::Trace* trace = nullptr);

/// The bytes of one sample.
/// Errors  bad_argument: there is no such sample; truncated: it ends behind the file; unsupported:
///         it lies in another file; limit_exceeded: more than limits.memory; io
Result<std::vector<uint8_t>> read_sample(const Mp4Source& source, const Mp4Track& track,
                                         size_t index, const Limits& limits);

/// A sample where it is, or else a copy.
struct Mp4SampleView {
  std::vector<uint8_t> copy;  ///< empty where the source can show the bytes
  std::span<const uint8_t> bytes;
};

/// The same without a copy where source.view is there. Errors: as read_sample.
Result<Mp4SampleView> view_sample(const Mp4Source& source, const Mp4Track& track, size_t index,
                                  const Limits& limits);

}  // namespace afx::bifs
