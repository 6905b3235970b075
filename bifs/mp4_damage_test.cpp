// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Files that are not as they should be: each gives an error with its byte and box, never more.
#include <functional>

#include "bifs/mp4_test_support.h"

namespace afx::bifs {
namespace {

using mp4_test::box;
using mp4_test::Bytes;
using mp4_test::HandMade;
using mp4_test::join;
using mp4_test::numbers;

TEST(Mp4Damage, TheUndamagedFileIsRead) {
  const Bytes file = mp4_test::hand_made_file({});
  const auto movie = mp4_test::read(file);
  ASSERT_TRUE(movie.ok()) << to_string(movie.error());
  const Mp4Track& track = movie.value().tracks.at(0);
  EXPECT_EQ(mp4_test::sample(file, track, 0), (Bytes{'a', 'b', 'c'}));
  EXPECT_EQ(mp4_test::sample(file, track, 1), (Bytes{'d', 'e', 'f', 'g'}));
  EXPECT_EQ(track.samples[1].time, 10U);
}

TEST(Mp4Damage, EveryTruncationOfAVectorIsACleanError) {
  for (const char* name : {"36-peer-end-flags", "13-media-object-descriptors", "14-bitwrapper"}) {
    const Bytes whole = mp4_test::read_file(std::string(name) + "/scene.mp4");
    size_t readable = 0;
    for (size_t size = 0; size < whole.size(); ++size) {
      const Bytes cut(whole.begin(), whole.begin() + static_cast<ptrdiff_t>(size));
      const auto movie = mp4_test::read(cut);
      if (movie.ok()) {
        ++readable;
        continue;
      }
      EXPECT_TRUE(movie.error().code == Errc::truncated || movie.error().code == Errc::malformed);
      EXPECT_EQ(movie.error().place.kind, Place::Kind::bit);
      EXPECT_LE(movie.error().place.bit, size * 8);
    }
    EXPECT_EQ(readable, 1U) << name;  // without the 'free' box at the end
  }
}

TEST(Mp4Damage, EveryCutInsideMoovSaysInWhichBox) {
  // Cut at the end of 'moov', all sizes around it made smaller: the error is in the box that is
  // cut.
  const Bytes whole = mp4_test::read_file("36-peer-end-flags/scene.mp4");
  const size_t moov = 28;
  const size_t size = whole[moov + 2] * 256U + whole[moov + 3];
  for (size_t cut = 8; cut < size; ++cut) {
    Bytes bytes(whole.begin(), whole.begin() + static_cast<ptrdiff_t>(moov + cut));
    bytes[moov + 2] = static_cast<uint8_t>(cut >> 8);
    bytes[moov + 3] = static_cast<uint8_t>(cut);
    const auto movie = mp4_test::read(bytes);
    if (movie.ok()) {  // between two boxes, before the track
      EXPECT_TRUE(movie.value().tracks.empty());
      continue;
    }
    EXPECT_TRUE(movie.error().text.starts_with("moov")) << movie.error().text;
    EXPECT_NE(movie.error().text.find(": "), std::string::npos);
  }
}

void expect_clean_with_each_byte_as(const std::string& name, const Bytes& values) {
  const Bytes whole = mp4_test::read_file(name + "/scene.mp4");
  for (size_t at = 0; at < whole.size(); ++at) {
    for (const uint8_t value : values) {
      Bytes bytes = whole;
      bytes[at] = value;
      const auto movie = mp4_test::read(bytes);
      if (movie.ok()) continue;
      EXPECT_EQ(movie.error().place.kind, Place::Kind::bit) << movie.error().text;
      EXPECT_LE(movie.error().place.bit, bytes.size() * 8);
      EXPECT_FALSE(movie.error().text.empty());
    }
  }
}

TEST(Mp4Damage, EveryByteOfAVectorMayBeWrong) {
  expect_clean_with_each_byte_as("36-peer-end-flags", {0x00, 0x01, 0x7F, 0x80, 0xFF});
  expect_clean_with_each_byte_as("14-bitwrapper", {0xFF});
}

TEST(Mp4Damage, TablesThatDoNotFitAreNamed) {
  const std::string stbl = "moov/trak[0]/mdia/minf/stbl";
  const struct {
    std::function<void(HandMade&)> change;
    Errc code;
    std::string text;
  } cases[] = {
      {[](HandMade& m) {
         m.stsz = numbers({0, 0, 0x40000000, 3, 4});
       },
       Errc::truncated,
       stbl + "/stsz: sample_count is 1073741824, which is more than the 8 bytes behind it hold"},
      {[](HandMade& m) {
         m.stsz = numbers({0, 1, 0xFFFFFFFF});
       },
       Errc::truncated,
       stbl + "/stsz: 4294967295 samples of 1 bytes each are more than the file has"},
      {[](HandMade& m) {
         m.stts = numbers({0, 1, 1, 10});
       },
       Errc::malformed, stbl + "/stts: describes 1 samples (expected 2)"},
      {[](HandMade& m) {
         m.stts = numbers({0, 0x20000000, 2, 10});
       },
       Errc::truncated,
       stbl + "/stts: entry_count is 536870912, which is more than the 8 bytes behind it hold"},
      {[](HandMade& m) {
         m.stts = numbers({0x01000000, 1, 2, 10});
       },
       Errc::unsupported, stbl + "/stts: version 1 is not known (expected at most 0)"},
      {[](HandMade& m) {
         m.stsc = numbers({0, 1, 1, 1, 1});
       },
       Errc::malformed, stbl + "/stsc: describes 1 samples (expected 2)"},
      {[](HandMade& m) {
         m.stsc = numbers({0, 1, 2, 2, 1});
       },
       Errc::malformed, stbl + "/stsc: first_chunk is 2 (expected 1)"},
      {[](HandMade& m) {
         m.stsc = numbers({0, 2, 1, 2, 1, 1, 2, 1});
       },
       Errc::malformed, stbl + "/stsc: first_chunk is 1 (expected more than the 1 before it)"},
      {[](HandMade& m) {
         m.stsc = numbers({0, 1, 1, 2, 2});
       },
       Errc::malformed, stbl + "/stsc: sample_description_index is 2 (expected 1 to 1)"},
      {[](HandMade& m) {
         m.chunks = box("stco", numbers({0, 1, 0xFFFFFFFF}));
       },
       Errc::truncated, stbl + "/stco: a sample of 3 bytes at 4294967295 ends behind the file"},
      {[](HandMade& m) {
         m.chunks = box("co64", numbers({0, 1, 0xFFFFFFFF, 0xFFFFFFFF}));
       },
       Errc::truncated, stbl + "/co64: a sample of 3 bytes at 18446744073709551615 ends"},
      {[](HandMade& m) { m.chunks = {}; }, Errc::malformed,
       stbl + ": there is no 'stco' (expected one)"},
      {[](HandMade& m) { m.more = box("stts", m.stts); }, Errc::malformed,
       stbl + ": 'stts' is there twice (expected once)"},
      {[](HandMade& m) {
         m.more = box("stss", numbers({0, 1, 3}));
       },
       Errc::malformed, stbl + "/stss: sample_number is 3 (expected 1 to 2)"},
      {[](HandMade& m) {
         m.more = numbers({7, fourcc("free")});
       },
       Errc::malformed,
       stbl + ": the size of 'free' is 7 (expected at least its header of 8 bytes)"},
      {[](HandMade& m) {
         m.more = numbers({9, fourcc("free")});
       },
       Errc::truncated,
       stbl + ": 'free' ends behind the box it is in (expected 1 bytes, 0 are left)"},
      {[](HandMade& m) {
         m.edits = box("edts", box("elst", numbers({0, 2, 1, 0, 0x10000})));
       },
       Errc::truncated, "moov/trak[0]/edts/elst: entry_count is 2"},
      {[](HandMade& m) {
         m.edits = box("tref", box("mpod", {0, 0, 1}));
       },
       Errc::truncated,
       "moov/trak[0]/tref/mpod: the box ends inside track_ID (expected 4 bytes, 3 are left)"},
  };
  for (const auto& damage : cases) {
    HandMade made;
    damage.change(made);
    const auto movie = mp4_test::read(mp4_test::hand_made_file(made));
    ASSERT_FALSE(movie.ok()) << damage.text;
    EXPECT_EQ(movie.error().code, damage.code) << movie.error().text;
    EXPECT_TRUE(movie.error().text.starts_with(damage.text)) << movie.error().text;
  }
}

TEST(Mp4Damage, PlacesAreThoseOfTheFile) {
  HandMade made;
  made.chunks = box("stco", numbers({0, 1, 0xFFFFFFFF}));
  const Bytes file = mp4_test::hand_made_file(made);
  const std::string type = "stco";
  const auto at = std::search(file.begin(), file.end(), type.begin(), type.end()) - file.begin();
  const auto movie = mp4_test::read(file);
  ASSERT_FALSE(movie.ok());
  EXPECT_EQ(movie.error().place, Place::at_byte(static_cast<uint64_t>(at) + 12));
}

TEST(Mp4Damage, MoreThanTheTablesNeedIsAWarning) {
  HandMade made;
  made.stts = numbers({0, 1, 5, 10});
  made.stsc = numbers({0, 1, 1, 9, 1});
  const Bytes file = mp4_test::hand_made_file(made);
  Diagnostics diagnostics;
  ASSERT_TRUE(read_mp4(mp4_source(file), {}, diagnostics).ok());
  ASSERT_EQ(diagnostics.warnings().size(), 2U);
  EXPECT_EQ(diagnostics.warnings()[0].code, "sample_table");
  EXPECT_EQ(diagnostics.warnings()[0].text,
            "moov/trak[0]/mdia/minf/stbl/stts: describes 3 samples more than there are");
}

TEST(Mp4Damage, MemoryStaysWithinTheLimit) {
  const Bytes file = mp4_test::read_file("13-media-object-descriptors/scene.mp4");
  uint64_t needed = 0;
  Limits limits;
  for (limits.memory = 0; limits.memory < 1000000; limits.memory += 500) {
    const auto movie = mp4_test::read(file, limits);
    if (movie.ok()) {
      needed = limits.memory;
      break;
    }
    EXPECT_EQ(movie.error().code, Errc::limit_exceeded) << movie.error().text;
  }
  EXPECT_GT(needed, 2000U);
  EXPECT_LT(needed, 100000U);
}

TEST(Mp4Damage, WhatIsNoMp4FileIsRefused) {
  for (const Bytes& bytes : {Bytes{}, Bytes{'#', 'V', 'R', 'M', 'L', ' ', 'V', '2'},
                             box("ftyp", numbers({fourcc("mp42"), 1})), Bytes(5)}) {
    EXPECT_FALSE(mp4_test::read(bytes).ok());
  }
  const Bytes file = mp4_test::hand_made_file({});
  const auto twice = mp4_test::read(join({file, mp4_test::hand_made_moov({})}));
  ASSERT_FALSE(twice.ok());
  EXPECT_EQ(twice.error().text, "moov: is there twice (expected once)");
  EXPECT_EQ(twice.error().place, Place::at_byte(file.size()));
}

TEST(Mp4Damage, AFileThatCannotBeReadGivesItsError) {
  Mp4Source source{1000, [](uint64_t offset, std::span<uint8_t>) -> Status {
                     return Error{Errc::io, Place::at_byte(offset), "the disk is gone"};
                   }};
  Diagnostics diagnostics;
  const auto movie = read_mp4(source, {}, diagnostics);
  ASSERT_FALSE(movie.ok());
  EXPECT_EQ(movie.error().code, Errc::io);
}

TEST(Mp4Damage, ASampleThatIsNotThereIsRefused) {
  const Bytes file = mp4_test::hand_made_file({});
  const Mp4Movie movie = mp4_test::read(file).value();
  const auto beyond = read_sample(mp4_source(file), movie.tracks[0], 2, {});
  ASSERT_FALSE(beyond.ok());
  EXPECT_EQ(beyond.error().code, Errc::bad_argument);
  const auto cut = read_sample(mp4_source(std::span(file).first(45)), movie.tracks[0], 1, {});
  ASSERT_FALSE(cut.ok());
  EXPECT_EQ(cut.error().code, Errc::truncated);
  EXPECT_EQ(cut.error().place, Place::at_byte(movie.tracks[0].samples[1].offset));
}

}  // namespace
}  // namespace afx::bifs
