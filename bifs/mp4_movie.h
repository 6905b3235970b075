// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What an MP4 file says, without its bytes: ISO/IEC 14496-12 and 14496-14 (clauses not checked).
// Read by mp4_reader.h, written by mp4_writer.h.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bifs/descriptor.h"

namespace afx::bifs {

/// A type of four characters, e.g. of a box, as a number (first character highest).
using FourCc = uint32_t;

/// fourcc("moov"); the text has exactly four characters.
constexpr FourCc fourcc(std::string_view text) {
  FourCc code = 0;
  for (const char c : text.substr(0, 4)) code = code << 8 | static_cast<uint8_t>(c);
  return code;
}

/// The four characters; those outside of printable ASCII as '?'.
std::string to_string(FourCc code);

/// A box that is carried along as it is, without its header.
struct Mp4Box {
  FourCc type = 0;
  std::vector<uint8_t> payload;
  bool operator==(const Mp4Box&) const = default;
};

/// One access unit of a track.
struct Mp4Sample {
  uint64_t offset = 0;             ///< of its first byte in the file; the writer chooses its own
  uint64_t time = 0;               ///< decoding time, ticks of the track's timescale
  int64_t composition_offset = 0;  ///< composition time minus `time`, -2^31..2^32-1
  uint32_t size = 0;               ///< bytes
  uint32_t duration = 0;           ///< ticks; in a written file time[i] + duration[i] = time[i + 1]
  uint32_t entry = 0;              ///< place in Mp4Track::entries, from 0
  bool random_access = true;       ///< decoding can begin here
  bool operator==(const Mp4Sample&) const = default;
};

/// How the samples of a track are coded ("sample description").
struct Mp4SampleEntry {
  FourCc type = fourcc("mp4s");
  std::vector<uint8_t> head;     ///< the fields between the box header and the boxes inside
  std::optional<Descriptor> es;  ///< ES_Descriptor of the 'esds' box
  std::vector<Mp4Box> boxes;     ///< the other boxes inside, in order, behind 'esds'
  bool in_this_file = true;      ///< otherwise the samples lie in another file (not supported)
  bool operator==(const Mp4SampleEntry&) const = default;
};

/// One edit: a stretch of the presentation and the media time shown there.
struct Mp4Edit {
  uint64_t duration = 0;   ///< ticks of the movie's timescale
  int64_t media_time = 0;  ///< ticks of the track's timescale; -1: nothing is shown
  int32_t rate = 0x10000;  ///< 16.16; 0: the picture at media_time stands still
  bool operator==(const Mp4Edit&) const = default;
};

/// Tracks that a track refers to, e.g. type 'mpod': those its object descriptors name, 'dpnd':
/// those it depends on.
struct Mp4Reference {
  FourCc type = 0;
  std::vector<uint32_t> tracks;  ///< track IDs
  bool operator==(const Mp4Reference&) const = default;
};

/// Row by row: a b u, c d v, x y w; a b c d x y are 16.16, u v w are 2.30.
using Mp4Matrix = std::array<int32_t, 9>;
constexpr Mp4Matrix kMp4Identity = {0x10000, 0, 0, 0, 0x10000, 0, 0, 0, 0x40000000};

/// A duration that is not known.
constexpr uint64_t kMp4UnknownDuration = ~uint64_t{0};

struct Mp4Track {
  uint32_t id = 0;              ///< not 0, unique in the file; its low 16 bits are the ES_ID
  uint32_t flags = 1;           ///< 1 enabled, 2 in the movie, 4 in the preview
  FourCc handler = 0;           ///< 'sdsm' scene or AFX, 'odsm' object descriptors, 'vide', 'soun'
  std::string name;             ///< of the handler, for people
  uint32_t timescale = 1000;    ///< ticks a second, not 0
  uint64_t duration = 0;        ///< in the movie's timescale, edits applied
  uint64_t media_duration = 0;  ///< in the track's timescale
  uint16_t language = 0x55C4;   ///< three letters of 5 bits; this is "und"
  uint64_t created = 0;         ///< seconds since 1904; 0: not said
  uint64_t modified = 0;        ///< likewise
  uint64_t media_created = 0;
  uint64_t media_modified = 0;
  int16_t layer = 0;
  int16_t alternate_group = 0;
  int16_t volume = 0;  ///< 8.8
  Mp4Matrix matrix = kMp4Identity;
  uint32_t width = 0;  ///< shown size, 16.16; of a scene that of its configuration
  uint32_t height = 0;
  std::vector<Mp4Edit> edits;  ///< empty: the media from its beginning
  std::vector<Mp4Reference> references;
  Mp4Box media_header{fourcc("nmhd"), {0, 0, 0, 0}};  ///< 'nmhd', 'vmhd', 'smhd', ...
  std::vector<Mp4SampleEntry> entries;
  std::vector<Mp4Sample> samples;   ///< in decoding order
  std::vector<Mp4Box> boxes;        ///< other boxes of 'trak', kept
  std::vector<Mp4Box> table_boxes;  ///< other boxes of 'stbl', kept
  bool operator==(const Mp4Track&) const = default;
};

struct Mp4Movie {
  FourCc major_brand = fourcc("mp42");
  uint32_t minor_version = 1;
  std::vector<FourCc> compatible_brands = {fourcc("isom"), fourcc("mp42"), fourcc("mp41")};
  uint32_t timescale = 600;  ///< ticks a second, not 0
  uint64_t duration = 0;     ///< of the longest track
  uint64_t created = 0;      ///< seconds since 1904; 0: not said
  uint64_t modified = 0;
  int32_t rate = 0x10000;  ///< 16.16
  int16_t volume = 0x100;  ///< 8.8
  Mp4Matrix matrix = kMp4Identity;
  uint32_t next_track_id = 1;
  std::optional<Descriptor> initial_object;  ///< of 'iods': an InitialObjectDescriptor (or, in
                                             ///< other people's files, another descriptor)
  std::vector<Mp4Track> tracks;
  std::vector<Mp4Box> boxes;  ///< other boxes of 'moov', kept
  bool operator==(const Mp4Movie&) const = default;
};

/// The ES_Descriptor of a sample entry; null where it has none.
const EsDescriptor* es_of(const Mp4SampleEntry& entry);
/// Its decoder configuration; null where it has none.
const DecoderConfig* decoder_config_of(const Mp4SampleEntry& entry);

/// The track with an ID; null where there is none. Valid as long as the tracks are left alone.
const Mp4Track* find_track(const Mp4Movie& movie, uint32_t id);

/// The track of the scene: the one of stream type "scene" with a BIFS object type that the initial
/// object descriptor names, without one the first in the file; null where there is none.
const Mp4Track* scene_track(const Mp4Movie& movie);

/// The track of the object descriptors, found likewise.
const Mp4Track* object_descriptor_track(const Mp4Movie& movie);

/// The track that an EsIdRef in a sample of `from` means; null where there is none.
const Mp4Track* referenced_track(const Mp4Movie& movie, const Mp4Track& from, EsIdRef reference);

/// When a media time is first shown, in the movie's timescale, rounded down, by the edit list;
/// nothing where it is cut out; rates other than 1 are not looked at. Without an edit list media
/// time 0 is movie time 0.
std::optional<uint64_t> movie_time(const Mp4Movie& movie, const Mp4Track& track,
                                   int64_t media_time);

/// Sets the durations of the tracks and the movie from the samples and edits, and next_track_id. A
/// last edit of duration 0 (writers of fragments do not know it) is made to last to the end.
void update_durations(Mp4Movie& movie);

/// `ticks` of one timescale in another, rounded down; kMp4UnknownDuration where it does not fit.
uint64_t rescale(uint64_t ticks, uint32_t from, uint32_t to);

}  // namespace afx::bifs
