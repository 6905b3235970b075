// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/mp4_builder.h"

#include <algorithm>
#include <string>
#include <utility>

#include "bifs/mp4_writer.h"

namespace afx::bifs {
namespace {

Mp4Track make_systems_track(uint32_t id, const char* handler, const char* name, uint8_t object_type,
                            uint8_t stream_type, std::vector<uint8_t> config) {
  DecoderConfig decoder;
  decoder.object_type = object_type;
  decoder.stream_type = stream_type;
  Mp4SampleEntry entry;
  entry.head = {0, 0, 0, 0, 0, 0, 0, 1};
  entry.es = Descriptor{es_descriptor_in_file(std::move(decoder), std::move(config))};
  Mp4Track track;
  track.id = id;
  track.handler = fourcc(handler);
  track.name = name;
  track.entries.push_back(std::move(entry));
  return track;
}

/// The fields of a VisualSampleEntry: 72 pixels an inch, one picture a sample, depth 24, no colour
/// table.
std::vector<uint8_t> visual_head(uint16_t width, uint16_t height) {
  std::vector<uint8_t> head(78);
  const auto put = [&head](size_t at, unsigned value) {
    head[at] = static_cast<uint8_t>(value >> 8);
    head[at + 1] = static_cast<uint8_t>(value);
  };
  put(6, 1);
  put(24, width);
  put(26, height);
  put(28, 72);
  put(32, 72);
  put(40, 1);
  put(74, 24);
  put(76, 0xFFFF);
  return head;
}

/// The most bits that begin within any one second.
uint64_t most_bits_a_second(const Mp4Track& track) {
  uint64_t most = 0;
  uint64_t sum = 0;
  size_t first = 0;
  for (const Mp4Sample& sample : track.samples) {
    sum += uint64_t{sample.size} * 8;
    while (sample.time - track.samples[first].time >= track.timescale) {
      sum -= uint64_t{track.samples[first++].size} * 8;
    }
    most = std::max(most, sum);
  }
  return most;
}

/// Of a track with a duration.
uint64_t average_bitrate(uint64_t bytes, const Mp4Track& track) {
  const uint64_t bits = bytes * 8;
  if (bits <= ~uint64_t{0} / track.timescale) return bits * track.timescale / track.media_duration;
  return bits / std::max<uint64_t>(1, track.media_duration / track.timescale);
}

uint32_t clip32(uint64_t value) {
  return static_cast<uint32_t>(std::min<uint64_t>(value, 0xFFFFFFFF));
}

}  // namespace

Mp4Track make_scene_track(uint32_t id, uint8_t object_type, std::vector<uint8_t> config,
                          uint16_t width, uint16_t height) {
  Mp4Track track = make_systems_track(id, "sdsm", "afx scene description", object_type,
                                      stream_type::kScene, std::move(config));
  track.width = uint32_t{width} << 16;
  track.height = uint32_t{height} << 16;
  return track;
}

Mp4Track make_object_descriptor_track(uint32_t id, std::vector<uint32_t> mpod) {
  Mp4Track track =
      make_systems_track(id, "odsm", "afx object descriptors", object_type::kObjectDescriptor,
                         stream_type::kObjectDescriptor, {});
  if (!mpod.empty()) track.references.push_back({fourcc("mpod"), std::move(mpod)});
  return track;
}

Mp4Track make_afx_track(uint32_t id, std::vector<uint8_t> config) {
  return make_systems_track(id, "sdsm", "afx stream", object_type::kAfx, stream_type::kScene,
                            std::move(config));
}

Mp4Track make_image_track(uint32_t id, uint8_t object_type, uint16_t width, uint16_t height) {
  Mp4Track track =
      make_systems_track(id, "vide", "afx pictures", object_type, stream_type::kVisual, {});
  track.width = uint32_t{width} << 16;
  track.height = uint32_t{height} << 16;
  track.media_header = {fourcc("vmhd"), {0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0}};
  track.entries[0].type = fourcc("mp4v");
  track.entries[0].head = visual_head(width, height);
  return track;
}

Descriptor make_initial_object(uint32_t scene_track, uint32_t od_track) {
  InitialObjectDescriptor object;
  object.od_profile = 0xFE;
  object.parts.push_back({EsIdInc{scene_track}});
  if (od_track != 0) object.parts.push_back({EsIdInc{od_track}});
  return {object};
}

size_t Mp4Builder::add_track(Mp4Track track) {
  movie.tracks.push_back(std::move(track));
  samples_.resize(movie.tracks.size());
  return movie.tracks.size() - 1;
}

size_t Mp4Builder::add_media(Media media) {
  const size_t track = add_track(std::move(media.track));
  samples_[track].elsewhere = std::move(media.bytes);
  return track;
}

void Mp4Builder::delay_track(size_t track, uint64_t ticks) {
  const uint64_t duration = rescale(ticks, movie.tracks[track].timescale, movie.timescale);
  movie.tracks[track].edits = {{duration, -1}, {0, 0}};
}

void Mp4Builder::add_sample(size_t track, std::vector<uint8_t> bytes, uint64_t time,
                            bool random_access) {
  Mp4Sample sample;
  sample.time = time;
  sample.random_access = random_access;
  movie.tracks[track].samples.push_back(sample);
  samples_[track].bytes.push_back(std::move(bytes));
  samples_[track].times.push_back(time);
}

void Mp4Builder::set_last_duration(size_t track, uint32_t ticks) {
  samples_[track].last_duration = ticks;
}

Status Mp4Builder::fill_samples(size_t place) {
  Mp4Track& track = movie.tracks[place];
  const Samples& media = samples_[place];
  if (media.elsewhere) return {};
  const auto bad = [&track](const std::string& text) {
    return Error{Errc::bad_argument, Place::none(),
                 "track " + std::to_string(track.id) + ": " + text};
  };
  if (track.timescale == 0) return bad("the timescale is 0 (expected 1 or more)");
  if (media.bytes.size() != track.samples.size()) {
    return bad("samples were added to the movie without their bytes (expected add_sample)");
  }
  for (size_t i = 0; i < track.samples.size(); ++i) {
    if (media.bytes[i].size() > 0xFFFFFFFF) return bad("a sample has 4 GB or more");
    track.samples[i].size = static_cast<uint32_t>(media.bytes[i].size());
    const bool last = i + 1 == track.samples.size();
    const uint64_t next = last ? media.times[i] + media.last_duration : media.times[i + 1];
    if (next < media.times[i] || next - media.times[i] > 0xFFFFFFFF) {
      return bad("the times of the samples go back or leave a gap of 2^32 ticks");
    }
    track.samples[i].duration = static_cast<uint32_t>(next - media.times[i]);
  }
  return {};
}

void Mp4Builder::fill_config(Mp4Track& track) {
  for (size_t place = 0; place < track.entries.size(); ++place) {
    auto& descriptor = track.entries[place].es;
    auto* es = descriptor ? std::get_if<EsDescriptor>(&descriptor->body) : nullptr;
    if (es == nullptr) continue;
    uint64_t bytes = 0;
    uint32_t largest = 0;
    for (const Mp4Sample& sample : track.samples) {
      bytes += sample.size;
      if (sample.entry == place) largest = std::max(largest, sample.size);
    }
    for (Descriptor& part : es->parts) {
      auto* config = std::get_if<DecoderConfig>(&part.body);
      if (config == nullptr) continue;
      if (config->buffer_bytes == 0) config->buffer_bytes = std::min<uint32_t>(largest, 0xFFFFFF);
      if (track.media_duration == 0) continue;  // one access unit for ever: no rate
      const uint64_t average = average_bitrate(bytes, track);
      if (config->avg_bitrate == 0) config->avg_bitrate = clip32(average);
      if (config->max_bitrate == 0) {
        config->max_bitrate = clip32(std::max(average, most_bits_a_second(track)));
      }
    }
  }
}

Status Mp4Builder::write(const Mp4Sink& sink) {
  samples_.resize(movie.tracks.size());
  for (size_t track = 0; track < movie.tracks.size(); ++track) {
    Status status = fill_samples(track);
    if (!status.ok()) return status;
  }
  update_durations(movie);
  for (size_t i = 0; i < movie.tracks.size(); ++i)
    if (!samples_[i].elsewhere) fill_config(movie.tracks[i]);
  return write_mp4(
      movie,
      [this](size_t track, size_t sample) -> Result<std::vector<uint8_t>> {
        const Samples& media = samples_[track];
        return media.elsewhere ? media.elsewhere(sample) : std::move(samples_[track].bytes[sample]);
      },
      sink);
}

}  // namespace afx::bifs
