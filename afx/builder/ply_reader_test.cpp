// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "afx/builder/model_reader.h"

namespace afx {
namespace {

using ::testing::HasSubstr;

std::span<const uint8_t> bytes_of(const std::string& text) {
  return {reinterpret_cast<const uint8_t*>(text.data()), text.size()};
}

Result<PointCloud> read(const std::string& file) {
  Diagnostics diagnostics;
  return read_ply_points(bytes_of(file), Limits(), diagnostics);
}

// Puts values into binary files.
class Bytes {
 public:
  explicit Bytes(bool big_endian)
      : swapped_(big_endian == (std::endian::native == std::endian::little)) {}
  template <class T>
  Bytes& put(T value) {
    std::string raw(sizeof(T), '\0');
    std::memcpy(raw.data(), &value, sizeof(T));
    if (swapped_) std::reverse(raw.begin(), raw.end());
    text += raw;
    return *this;
  }
  std::string text;

 private:
  bool swapped_;
};

const std::string kAscii =
    "ply\nformat ascii 1.0\ncomment made by hand\nelement vertex 3\nproperty float x\nproperty "
    "float y\n"
    "property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n"
    "1 2 3 255 0 1\n2 4 -6 0 128 2\n1.5e0 +2 3 9 8 7\n";

TEST(PlyPoints, AreReadFromText) {
  const auto cloud = read(kAscii);
  ASSERT_TRUE(cloud.ok()) << cloud.error().text;
  EXPECT_EQ(cloud.value().origin, glm::dvec3(1, 2, 3));
  ASSERT_EQ(cloud.value().positions.size(), 3U);
  EXPECT_EQ(cloud.value().positions[1], glm::vec3(1, 2, -9));
  EXPECT_EQ(cloud.value().positions[2], glm::vec3(0.5F, 0, 0));
  EXPECT_EQ(cloud.value().colours[1], (Rgba8{0, 128, 2, 255}));
  EXPECT_TRUE(cloud.value().normals.empty());
}

TEST(PlyPoints, AreReadFromTextWithOtherLineEnds) {
  std::string file;
  for (const char c : kAscii) file += c == '\n' ? std::string("\r\n") : std::string(1, c);
  const auto cloud = read(file);
  ASSERT_TRUE(cloud.ok()) << cloud.error().text;
  EXPECT_EQ(cloud.value().positions.size(), 3U);
  file = kAscii;
  file.pop_back();  // the last line end may be missing
  EXPECT_TRUE(read(file).ok());
}

// Colours of 16 bits, doubles, properties that mean nothing to us, lists among them, in odd order,
// another element before and after: all that must not confuse the reader.
TEST(PlyPoints, AreReadFromBinaryOfBothByteOrders) {
  for (const bool big : {false, true}) {
    Bytes data(big);
    data.put<uint8_t>(2).put<int16_t>(7).put<int16_t>(8).put<float>(9);  // element camera
    data.put<uint16_t>(65535)
        .put<double>(3)
        .put<uint8_t>(1)
        .put<int32_t>(42)
        .put<double>(1)
        .put<int8_t>(-1);
    data.put<uint16_t>(257).put<uint16_t>(0).put<float>(2).put<float>(0).put<float>(0).put<float>(
        -1);
    data.put<uint16_t>(0).put<double>(30).put<uint8_t>(0).put<double>(10).put<int8_t>(-1);
    data.put<uint16_t>(514)
        .put<uint16_t>(65535)
        .put<float>(20)
        .put<float>(1)
        .put<float>(2)
        .put<float>(3);
    data.put<uint8_t>(200);  // element other
    const std::string header =
        std::string("ply\nformat ") + (big ? "binary_big_endian" : "binary_little_endian") +
        " 1.0\nelement camera 1\nproperty list uchar short p\nproperty float q\n"
        "element vertex 2\nproperty ushort red\nproperty double z\nproperty list uint8 int32 tags\n"
        "property double x\nproperty char confidence\nproperty ushort diffuse_green\n"
        "property ushort blue\nproperty float32 y\nproperty float nx\nproperty float ny\n"
        "property float nz\nelement other 1\nproperty uchar u\nend_header\n";
    const auto cloud = read(header + data.text);
    ASSERT_TRUE(cloud.ok()) << to_string(cloud.error());
    EXPECT_EQ(cloud.value().origin, glm::dvec3(1, 2, 3));
    EXPECT_EQ(cloud.value().positions[1], glm::vec3(9, 18, 27));
    EXPECT_EQ(cloud.value().colours[0], (Rgba8{255, 1, 0, 255}));
    EXPECT_EQ(cloud.value().colours[1], (Rgba8{0, 2, 255, 255}));
    EXPECT_EQ(cloud.value().normals[0], glm::vec3(0, 0, -1));
  }
}

TEST(PlyPoints, WithFloatColoursAreScaled) {
  const auto cloud = read(
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float "
      "z\n"
      "property float red\nproperty float green\nproperty float blue\nend_header\n0 0 0 1 0.5 7\n");
  ASSERT_TRUE(cloud.ok());
  EXPECT_EQ(cloud.value().colours[0], (Rgba8{255, 128, 255, 255}));
}

TEST(PlyPoints, KeepThePrecisionOfLargeCoordinates) {
  const auto cloud = read(
      "ply\nformat ascii 1.0\nelement vertex 2\nproperty double x\nproperty double y\nproperty "
      "double z\nend_header\n"
      "4512345.001 512345.5 100\n4512345.002 512345.5 100\n");
  ASSERT_TRUE(cloud.ok());
  EXPECT_NEAR(cloud.value().positions[1].x, 0.001, 1e-6);
}

TEST(PlyPoints, ThatAreNotFiniteAreLeftOutWithAWarning) {
  Diagnostics diagnostics;
  const std::string file =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float "
      "z\nend_header\n"
      "nan 0 0\n1 2 3\ninf 0 0\n0 0 1e999\n";
  const auto cloud = read_ply_points(bytes_of(file), Limits(), diagnostics);
  ASSERT_TRUE(cloud.ok());
  EXPECT_EQ(cloud.value().positions.size(), 1U);
  ASSERT_EQ(diagnostics.warnings().size(), 1U);
  EXPECT_EQ(diagnostics.warnings()[0].code, "non_finite");
  EXPECT_THAT(diagnostics.warnings()[0].text, HasSubstr("3 points"));
}

struct BadFile {
  const char* file;
  Errc code;
  Place place;
  const char* text;
};

const Place kEnd = Place::at_byte(1 << 30);  // stands for the end of the file

class BadPly : public ::testing::TestWithParam<BadFile> {};

TEST_P(BadPly, IsRefusedWithPlaceAndReason) {
  const auto cloud = read(GetParam().file);
  ASSERT_FALSE(cloud.ok());
  EXPECT_EQ(cloud.error().code, GetParam().code);
  const Place place =
      GetParam().place == kEnd ? Place::at_byte(std::strlen(GetParam().file)) : GetParam().place;
  EXPECT_EQ(cloud.error().place, place) << to_string(cloud.error().place);
  EXPECT_THAT(cloud.error().text, HasSubstr(GetParam().text));
}

#define PLY_XYZ "property float x\nproperty float y\nproperty float z\n"

INSTANTIATE_TEST_SUITE_P(
    Files, BadPly,
    ::testing::Values(
        BadFile{"plx\n", Errc::malformed, Place::at_line(1, 1), "no PLY file"},
        BadFile{"ply\nformat ascii 1.0\n", Errc::truncated, kEnd, "inside the PLY header"},
        BadFile{"ply\nformat morse 1.0\n", Errc::malformed, Place::at_line(2, 1), "unknown format"},
        BadFile{"ply\nend_header\n", Errc::malformed, Place::at_line(2, 1), "no format"},
        BadFile{"ply\nformat ascii 1.0\nelement vertex many\n", Errc::malformed,
                Place::at_line(3, 1), "not a number"},
        BadFile{"ply\nformat ascii 1.0\nelement vertex -1\n", Errc::malformed, Place::at_line(3, 1),
                "not a number"},
        BadFile{"ply\nformat ascii 1.0\nproperty float x\n", Errc::malformed, Place::at_line(3, 1),
                "before the first"},
        BadFile{"ply\nformat ascii 1.0\nelement vertex 1\nproperty quad x\n", Errc::malformed,
                Place::at_line(4, 1), "unknown type"},
        BadFile{"ply\nformat ascii 1.0\nend_header\n", Errc::malformed, Place(), "no vertices"},
        BadFile{"ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n",
                Errc::malformed, Place(), "no x, y and z"},
        BadFile{"ply\nformat ascii 1.0\nelement vertex 18446744073709551615\n" PLY_XYZ
                "end_header\n1 2 3\n",
                Errc::truncated, kEnd, "18446744073709551615 vertices"},
        BadFile{"ply\nformat binary_little_endian 1.0\nelement vertex 2\n" PLY_XYZ
                "end_header\n12345678901",
                Errc::truncated, kEnd, "2 vertices"},
        BadFile{"ply\nformat binary_little_endian 1.0\nelement big 9223372036854775807\nproperty "
                "double d\nelement vertex 1\n" PLY_XYZ "end_header\n123456789012",
                Errc::truncated, kEnd, "ends inside"},
        BadFile{"ply\nformat ascii 1.0\nelement vertex 1\n" PLY_XYZ "end_header\n1 two 3\n",
                Errc::malformed, Place::at_line(8, 3), "not a number"},
        BadFile{"ply\nformat ascii 1.0\nelement vertex 1\n" PLY_XYZ
                "property list char int l\nend_header\n1 2 3 -4\n",
                Errc::malformed, Place::at_line(9, 9), "negative"},
        BadFile{"ply\nformat ascii 1.0\nelement vertex 1\n" PLY_XYZ "end_header\nnan 2 3\n",
                Errc::malformed, Place(), "finite"}));

TEST(PlyPoints, CutAnywhereAreErrors) {
  Bytes data(false);
  for (int i = 0; i < 12; ++i) data.put<float>(static_cast<float>(i));
  const std::string binary =
      "ply\nformat binary_little_endian 1.0\nelement vertex 4\n" PLY_XYZ "end_header\n" + data.text;
  ASSERT_TRUE(read(binary).ok());
  for (size_t length = 0; length < binary.size(); ++length) {
    const std::vector<char> cut(binary.begin(),
                                binary.begin() + static_cast<std::ptrdiff_t>(length));
    Diagnostics diagnostics;
    const auto cloud = read_ply_points({reinterpret_cast<const uint8_t*>(cut.data()), cut.size()},
                                       Limits(), diagnostics);
    EXPECT_FALSE(cloud.ok()) << length;
  }
}

TEST(PlyPoints, KeepToTheLimit) {
  Limits limits;
  limits.memory = 3 * 28 - 1;
  Diagnostics diagnostics;
  const auto cloud = read_ply_points(bytes_of(kAscii), limits, diagnostics);
  ASSERT_FALSE(cloud.ok());
  EXPECT_EQ(cloud.error().code, Errc::limit_exceeded);
}

TEST(PlyKinds, AreToldByTheFaces) {
  EXPECT_EQ(ply_kind(bytes_of(kAscii)), PlyKind::points);
  EXPECT_EQ(ply_kind(bytes_of("OFF\n")), PlyKind::not_ply);
  EXPECT_EQ(ply_kind(bytes_of("")), PlyKind::not_ply);
  const std::string head = "ply\nformat ascii 1.0\nelement vertex 1\n" PLY_XYZ;
  EXPECT_EQ(ply_kind(bytes_of(
                head + "element face 1\nproperty list uchar int vertex_indices\nend_header\n")),
            PlyKind::mesh);
  EXPECT_EQ(ply_kind(bytes_of(
                head + "element face 0\nproperty list uchar int vertex_indices\nend_header\n")),
            PlyKind::points);
}

}  // namespace
}  // namespace afx
