// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Where the samples of a written file lie. Part of mp4_writer, not for others.
#pragma once

#include <cstdint>
#include <vector>

#include "bifs/mp4_movie.h"

namespace afx::bifs {

/// Samples of one track and one sample entry that lie one behind the other.
struct Mp4Chunk {
  size_t track = 0;     ///< place in Mp4Movie::tracks
  size_t first = 0;     ///< sample
  size_t count = 0;     ///< samples
  uint64_t offset = 0;  ///< from the start of the sample data
};

struct Mp4Layout {
  std::vector<Mp4Chunk> chunks;  ///< in the order of the file
  uint64_t bytes = 0;            ///< of all samples
};

/// All samples in the order of their times, at the same time in the order of the tracks; what comes
/// to lie together is one chunk.
Mp4Layout lay_out(const Mp4Movie& movie);

}  // namespace afx::bifs
