// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// MPEG-4 scene files from their parts, with the conventions by which players find them.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "bifs/media.h"
#include "bifs/mp4_movie.h"
#include "bifs/mp4_source.h"
#include "codec/error.h"

namespace afx::bifs {

/// A track of the scene ('sdsm').
/// object_type    object_type::kBifs, kBifsV2 or kBifsExtended
/// config         the decoder configuration
/// width, height  pixels, as in the configuration; 0 where it has no size
Mp4Track make_scene_track(uint32_t id, uint8_t object_type, std::vector<uint8_t> config,
                          uint16_t width, uint16_t height);

/// A track of object descriptors ('odsm'). mpod: IDs of the tracks that its EsIdRefs count through,
/// from 1.
Mp4Track make_object_descriptor_track(uint32_t id, std::vector<uint32_t> mpod);

/// A track of an AFX stream ('sdsm', object type AFX). config: begins with the object code.
Mp4Track make_afx_track(uint32_t id, std::vector<uint8_t> config);

/// A track of still pictures ('vide', 'mp4v'): each sample is a whole file.
/// object_type    object_type::kJpeg, kPng or kJpeg2000
/// width, height  pixels
Mp4Track make_image_track(uint32_t id, uint8_t object_type, uint16_t width, uint16_t height);

/// The initial object descriptor of a file: ID 1, no profiles stated. od_track: 0 where there is
/// none.
Descriptor make_initial_object(uint32_t scene_track, uint32_t od_track);

/// Collects tracks and samples in memory and writes them.
class Mp4Builder {
 public:
  /// Everything but the samples; may be changed until write().
  Mp4Movie movie;

  /// Adds a track and gives its place.
  size_t add_track(Mp4Track track);

  /// Adds a sample to a track. Times count in ticks of the track from 0 and do not go back.
  void add_sample(size_t track, std::vector<uint8_t> bytes, uint64_t time,
                  bool random_access = true);

  /// Adds a track with its samples, which come from elsewhere and are asked for when the file is
  /// written. Gives its place.
  size_t add_media(Media media);

  /// Makes a track begin later by so many of its ticks (an empty edit); the times of its samples
  /// then count from there. movie.timescale should be such that the ticks are whole in it.
  void delay_track(size_t track, uint64_t ticks);

  /// How long the last sample of a track lasts, in its ticks; 0 where nothing is said.
  void set_last_duration(size_t track, uint32_t ticks);

  /// Works out durations, buffer sizes and bit rates (where a DecoderConfig has 0) and writes. To
  /// be called once: the samples are handed over.
  ///
  /// Errors  bad_argument: the first sample of a track is not at time 0, times go back or leave a
  ///         gap of 2^32 ticks, a sample has 4 GB or more; those of write_mp4
  Status write(const Mp4Sink& sink);

 private:
  Status fill_samples(size_t track);
  void fill_config(Mp4Track& track);

  /// The samples of a track.
  struct Samples {
    std::vector<std::vector<uint8_t>> bytes;
    std::vector<uint64_t> times;
    uint32_t last_duration = 0;
    std::function<Result<std::vector<uint8_t>>(size_t)> elsewhere;  ///< of Media
  };
  std::vector<Samples> samples_;
};

}  // namespace afx::bifs
