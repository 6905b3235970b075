// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// 'stbl'. Part of mp4_writer, not for others.
#pragma once

#include "bifs/mp4_box_writer.h"
#include "bifs/mp4_layout.h"
#include "codec/error.h"

namespace afx::bifs {

/// Appends 'stbl'. chunks: those of this track; data: offset of the sample data in the file; wide:
/// chunk offsets in 64 bits.
/// Errors  those of write_descriptors
Status write_sample_tables(const Mp4Track& track, const std::vector<Mp4Chunk>& chunks,
                           uint64_t data, bool wide, Mp4BoxWriter& out);

/// Appends a box with one descriptor behind version and flags: 'esds', 'iods'.
Status write_descriptor_box(FourCc type, const Descriptor& descriptor, Mp4BoxWriter& out);

}  // namespace afx::bifs
