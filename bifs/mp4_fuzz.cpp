// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Any bytes as an MP4 file and a raw scene. What is read is written, reads the same, and is then
// written to the same bytes.
#include <algorithm>
#include <cstdint>
#include <vector>

#include "bifs/mp4_reader.h"
#include "bifs/mp4_writer.h"
#include "bifs/raw_bifs.h"
#include "codec/fuzz_test_support.h"

namespace {

using namespace afx;
using namespace afx::bifs;
using Bytes = std::vector<uint8_t>;

Limits small_limits() {
  Limits limits;
  limits.memory = 4U << 20;
  return limits;
}

Status rewrite(std::span<const uint8_t> file, const Mp4Movie& movie, Bytes& out) {
  const Mp4Source source = mp4_source(file);
  const Limits limits = small_limits();
  return write_mp4(movie, samples_of(source, movie, limits),
                   [&out](std::span<const uint8_t> part) -> Status {
                     // Tables may name the same bytes again and again.
                     if (out.size() + part.size() > (64U << 20)) {
                       return Error{Errc::limit_exceeded, Place::none(), "enough"};
                     }
                     out.insert(out.end(), part.begin(), part.end());
                     return {};
                   });
}

/// Without what is another in a written file: where samples lie, and the number of the data
/// reference, of which it has one.
Mp4Movie comparable(Mp4Movie movie) {
  for (Mp4Track& track : movie.tracks) {
    for (Mp4Sample& sample : track.samples) sample.offset = 0;
    for (Mp4SampleEntry& entry : track.entries)
      if (entry.head.size() >= 8) entry.head[6] = entry.head[7] = 0;
  }
  return movie;
}

void check_error(const Error& error, size_t size) {
  require(!error.text.empty());
  require(error.place.kind == Place::Kind::bit && error.place.bit <= uint64_t{size} * 8);
}

void run_file(std::span<const uint8_t> data) {
  Diagnostics diagnostics;
  const auto movie = read_mp4(mp4_source(data), small_limits(), diagnostics);
  if (!movie.ok()) return check_error(movie.error(), data.size());
  Bytes first;
  if (!rewrite(data, movie.value(), first).ok()) return;
  Limits limits = small_limits();
  limits.memory *= 4;  // the other form of the same may take a little more
  Diagnostics none;
  const auto again = read_mp4(mp4_source(first), limits, none);
  require(again.ok());
  require(comparable(movie.value()) == comparable(again.value()));
  Bytes second;
  require(rewrite(first, again.value(), second).ok());
  require(first == second);
}

void run_raw(std::span<const uint8_t> data) {
  const auto scene = read_raw_bifs(data, small_limits());
  if (!scene.ok()) return check_error(scene.error(), data.size());
  const auto written = write_raw_bifs(scene.value());
  require(written.ok());
  require(std::equal(written.value().begin(), written.value().end(), data.begin(), data.end()));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::span<const uint8_t> bytes(data, size);
  run_file(bytes);
  run_raw(bytes);
  return 0;
}
