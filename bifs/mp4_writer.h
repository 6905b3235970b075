// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "bifs/mp4_movie.h"
#include "bifs/mp4_source.h"
#include "codec/error.h"
#include "codec/limits.h"

namespace afx::bifs {

/// Gives the bytes of a sample, by the places of its track and itself in the movie; they must be as
/// many as Mp4Sample::size says.
using Mp4SampleBytes = std::function<Result<std::vector<uint8_t>>(size_t track, size_t sample)>;

/// The samples of a file that was read with read_mp4, for passing them through. `source`, `movie`
/// and `limits` must live as long as the function.
Mp4SampleBytes samples_of(const Mp4Source& source, const Mp4Movie& movie, const Limits& limits);

/// Writes an MP4 file from front to end: 'ftyp', 'moov', 'mdat'. The samples lie in the order of
/// their times, at the same time in the order of the tracks; Mp4Sample::offset is not looked at.
/// 64-bit forms are used where a number needs them and only there. The same content gives the same
/// bytes, so what was written, read and written again is the same file. Durations are written as
/// they are: see update_durations.
///
/// Errors  bad_argument: a track ID that is 0 or used twice, a timescale of 0, times of samples
/// that
///         do not follow from 0 and their durations, a sample with an `entry` that is not there, a
///         sample whose bytes are not as many as it says, composition offsets of one track that
///         need more than 32 bits, those of write_descriptors; unsupported: a sample entry with
///         in_this_file false; limit_exceeded: 'moov' would have 4 GB or more; those of `bytes` and
///         `sink`
Status write_mp4(const Mp4Movie& movie, const Mp4SampleBytes& bytes, const Mp4Sink& sink);

}  // namespace afx::bifs
