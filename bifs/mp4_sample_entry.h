// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// 'stsd', how samples are coded. Part of mp4_reader, not for others.
#pragma once

#include "bifs/mp4_box_reader.h"

namespace afx::bifs {

/// Reads 'stsd' into track.entries; track.handler must be known.
Status read_sample_entries(const Mp4Part& stsd, const std::vector<bool>& self_contained,
                           Mp4Context& context, Mp4Track& track);

/// Reads a box that holds one descriptor behind version and flags: 'esds', 'iods'.
Result<Descriptor> read_descriptor_box(const Mp4Part& part, Mp4Context& context);

}  // namespace afx::bifs
