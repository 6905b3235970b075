// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/mp4_movie.h"

#include <algorithm>

namespace afx::bifs {
namespace {

bool is_scene(const Mp4Track& track) {
  const auto* config = track.entries.empty() ? nullptr : decoder_config_of(track.entries[0]);
  if (config == nullptr || config->stream_type != stream_type::kScene) return false;
  return config->object_type == object_type::kBifs || config->object_type == object_type::kBifsV2 ||
         config->object_type == object_type::kBifsExtended;
}

bool is_object_descriptors(const Mp4Track& track) {
  const auto* config = track.entries.empty() ? nullptr : decoder_config_of(track.entries[0]);
  if (config == nullptr) return track.handler == fourcc("odsm");
  return config->stream_type == stream_type::kObjectDescriptor;
}

const Mp4Track* starting_track(const Mp4Movie& movie, bool (*wanted)(const Mp4Track&)) {
  const auto* initial = movie.initial_object
                            ? std::get_if<InitialObjectDescriptor>(&movie.initial_object->body)
                            : nullptr;
  if (initial != nullptr) {
    for (const Descriptor& part : initial->parts) {
      const auto* inc = std::get_if<EsIdInc>(&part.body);
      const Mp4Track* track = inc != nullptr ? find_track(movie, inc->track_id) : nullptr;
      if (track != nullptr && wanted(*track)) return track;
    }
  }
  const auto found = std::find_if(movie.tracks.begin(), movie.tracks.end(), wanted);
  return found != movie.tracks.end() ? &*found : nullptr;
}

/// The sum of the edits; the last one is given its length where it has none.
uint64_t edited_duration(const Mp4Movie& movie, Mp4Track& track) {
  Mp4Edit& last = track.edits.back();
  const auto start = static_cast<uint64_t>(last.media_time);
  if (last.duration == 0 && last.media_time >= 0 && start < track.media_duration) {
    last.duration = rescale(track.media_duration - start, track.timescale, movie.timescale);
  }
  uint64_t duration = 0;
  for (const Mp4Edit& edit : track.edits) duration += edit.duration;
  return duration;
}

}  // namespace

std::string to_string(FourCc code) {
  std::string text;
  for (int shift = 24; shift >= 0; shift -= 8) {
    const auto c = static_cast<uint8_t>(code >> shift);
    text += c >= 0x20 && c < 0x7F ? static_cast<char>(c) : '?';
  }
  return text;
}

const EsDescriptor* es_of(const Mp4SampleEntry& entry) {
  return entry.es ? std::get_if<EsDescriptor>(&entry.es->body) : nullptr;
}

const DecoderConfig* decoder_config_of(const Mp4SampleEntry& entry) {
  const EsDescriptor* es = es_of(entry);
  return es != nullptr ? find_part<DecoderConfig>(es->parts) : nullptr;
}

const Mp4Track* find_track(const Mp4Movie& movie, uint32_t id) {
  const auto found = std::find_if(movie.tracks.begin(), movie.tracks.end(),
                                  [id](const Mp4Track& track) { return track.id == id; });
  return found != movie.tracks.end() ? &*found : nullptr;
}

const Mp4Track* scene_track(const Mp4Movie& movie) { return starting_track(movie, is_scene); }

const Mp4Track* object_descriptor_track(const Mp4Movie& movie) {
  return starting_track(movie, is_object_descriptors);
}

const Mp4Track* referenced_track(const Mp4Movie& movie, const Mp4Track& from, EsIdRef reference) {
  for (const Mp4Reference& list : from.references) {
    if (list.type != fourcc("mpod") || reference.index == 0) continue;
    if (reference.index > list.tracks.size()) return nullptr;
    return find_track(movie, list.tracks[reference.index - 1U]);
  }
  return nullptr;
}

uint64_t rescale(uint64_t ticks, uint32_t from, uint32_t to) {
  if (ticks == kMp4UnknownDuration || from == 0) return kMp4UnknownDuration;
  const uint64_t whole = ticks / from;  // both products below stay under 2^64
  if (to != 0 && whole >= (uint64_t{1} << 62) / to) return kMp4UnknownDuration;
  return whole * to + ticks % from * to / from;
}

std::optional<uint64_t> movie_time(const Mp4Movie& movie, const Mp4Track& track,
                                   int64_t media_time) {
  if (track.edits.empty()) {
    if (media_time < 0) return std::nullopt;
    return rescale(static_cast<uint64_t>(media_time), track.timescale, movie.timescale);
  }
  uint64_t start = 0;
  for (const Mp4Edit& edit : track.edits) {
    if (edit.media_time >= 0 && media_time >= edit.media_time) {
      const auto since = static_cast<uint64_t>(media_time - edit.media_time);
      const uint64_t ticks = rescale(since, track.timescale, movie.timescale);
      // Writers give the last edit the duration 0 where they do not know it ("to the end").
      const bool open = edit.duration == 0 && &edit == &track.edits.back();
      if (ticks < edit.duration || open) return start + ticks;
    }
    start += edit.duration;
  }
  return std::nullopt;
}

void update_durations(Mp4Movie& movie) {
  movie.duration = 0;
  movie.next_track_id = 1;
  for (Mp4Track& track : movie.tracks) {
    track.media_duration = 0;
    for (const Mp4Sample& sample : track.samples) track.media_duration += sample.duration;
    track.duration = track.edits.empty()
                         ? rescale(track.media_duration, track.timescale, movie.timescale)
                         : edited_duration(movie, track);
    movie.duration = std::max(movie.duration, track.duration);
    if (track.id >= movie.next_track_id && track.id != 0xFFFFFFFF) {
      movie.next_track_id = track.id + 1;
    }
  }
}

}  // namespace afx::bifs
