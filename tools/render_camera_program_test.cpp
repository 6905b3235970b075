// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Runs of `afx render` from everywhere.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>

#include "tools/program_fixture.h"

namespace afx::tools {
namespace {

using nlohmann::json;
using std::numbers::pi;

/// A cube of 8 voxels whose middle is at 3, 0, 0, and cameras.
constexpr const char* kScene = R"(
Transform { translation 3 0 0 children [ OctreeImage { octreeResolution 2 octree 255 } ] }
DEF FRONT Viewpoint { position 3 0 5 description "From the front" }
Transform { translation 3 0 0 rotation 0 1 0 1.5707963 scale 2 2 2 children [
  Viewpoint { position 0 0 2 description "From the right" fieldOfView 1 } ] }
Viewpoint { position 3 4 0 orientation 1 0 0 -1.5707963 }
)";

class RenderCamera : public Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    write_file(file("s.wrl"), kScene);
    write_file(file("t.obj"), kTetrahedron);
  }
  [[nodiscard]] json camera(const std::string& words) const {
    return result("render s.wrl -n -o p.png --size 16x16 " + words).at("camera");
  }
  void expect_usage(const std::string& words, const std::string& text) const {
    const Outcome outcome = run("render s.wrl -o x.png " + words);
    EXPECT_EQ(outcome.code, 2) << words;
    EXPECT_EQ(outcome.err, "afx: " + text + " (see 'afx render --help')\n");
    EXPECT_FALSE(fs::exists(file("x.png")));
  }
};

/// "1,2,3", so that the same numbers are read again.
std::string listed(const json& numbers) {
  std::string list;
  for (const json& number : numbers) list += (list.empty() ? "" : ",") + number.dump();
  return list;
}

/// The options that give a camera.
std::string options_of(const json& camera) {
  return "--position " + listed(camera.at("position")) + " --orientation " +
         listed(camera.at("orientation")) + " --near " + camera.at("near").dump() +
         (camera.contains("fov")
              ? " --fov " + camera.at("fov").dump()
              : " --orthographic --view-height " + camera.at("viewHeight").dump());
}

void expect_near(const json& numbers, const std::vector<double>& expected, double error = 1e-6) {
  ASSERT_EQ(numbers.size(), expected.size());
  for (size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(numbers[i].get<double>(), expected[i], error) << numbers;
}

TEST_F(RenderCamera, ByNumbersIsTheFittedOneOfTheseNumbers) {
  for (const std::string model : {"s.wrl", "t.obj"}) {
    for (const std::string how : {"", "--orthographic", "--azimuth -100 --elevation 60 --fov 70"}) {
      const json fitted = result("render " + model + " -f -o a.png --size 80x50 " + how);
      const json again =
          result("render " + model + " -f -o b.png --size 80x50 " + options_of(fitted["camera"]));
      EXPECT_EQ(read_file(file("a.png")), read_file(file("b.png"))) << model << how;
      EXPECT_EQ(again["camera"].contains("fov"), how != "--orthographic");
    }
  }
}

TEST_F(RenderCamera, LooksAtAPointOrTheMiddleOfTheModel) {
  // From the right: turned by a quarter around y. From the front: not at all.
  const json right = camera("--position 7,0,0");
  expect_near(right.at("orientation"), {0, 1, 0, pi / 2});
  expect_near(camera("--position 7,0,0 --look-at 3,0,0").at("orientation"), {0, 1, 0, pi / 2});
  EXPECT_NEAR(camera("--position -1,-2,-3 --look-at -1,-2,-9").at("orientation")[3], 0, 1e-9);
  // The corner of the cube is 0.5 before its middle, so 3.5 away; a hundredth of that.
  EXPECT_NEAR(right.at("near"), 0.035, 1e-9);
  // Up to the right: the camera is turned around its axis by a quarter to the right.
  expect_near(camera("--position 3,0,5 --up 1,0,0").at("orientation"), {0, 0, -1, pi / 2});
  EXPECT_EQ(camera("--position 3,0,5 --near 0.25").at("near"), 0.25);
}

TEST_F(RenderCamera, StandsAtAViewpointOfTheScene) {
  const json front = camera("--viewpoint FRONT");
  expect_near(front.at("position"), {3, 0, 5});
  EXPECT_EQ(camera("--viewpoint 'From the front'"), front);
  EXPECT_EQ(camera("--viewpoint 1"), front);
  // 2 units before the middle, scaled by 2, turned to the right.
  const json right = camera("--viewpoint 'From the right'");
  expect_near(right.at("position"), {7, 0, 0});
  expect_near(right.at("orientation"), {0, 1, 0, pi / 2});
  EXPECT_NEAR(right.at("fov"), 180 / pi, 1e-9);
  EXPECT_NEAR(camera("--viewpoint 2 --fov 20").at("fov"), 20, 1e-9);
  expect_near(camera("--viewpoint 3").at("position"), {3, 4, 0});
}

TEST_F(RenderCamera, AViewpointsAngleIsThatOfTheShorterSide) {
  const auto angle = [this](const std::string& size) {
    return result("render s.wrl -n -o p.png --viewpoint 2 --size " + size)
        .at("camera")
        .at("fov")
        .get<double>();
  };
  EXPECT_NEAR(angle("64x32"), 180 / pi, 1e-9);
  EXPECT_NEAR(angle("32x64"), 2 * std::atan(2 * std::tan(0.5)) * 180 / pi, 1e-9);
}

TEST_F(RenderCamera, WrongViewpointsAreNamedWithThoseThereAre) {
  expect_usage("--viewpoint FRNOT",
               "s.wrl: there is no viewpoint 'FRNOT' (did you mean 'FRONT'?) (expected 'FRONT', "
               "'From the right', 3, or a number from 1 to 3)");
  expect_usage("--viewpoint 4",
               "s.wrl: there is no viewpoint '4' (expected 'FRONT', 'From the right', 3, or a "
               "number from 1 to 3)");
  const Outcome mesh = run("render t.obj -o x.png --viewpoint A");
  EXPECT_EQ(mesh.code, 2);
  EXPECT_THAT(mesh.err, HasSubstr("t.obj: there is no viewpoint 'A' (the scene has none)"));
}

TEST_F(RenderCamera, OptionsThatDoNotGoTogetherAreUsageErrors) {
  expect_usage("--position 1,2", "--position is 1,2 (expected X,Y,Z)");
  expect_usage("--position 1,2,3,", "--position is 1,2,3, (expected X,Y,Z)");
  expect_usage("--position 1,2,inf", "--position is 1,2,inf (expected X,Y,Z)");
  expect_usage("--position 1,2,3 --orientation 0,1,0",
               "--orientation is 0,1,0 (expected AX,AY,AZ,ANGLE)");
  expect_usage("--look-at 1,2,3", "--look-at needs --position");
  expect_usage("--up 1,2,3", "--up needs --position");
  expect_usage("--orthographic --view-height 3", "--view-height needs --position");
  expect_usage("--position 1,2,3 --orthographic",
               "--orthographic by --position needs --view-height");
  expect_usage("--position 1,2,3 --view-height 4", "--view-height needs --orthographic");
  expect_usage("--orthographic --fov 30", "--fov has no effect beside --orthographic");
  expect_usage("--position 1,2,3 --azimuth 4", "--azimuth has no effect beside --position");
  expect_usage("--viewpoint 1 --margin 0.1", "--margin has no effect beside --viewpoint");
  expect_usage("--viewpoint 1 --position 1,2,3", "--position and --viewpoint exclude each other");
  expect_usage("--position 1,2,3 --look-at 0,0,0 --orientation 0,1,0,1",
               "--look-at and --orientation exclude each other");
  expect_usage("--position 1,2,3 --up 0,0,0", "--up is 0,0,0 (expected a direction)");
  expect_usage("--position 1,2,3 --look-at 1,0,3",
               "--look-at is straight above or below --position, or is that point (expected "
               "another --up or --look-at)");
  expect_usage("--position 3,5,0",
               "--position is straight above or below the model's middle, or there (expected "
               "--look-at, --up or --orientation)");
}

}  // namespace
}  // namespace afx::tools
