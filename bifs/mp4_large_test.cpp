// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Files beyond 4 GB, which are never there as a whole.
#include <map>

#include "bifs/mp4_test_support.h"

namespace afx::bifs {
namespace {

using mp4_test::box;
using mp4_test::Bytes;
using mp4_test::join;
using mp4_test::numbers;

/// A file that is zero except for some stretches, and counts what is read.
struct SparseFile {
  std::map<uint64_t, Bytes> stretches;
  uint64_t size = 0;
  uint64_t bytes_read = 0;

  void put(uint64_t offset, const Bytes& bytes) {
    stretches[offset] = bytes;
    size = std::max(size, offset + bytes.size());
  }
  Mp4Source source() {
    return {size, [this](uint64_t offset, std::span<uint8_t> out) -> Status {
              bytes_read += out.size();
              std::fill(out.begin(), out.end(), uint8_t{0});
              for (const auto& [begin, bytes] : stretches) {
                for (size_t i = 0; i < bytes.size(); ++i) {
                  const uint64_t at = begin + i;
                  if (at >= offset && at - offset < out.size()) out[at - offset] = bytes[i];
                }
              }
              return {};
            }};
  }
};

constexpr uint64_t kFiveGb = 5'000'000'000;

TEST(Mp4Large, LargesizeAndCo64AreReadWithoutTheDataBetween) {
  SparseFile file;
  file.put(0, box("ftyp", numbers({fourcc("mp42"), 1})));
  Bytes mdat = numbers({1, fourcc("mdat")});
  mp4_test::put(mdat, kFiveGb + 1000 - 16, 8);  // up to the byte behind it
  file.put(16, mdat);
  file.put(kFiveGb, {'a', 'b', 'c', 'd', 'e', 'f', 'g'});
  mp4_test::HandMade made;
  Bytes offsets = numbers({0, 1});
  mp4_test::put(offsets, kFiveGb, 8);
  made.chunks = box("co64", offsets);
  file.put(kFiveGb + 1000, mp4_test::hand_made_moov(made));

  const Mp4Source source = file.source();
  Diagnostics diagnostics;
  const auto movie = read_mp4(source, {}, diagnostics);
  ASSERT_TRUE(movie.ok()) << to_string(movie.error());
  const Mp4Track& track = movie.value().tracks.at(0);
  ASSERT_EQ(track.samples.size(), 2U);
  EXPECT_EQ(read_sample(source, track, 0, {}).value(), (Bytes{'a', 'b', 'c'}));
  EXPECT_EQ(read_sample(source, track, 1, {}).value(), (Bytes{'d', 'e', 'f', 'g'}));
  EXPECT_LT(file.bytes_read, 2000U);
}

TEST(Mp4Large, ALastBoxOfSizeZeroReachesToTheEnd) {
  SparseFile file;
  const Bytes moov = mp4_test::hand_made_moov({});
  file.put(0, moov);
  file.put(moov.size(), numbers({0, fourcc("mdat")}));
  file.put(kFiveGb, {1});
  const Mp4Source source = file.source();
  Diagnostics diagnostics;
  EXPECT_TRUE(read_mp4(source, {}, diagnostics).ok());
}

/// A movie with `count` samples of 16 MB.
Mp4Movie big_movie(uint32_t count) {
  Mp4Movie movie = mp4_test::read(mp4_test::hand_made_file({})).value();
  Mp4Sample sample = movie.tracks[0].samples[0];
  sample.size = 16'000'000;
  movie.tracks[0].samples.clear();
  for (uint32_t i = 0; i < count; ++i) {
    sample.time = i * uint64_t{10};
    movie.tracks[0].samples.push_back(sample);
  }
  return movie;
}

/// The beginning of the file, up to the first sample, where the sink gives up.
Bytes front_of(const Mp4Movie& movie) {
  Bytes front;
  const Status status = write_mp4(
      movie, [](size_t, size_t) -> Result<Bytes> { return Bytes(16'000'000); },
      [&front](std::span<const uint8_t> part) -> Status {
        if (!front.empty()) return Error{Errc::io, Place::none(), "the disk is full"};
        front.assign(part.begin(), part.end());
        return {};
      });
  EXPECT_EQ(status.ok() ? "" : status.error().text, "the disk is full");
  return front;
}

bool holds(const Bytes& bytes, const std::string& text) {
  return std::search(bytes.begin(), bytes.end(), text.begin(), text.end()) != bytes.end();
}

TEST(Mp4Large, SixtyFourBitFormsAreWrittenOnlyWhereTheyAreNeeded) {
  EXPECT_TRUE(holds(front_of(big_movie(200)), "stco"));  // 3.2 GB
  // 6.4 GB from one chunk: the data need a 64-bit size, the chunk begins near the front.
  Mp4Movie movie = big_movie(400);
  const Bytes one_chunk = front_of(movie);
  EXPECT_TRUE(holds(one_chunk, "stco"));
  // The same cut in two tracks, one of which begins behind the other's 6.4 GB.
  Mp4Track second = movie.tracks[0];
  second.id = 2;
  second.samples.assign(1, movie.tracks[0].samples[0]);
  second.samples.push_back(movie.tracks[0].samples[0]);
  second.samples[0].size = 0;
  second.samples[0].duration = 4000;
  second.samples[1].time = 4000;
  movie.tracks.push_back(second);
  const Bytes front = front_of(movie);
  EXPECT_TRUE(holds(front, "co64"));
  EXPECT_FALSE(holds(front, "stco"));

  SparseFile file;
  file.put(0, front);
  file.size = front.size() + 401 * uint64_t{16'000'000};
  Diagnostics diagnostics;
  const auto read = read_mp4(file.source(), {}, diagnostics);
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  const Mp4Track& track = read.value().tracks[1];
  EXPECT_EQ(track.samples[1].offset, file.size - 16'000'000);
  EXPECT_TRUE(mp4_test::without_offsets(read.value()) == mp4_test::without_offsets(movie));
}

TEST(Mp4Large, LongTimesSurviveWriting) {
  const Bytes bytes = mp4_test::hand_made_file({});
  Mp4Movie movie = mp4_test::read(bytes).value();
  movie.created = movie.tracks[0].media_created = uint64_t{1} << 33;
  movie.duration = 0xFFFFFFFF;  // in 32 bits this would say "unknown"
  movie.tracks[0].duration = kMp4UnknownDuration;
  movie.tracks[0].edits = {{uint64_t{1} << 32, -1, 0x10000}, {5, int64_t{1} << 31, 0x10000}};
  const auto again = mp4_test::read(mp4_test::rewrite(bytes, movie));
  ASSERT_TRUE(again.ok()) << to_string(again.error());
  EXPECT_TRUE(mp4_test::without_offsets(again.value()) == mp4_test::without_offsets(movie));
}

}  // namespace
}  // namespace afx::bifs
