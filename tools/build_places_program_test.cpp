// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Runs of the program that build from where it is not easy: far from the origin, with cameras of
// the user's own, with nothing to see, with opacity.
#include <cmath>

#include "afx/picture_io.h"
#include "tools/program_fixture.h"

namespace afx::tools {
namespace {

using nlohmann::json;

constexpr double kGoldenAngle = 2.399963229728653;

/// Points on a sphere of radius 1, from top to bottom.
std::string sphere(double x, double y) {
  constexpr int kPoints = 3000;
  std::string ply = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(kPoints) +
                    "\nproperty double x\nproperty double y\nproperty double z\nend_header\n";
  for (int i = 0; i < kPoints; ++i) {
    const double height = 1 - (2 * i + 1.0) / kPoints;
    const double radius = std::sqrt(1 - height * height);
    ply += std::to_string(x + radius * std::cos(kGoldenAngle * i)) + " " +
           std::to_string(y + height) + " " + std::to_string(radius * std::sin(kGoldenAngle * i)) +
           "\n";
  }
  return ply;
}

/// A list of one camera before the tetrahedron, looking along -z.
std::string camera(const std::string& size, double far_plane) {
  return R"({"cameras": [{"position": [0.5, 0.5, 3], "fieldOfView": [2, 2], "nearPlane": 1,
 "farPlane": )" +
         std::to_string(far_plane) + ", " + size + "}]}";
}

class BuildPlaces : public Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    write_file(file("t.obj"), kTetrahedron);
  }
};

TEST_F(BuildPlaces, FarFromTheOriginEveryFormIsAsNearAsAtTheOrigin) {
  write_file(file("near.ply"), sphere(0, 0));
  write_file(file("far.ply"), sphere(500000.03, 4000000.11));
  for (const std::string form : {"depth", "points", "octree"}) {
    double d1[2] = {};
    for (const std::string place : {"near", "far"}) {
      const std::string scene = place + "_" + form + ".wrl";
      (void)result("build " + place + ".ply -o " + scene + " --resolution 32 --as " + form);
      d1[place == "far" ? 1 : 0] =
          result("compare " + place + ".ply " + scene + " --views 0", 4).at("d1");
    }
    EXPECT_LT(d1[0], 1.0 / 32) << form;
    EXPECT_NEAR(d1[1], d1[0], 0.05 * d1[0]) << form;
  }
  EXPECT_THAT(read_file(file("far_depth.wrl")), HasSubstr("translation 5e+05 4e+06 0\n"));
  EXPECT_THAT(read_file(file("near_depth.wrl")), Not(HasSubstr("translation")));
}

TEST_F(BuildPlaces, CamerasOfASceneFarFromTheOriginSeeTheModelAgain) {
  write_file(file("far.ply"), sphere(500000.03, 4000000.11));
  const json once = result("build far.ply -o a.wrl --as depth --resolution 32 --views 1");
  const json again = result("build far.ply -o b.wrl --as depth --views a.wrl");
  EXPECT_EQ(again.at("usedPixels"), once.at("usedPixels"));
  EXPECT_EQ(read_file(file("a_view01_depth.png")), read_file(file("b_view01_depth.png")));
  const json octree = result("build a.wrl -o c.wrl --as octree --resolution 16");
  EXPECT_LT(result("compare a.wrl c.wrl --views 0", 4).at("d1"), 1.0 / 16);
  EXPECT_GT(octree.at("voxels"), 100);
}

TEST_F(BuildPlaces, CamerasMayBeMovedButNotTurned) {
  (void)result("build t.obj -o a.wrl --as depth --resolution 16 --views 1");
  std::string text = read_file(file("a.wrl"));
  const size_t at = text.find("Transform {") + std::string("Transform {").size();
  write_file(file("turned.wrl"), text.insert(at, " rotation 0 1 0 1"));
  EXPECT_EQ(run("build t.obj -o b.wrl --as depth --views turned.wrl").err,
            "afx: turned.wrl: its DepthImages stand under a Transform that turns or scales them "
            "(expected one that moves them at most)\n");
}

TEST_F(BuildPlaces, NothingToSeeIsAnErrorNotAnEmptyScene) {
  write_file(file("short.json"), camera(R"("width": 8, "height": 8)", 1.5));
  for (const char* form : {"depth", "points"}) {
    const Outcome built = run(std::string("build t.obj -o x.wrl --views short.json --as ") + form);
    EXPECT_EQ(built.code, 3) << form;
    EXPECT_EQ(built.err,
              "afx: t.obj: nothing of the model can be seen (expected a surface before the "
              "cameras)\n");
  }
  EXPECT_EQ(files(), (std::vector<std::string>{"short.json", "t.obj"}));
}

TEST_F(BuildPlaces, AMeshIsSampledAsTheGivenPlaneAsks) {
  const json plain = result("build t.obj -o a.wrl --as points --resolution 40 --depth-bits 12");
  const json given = result("build t.obj -o b.wrl --as points --views a.wrl --depth-bits 12");
  EXPECT_EQ(given.at("samples"), plain.at("samples"));
  EXPECT_EQ(run("compare --exact a.wrl b.wrl").code, 0);
}

TEST_F(BuildPlaces, TheLongerSideOfAPixelSaysTheBitsOfDepths) {
  // Pixels of 0.01 x 0.2 over a range of 3: 0.1 takes 30 steps, 0.005 would take 600.
  write_file(file("flat.json"), camera(R"("width": 200, "height": 10)", 4));
  EXPECT_EQ(result("build t.obj -o a.wrl --as points --views flat.json").at("depthBits"), 8);
}

TEST_F(BuildPlaces, ThePlaneOfPointsIsOneCamera) {
  (void)result("build t.obj -o a.wrl --as depth --resolution 8");
  EXPECT_EQ(run("build t.obj -o b.wrl --as points --views a.wrl").err,
            "afx: a.wrl: has 6 cameras (expected one, the reference plane of --as points)\n");
}

TEST_F(BuildPlaces, OpacityIsLeftOutWithACountWhereThereIsNoPlaceForIt) {
  Picture colour(4, 4, 4);
  for (size_t i = 0; i < colour.samples.size(); ++i)
    colour.samples[i] = i % 4 == 3 ? 100 : 200;  // all translucent
  const DeepPicture depth{4, 4, 1, 8, std::vector<uint16_t>(16, 128)};
  const auto colours = encode_picture(colour, "png");
  const auto depths = encode_picture(depth, "png", {.colour = false});
  ASSERT_TRUE(colours.ok() && depths.ok());
  write_file(file("c.png"), {colours.value().begin(), colours.value().end()});
  write_file(file("d.png"), {depths.value().begin(), depths.value().end()});
  write_file(file("glass.wrl"),
             "#VRML V2.0 utf8\nGroup { children [ DepthImage { fieldOfView 4 4 nearPlane 1\n"
             "farPlane 20 diTexture SimpleTexture { texture ImageTexture { url \"c.png\" }\n"
             "depth ImageTexture { url \"d.png\" } } } ] }\n");
  const std::string words = "build glass.wrl --as depth --views glass.wrl -o ";
  const Outcome jpeg = run(words + "a.wrl --image-format jpeg");
  EXPECT_EQ(jpeg.code, 0);
  EXPECT_THAT(jpeg.err, HasSubstr("afx: glass.wrl: warning: 16 pixels become opaque: JPEG has no "
                                  "alpha channel\n"));
  const Outcome alpha = run(words + "b.wrl --depth-in-alpha");
  EXPECT_EQ(alpha.code, 0);
  EXPECT_THAT(alpha.err, HasSubstr("16 pixels become opaque: the alpha channel has the depth\n"));
  const Outcome png = run(words + "c.wrl");
  EXPECT_THAT(png.err, Not(HasSubstr("opaque")));
  EXPECT_EQ(result("info c_view01.png").at("components"), 4);
}

}  // namespace
}  // namespace afx::tools
