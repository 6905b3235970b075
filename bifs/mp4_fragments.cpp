// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/mp4_fragments.h"

#include "bifs/mp4_sample_tables.h"

namespace afx::bifs {
namespace {

constexpr uint32_t kNotSync = 0x10000;  // of the flags of a sample

/// Samples that are said to have no bytes cost none: only so many are believed.
constexpr uint32_t kMostEmptySamples = 4096;

/// The movie and what is known of its tracks.
struct Tracks {
  const Mp4TrackDefaults& defaults;
  const std::map<uint32_t, size_t>& places;
  Mp4Movie& movie;
};

/// The 'traf' being read.
struct Fragment {
  Mp4Track* track = nullptr;
  Mp4FragmentDefaults defaults;
  uint64_t base = 0;  // offsets of runs count from here
  uint64_t next = 0;  // where a run without an offset begins
  uint64_t time = 0;  // of the next sample
};

Status read_header(const Mp4Part& tfhd, const Tracks& tracks, uint64_t moof_begin,
                   Mp4Context& context, Fragment& fragment) {
  Mp4Fields in(tfhd, context);
  const uint32_t flags = in.version(0).flags;
  const uint32_t id = in.u32("track_ID");
  const auto found = tracks.places.find(id);
  if (in.ok() && found == tracks.places.end()) {
    in.fail(Errc::malformed, "track_ID is " + std::to_string(id) + " (expected that of a track)");
  }
  if (!in.ok()) return in.status();
  fragment.track = &tracks.movie.tracks[found->second];
  const auto general = tracks.defaults.find(id);
  if (general != tracks.defaults.end()) fragment.defaults = general->second;
  if ((flags & 0x20000) != 0) fragment.base = moof_begin;
  if ((flags & 1) != 0) fragment.base = in.u(8, "base_data_offset");
  if ((flags & 2) != 0) fragment.defaults.entry = in.u32("sample_description_index");
  if ((flags & 8) != 0) fragment.defaults.duration = in.u32("default_sample_duration");
  if ((flags & 0x10) != 0) fragment.defaults.size = in.u32("default_sample_size");
  if ((flags & 0x20) != 0) fragment.defaults.flags = in.u32("default_sample_flags");
  const uint32_t entry = fragment.defaults.entry;
  const size_t entries = fragment.track->entries.size();
  if (in.ok() && (entry == 0 || entry > entries)) {
    in.fail(Errc::malformed, "sample_description_index is " + std::to_string(entry) +
                                 " (expected 1 to " + std::to_string(entries) + ")");
  }
  fragment.next = fragment.base;
  return in.status();
}

/// 'tfdt' says when the first sample of the fragment is decoded; the sample before lasts until
/// then.
Status read_time(const Mp4Part& tfdt, Mp4Context& context, Fragment& fragment) {
  Mp4Fields in(tfdt, context);
  const unsigned wide = in.version(1).version == 1 ? 8 : 4;
  const uint64_t time = in.u(wide, "baseMediaDecodeTime");
  std::vector<Mp4Sample>& samples = fragment.track->samples;
  if (in.ok() && !samples.empty()) {
    const uint64_t before = samples.back().time;
    if (time < before || time - before > 0xFFFFFFFF) {
      in.fail(Errc::malformed, "baseMediaDecodeTime is " + std::to_string(time) + " (expected " +
                                   std::to_string(before) +
                                   ", the time of the sample before, or up to 2^32 more)");
      return in.status();
    }
    samples.back().duration = static_cast<uint32_t>(time - before);
  }
  if (in.ok() && time >> 63 != 0) {
    in.fail(Errc::malformed,
            "baseMediaDecodeTime is " + std::to_string(time) + " (expected less than 2^63)");
  }
  fragment.time = time;
  return in.status();
}

class RunReader {
 public:
  RunReader(const Mp4Part& trun, Mp4Context& context, Fragment& fragment)
      : part_(trun), context_(context), fragment_(fragment), in_(trun, context) {}

  Status read() {
    const auto header = in_.version(1);
    flags_ = header.flags;
    is_signed_ = header.version == 1;
    unsigned bits = 0;
    for (const uint32_t field : {0x100U, 0x200U, 0x400U, 0x800U}) {
      if ((flags_ & field) != 0) bits += 32;
    }
    const uint32_t count = in_.count(bits, "sample_count");
    check_count(count);
    if ((flags_ & 1) != 0) move_to(in_.i32("data_offset"));
    if ((flags_ & 4) != 0) first_flags_ = in_.u32("first_sample_flags");
    Status status = in_.status();
    if (status.ok()) status = context_.charge(uint64_t{count} * sizeof(Mp4Sample), part_);
    for (uint32_t i = 0; i < count && status.ok(); ++i) status = read_one(i == 0);
    return status;
  }

 private:
  void move_to(int32_t data_offset) {
    const uint64_t back = data_offset < 0 ? -static_cast<uint64_t>(int64_t{data_offset}) : 0;
    if (back > fragment_.base) {
      in_.fail(Errc::malformed,
               "data_offset is " + std::to_string(data_offset) + ", which is before the file");
      return;
    }
    fragment_.next = fragment_.base + static_cast<uint64_t>(int64_t{data_offset});
  }

  /// Where the sizes are not listed, so many samples must be in the file.
  void check_count(uint32_t count) {
    const uint32_t size = fragment_.defaults.size;
    if ((flags_ & 0x200) == 0 && uint64_t{size} * count > context_.source.size) {
      in_.fail(Errc::truncated, "sample_count is " + std::to_string(count) + " with " +
                                    std::to_string(size) +
                                    " bytes for each, which is more than the file has");
    }
    if ((flags_ & 0x200) == 0 && size == 0 && count > kMostEmptySamples) {
      in_.fail(Errc::limit_exceeded, "there are " + std::to_string(count) +
                                         " samples without bytes (expected at most " +
                                         std::to_string(kMostEmptySamples) + ")");
    }
  }

  Status read_one(bool first) {
    Mp4Sample sample;
    const uint64_t at = in_.offset();
    const Mp4FragmentDefaults& defaults = fragment_.defaults;
    sample.duration = (flags_ & 0x100) != 0 ? in_.u32("sample_duration") : defaults.duration;
    sample.size = (flags_ & 0x200) != 0 ? in_.u32("sample_size") : defaults.size;
    uint32_t flags = (flags_ & 0x400) != 0 ? in_.u32("sample_flags") : defaults.flags;
    if (first && (flags_ & 4) != 0) flags = first_flags_;
    if ((flags_ & 0x800) != 0) {
      const uint32_t raw = in_.u32("sample_composition_time_offset");
      sample.composition_offset = is_signed_ ? int64_t{static_cast<int32_t>(raw)} : int64_t{raw};
    }
    if (!in_.ok()) return in_.status();
    sample.random_access = (flags & kNotSync) == 0;
    sample.entry = defaults.entry - 1;
    sample.offset = fragment_.next;
    sample.time = fragment_.time;
    if (fragment_.track->entries[sample.entry].in_this_file) {
      Status status = check_sample_place(sample, part_, at, context_);
      if (!status.ok()) return status;
    }
    fragment_.next += sample.size;
    fragment_.time += sample.duration;
    fragment_.track->samples.push_back(sample);
    return {};
  }

  const Mp4Part& part_;
  Mp4Context& context_;
  Fragment& fragment_;
  Mp4Fields in_;
  uint32_t flags_ = 0;
  uint32_t first_flags_ = 0;
  bool is_signed_ = false;
};

Status read_track_fragment(const Mp4Part& traf, const Tracks& tracks, uint64_t moof_begin,
                           Mp4Context& context, Fragment& fragment) {
  constexpr FourCc kWanted[] = {fourcc("tfhd"), fourcc("tfdt")};
  const auto children = Mp4Children::read(traf, kWanted, context);
  if (!children.ok()) return children.error();
  const auto tfhd = children.value().need(fourcc("tfhd"));
  if (!tfhd.ok()) return tfhd.error();
  Status status = read_header(*tfhd.value(), tracks, moof_begin, context, fragment);
  if (!status.ok()) return status;
  const std::vector<Mp4Sample>& samples = fragment.track->samples;
  fragment.time = samples.empty() ? 0 : samples.back().time + samples.back().duration;
  const Mp4Part* tfdt = children.value().find(fourcc("tfdt"));
  if (tfdt != nullptr) status = read_time(*tfdt, context, fragment);
  for (const Mp4Part& other : children.value().others()) {
    if (!status.ok()) return status;
    if (other.type == fourcc("trun")) {
      status = RunReader(other, context, fragment).read();
    } else {
      context.warn("box_ignored", other, "is not carried along");
    }
  }
  return status;
}

}  // namespace

Status read_movie_extends(const Mp4Part& mvex, Mp4Context& context, Mp4TrackDefaults& defaults) {
  Mp4Fields boxes(mvex, context);
  while (const auto part = boxes.box()) {
    if (part->type != fourcc("trex")) continue;
    Mp4Fields in(*part, context);
    in.version(0);
    const uint32_t id = in.u32("track_ID");
    Mp4FragmentDefaults of;
    of.entry = in.u32("default_sample_description_index");
    of.duration = in.u32("default_sample_duration");
    of.size = in.u32("default_sample_size");
    of.flags = in.u32("default_sample_flags");
    if (!in.ok()) return in.status();
    Status charged = context.charge(2 * sizeof of, *part);
    if (!charged.ok()) return charged;
    defaults[id] = of;
  }
  return boxes.status();
}

Status read_fragment(const Mp4Part& moof, const Mp4TrackDefaults& defaults,
                     const std::map<uint32_t, size_t>& places, Mp4Context& context,
                     Mp4Movie& movie) {
  const Tracks tracks{defaults, places, movie};
  Mp4Fields boxes(moof, context);
  // Without a base of its own a 'traf' counts from 'moof', or from the end of the data of the one
  // before.
  uint64_t base = moof.begin;
  while (const auto part = boxes.box()) {
    if (part->type != fourcc("traf")) continue;
    Fragment fragment;
    fragment.base = base;
    Status status = read_track_fragment(*part, tracks, moof.begin, context, fragment);
    if (!status.ok()) return status;
    base = fragment.next;
  }
  return boxes.status();
}

}  // namespace afx::bifs
