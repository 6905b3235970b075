// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// 'trak'. Part of mp4_reader, not for others.
#pragma once

#include "bifs/mp4_box_reader.h"

namespace afx::bifs {

Result<Mp4Track> read_track(const Mp4Part& trak, Mp4Context& context);

/// The 9 numbers of a matrix.
Mp4Matrix read_matrix(Mp4Fields& in);

/// A duration of 4 or 8 bytes; all ones are kMp4UnknownDuration.
uint64_t read_duration(Mp4Fields& in, unsigned bytes);

}  // namespace afx::bifs
