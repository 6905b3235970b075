// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/ply_writer.h"

#include <gtest/gtest.h>

#include <string>

#include "afx/builder/model_reader.h"

namespace afx {
namespace {

PointCloud points_or_fail(const std::vector<uint8_t>& bytes) {
  Diagnostics diagnostics;
  auto cloud = read_ply_points(bytes, {}, diagnostics);
  EXPECT_TRUE(cloud.ok()) << cloud.error().text;
  EXPECT_EQ(diagnostics.count(), 0U);
  return cloud.ok() ? cloud.value() : PointCloud{};
}

TEST(PlyWriter, WritesTheseBytes) {
  PointCloud cloud;
  cloud.positions = {{1, -2, 0.5}};
  cloud.colours = {{7, 8, 9, 255}};
  using std::string_literals::operator""s;
  const std::string expected =
      "ply\nformat binary_little_endian 1.0\nelement vertex 1\n"
      "property float x\nproperty float y\nproperty float z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n"
      "\x00\x00\x80\x3F\x00\x00\x00\xC0\x00\x00\x00\x3F\x07\x08\x09"s;
  const std::vector<uint8_t> bytes = write_ply_points(cloud);
  EXPECT_EQ(std::string(bytes.begin(), bytes.end()), expected);
}

TEST(PlyWriter, WhatItWritesIsReadBack) {
  for (const bool normals : {false, true})
    for (const bool colours : {false, true}) {
      PointCloud cloud;  // as readers give it: the first point is the origin
      cloud.origin = {123456789.125, -4, 1e-3};
      cloud.positions = {{0, 0, 0}, {0.125F, 3, -7}, {1e6F, 0.25F, 1024}};
      if (normals) cloud.normals = {{0, 0, 1}, {0.1F, 0.2F, 0.3F}, {0, 0, 0}};
      if (colours) cloud.colours = {{1, 2, 3, 255}, {255, 0, 254, 255}, {0, 128, 0, 255}};
      const PointCloud again = points_or_fail(write_ply_points(cloud));
      EXPECT_EQ(again.origin, cloud.origin);
      EXPECT_EQ(again.positions, cloud.positions);
      EXPECT_EQ(again.normals, cloud.normals);
      EXPECT_EQ(again.colours, cloud.colours);
    }
}

TEST(PlyWriter, SinglePrecisionIsEnoughWithoutOrigin) {
  PointCloud cloud;
  cloud.positions = {{0.1F, 0.2F, 0.3F}, {0.1F, 0.7F, 1e-9F}};
  const std::vector<uint8_t> bytes = write_ply_points(cloud);
  EXPECT_NE(std::string(bytes.begin(), bytes.end()).find("property float x"), std::string::npos);
  const PointCloud again = points_or_fail(bytes);
  EXPECT_EQ(again.origin, glm::dvec3(cloud.positions[0]));
  for (size_t n = 0; n < 2; ++n) {
    const glm::vec3 place(again.origin + glm::dvec3(again.positions[n]));
    EXPECT_FLOAT_EQ(place.x, cloud.positions[n].x);
    EXPECT_FLOAT_EQ(place.y, cloud.positions[n].y);
    EXPECT_NEAR(place.z, cloud.positions[n].z, 1e-7);
  }
}

}  // namespace
}  // namespace afx
