// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "bifs/descriptor.h"
#include "bifs/mp4_movie.h"
#include "codec/error.h"

namespace afx::bifs {

/// The access units of one elementary stream, wherever they are.
struct Media {
  /// All but the track's ID and its references to others. Samples have size, time and duration;
  /// their offset means nothing. Durations of edits count in the track's own timescale.
  Mp4Track track;
  /// The bytes of a sample, by its place in track.samples.
  std::function<Result<std::vector<uint8_t>>(size_t sample)> bytes;
};

/// Finds the access units that a text names. Errors: io (no such file); unsupported, malformed (not
/// a kind of media that is known, or broken).
using LoadMedia = std::function<Result<Media>(const MediaSource& source)>;

}  // namespace afx::bifs
