// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// 'mvex' and 'moof': samples that come behind 'moov'. Part of mp4_reader, not for others.
#pragma once

#include <map>

#include "bifs/mp4_box_reader.h"

namespace afx::bifs {

/// What the samples of a track have in common ('trex').
struct Mp4FragmentDefaults {
  uint32_t entry = 1;  ///< from 1
  uint32_t duration = 0;
  uint32_t size = 0;
  uint32_t flags = 0;
};
using Mp4TrackDefaults = std::map<uint32_t, Mp4FragmentDefaults>;  ///< by track ID

Status read_movie_extends(const Mp4Part& mvex, Mp4Context& context, Mp4TrackDefaults& defaults);

/// Appends the samples of a 'moof' to the tracks of the movie. places: of each track ID in
/// movie.tracks.
Status read_fragment(const Mp4Part& moof, const Mp4TrackDefaults& defaults,
                     const std::map<uint32_t, size_t>& places, Mp4Context& context,
                     Mp4Movie& movie);

}  // namespace afx::bifs
