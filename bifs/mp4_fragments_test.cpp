// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Files in fragments, made by hand.
#include "bifs/mp4_test_support.h"

namespace afx::bifs {
namespace {

using mp4_test::box;
using mp4_test::Bytes;
using mp4_test::join;
using mp4_test::numbers;

constexpr uint32_t kSync = 0x02000000, kNotSync = 0x01010000;

/// 'ftyp' and a 'moov' without samples; defaults: 10 ticks, 2 bytes, not sync.
Bytes head() {
  mp4_test::HandMade made;
  made.stts = made.stsc = numbers({0, 0});
  made.stsz = numbers({0, 0, 0});
  made.chunks = box("stco", numbers({0, 0}));
  made.mvex = box("mvex", box("trex", numbers({0, 1, 1, 10, 2, kNotSync})));
  return join({box("ftyp", numbers({fourcc("iso5"), 1})), mp4_test::hand_made_moov(made)});
}

Bytes moof(const std::vector<Bytes>& trafs) {
  return box("moof", join({box("mfhd", numbers({0, 1})), join(trafs)}));
}

void expect_samples(const Bytes& file, const std::vector<std::string>& data,
                    const std::vector<Mp4Sample>& expected) {
  const auto movie = mp4_test::read(file);
  ASSERT_TRUE(movie.ok()) << to_string(movie.error());
  const Mp4Track& track = movie.value().tracks[0];
  ASSERT_EQ(track.samples.size(), data.size());
  for (size_t i = 0; i < data.size(); ++i) {
    const Bytes bytes = mp4_test::sample(file, track, i);
    EXPECT_EQ(std::string(bytes.begin(), bytes.end()), data[i]) << i;
    Mp4Sample sample = track.samples[i];
    sample.offset = 0;
    EXPECT_TRUE(sample == expected[i])
        << i << ": time " << sample.time << " duration " << sample.duration << " composition "
        << sample.composition_offset << " random access " << sample.random_access;
  }
}

TEST(Mp4Fragments, SamplesWithEveryFieldOfTheirOwn) {
  // moof of 8 + 16 + (8 + 16 + 20 + 52) bytes; the data begin behind it and the mdat header.
  const Bytes traf = box(
      "traf", join({box("tfhd", numbers({0x20000, 1})), box("tfdt", numbers({0x01000000, 0, 0})),
                    box("trun", numbers({0x01000F01, 2, 120 + 8, 5, 3, kSync, 0xFFFFFFFF, 7, 1,
                                         kNotSync, 4}))}));
  const Bytes fragment = moof({traf});
  ASSERT_EQ(fragment.size(), 120U);
  expect_samples(join({head(), fragment, box("mdat", {'a', 'b', 'c', 'd'})}), {"abc", "d"},
                 {{0, 0, -1, 3, 5, 0, true}, {0, 5, 4, 1, 7, 0, false}});
}

TEST(Mp4Fragments, DefaultsOfTheTrackTheFragmentAndTheFirstSample) {
  // First fragment: the defaults of 'trex', first_sample_flags.
  const Bytes first = moof({box("traf", join({box("tfhd", numbers({0, 1})),
                                              box("trun", numbers({0x5, 2, 72 + 8, kSync}))}))});
  ASSERT_EQ(first.size(), 72U);
  // Second: those of 'tfhd', and time 100, so that the sample before lasts until then.
  const Bytes second =
      moof({box("traf", join({box("tfhd", numbers({0x20038, 1, 20, 1, kSync})),
                              box("tfdt", numbers({0, 100})), box("trun", numbers({1, 1, 112 + 8})),
                              box("trun", numbers({0, 2}))}))});
  ASSERT_EQ(second.size(), 112U);
  expect_samples(join({head(), first, box("mdat", {'a', 'b', 'c', 'd'}), second,
                       box("mdat", {'e', 'f', 'g'})}),
                 {"ab", "cd", "e", "f", "g"},
                 {{0, 0, 0, 2, 10, 0, true},
                  {0, 10, 0, 2, 90, 0, false},
                  {0, 100, 0, 1, 20, 0, true},
                  {0, 120, 0, 1, 20, 0, true},
                  {0, 140, 0, 1, 20, 0, true}});
}

TEST(Mp4Fragments, OffsetsFromABaseAndFromTheTrackFragmentBefore) {
  // The data come first, at 8 behind `head`. The first 'traf' has that as its base, the second has
  // no base and no offset: its data begin where those of the first end.
  const Bytes front = join({head(), box("mdat", {'a', 'b', 'c', 'd'})});
  Bytes base;
  mp4_test::put(base, head().size() + 8, 8);
  const Bytes one =
      box("traf", join({box("tfhd", join({numbers({1, 1}), base})), box("trun", numbers({0, 1}))}));
  const Bytes two = box("traf", join({box("tfhd", numbers({0, 1})), box("trun", numbers({0, 1}))}));
  expect_samples(join({front, moof({one, two})}), {"ab", "cd"},
                 {{0, 0, 0, 2, 10, 0, false}, {0, 10, 0, 2, 10, 0, false}});
}

TEST(Mp4Fragments, WrittenTheyAreAnOrdinaryFileThatSaysTheSame) {
  const Bytes fragment = moof({box(
      "traf", join({box("tfhd", numbers({0x20000, 1})), box("trun", numbers({1, 3, 68 + 8}))}))});
  ASSERT_EQ(fragment.size(), 68U);
  const Bytes file = join({head(), fragment, box("mdat", {'a', 'b', 'c', 'd', 'e', 'f'})});
  const auto movie = mp4_test::read(file);
  ASSERT_TRUE(movie.ok()) << to_string(movie.error());
  EXPECT_EQ(movie.value().tracks[0].media_duration, 30U);
  EXPECT_EQ(movie.value().duration, 18U);  // 30 / 1000 s in 1 / 600 s
  const Bytes written = mp4_test::rewrite(file, movie.value());
  const auto again = mp4_test::read(written);
  ASSERT_TRUE(again.ok());
  EXPECT_TRUE(mp4_test::without_offsets(again.value()) == mp4_test::without_offsets(movie.value()));
  EXPECT_EQ(mp4_test::sample(written, again.value().tracks[0], 2), (Bytes{'e', 'f'}));
}

TEST(Mp4Fragments, DamageIsNamedWithItsBox) {
  const auto traf = [](const Bytes& tfhd, const Bytes& more) {
    return moof({box("traf", join({box("tfhd", tfhd), more}))});
  };
  const struct {
    Bytes moof;
    Errc code;
    const char* text;
  } cases[] = {
      {traf(numbers({0, 2}), {}), Errc::malformed, "moof[0]/traf[0]/tfhd: track_ID is 2"},
      {traf(numbers({2, 1, 9}), {}), Errc::malformed,
       "moof[0]/traf[0]/tfhd: sample_description_index is 9"},
      {moof({box("traf", {})}), Errc::malformed, "moof[0]/traf[0]: there is no 'tfhd'"},
      {traf(numbers({0, 1}), box("trun", numbers({0x200, 0xFFFFFFFF, 1}))), Errc::truncated,
       "moof[0]/traf[0]/trun[0]: sample_count is 4294967295"},
      {traf(numbers({0, 1}), box("trun", numbers({0, 0xFFFFFFFF}))), Errc::truncated,
       "trun[0]: sample_count is 4294967295 with 2 bytes"},
      {traf(numbers({0x10, 1, 0}), box("trun", numbers({0, 0xFFFFFFFF}))), Errc::limit_exceeded,
       "trun[0]: there are 4294967295 samples without bytes"},
      {traf(numbers({0, 1}), box("trun", numbers({1, 1, 0x7FFFFFFF}))), Errc::truncated,
       "trun[0]: a sample of 2 bytes"},
      {traf(numbers({0, 1}), box("trun", numbers({1, 1, 0x80000000}))), Errc::malformed,
       "before the file"},
      {traf(numbers({0, 1}), box("trun", numbers({0x02000000, 1}))), Errc::unsupported,
       "trun[0]: version 2"},
  };
  for (const auto& damage : cases) {
    const auto movie = mp4_test::read(join({head(), damage.moof}));
    ASSERT_FALSE(movie.ok()) << damage.text;
    EXPECT_EQ(movie.error().code, damage.code) << movie.error().text;
    EXPECT_NE(movie.error().text.find(damage.text), std::string::npos) << movie.error().text;
    EXPECT_GE(movie.error().place.bit, head().size() * 8);
  }
  const Bytes early = join({moof({}), head()});
  const auto movie = mp4_test::read(early);
  ASSERT_FALSE(movie.ok());
  EXPECT_EQ(movie.error().text, "moof[0]: stands before 'moov' (expected behind it)");
}

TEST(Mp4Fragments, ATimeThatGoesBackIsRefused) {
  const auto at = [](uint32_t time) {
    return moof(
        {box("traf", join({box("tfhd", numbers({0x20000, 1})), box("tfdt", numbers({0, time})),
                           box("trun", numbers({0, 2}))}))});
  };
  EXPECT_TRUE(mp4_test::read(join({head(), at(0), at(20)})).ok());
  EXPECT_TRUE(
      mp4_test::read(join({head(), at(0), at(15)})).ok());  // the second sample is cut short
  EXPECT_FALSE(mp4_test::read(join({head(), at(0), at(9)})).ok());
}

}  // namespace
}  // namespace afx::bifs
