// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/mp4_reader.h"

#include <algorithm>
#include <map>
#include <utility>

#include "bifs/mp4_box_reader.h"
#include "bifs/mp4_fragments.h"
#include "bifs/mp4_sample_entry.h"
#include "bifs/mp4_track_reader.h"

namespace afx::bifs {
namespace {

/// A box of the file itself, not read yet.
struct TopBox {
  FourCc type = 0;
  uint64_t begin = 0;
  uint64_t payload = 0;  // offset
  uint64_t end = 0;
};

/// Boxes that say nothing that would be lost.
bool is_dispensable(FourCc type) {
  for (const char* known : {"mdat", "free", "skip", "wide", "sidx", "ssix", "styp", "mfra"}) {
    if (type == fourcc(known)) return true;
  }
  return false;
}

class Mp4Reader {
 public:
  Mp4Reader(const Mp4Source& source, const Limits& limits, Diagnostics& diagnostics,
            const codec::Trace* trace)
      : context_{source, limits, diagnostics, trace, limits.memory} {}

  Result<Mp4Movie> read() {
    for (uint64_t at = 0; at < context_.source.size;) {
      const auto box = header(at);
      if (!box.ok()) return box.error();
      Status status = top_box(box.value());
      if (!status.ok()) return status.error();
      at = box.value().end;
    }
    if (!has_movie_) {
      return Error{Errc::malformed, Place::at_byte(context_.source.size),
                   "there is no 'moov' (expected an MP4 file)"};
    }
    if (context_.fragmented) update_durations(movie_);
    return std::move(movie_);
  }

 private:
  Result<TopBox> header(uint64_t at);
  Status top_box(const TopBox& box);
  Status load(const TopBox& box, std::vector<uint8_t>& bytes, Mp4Part& part);
  Status brands(const Mp4Part& ftyp);
  Status movie(const Mp4Part& moov);
  Status movie_header(const Mp4Part& mvhd);
  Status track(const Mp4Part& trak);
  Status other(const Mp4Part& part);

  Mp4Context context_;
  Mp4Movie movie_;
  Mp4TrackDefaults defaults_;
  std::map<uint32_t, size_t> places_;  // of each track ID in movie_.tracks
  bool has_movie_ = false;
  unsigned fragments_ = 0;
};

Result<TopBox> Mp4Reader::header(uint64_t at) {
  const uint64_t left = context_.source.size - at;
  std::array<uint8_t, 16> bytes{};
  const auto have = static_cast<size_t>(std::min<uint64_t>(left, bytes.size()));
  Status status = context_.source.read(at, std::span(bytes).first(have));
  if (!status.ok()) return status.error();
  const Mp4Part whole{0, std::span(bytes).first(have), at, at, "file"};
  Mp4Fields in(whole, context_);
  TopBox box;
  uint64_t size = in.u32("size");
  box.type = in.u32("type");
  if (size == 1) size = in.u(8, "largesize");
  if (!in.ok()) return in.status().error();
  box.begin = at;
  box.payload = in.offset();
  if (size == 0) size = left;  // to the end of the file
  const Mp4Part named{box.type, {}, at, at, to_string(box.type)};
  if (size < box.payload - at) {
    return mp4_error(Errc::malformed, named, at,
                     "its size is " + std::to_string(size) + " (expected at least its header of " +
                         std::to_string(box.payload - at) + " bytes)");
  }
  if (size > left) {
    return mp4_error(Errc::truncated, named, at,
                     "ends behind the file (expected " + std::to_string(size) + " bytes, " +
                         std::to_string(left) + " are left)");
  }
  box.end = at + size;
  return box;
}

Status Mp4Reader::load(const TopBox& box, std::vector<uint8_t>& bytes, Mp4Part& part) {
  part = {box.type, {}, box.payload, box.begin, to_string(box.type)};
  const uint64_t size = box.end - box.payload;
  if (size > context_.memory_left) return context_.charge(size, part);
  bytes.resize(size);
  part.bytes = bytes;
  return context_.source.read(box.payload, bytes);
}

Status Mp4Reader::top_box(const TopBox& box) {
  std::vector<uint8_t> bytes;
  Mp4Part part;
  if (box.type == fourcc("ftyp")) {
    Status status = load(box, bytes, part);
    return status.ok() ? brands(part) : status;
  }
  if (box.type == fourcc("moov")) {
    Status status = load(box, bytes, part);
    return status.ok() ? movie(part) : status;
  }
  if (box.type == fourcc("moof")) {
    Status status = load(box, bytes, part);
    if (!status.ok()) return status;
    part.path += "[" + std::to_string(fragments_++) + "]";
    context_.fragmented = true;
    if (has_movie_) return read_fragment(part, defaults_, places_, context_, movie_);
    return mp4_error(Errc::malformed, part, box.begin, "stands before 'moov' (expected behind it)");
  }
  if (!is_dispensable(box.type)) {
    part = {box.type, {}, box.begin, box.begin, to_string(box.type)};
    context_.warn("box_ignored", part, "is not carried along");
  }
  return {};
}

Status Mp4Reader::brands(const Mp4Part& ftyp) {
  Status charged = context_.charge(ftyp.bytes.size(), ftyp);
  if (!charged.ok()) return charged;
  Mp4Fields in(ftyp, context_);
  movie_.major_brand = in.u32("major_brand");
  movie_.minor_version = in.u32("minor_version");
  movie_.compatible_brands.clear();
  while (in.ok() && in.left() > 0) {
    movie_.compatible_brands.push_back(in.u32("compatible_brand"));
  }
  return in.status();
}

Status Mp4Reader::movie(const Mp4Part& moov) {
  if (has_movie_) {
    return mp4_error(Errc::malformed, moov, moov.begin, "is there twice (expected once)");
  }
  has_movie_ = true;
  constexpr FourCc kWanted[] = {fourcc("mvhd"), fourcc("iods"), fourcc("mvex"), fourcc("cmov")};
  const auto read = Mp4Children::read(moov, kWanted, context_);
  if (!read.ok()) return read.error();
  const Mp4Children& children = read.value();
  if (const Mp4Part* cmov = children.find(fourcc("cmov"))) {
    return mp4_error(Errc::unsupported, *cmov, cmov->begin, "a compressed 'moov' is not read");
  }
  const auto mvhd = children.need(fourcc("mvhd"));
  if (!mvhd.ok()) return mvhd.error();
  Status status = movie_header(*mvhd.value());
  const Mp4Part* iods = children.find(fourcc("iods"));
  if (status.ok() && iods != nullptr) {
    auto initial = read_descriptor_box(*iods, context_);
    if (!initial.ok()) return initial.error();
    movie_.initial_object = std::move(initial).value();
  }
  const Mp4Part* mvex = children.find(fourcc("mvex"));
  if (status.ok() && mvex != nullptr) status = read_movie_extends(*mvex, context_, defaults_);
  for (const Mp4Part& part : children.others()) {
    if (!status.ok()) return status;
    status = part.type == fourcc("trak") ? track(part) : other(part);
  }
  return status;
}

Status Mp4Reader::movie_header(const Mp4Part& mvhd) {
  Mp4Fields in(mvhd, context_);
  const unsigned wide = in.version(1).version == 1 ? 8 : 4;
  movie_.created = in.u(wide, "creation_time");
  movie_.modified = in.u(wide, "modification_time");
  movie_.timescale = in.u32("timescale");
  if (in.ok() && movie_.timescale == 0) {
    in.fail(Errc::malformed, "timescale is 0 (expected 1 or more)");
  }
  movie_.duration = read_duration(in, wide);
  movie_.rate = in.i32("rate");
  movie_.volume = in.i16("volume");
  in.skip(10, "reserved");
  movie_.matrix = read_matrix(in);
  in.skip(24, "pre_defined");
  movie_.next_track_id = in.u32("next_track_ID");
  return in.status();
}

Status Mp4Reader::track(const Mp4Part& trak) {
  auto read = read_track(trak, context_);
  if (!read.ok()) return read.error();
  if (!places_.emplace(read.value().id, movie_.tracks.size()).second) {
    return mp4_error(
        Errc::malformed, trak, trak.offset,
        "track_ID " + std::to_string(read.value().id) + " is used twice (expected one of its own)");
  }
  movie_.tracks.push_back(std::move(read).value());
  return {};
}

Status Mp4Reader::other(const Mp4Part& part) {
  auto box = keep_box(part, context_);
  if (!box.ok()) return box.error();
  movie_.boxes.push_back(std::move(box).value());
  return {};
}

}  // namespace

Result<Mp4Movie> read_mp4(const Mp4Source& source, const Limits& limits, Diagnostics& diagnostics,
                          const codec::Trace* trace) {
  return Mp4Reader(source, limits, diagnostics, trace).read();
}

namespace {

/// Whether a sample can be read.
Status check_sample(const Mp4Source& source, const Mp4Track& track, size_t index,
                    const Limits& limits) {
  const auto refuse = [&](Errc code, const std::string& text, Place place = Place::none()) {
    return Error{
        code, place,
        "track " + std::to_string(track.id) + ", sample " + std::to_string(index) + ": " + text};
  };
  if (index >= track.samples.size()) {
    return refuse(Errc::bad_argument,
                  "there are " + std::to_string(track.samples.size()) + " samples, counted from 0");
  }
  const Mp4Sample& sample = track.samples[index];
  if (sample.entry >= track.entries.size()) {
    return refuse(Errc::bad_argument, "its sample entry is not there");
  }
  if (!track.entries[sample.entry].in_this_file) {
    return refuse(Errc::unsupported, "it lies in another file, which is not read");
  }
  const Place place = Place::at_byte(sample.offset);
  if (sample.offset > source.size || sample.size > source.size - sample.offset) {
    return refuse(Errc::truncated,
                  "it ends behind the file of " + std::to_string(source.size) + " bytes", place);
  }
  if (sample.size > limits.memory) {
    return refuse(Errc::limit_exceeded, "it has more bytes than the limit allows", place);
  }
  return {};
}

}  // namespace

Result<std::vector<uint8_t>> read_sample(const Mp4Source& source, const Mp4Track& track,
                                         size_t index, const Limits& limits) {
  if (Status fits = check_sample(source, track, index, limits); !fits.ok()) return fits.error();
  const Mp4Sample& sample = track.samples[index];
  std::vector<uint8_t> bytes(sample.size);
  Status status = source.read(sample.offset, bytes);
  if (!status.ok()) return status.error();
  return bytes;
}

Result<Mp4SampleView> view_sample(const Mp4Source& source, const Mp4Track& track, size_t index,
                                  const Limits& limits) {
  if (Status fits = check_sample(source, track, index, limits); !fits.ok()) return fits.error();
  const Mp4Sample& sample = track.samples[index];
  if (source.view) return Mp4SampleView{{}, source.view(sample.offset, sample.size)};
  Mp4SampleView view{std::vector<uint8_t>(sample.size), {}};
  Status status = source.read(sample.offset, view.copy);
  if (!status.ok()) return status.error();
  view.bytes = view.copy;
  return view;
}

}  // namespace afx::bifs
