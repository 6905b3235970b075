// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The tables of 'stbl' as a list of samples. Part of mp4_reader, not for others.
#pragma once

#include "bifs/mp4_box_reader.h"

namespace afx::bifs {

/// Reads 'stbl': the sample entries, the samples and the boxes carried along.
/// self_contained   for each data reference, from 'dref', whether it is the file itself
Status read_sample_tables(const Mp4Part& stbl, const std::vector<bool>& self_contained,
                          Mp4Context& context, Mp4Track& track);

/// Refuses a sample that does not lie in the file; `part` is what told where it lies.
Status check_sample_place(const Mp4Sample& sample, const Mp4Part& part, uint64_t at,
                          const Mp4Context& context);

}  // namespace afx::bifs
