// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/video_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "afx/file.h"
#include "afx/file_test_folder.h"
#include "afx/picture_io.h"

namespace afx {
namespace {

using ::testing::HasSubstr;

Picture filled(uint32_t width, uint32_t height, Rgba8 colour) {
  Picture picture(width, height, 4);
  for (uint32_t y = 0; y < height; ++y)
    for (uint32_t x = 0; x < width; ++x) {
      uint8_t* pixel = picture.pixel(x, y);
      pixel[0] = colour.r;
      pixel[1] = colour.g;
      pixel[2] = colour.b;
      pixel[3] = colour.a;
    }
  return picture;
}

class Videos : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto writer = VideoWriter::begin({.width = 16, .height = 16});
    if (!writer.ok() && writer.error().text == "this build has no video")
      GTEST_SKIP() << writer.error().text;
  }
};

Result<std::vector<uint8_t>> write(const std::string& format, const std::vector<Picture>& pictures,
                                   const Limits& limits = {}) {
  auto writer = VideoWriter::begin(
      {.format = format, .width = pictures[0].width, .height = pictures[0].height, .fps = 25},
      limits);
  if (!writer.ok()) return std::move(writer).error();
  for (const Picture& picture : pictures)
    if (Status added = writer.value().add(picture); !added.ok()) return added.error();
  return writer.value().finish();
}

TEST_F(Videos, ShowTheirColoursAgain) {
  constexpr Rgba8 kColours[] = {{255, 0, 0}, {20, 180, 60}, {255, 255, 255}, {0, 0, 0}};
  std::vector<Picture> pictures;
  for (const Rgba8& colour : kColours) pictures.push_back(filled(64, 48, colour));
  for (const std::string format : {"mp4", "mkv", "webm", "avi"}) {
    const auto bytes = write(format, pictures);
    ASSERT_TRUE(bytes.ok()) << format << ": " << bytes.error().text;
    const TestFolder folder;
    ASSERT_TRUE(write_file_atomically(folder.path("v." + format), bytes.value(), false).ok());
    const std::string decode =
        "ffmpeg -v error -i '" + folder.path("v." + format) +
        "' -fps_mode passthrough -vf "
        "scale=in_color_matrix=bt709:in_range=tv:flags=accurate_rnd,format=rgb24 '" +
        folder.path("f%d.png") + "'";
    ASSERT_EQ(std::system(decode.c_str()), 0) << format;
    for (size_t i = 0; i < std::size(kColours); ++i) {
      const auto shown = read_picture(folder.path("f" + std::to_string(i + 1) + ".png"));
      ASSERT_TRUE(shown.ok()) << format << ": " << shown.error().text;
      const Rgba8 middle = colour_at(shown.value(), 32, 24);
      EXPECT_NEAR(middle.r, kColours[i].r, 4) << format << " " << i;
      EXPECT_NEAR(middle.g, kColours[i].g, 4) << format << " " << i;
      EXPECT_NEAR(middle.b, kColours[i].b, 4) << format << " " << i;
    }
    EXPECT_FALSE(read_picture(folder.path("f5.png")).ok());
  }
}

TEST_F(Videos, AreTheSameBytesEachTime) {
  const std::vector<Picture> pictures(5, filled(32, 32, {9, 99, 199}));
  for (const std::string format : {"mp4", "mkv", "webm", "avi"}) {
    const auto first = write(format, pictures), second = write(format, pictures);
    ASSERT_TRUE(first.ok() && second.ok());
    EXPECT_EQ(first.value(), second.value()) << format;
  }
}

TEST_F(Videos, TakeOnlyWhatTheyCanHold) {
  const auto text = [](const VideoOptions& options) {
    const auto writer = VideoWriter::begin(options);
    return writer.ok() ? std::string() : writer.error().text;
  };
  EXPECT_EQ(text({.width = 31, .height = 32}),
            "a side of the video is 31 pixels (expected an even number, 2 to 16384)");
  EXPECT_THAT(text({.format = "gif", .width = 32, .height = 32}), HasSubstr("expected mp4, mkv"));
  EXPECT_THAT(text({.width = 32, .height = 32, .fps = 0}), HasSubstr("expected 0.1 to 1000"));
  EXPECT_THAT(text({.width = 32, .height = 32, .quality = 52}), HasSubstr("expected 0 to 51"));
  auto writer = VideoWriter::begin({.width = 32, .height = 32});
  ASSERT_TRUE(writer.ok());
  EXPECT_FALSE(writer.value().add(Picture(32, 34, 4)).ok());
  EXPECT_FALSE(writer.value().add(Picture(32, 32, 3)).ok());
}

TEST_F(Videos, BeyondTheLimitAreRefused) {
  Limits limits;
  limits.memory = 300;
  const auto bytes = write("mp4", std::vector<Picture>(3, filled(64, 64, {1, 2, 3})), limits);
  ASSERT_FALSE(bytes.ok());
  EXPECT_EQ(bytes.error().code, Errc::limit_exceeded);
  EXPECT_EQ(bytes.error().text, "the video has more than 300 bytes, which is the limit");
}

}  // namespace
}  // namespace afx
