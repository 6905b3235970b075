// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bifs/mp4_movie.h"
#include "codec/bit_reader.h"
#include "codec/diagnostics.h"
#include "codec/error.h"
#include "codec/limits.h"

namespace afx::bifs {

/// One access unit (command frame) of a raw scene.
struct RawBifsUnit {
  uint64_t time = 0;          ///< ticks of RawBifs::timescale; not less than of the one before
  bool random_access = true;  ///< decoding can begin here
  std::vector<uint8_t> bytes;
  bool operator==(const RawBifsUnit&) const = default;
};

/// A scene without an MP4 file.
struct RawBifs {
  uint8_t object_type = 1;      ///< 1, 2, 4: which form `config` has, see object_type
  std::vector<uint8_t> config;  ///< decoder configuration, at most 65535 bytes
  uint32_t timescale = 1000;    ///< ticks a second, not 0
  std::vector<RawBifsUnit> units;
  bool operator==(const RawBifs&) const = default;
};

/// Reads a raw scene (files named .bifs): the configuration and the access units as an MP4 file has
/// them, one behind the other. It is a form of this project, no standard's. Numbers are big-endian:
///
///     4 bytes   "BIFS"
///     u(8)      1, the version of this form
///     u(8)      object type
///     u(16)     size of the configuration, then so many bytes
///     u(32)     timescale
///     then to the end of the file for each access unit
///       u(64)   time
///       u(8)    1 random access, 0 not
///       u(32)   size, then so many bytes
///
/// Written again it gives the same bytes. No object descriptors: scenes that need streams beside
/// them need an MP4 file.
///
/// Errors  truncated; malformed: it does not begin with "BIFS", a timescale of 0, a flag other than
///         0 and 1, times that go back; unsupported: another version; limit_exceeded: limits.memory
Result<RawBifs> read_raw_bifs(std::span<const uint8_t> data, const Limits& limits,
                              const codec::Trace* trace = nullptr);

/// A raw scene as an MP4 file would say it: one track, whose samples lie where write_raw_bifs puts
/// them, so that what reads MP4 files reads raw scenes too.
Mp4Movie movie_of_raw_bifs(const RawBifs& scene);

/// Errors  bad_argument: what read_raw_bifs would refuse, or a configuration or access unit whose
///         size does not fit
Result<std::vector<uint8_t>> write_raw_bifs(const RawBifs& scene);

}  // namespace afx::bifs
