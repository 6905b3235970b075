// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/picture_header.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace afx {
namespace {

using Bytes = std::vector<uint8_t>;

Bytes read_file(const std::string& name) {
  std::ifstream in(AFX_SOURCE_DIR "/conformance/suites/bifs-gpac/" + name, std::ios::binary);
  EXPECT_TRUE(in) << name;
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// JP2: signature, 'ftyp', 'jp2h' with 'ihdr' of 3 rows and 5 columns; written by hand.
const Bytes kJp2 = {0, 0, 0, 12, 'j', 'P', ' ', ' ', 13,  10,  0x87, 10,   //
                    0, 0, 0, 20, 'f', 't', 'y', 'p', 'j', 'p', '2',  ' ',  //
                    0, 0, 0, 0,  'j', 'p', '2', ' ',                       //
                    0, 0, 0, 45, 'j', 'p', '2', 'h',                       //
                    0, 0, 0, 22, 'i', 'h', 'd', 'r', 0,   0,   0,    3,   0, 0, 0, 5};

PictureHeader header_of(const Bytes& bytes) {
  const auto header = read_picture_header(bytes);
  EXPECT_TRUE(header.ok()) << to_string(header.error());
  return header.ok() ? header.value() : PictureHeader{};
}

TEST(PictureHeader, KindsAndSizesOfTheVectorsPictures) {
  EXPECT_EQ(header_of(read_file("02-depthimage-imagetexture/color32.jpg")),
            (PictureHeader{0x6C, 32, 24}));
  EXPECT_EQ(header_of(read_file("02-depthimage-imagetexture/color16.jpg")),
            (PictureHeader{0x6C, 16, 16}));
  EXPECT_EQ(header_of(read_file("02-depthimage-imagetexture/depth32.png")),
            (PictureHeader{0x6D, 32, 24}));
}

TEST(PictureHeader, WidthAndHeightAreNotTakenForEachOther) {
  EXPECT_EQ(header_of(kJp2), (PictureHeader{0x6E, 5, 3}));
  const Bytes png = {0x89, 'P', 'N', 'G', 13, 10, 26, 10, 0, 0, 0, 13,
                     'I',  'H', 'D', 'R', 0,  0,  1,  2,  0, 0, 0, 7};
  EXPECT_EQ(header_of(png), (PictureHeader{0x6D, 258, 7}));
  // A comment, a filling byte, a restart marker, Huffman tables (C4), then a progressive frame.
  const Bytes jpeg = {0xFF, 0xD8, 0xFF, 0xFE, 0,    3, 'c', 0xFF, 0xFF, 0xD0, 0xFF, 0xC4, 0,
                      4,    1,    2,    0xFF, 0xC2, 0, 11,  8,    0,    7,    1,    2};
  EXPECT_EQ(header_of(jpeg), (PictureHeader{0x6C, 258, 7}));
}

TEST(PictureHeader, EveryTruncationBeforeTheSizeIsACleanError) {
  for (const Bytes& whole : {read_file("02-depthimage-imagetexture/color32.jpg"),
                             read_file("02-depthimage-imagetexture/depth32.png"), kJp2}) {
    bool readable = false;
    for (size_t size = 0; size <= whole.size(); ++size) {
      const auto header = read_picture_header(std::span(whole).first(size));
      if (header.ok()) {
        readable = true;
        continue;
      }
      EXPECT_FALSE(readable) << "was read with fewer bytes than " << size;
      EXPECT_EQ(header.error().code, still_picture_type(std::span(whole).first(size)) != 0
                                         ? Errc::truncated
                                         : Errc::unsupported);
    }
    EXPECT_TRUE(readable);
  }
}

TEST(PictureHeader, DamageIsToldWithItsPlace) {
  const auto error_of = [](const Bytes& bytes) {
    const auto header = read_picture_header(bytes);
    return header.ok() ? "none" : to_string(header.error());
  };
  Bytes png = read_file("02-depthimage-imagetexture/depth32.png");
  png[12] = 'X';
  EXPECT_EQ(error_of(png), "8: the first chunk of the PNG is not IHDR");
  EXPECT_EQ(error_of({0xFF, 0xD8, 0xFF, 0xDA, 0, 2}),
            "2: the JPEG has no frame header before its first scan");
  EXPECT_EQ(error_of({0xFF, 0xD8, 0xFF, 0xE0, 0, 1, 0, 0}),
            "4: a segment of the JPEG is too short");
  EXPECT_EQ(error_of({0xFF, 0xD8, 0xFF, 0xE0, 0, 2, 7, 7, 7, 7}), "6: no marker in the JPEG here");
  EXPECT_EQ(error_of({0xFF, 0xD8, 0xFF, 0xC0, 0, 11, 8, 0, 0, 0, 9}),
            "7: the JPEG says its height only after its first scan");
  EXPECT_EQ(error_of({0xFF, 0xD8, 0xFF, 0xC0, 0, 11, 8, 0, 9, 0, 0}),
            "7: the picture has the size 0 x 9 (expected 1 or more)");
  Bytes jp2 = kJp2;
  jp2[15] = 7;
  EXPECT_EQ(error_of(jp2), "12: a box of the JP2 is too short");
}

}  // namespace
}  // namespace afx
