// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/mp4_writer.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "bifs/mp4_reader.h"
#include "bifs/mp4_table_writer.h"

namespace afx::bifs {
namespace {

using Bytes = std::vector<uint8_t>;
using Scope = Mp4BoxWriter::Scope;

constexpr uint64_t kMost32 = 0xFFFFFFFF;

Error bad(const Mp4Track& track, const std::string& text) {
  return {Errc::bad_argument, Place::none(), "track " + std::to_string(track.id) + ": " + text};
}

Status check_samples(const Mp4Track& track) {
  int64_t least = 0;
  int64_t most = 0;
  uint64_t time = 0;
  for (const Mp4Sample& sample : track.samples) {
    if (sample.time != time) {
      return bad(track, "a sample has the time " + std::to_string(sample.time) + " (expected " +
                            std::to_string(time) + ", where those before it end)");
    }
    time += sample.duration;
    if (sample.entry >= track.entries.size()) return bad(track, "a sample has no sample entry");
    least = std::min(least, sample.composition_offset);
    most = std::max(most, sample.composition_offset);
  }
  const int64_t allowed = least < 0 ? int64_t{0x7FFFFFFF} : int64_t{0xFFFFFFFF};
  if (least < -int64_t{0x80000000} || most > allowed) {
    return bad(track, "the composition offsets need more than 32 bits");
  }
  if (track.samples.size() > kMost32) return bad(track, "has more than 2^32 - 1 samples");
  return {};
}

Status check(const Mp4Movie& movie) {
  if (movie.timescale == 0) {
    return Error{Errc::bad_argument, Place::none(),
                 "the movie's timescale is 0 (expected 1 or more)"};
  }
  std::set<uint32_t> ids;
  for (const Mp4Track& track : movie.tracks) {
    if (track.id == 0 || !ids.insert(track.id).second) {
      return bad(track, "the ID is 0 or used twice (expected one of its own)");
    }
    if (track.timescale == 0) return bad(track, "the timescale is 0 (expected 1 or more)");
    for (const Mp4SampleEntry& entry : track.entries) {
      if (!entry.in_this_file) {
        return Error{Errc::unsupported, Place::none(),
                     "track " + std::to_string(track.id) + ": its samples lie in another file"};
      }
    }
    Status status = check_samples(track);
    if (!status.ok()) return status;
  }
  return {};
}

/// Times and durations take 32 bits unless one of them needs more.
bool needs_64(std::initializer_list<uint64_t> numbers, uint64_t duration) {
  return std::max(numbers) > kMost32 || (duration >= kMost32 && duration != kMp4UnknownDuration);
}

/// Writes 'moov' for given places of the samples.
class MovieWriter {
 public:
  MovieWriter(const Mp4Movie& movie, const std::vector<std::vector<Mp4Chunk>>& chunks,
              uint64_t data, bool wide, Bytes& out)
      : movie_(movie), chunks_(chunks), data_(data), wide_(wide), out_(out) {}

  Status write() {
    const Scope moov(out_, fourcc("moov"));
    movie_header();
    if (movie_.initial_object) {
      Status status = write_descriptor_box(fourcc("iods"), *movie_.initial_object, out_);
      if (!status.ok()) return status;
    }
    for (size_t i = 0; i < movie_.tracks.size(); ++i) {
      Status status = track(movie_.tracks[i], chunks_[i]);
      if (!status.ok()) return status;
    }
    for (const Mp4Box& box : movie_.boxes) out_.box(box);
    return {};
  }

 private:
  void movie_header();
  Status track(const Mp4Track& track, const std::vector<Mp4Chunk>& chunks);
  void track_header(const Mp4Track& track);
  void edits(const std::vector<Mp4Edit>& edits);
  void references(const std::vector<Mp4Reference>& references);
  void media_header(const Mp4Track& track);
  void handler(const Mp4Track& track);
  void data_reference();

  const Mp4Movie& movie_;
  const std::vector<std::vector<Mp4Chunk>>& chunks_;
  uint64_t data_;
  bool wide_;
  Mp4BoxWriter out_;
};

void MovieWriter::movie_header() {
  const bool wide = needs_64({movie_.created, movie_.modified}, movie_.duration);
  const Scope mvhd(out_, fourcc("mvhd"));
  out_.version(wide ? 1 : 0, 0);
  out_.u(movie_.created, wide ? 8 : 4);
  out_.u(movie_.modified, wide ? 8 : 4);
  out_.u32(movie_.timescale);
  out_.u(movie_.duration, wide ? 8 : 4);
  out_.i32(movie_.rate);
  out_.i16(movie_.volume);
  out_.zeros(10);
  out_.matrix(movie_.matrix);
  out_.zeros(24);
  out_.u32(movie_.next_track_id);
}

Status MovieWriter::track(const Mp4Track& track, const std::vector<Mp4Chunk>& chunks) {
  const Scope trak(out_, fourcc("trak"));
  track_header(track);
  edits(track.edits);
  references(track.references);
  {
    const Scope mdia(out_, fourcc("mdia"));
    media_header(track);
    handler(track);
    const Scope minf(out_, fourcc("minf"));
    out_.box(track.media_header);
    data_reference();
    Status status = write_sample_tables(track, chunks, data_, wide_, out_);
    if (!status.ok()) {
      Error error = std::move(status).error();
      error.text = "track " + std::to_string(track.id) + ": " + error.text;
      return error;
    }
  }
  for (const Mp4Box& box : track.boxes) out_.box(box);
  return {};
}

void MovieWriter::track_header(const Mp4Track& track) {
  const bool wide = needs_64({track.created, track.modified}, track.duration);
  const Scope tkhd(out_, fourcc("tkhd"));
  out_.version(wide ? 1 : 0, track.flags & 0xFFFFFF);
  out_.u(track.created, wide ? 8 : 4);
  out_.u(track.modified, wide ? 8 : 4);
  out_.u32(track.id);
  out_.zeros(4);
  out_.u(track.duration, wide ? 8 : 4);
  out_.zeros(8);
  out_.i16(track.layer);
  out_.i16(track.alternate_group);
  out_.i16(track.volume);
  out_.zeros(2);
  out_.matrix(track.matrix);
  out_.u32(track.width);
  out_.u32(track.height);
}

void MovieWriter::edits(const std::vector<Mp4Edit>& edits) {
  if (edits.empty()) return;
  const bool wide = std::any_of(edits.begin(), edits.end(), [](const Mp4Edit& edit) {
    return edit.duration > kMost32 || edit.media_time > 0x7FFFFFFF ||
           edit.media_time < -int64_t{0x80000000};
  });
  const Scope edts(out_, fourcc("edts"));
  const Scope elst(out_, fourcc("elst"));
  out_.version(wide ? 1 : 0, 0);
  out_.u32(static_cast<uint32_t>(edits.size()));
  for (const Mp4Edit& edit : edits) {
    out_.u(edit.duration, wide ? 8 : 4);
    out_.u(static_cast<uint64_t>(edit.media_time), wide ? 8 : 4);
    out_.i32(edit.rate);
  }
}

void MovieWriter::references(const std::vector<Mp4Reference>& references) {
  if (references.empty()) return;
  const Scope tref(out_, fourcc("tref"));
  for (const Mp4Reference& reference : references) {
    const Scope list(out_, reference.type);
    for (const uint32_t id : reference.tracks) out_.u32(id);
  }
}

void MovieWriter::media_header(const Mp4Track& track) {
  const bool wide = needs_64({track.media_created, track.media_modified}, track.media_duration);
  const Scope mdhd(out_, fourcc("mdhd"));
  out_.version(wide ? 1 : 0, 0);
  out_.u(track.media_created, wide ? 8 : 4);
  out_.u(track.media_modified, wide ? 8 : 4);
  out_.u32(track.timescale);
  out_.u(track.media_duration, wide ? 8 : 4);
  out_.u16(track.language);
  out_.zeros(2);
}

void MovieWriter::handler(const Mp4Track& track) {
  const Scope hdlr(out_, fourcc("hdlr"));
  out_.version(0, 0);
  out_.zeros(4);
  out_.u32(track.handler);
  out_.zeros(12);
  const std::string name = track.name.substr(0, track.name.find('\0'));
  out_.bytes({reinterpret_cast<const uint8_t*>(name.data()), name.size()});
  out_.u8(0);
}

void MovieWriter::data_reference() {
  const Scope dinf(out_, fourcc("dinf"));
  const Scope dref(out_, fourcc("dref"));
  out_.version(0, 0);
  out_.u32(1);
  const Scope url(out_, fourcc("url "));
  out_.version(0, 1);  // the samples are in this file
}

Bytes file_type(const Mp4Movie& movie) {
  Bytes bytes;
  {
    Mp4BoxWriter out(bytes);
    const Scope ftyp(out, fourcc("ftyp"));
    out.u32(movie.major_brand);
    out.u32(movie.minor_version);
    for (const FourCc brand : movie.compatible_brands) out.u32(brand);
  }
  return bytes;
}

Bytes data_header(uint64_t size) {
  Bytes bytes;
  Mp4BoxWriter out(bytes);
  const bool wide = size + 8 > kMost32;
  out.u32(wide ? 1 : static_cast<uint32_t>(size + 8));
  out.u32(fourcc("mdat"));
  if (wide) out.u(size + 16, 8);
  return bytes;
}

Status write_samples(const Mp4Movie& movie, const Mp4Layout& layout, const Mp4SampleBytes& bytes,
                     const Mp4Sink& sink) {
  for (const Mp4Chunk& chunk : layout.chunks) {
    const Mp4Track& track = movie.tracks[chunk.track];
    for (size_t i = chunk.first; i < chunk.first + chunk.count; ++i) {
      const auto sample = bytes(chunk.track, i);
      if (!sample.ok()) return sample.error();
      if (sample.value().size() != track.samples[i].size) {
        return bad(track, "sample " + std::to_string(i) + " has " +
                              std::to_string(sample.value().size()) + " bytes (expected " +
                              std::to_string(track.samples[i].size) + ")");
      }
      Status status = sink(sample.value());
      if (!status.ok()) return status;
    }
  }
  return {};
}

}  // namespace

Mp4SampleBytes samples_of(const Mp4Source& source, const Mp4Movie& movie, const Limits& limits) {
  return [&source, &movie, &limits](size_t track, size_t sample) {
    return read_sample(source, movie.tracks[track], sample, limits);
  };
}

Status write_mp4(const Mp4Movie& movie, const Mp4SampleBytes& bytes, const Mp4Sink& sink) {
  Status status = check(movie);
  if (!status.ok()) return status;
  const Mp4Layout layout = lay_out(movie);
  std::vector<std::vector<Mp4Chunk>> chunks(movie.tracks.size());
  for (const Mp4Chunk& chunk : layout.chunks) chunks[chunk.track].push_back(chunk);
  Bytes front = file_type(movie);
  const size_t type_size = front.size();
  const Bytes header = layout.bytes > 0 ? data_header(layout.bytes) : Bytes();
  // The size of 'moov' does not depend on the offsets, only on their width: write it once to see
  // its size, and again where the offsets are known.
  bool wide = false;
  if (status = MovieWriter(movie, chunks, 0, wide, front).write(); !status.ok()) return status;
  const uint64_t last = layout.chunks.empty() ? 0 : layout.chunks.back().offset;
  if (front.size() + header.size() + last > kMost32) {
    wide = true;
    front.resize(type_size);
    if (status = MovieWriter(movie, chunks, 0, wide, front).write(); !status.ok()) return status;
  }
  if (front.size() - type_size > kMost32) {
    return Error{Errc::limit_exceeded, Place::none(), "'moov' would have 4 GB or more"};
  }
  const uint64_t data = front.size() + header.size();
  front.resize(type_size);
  if (status = MovieWriter(movie, chunks, data, wide, front).write(); !status.ok()) return status;
  front.insert(front.end(), header.begin(), header.end());
  if (status = sink(front); !status.ok()) return status;
  return write_samples(movie, layout, bytes, sink);
}

}  // namespace afx::bifs
