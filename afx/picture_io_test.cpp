// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/picture_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "afx/file_test_folder.h"
#include "afx/float_tiff_test_file.h"

namespace afx {
namespace {

using ::testing::HasSubstr;

// Every sample different from its neighbours; alpha goes down to 0.
Picture pattern(uint32_t width, uint32_t height, uint32_t components) {
  Picture picture(width, height, components);
  for (size_t i = 0; i < picture.samples.size(); ++i)
    picture.samples[i] = static_cast<uint8_t>(i * 37 + i / 11);
  return picture;
}

// A smooth picture, as JPEG is made for.
Picture ramp(uint32_t side) {
  Picture picture(side, side, 3);
  for (uint32_t y = 0; y < side; ++y)
    for (uint32_t x = 0; x < side; ++x) {
      picture.pixel(x, y)[0] = static_cast<uint8_t>(x * 255 / side);
      picture.pixel(x, y)[1] = static_cast<uint8_t>(y * 255 / side);
      picture.pixel(x, y)[2] = 90;
    }
  return picture;
}

std::span<const uint8_t> bytes_of(std::string_view text) {
  return {reinterpret_cast<const uint8_t*>(text.data()), text.size()};
}

TEST(PictureFormats, AreToldByEnding) {
  EXPECT_EQ(picture_format_of("a/b.PNG"), "png");
  EXPECT_EQ(picture_format_of("x.y.jpg"), "jpeg");
  EXPECT_EQ(picture_format_of("x.exr"), "openexr");
  EXPECT_EQ(picture_format_of("x.wrl"), "");
  EXPECT_EQ(picture_format_of("png"), "");
  EXPECT_EQ(picture_format_of("x."), "");
}

class LosslessFormats : public ::testing::TestWithParam<std::pair<const char*, uint32_t>> {};

TEST_P(LosslessFormats, GiveBackEverySample) {
  const auto [format, components] = GetParam();
  const Picture picture = pattern(13, 7, components);
  const auto bytes = encode_picture(picture, format);
  ASSERT_TRUE(bytes.ok()) << bytes.error().text;
  const auto again = decode_picture(bytes.value(), std::string("x.") + format);
  ASSERT_TRUE(again.ok()) << again.error().text;
  EXPECT_EQ(again.value().width, 13U);
  EXPECT_EQ(again.value().height, 7U);
  EXPECT_EQ(again.value().components, components);
  // Alpha neither multiplies the colours nor hides them where it is 0.
  EXPECT_EQ(again.value().samples, picture.samples);
}

INSTANTIATE_TEST_SUITE_P(All, LosslessFormats,
                         ::testing::Values(std::pair{"png", 1U}, std::pair{"png", 2U},
                                           std::pair{"png", 3U}, std::pair{"png", 4U},
                                           std::pair{"tga", 3U}, std::pair{"tga", 4U},
                                           std::pair{"bmp", 3U}));

TEST(Png, KeepsSixteenBits) {
  DeepPicture picture{3, 2, 1, 16, {0, 1, 255, 256, 32768, 65535}};
  const auto bytes = encode_picture(picture, "png", {.colour = false});
  ASSERT_TRUE(bytes.ok()) << bytes.error().text;
  const auto again = decode_deep_picture(bytes.value());
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(again.value().bits, 16U);
  EXPECT_EQ(again.value().samples, picture.samples);
  // Read as a picture of 8 bits they are rounded: 32768 / 257 = 127.5.
  const auto shallow = decode_picture(bytes.value());
  ASSERT_TRUE(shallow.ok());
  EXPECT_EQ(shallow.value().samples[2], 1);
  EXPECT_EQ(shallow.value().samples[5], 255);
}

TEST(Png, DeepReadingGivesBytesUnscaled) {
  const Picture picture = pattern(5, 3, 2);
  const auto bytes = encode_picture(picture, "png");
  ASSERT_TRUE(bytes.ok());
  const auto deep = decode_deep_picture(bytes.value());
  ASSERT_TRUE(deep.ok());
  EXPECT_EQ(deep.value().bits, 8U);
  EXPECT_TRUE(std::equal(picture.samples.begin(), picture.samples.end(),
                         deep.value().samples.begin(), deep.value().samples.end()));
}

TEST(Png, DeepReadingGivesFourBitGreyAsStored) {
  // 4 x 1 pixels of 4 bits, values 0 1 7 15, written with Python's zlib by the PNG specification.
  constexpr unsigned char kFile[] = {
      0x89, 'P',  'N',  'G',  0x0D, 0x0A, 0x1A, 0x0A, 0,    0,    0,    0x0D, 'I',  'H',
      'D',  'R',  0,    0,    0,    4,    0,    0,    0,    1,    4,    0,    0,    0,
      0,    0x19, 0xA7, 0xBD, 0x10, 0x00, 0x00, 0x00, 0x0B, 0x49, 0x44, 0x41, 0x54, 0x78,
      0x9C, 0x63, 0x60, 0xAC, 0x07, 0x00, 0x00, 0x84, 0x00, 0x81, 0xA7, 0xD7, 0x71, 0x01,
      0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4E, 0x44, 0xAE, 0x42, 0x60, 0x82};
  const auto deep = decode_deep_picture(kFile);
  ASSERT_TRUE(deep.ok()) << deep.error().text;
  EXPECT_EQ(deep.value().bits, 4U);
  EXPECT_EQ(deep.value().samples, (std::vector<uint16_t>{0, 1, 7, 15}));
}

TEST(FloatPictures, AreReadAsStored) {
  const std::vector<float> samples{0, -1.5F, 1e-20F, 3e8F, std::numeric_limits<float>::infinity(),
                                   7};
  const auto bytes = float_tiff(3, 2, samples);
  const auto picture = decode_float_picture(bytes);
  ASSERT_TRUE(picture.ok()) << picture.error().text;
  EXPECT_EQ(picture.value().width, 3U);
  EXPECT_EQ(picture.value().height, 2U);
  EXPECT_EQ(picture.value().components, 1U);
  EXPECT_EQ(picture.value().samples, samples);
  const auto deep = decode_deep_picture(bytes);
  ASSERT_FALSE(deep.ok());
  EXPECT_EQ(deep.error().text, "samples are neither 8 nor 16 bit integers");
}

TEST(FloatPictures, AreNotMadeFromIntegers) {
  const auto bytes = encode_picture(pattern(3, 2, 1), "png");
  ASSERT_TRUE(bytes.ok());
  const auto picture = decode_float_picture(bytes.value(), "a.png");
  ASSERT_FALSE(picture.ok());
  EXPECT_EQ(picture.error().code, Errc::unsupported);
  EXPECT_EQ(picture.error().text, "samples are integers (expected floating point)");
}

TEST(Png, HoldsNoDateAndNoProgramName) {
  const auto bytes = encode_picture(ramp(16), "png");
  ASSERT_TRUE(bytes.ok());
  const std::string text(bytes.value().begin(), bytes.value().end());
  for (const char* chunk : {"tIME", "eXIf", "Date", "Software", "OpenImageIO"})
    EXPECT_EQ(text.find(chunk), std::string::npos) << chunk;
  EXPECT_NE(text.find("sRGB"), std::string::npos);
}

TEST(Pictures, AreEncodedToTheSameBytesEachTime) {
  for (const char* format : {"png", "jpeg"}) {
    const auto first = encode_picture(ramp(64), format), second = encode_picture(ramp(64), format);
    ASSERT_TRUE(first.ok() && second.ok());
    EXPECT_EQ(first.value(), second.value());
  }
}

TEST(Jpeg, IsWrittenWithFullChromaAndTheQualityAskedFor) {
  const Picture picture = pattern(64, 64, 3);
  const auto fine = encode_picture(picture, "jpg", {.jpeg_quality = 95});
  const auto coarse = encode_picture(picture, "jpeg", {.jpeg_quality = 20});
  ASSERT_TRUE(fine.ok() && coarse.ok());
  EXPECT_GT(fine.value().size(), 2 * coarse.value().size());
  // Start of frame (FFC0 or FFC2): length 17, 8 bits, height, width, 3 components; the first has id
  // 1 and sampling factors 1 x 1 where nothing is subsampled. Source: ITU-T T.81, B.2.2.
  const std::string text(fine.value().begin(), fine.value().end());
  size_t frame = text.find(std::string("\xFF\xC0\x00\x11\x08", 5));
  if (frame == std::string::npos) frame = text.find(std::string("\xFF\xC2\x00\x11\x08", 5));
  ASSERT_NE(frame, std::string::npos);
  EXPECT_EQ(text[frame + 11], 0x11);
}

TEST(Jpeg, ComesCloseToASmoothPicture) {
  const Picture picture = ramp(64);
  const auto bytes = encode_picture(picture, "jpeg");
  ASSERT_TRUE(bytes.ok());
  const auto again = decode_picture(bytes.value());
  ASSERT_TRUE(again.ok());
  for (size_t i = 0; i < picture.samples.size(); ++i)
    ASSERT_NEAR(again.value().samples[i], picture.samples[i], 8) << i;
}

TEST(Pictures, CutAtAnyLengthAreErrorsOrWhole) {
  for (const char* format : {"png", "jpeg"}) {
    const auto bytes = encode_picture(ramp(32), format);
    ASSERT_TRUE(bytes.ok());
    const auto whole = decode_picture(bytes.value());
    ASSERT_TRUE(whole.ok());
    for (size_t length = 0; length < bytes.value().size(); ++length) {
      const std::vector<uint8_t> cut(bytes.value().begin(),
                                     bytes.value().begin() + static_cast<std::ptrdiff_t>(length));
      const auto picture = decode_picture(cut);
      if (picture.ok()) {
        EXPECT_EQ(picture.value().samples, whole.value().samples) << format << " cut at " << length;
        EXPECT_GE(length + 16, bytes.value().size())
            << format;  // only marks of the end may be missing
      } else {
        EXPECT_FALSE(picture.error().text.empty());
      }
    }
  }
}

TEST(Pictures, BeyondTheLimitAreRefusedBeforeDecoding) {
  const auto bytes = encode_picture(ramp(32), "png");
  ASSERT_TRUE(bytes.ok());
  Limits limits;
  limits.picture_pixels = 1023;
  const auto picture = decode_picture(bytes.value(), "big.png", limits);
  ASSERT_FALSE(picture.ok());
  EXPECT_EQ(picture.error().code, Errc::limit_exceeded);
  EXPECT_EQ(picture.error().file, "big.png");
  limits = {};
  limits.memory = 3071;
  EXPECT_FALSE(decode_picture(bytes.value(), {}, limits).ok());
}

TEST(Pictures, AreToldByContentNotByName) {
  const TestFolder folder;
  const auto bytes = encode_picture(ramp(8), "png");
  ASSERT_TRUE(bytes.ok());
  const std::string path = folder.write(
      "x.jpg", {reinterpret_cast<const char*>(bytes.value().data()), bytes.value().size()});
  const auto picture = read_picture(path);
  ASSERT_TRUE(picture.ok()) << picture.error().text;
  EXPECT_EQ(picture.value().samples, ramp(8).samples);
}

TEST(Pictures, OfNoKnownFormatAreUnsupported) {
  for (const char* text : {"", "hello world, this is no picture", "\x89PNG"}) {
    const auto picture = decode_picture(bytes_of(text), "x.png");
    ASSERT_FALSE(picture.ok());
    EXPECT_EQ(picture.error().code, Errc::unsupported);
  }
  const auto movie = decode_picture(bytes_of(std::string_view("\0\0\0\x18"
                                                              "ftypmp42",
                                                              12)),
                                    "x.mp4");
  ASSERT_FALSE(movie.ok());
  EXPECT_EQ(movie.error().code, Errc::unsupported);
}

TEST(Pictures, ThatCannotBeWrittenAreRefused) {
  const auto code = [](const auto& result) { return result.ok() ? Errc::io : result.error().code; };
  EXPECT_EQ(code(encode_picture(Picture(), "png")), Errc::bad_argument);
  Picture wrong(4, 4, 3);
  wrong.samples.pop_back();
  EXPECT_EQ(code(encode_picture(wrong, "png")), Errc::bad_argument);
  EXPECT_EQ(code(encode_picture(ramp(4), "xyz")), Errc::unsupported);
  EXPECT_EQ(code(encode_picture(pattern(4, 4, 4), "jpeg")), Errc::bad_argument);
  EXPECT_EQ(code(encode_picture(ramp(4), "jpeg", {.jpeg_quality = 0})), Errc::bad_argument);
}

TEST(WritePicture, WritesByEndingAndOverwritesOnlyWhenTold) {
  const TestFolder folder;
  const std::string path = folder.path("x.png");
  ASSERT_TRUE(write_picture(path, ramp(8)).ok());
  EXPECT_FALSE(write_picture(path, ramp(8)).ok());
  EXPECT_TRUE(write_picture(path, ramp(9), {}, true).ok());
  const auto picture = read_picture(path);
  ASSERT_TRUE(picture.ok());
  EXPECT_EQ(picture.value().width, 9U);
  const Status status = write_picture(folder.path("x.txt"), ramp(8));
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, Errc::unsupported);
  EXPECT_EQ(folder.count(), 1U);
}

TEST(ReadPicture, NamesTheFileThatIsNotThere) {
  const auto picture = read_picture("no/such.png");
  ASSERT_FALSE(picture.ok());
  EXPECT_EQ(picture.error().code, Errc::io);
  EXPECT_EQ(picture.error().file, "no/such.png");
}

TEST(Pictures, InFloatingPointAreLinearLight) {
  // Radiance HDR, 1 x 1, flat: mantissas 128, exponent 128: 128/256 * 2^0 = 0.5. sRGB of linear 0.5
  // is 188.
  const std::string file =
      std::string("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n") + "\x80\x80\x80\x80";
  const auto picture = decode_picture(bytes_of(file), "x.hdr");
  ASSERT_TRUE(picture.ok()) << picture.error().text;
  EXPECT_NEAR(picture.value().samples[0], 188, 1);
  EXPECT_FALSE(decode_deep_picture(bytes_of(file), "x.hdr").ok());
}

}  // namespace
}  // namespace afx
