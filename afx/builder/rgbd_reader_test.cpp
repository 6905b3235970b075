// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/rgbd_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <string>

#include "afx/builder/rgbd_frame.h"
#include "afx/file_test_folder.h"
#include "afx/float_tiff_test_file.h"
#include "afx/picture_io.h"

namespace afx {
namespace {

constexpr const char* kIdentity = "[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]";

void expect_near(const glm::dvec3& a, const glm::dvec3& b) {
  EXPECT_NEAR(glm::distance(a, b), 0, 1e-6) << a.x << ' ' << a.y << ' ' << a.z;
}

// A folder with a description and its pictures: 4 x 3 pixels, focal length 2, 2000 of 1/1000.
class Rgbd : public ::testing::Test {
 protected:
  Rgbd() {
    put("c.png", Picture(4, 3, 3));
    put("d.png", depths(4, 3, 2000));
  }

  static DeepPicture depths(uint32_t width, uint32_t height, uint16_t value) {
    return {width, height, 1, 16, std::vector<uint16_t>(size_t{width} * height, value)};
  }

  void put(const std::string& name, const std::vector<uint8_t>& bytes) {
    folder_.write(name, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  }
  template <class P>
  void put(const std::string& name, const P& picture) {
    const auto bytes = encode_picture(picture, "png");
    ASSERT_TRUE(bytes.ok());
    put(name, bytes.value());
  }

  // The members of the one frame; others of the top.
  static std::string with(const std::string& frame, const std::string& top = "") {
    return "{\"depthScale\": 0.001, \"fx\": 2, \"fy\": 2, \"cx\": 1, \"cy\": 1" +
           (top.empty() ? "" : ", " + top) +
           ",\n \"frames\": [{\"colour\": \"c.png\", \"depth\": \"d.png\", \"pose\": " + kIdentity +
           (frame.empty() ? "" : ", " + frame) + "}]}";
  }

  Result<Surfels> read(const std::string& json, const Limits& limits = {}, unsigned threads = 1) {
    return read_rgbd(folder_.write("r.json", json), threads, limits, diagnostics_);
  }
  Surfels read_or_fail(const std::string& json) {
    auto surfels = read(json);
    EXPECT_TRUE(surfels.ok()) << to_string(surfels.error());
    return surfels.ok() ? surfels.value() : Surfels{};
  }
  Error error_of(const std::string& json) {
    const auto surfels = read(json);
    return surfels.ok() ? Error{Errc::io, {}, "none"} : surfels.error();
  }

  TestFolder folder_;
  Diagnostics diagnostics_;
};

TEST_F(Rgbd, APixelShowsThePointOnItsLineOfSightAtItsDepth) {
  DeepPicture depth = depths(4, 3, 0);
  depth.samples[1 * 4 + 3] = 2000;  // row 1 is the middle: cy
  depth.samples[2 * 4 + 1] = 3000;  // column 1: cx
  put("d.png", depth);
  Picture colour(4, 3, 3);
  colour.pixel(3, 1)[0] = 200;
  put("c.png", colour);
  const Surfels surfels = read_or_fail(with(""));
  ASSERT_EQ(surfels.size(), 2U);
  // OpenCV: x right, y down, z forward; 2 pixels right of cx at 2: x = 2 / 2 * 2.
  expect_near(surfels.centres[1], {2, 0, 2});
  expect_near(surfels.u[1], {0.5, 0, 0});   // a pixel is 1 wide at 2
  expect_near(surfels.v[1], {0, -0.5, 0});  // up
  EXPECT_EQ(surfels.colours[1], (Rgba8{200, 0, 0, 255}));
  expect_near(surfels.centres[0], {0, 1.5, 3});
  const glm::vec3 outside = glm::cross(surfels.u[1], surfels.v[1]);
  EXPECT_LT(outside.z, 0);  // towards the camera
}

TEST_F(Rgbd, TheConventionSaysWhereTheCameraLooks) {
  DeepPicture depth = depths(4, 3, 0);
  depth.samples[2 * 4 + 3] = 2000;
  put("d.png", depth);
  const Surfels surfels = read_or_fail(with("", "\"convention\": \"opengl\""));
  ASSERT_EQ(surfels.size(), 1U);
  expect_near(surfels.centres[0], {2, -1, -2});
  EXPECT_GT(glm::cross(surfels.u[0], surfels.v[0]).z, 0);
}

TEST_F(Rgbd, ThePoseTakesFromTheCameraToTheWorldByRows) {
  DeepPicture depth = depths(4, 3, 0);
  depth.samples[1 * 4 + 3] = 2000;
  put("d.png", depth);
  std::string json = with("");
  const std::string pose = "[[0,0,1,10],[1,0,0,20],[0,1,0,30],[0,0,0,1]]";  // (z, x, y)
  json.replace(json.find(kIdentity), std::string(kIdentity).size(), pose);
  const Surfels surfels = read_or_fail(json);
  ASSERT_EQ(surfels.size(), 1U);
  expect_near(surfels.centres[0], {10 + 2, 20 + 2, 30});
}

TEST_F(Rgbd, FramesHaveTheirOwnValuesOrThoseOfTheTop) {
  put("one.png", depths(1, 1, 1000));
  const std::string frame =
      "\"colour\": \"c.png\", \"depth\": \"one.png\", \"pose\": " + std::string(kIdentity);
  const Surfels surfels = read_or_fail(
      "{\"intrinsics\": {\"fx\": 1, \"fy\": 1, \"cx\": 0, \"cy\": 0, \"width\": 1, \"height\": 1},"
      " \"depthScale\": 0.001, \"frames\": [{" +
      frame + "}, {" + frame +
      ", \"depthScale\": 0.002},"
      " {" +
      frame + ", \"cx\": 1}, {" + frame + ", \"intrinsics\": {\"cy\": 1}}]}");
  ASSERT_EQ(surfels.size(), 4U);
  expect_near(surfels.centres[0], {0, 0, 1});
  expect_near(surfels.centres[1], {0, 0, 2});
  expect_near(surfels.centres[2], {-1, 0, 1});
  expect_near(surfels.centres[3], {0, -1, 1});
  EXPECT_EQ(diagnostics_.count(), 0U);
}

TEST_F(Rgbd, DepthsInFloatingPointAreSceneUnitsAndWhatIsNoneIsLeftOut) {
  const float inf = std::numeric_limits<float>::infinity();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  put("d.tif", float_tiff(4, 3, {2, 0, nan, inf, -2, -inf, 2, 2, 2, 2, 2, 2}));
  std::string json = with("");
  json.replace(json.find("d.png"), 5, "d.tif");
  const Surfels surfels = read_or_fail(json);
  EXPECT_EQ(surfels.size(), 7U);
  for (const glm::dvec3& centre : surfels.centres) EXPECT_EQ(centre.z, 2);
}

TEST_F(Rgbd, NearFarAndMaskCutTheBackground) {
  DeepPicture depth = depths(4, 3, 2000);
  depth.samples[0] = 999;
  depth.samples[1] = 1000;
  depth.samples[2] = 3000;
  depth.samples[3] = 3001;
  put("d.png", depth);
  EXPECT_EQ(read_or_fail(with("", "\"near\": 1, \"far\": 3")).size(), 10U);
  EXPECT_EQ(read_or_fail(with("\"far\": 2.5")).size(), 10U);
  Picture mask(2, 1, 1);  // the left half is background
  mask.samples = {0, 3};
  put("m.png", mask);
  const Surfels right = read_or_fail(with("\"mask\": \"m.png\""));
  EXPECT_EQ(right.size(), 6U);
  for (const glm::dvec3& centre : right.centres) EXPECT_GT(centre.x, 0.9);
}

TEST_F(Rgbd, PixelsInTheAirBetweenTwoSurfacesAreDropped) {
  // At focal length 20 a pixel at 2 is 0.1 wide: jumps are those of more than 0.4.
  DeepPicture depth = depths(5, 3, 2000);
  for (size_t row = 0; row < 3; ++row)
    for (size_t column = 3; column < 5; ++column) depth.samples[row * 5 + column] = 4000;
  depth.samples[1 * 5 + 2] = 3000;  // in the air
  depth.samples[2 * 5 + 2] = 2300;  // at the end of the near surface
  put("d.png", depth);
  std::string json = with("");
  json.replace(json.find("\"fx\": 2, \"fy\": 2"), 16, "\"fx\": 20, \"fy\": 20");
  const Surfels surfels = read_or_fail(json);
  EXPECT_EQ(surfels.size(), 14U);
  for (const glm::dvec3& centre : surfels.centres) EXPECT_NE(centre.z, 3);
}

TEST_F(Rgbd, ColoursOfAPictureOfAnotherSizeAreThoseOfTheSamePlace) {
  Picture large(8, 6, 3);
  for (uint32_t y = 0; y < 6; ++y)
    for (uint32_t x = 0; x < 8; ++x) {
      large.pixel(x, y)[0] = x == 2 || x == 3 ? 255 : 0;  // column 1 of the depths
      large.pixel(x, y)[1] = y % 2 == 0 ? 0 : 255;        // in half of every pixel
    }
  put("c.png", large);
  const Surfels surfels = read_or_fail(with(""));
  ASSERT_EQ(surfels.size(), 12U);
  for (size_t n = 0; n < 12; ++n)
    EXPECT_EQ(surfels.colours[n], (Rgba8{static_cast<uint8_t>(n % 4 == 1 ? 255 : 0), 188, 0, 255}))
        << n;
}

TEST_F(Rgbd, AFrameWithoutDepthsIsCountedInAWarning) {
  put("d.png", depths(4, 3, 0));
  EXPECT_EQ(read_or_fail(with("\"name\": \"first\"")).size(), 0U);
  ASSERT_EQ(diagnostics_.count(), 2U);
  EXPECT_EQ(diagnostics_.warnings()[0].code, "unknown_member");
  EXPECT_EQ(diagnostics_.warnings()[0].text, "frames[0].name is not known");
  EXPECT_EQ(diagnostics_.warnings()[1].code, "empty_frame");
  EXPECT_EQ(diagnostics_.warnings()[1].text, "1 of 1 frames have no valid depth");
}

TEST_F(Rgbd, OneLevelOfIntrinsicsIsReadHoweverDeepTheyNest) {
  std::string nested;
  for (int n = 0; n < 200000; ++n) nested += "{\"intrinsics\": ";
  nested += "1" + std::string(200000, '}');
  EXPECT_EQ(read_or_fail(with("", "\"intrinsics\": " + nested)).size(), 12U);
  EXPECT_EQ(diagnostics_.count(), 0U);
  read_or_fail(with("", "\"intrinsics\": {\"k1\": 0}"));
  ASSERT_EQ(diagnostics_.count(), 1U);
  EXPECT_EQ(diagnostics_.warnings()[0].text, "intrinsics.k1 is not known");
}

TEST_F(Rgbd, ErrorsNameTheMember) {
  const auto replaced = [](const std::string& what, const std::string& by) {
    std::string json = with("");
    json.replace(json.find(what), what.size(), by);
    return json;
  };
  const struct {
    std::string json, text;
  } cases[] = {
      {"[]", "the JSON is not an object"},
      {"{}", "frames is missing"},
      {"{\"frames\": []}", "frames is not a list of one frame or more"},
      {"{\"frames\": {}}", "frames is not a list of one frame or more"},
      {"{\"frames\": [7]}", "frames[0] is not an object"},
      {"{\"frames\": [{}]}", "frames[0].colour is missing"},
      {replaced("\"fx\": 2", "\"fx\": 0"), "fx is 0 (expected more than 0)"},
      {replaced("\"fy\": 2", "\"fy\": -1"), "fy is -1 (expected more than 0)"},
      {replaced("\"fx\": 2", "\"fx\": \"2\""), "fx is not a number"},
      {replaced("\"cx\": 1,", ""), "frames[0].cx is missing"},
      {replaced("\"c.png\"", "5"), "frames[0].colour is not a text"},
      {replaced("\"depthScale\": 0.001", "\"depthScale\": 0"),
       "depthScale is 0 (expected more than 0)"},
      {replaced("\"depthScale\": 0.001,", ""),
       "frames[0].depthScale is missing (d.png has integers)"},
      {replaced("[1,0,0,0],", ""), "frames[0].pose is not a matrix of four rows of four numbers"},
      {replaced("[1,0,0,0]", "[1,0,0]"),
       "frames[0].pose is not a matrix of four rows of four numbers"},
      {replaced("[1,0,0,0]", "[1,0,0,null]"),
       "frames[0].pose is not a matrix of four rows of four numbers"},
      {replaced("[1,0,0,0]", "[0,0,0,0]"), "frames[0].pose cannot be inverted"},
      {replaced("[1,0,0,0],[0,1,0,0]", "[1e200,0,0,0],[0,1e200,0,0]"),
       "frames[0].pose cannot be inverted"},
      {replaced("[1,0,0,0]", "[1,0,0,1e37]"), "frames[0].pose moves points beyond 1e37"},
      {replaced("[1,0,0,0]", "[1,0,0,-1e300]"), "frames[0].pose moves points beyond 1e37"},
      {replaced("[1,0,0,0]", "[1e38,0,0,0]"), "frames[0].pose moves points beyond 1e37"},
      {replaced("[0,0,0,1]", "[0,0,1,1]"),
       "frames[0].pose is not affine (expected a last row of 0 0 0 1)"},
      {with("", "\"convention\": \"colmap\""),
       "convention is \"colmap\" (expected \"opencv\" or \"opengl\")"},
      {with("\"near\": 2, \"far\": 2"), "frames[0].far is 2 (expected more than near, 2)"},
      {with("\"width\": 5"), "frames[0].width is 5 (d.png has 4)"},
      {with("", "\"intrinsics\": {\"height\": 4}"), "intrinsics.height is 4 (d.png has 3)"},
      {with("\"intrinsics\": 3"), "frames[0].intrinsics is not an object"},
  };
  for (const auto& c : cases) {
    const Error error = error_of(c.json);
    EXPECT_EQ(error.text, c.text) << c.json;
    EXPECT_EQ(error.code, Errc::bad_argument);
    EXPECT_EQ(error.file, folder_.path("r.json"));
  }
}

TEST_F(Rgbd, WhatIsNoJsonIsRefusedWithItsPlace) {
  const Error error = error_of("{\"frames\":\n [1,]}");
  EXPECT_EQ(error.code, Errc::malformed);
  EXPECT_EQ(error.text, "this is not JSON");
  EXPECT_EQ(error.place, Place::at_line(2, 5));
  EXPECT_EQ(error_of(with("\"near\": 1e999")).text, "a number of the JSON is too large");
}

TEST_F(Rgbd, PicturesThatCannotBeReadAreNamedWithTheirMember) {
  const Error missing = error_of(with("\"mask\": \"none.png\""));
  EXPECT_EQ(missing.code, Errc::io);
  EXPECT_EQ(missing.file, folder_.path("none.png"));
  EXPECT_NE(missing.text.find("(frames[0].mask of " + folder_.path("r.json") + ")"),
            std::string::npos);
  put("d.png", Picture(4, 3, 3));
  EXPECT_EQ(error_of(with("")).text, "frames[0].depth has 3 components (expected one of depth)");
  folder_.write("d.png", "text");
  const Error text = error_of(with(""));
  EXPECT_EQ(text.code, Errc::unsupported);
  EXPECT_EQ(text.file, folder_.path("d.png"));
  EXPECT_EQ(text.text,
            "is not a picture of a known format (expected PNG, JPEG, TIFF or the like) "
            "(frames[0].depth of " +
                folder_.path("r.json") + ")");
  EXPECT_EQ(read_rgbd(folder_.path("no.json"), 1, {}, diagnostics_).error().code, Errc::io);
}

TEST_F(Rgbd, KeepToTheLimits) {
  Limits limits;
  limits.memory = 11 * kSurfelBytes;
  const auto json = read(with(""), limits);
  ASSERT_FALSE(json.ok());
  EXPECT_EQ(json.error().text, "the JSON is larger than the limit");
  put("d.png", depths(200, 200, 2000));
  limits.memory = 100 * 1024;
  const auto many = read(with(""), limits);
  ASSERT_FALSE(many.ok());
  EXPECT_EQ(many.error().code, Errc::limit_exceeded);
  EXPECT_EQ(many.error().text, "40000 pieces of surface take more memory than the limit");
}

}  // namespace
}  // namespace afx
