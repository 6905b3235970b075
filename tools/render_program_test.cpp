// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Runs of `afx render` to everything it writes.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "afx/picture_io.h"
#include "tools/program_fixture.h"

namespace afx::tools {
namespace {

using nlohmann::json;
using std::numbers::pi;

class RenderProgram : public Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    write_file(file("t.obj"), kTetrahedron);
    write_file(file("cube.wrl"), "OctreeImage { octreeResolution 2 octree 255 }");
  }
  void expect_usage(const std::string& words, const std::string& text) const {
    const auto before = contents();
    const Outcome outcome = run("render " + words);
    EXPECT_EQ(outcome.code, 2) << words;
    EXPECT_EQ(outcome.err, "afx: " + text + " (see 'afx render --help')\n");
    EXPECT_EQ(contents(), before);
  }
  [[nodiscard]] Picture picture(const std::string& name) const {
    auto read = read_picture(file(name).string());
    EXPECT_TRUE(read.ok()) << name;
    return read.ok() ? std::move(read).value() : Picture(1, 1, 4);
  }
  /// The channel Z of an OpenEXR file.
  [[nodiscard]] std::vector<float> depths(const std::string& name) const {
    const std::string z = file("z_of_it.exr").string();
    const std::string line =
        "oiiotool '" + file(name).string() + "' --ch Z -d float -o '" + z + "'";
    EXPECT_EQ(std::system(line.c_str()), 0);
    const std::string bytes = read_file(z);
    const auto read =
        decode_float_picture({reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size()});
    EXPECT_TRUE(read.ok());
    return read.ok() ? read.value().samples : std::vector<float>();
  }
  /// What ffprobe says of a video's only stream.
  [[nodiscard]] json probe(const std::string& name) const {
    const std::string line = "ffprobe -v error -count_frames -show_streams -of json '" +
                             file(name).string() + "' >'" + file("probe.log").string() + "'";
    EXPECT_EQ(std::system(line.c_str()), 0);
    const json all = json::parse(read_file(file("probe.log")), nullptr, false);
    EXPECT_EQ(all.at("streams").size(), 1U);
    return all.at("streams")[0];
  }
  [[nodiscard]] bool has_video() const {
    return run("render cube.wrl -n -o v.mp4 --turntable 1 --size 16x16").code == 0;
  }
};

TEST_F(RenderProgram, DepthIsTheDistanceToThePlaneThroughTheCamera) {
  // The plane z = x over 0..1 x 0..1, from z = 3: at the centre of column c of 8 it is 3 - x away,
  // x = (c + 0.5) / 8. The view, 2 units high, reaches from -0.5 to 1.5.
  write_file(file("plane.obj"), "v 0 0 0\nv 1 0 1\nv 0 1 0\nv 1 1 1\nf 1 2 3\nf 2 4 3\n");
  (void)result(
      "render plane.obj -o p.exr --depth --size 16x16 --orthographic --view-height 2 --position "
      "0.5,0.5,3 --orientation 0,1,0,0");
  const std::vector<float> z = depths("p.exr");
  ASSERT_EQ(z.size(), 256U);
  for (size_t y = 0; y < 16; ++y)
    for (size_t x = 0; x < 16; ++x) {
      const bool inside = x >= 4 && x < 12 && y >= 4 && y < 12;
      const double at = (static_cast<double>(x) + 0.5) / 8 - 0.5;
      if (inside) {
        EXPECT_NEAR(z[y * 16 + x], 3 - at, 1e-5);
      } else {
        EXPECT_TRUE(std::isinf(z[y * 16 + x]));
      }
    }
}

TEST_F(RenderProgram, DepthOfVoxelsIsThatOfTheirCentres) {
  // The middles of the front voxels are at +-0.25, +-0.25, 0.25: from z = 10 that is 9.75. An odd
  // number of pixels for each voxel: one has its centre there.
  for (const char* how : {"--orthographic --view-height 3", "--fov 17"}) {
    (void)result(
        std::string("render cube.wrl -f -o p.exr --depth --size 90x90 --position 0,0,10 ") + how);
    const std::vector<float> z = depths("p.exr");
    ASSERT_EQ(z.size(), 8100U);
    EXPECT_NEAR(z[37 * 90 + 37], 9.75, 2e-3) << how;
    EXPECT_NEAR(z[52 * 90 + 52], 9.75, 2e-3) << how;
    EXPECT_TRUE(std::isinf(z[0]));
  }
}

TEST_F(RenderProgram, ExrHoldsWhatPngShows) {
  for (const std::string model : {"cube.wrl", "t.obj"}) {
    (void)result("render " + model + " -f -o p.png --size 40x30 --background '#336699ff'");
    (void)result("render " + model + " -f -o p.exr --size 40x30 --background '#336699ff'");
    EXPECT_EQ(picture("p.exr").samples, picture("p.png").samples) << model;
    EXPECT_EQ(run("compare p.exr p.png").code, 0);
  }
  expect_usage("cube.wrl -o d.png --depth",
               "--depth is for .exr, which alone holds depth, not for .png");
}

TEST_F(RenderProgram, TurntablePicturesAreNumberedAndTurnToTheRight) {
  const json turned = result("render t.obj -o f_%03d.png --turntable 5 --size 60x40 --azimuth 10");
  EXPECT_EQ(turned.at("outputs"),
            json({"f_000.png", "f_001.png", "f_002.png", "f_003.png", "f_004.png"}));
  for (size_t k = 0; k < 5; ++k) {
    const json& camera = turned.at("cameras")[k];
    const double x = camera.at("position")[0].get<double>() - 0.5;
    const double z = camera.at("position")[2].get<double>() - 0.5;
    const double azimuth = (10 + 72 * static_cast<double>(k)) * pi / 180;
    const double away = std::hypot(x, z);
    // Straight in front of the axis, which goes through the middle of the model.
    EXPECT_NEAR(x, away * std::sin(azimuth), 1e-9);
    EXPECT_NEAR(z, away * std::cos(azimuth), 1e-9);
    EXPECT_EQ(camera.at("near"), turned.at("cameras")[0].at("near"));
    EXPECT_NEAR(camera.at("position")[1], turned.at("cameras")[0].at("position")[1], 1e-12);
    // The same as by --azimuth: the fitted camera of that direction looks the same way.
    const json fitted =
        result("render t.obj -n -o x.png --size 60x40 --azimuth " + std::to_string(10 + 72 * k));
    for (size_t i = 0; i < 4; ++i)
      EXPECT_NEAR(fitted.at("camera").at("orientation")[i], camera.at("orientation")[i], 1e-9);
    std::string by_numbers = "--position ";
    for (size_t i = 0; i < 3; ++i) by_numbers += (i ? "," : "") + camera.at("position")[i].dump();
    by_numbers += " --orientation ";
    for (size_t i = 0; i < 4; ++i)
      by_numbers += (i ? "," : "") + camera.at("orientation")[i].dump();
    (void)result("render t.obj -f -o one.png --size 60x40 " + by_numbers);
    EXPECT_EQ(read_file(file("one.png")),
              read_file(file(turned.at("outputs")[k].get<std::string>())));
  }
}

/// The most opaque alpha along the square that is `inset` pixels inside the border.
unsigned opacity_along(const Picture& picture, uint32_t inset) {
  unsigned most = 0;
  const uint32_t far = picture.width - 1 - inset;
  for (uint32_t i = inset; i <= far; ++i)
    for (const uint8_t* pixel : {picture.pixel(i, inset), picture.pixel(i, far),
                                 picture.pixel(inset, i), picture.pixel(far, i)})
      most = std::max<unsigned>(most, pixel[3]);
  return most;
}

TEST_F(RenderProgram, NoPictureOfATurntableIsCutAndTheModelFillsThem) {
  (void)result("build t.obj -o voxels.wrl --resolution 64");
  for (const std::string model : {"t.obj", "voxels.wrl"}) {
    for (const std::string how : {"", "--orthographic", "--elevation 70 --fov 90"}) {
      // The margin is 3.2 pixels; splats reach out by less than one.
      (void)result("render " + model + " -f -o f%d.png --turntable 16 --size 64x64 --margin 0.05 " +
                   how);
      unsigned inside = 0;
      for (int k = 0; k < 16; ++k) {
        const Picture shown = picture("f" + std::to_string(k) + ".png");
        EXPECT_EQ(opacity_along(shown, 1), 0U) << model << how << k;
        inside = std::max(inside, opacity_along(shown, 4));
      }
      EXPECT_GT(inside, 0U) << model << how;
    }
  }
}

TEST_F(RenderProgram, TurntablesDoNotDependOnThreads) {
  (void)result("render cube.wrl -o a%d.png --turntable 5 --size 32x32 --threads 1");
  (void)result("render cube.wrl -o b%d.png --turntable 5 --size 32x32 --threads 3");
  for (const std::string k : {"0", "1", "4"})
    EXPECT_EQ(read_file(file("a" + k + ".png")), read_file(file("b" + k + ".png")));
  if (!has_video()) return;
  (void)result("render cube.wrl -o a.mp4 --turntable 5 --size 32x32 --threads 1");
  (void)result("render cube.wrl -o b.mp4 --turntable 5 --size 32x32 --threads 3");
  EXPECT_EQ(read_file(file("a.mp4")), read_file(file("b.mp4")));
}

TEST_F(RenderProgram, VideosHaveTheFramesTheSizeAndTheSpeedAskedFor) {
  if (!has_video()) GTEST_SKIP() << "this build has no video";
  for (const std::string format : {"mp4", "mkv", "webm", "avi"}) {
    const json made = result("render t.obj -o v." + format +
                             " --turntable 12 --fps 25 --size 64x48 --progress always");
    EXPECT_EQ(made.at("frames"), 12);
    const json stream = probe("v." + format);
    EXPECT_EQ(stream.at("nb_read_frames"), "12") << format;
    EXPECT_EQ(stream.at("width"), 64);
    EXPECT_EQ(stream.at("height"), 48);
    EXPECT_EQ(stream.at("r_frame_rate"), "25/1") << format;
    EXPECT_EQ(stream.at("pix_fmt"), "yuv420p");
    if (stream.at("codec_name") == "mpeg4") continue;  // has no room for the marks
    EXPECT_EQ(stream.at("color_space"), "bt709") << format;
    EXPECT_EQ(stream.at("color_primaries"), "bt709") << format;
    EXPECT_EQ(stream.at("color_transfer"), "iec61966-2-1") << format;
    EXPECT_EQ(stream.at("color_range"), "tv") << format;
  }
  const Outcome piped = run("render t.obj -o - --format mkv --turntable 2 --size 32x32 -q");
  EXPECT_EQ(piped.code, 0);
  EXPECT_EQ(piped.out.substr(0, 4), "\x1A\x45\xDF\xA3");  // of EBML
}

TEST_F(RenderProgram, OutputsThatCannotBeAreUsageErrors) {
  expect_usage("t.obj -o x.mp4", "a video is of several pictures (expected --turntable N)");
  expect_usage("t.obj -o x.mp4 --turntable 2 --size 33x32",
               "--size is 33x32 (expected even numbers for a video)");
  expect_usage("t.obj -o x.mp4 --turntable 2 --background transparent",
               "a video has no transparency (expected an opaque --background)");
  expect_usage("t.obj -o x.png --turntable 3",
               "3 pictures cannot all be x.png (expected a number in the name, such as "
               "frame_%04d.png, or a video, such as turn.mp4)");
  expect_usage("t.obj -o x.png --fps 3", "--fps is for videos");
  expect_usage("t.obj -o x.png --video-quality 3", "--video-quality is for videos");
  expect_usage("t.obj", "there is nothing to do (expected --output, --compare or both)");
  expect_usage("t.obj -o x.png --splats flat", "--splats is for voxels and points, not for meshes");
  expect_usage("t.obj -o x.png --levels 2", "--levels is for octrees, not for meshes");
  expect_usage("cube.wrl -o x.gif",
               "cannot render to x.gif (expected .png, .jpeg, .bmp, .tga, .exr, .mp4, .mkv, .webm "
               "or .avi, or --format)");
  expect_usage("cube.wrl -o x.mkv --format png --turntable 2",
               "--format png disagrees with the name x.mkv (--format is for - and for names "
               "without a known ending)");
}

TEST_F(RenderProgram, NothingIsLeftAfterAFailure) {
  write_file(file("f2.png"), "mine");
  const auto before = contents();
  const Outcome there = run("render t.obj -o f%d.png --turntable 4 --size 32x32");
  EXPECT_EQ(there.code, 1);
  EXPECT_EQ(there.err, "afx: f2.png: exists already (use -f to overwrite)\n");
  EXPECT_EQ(run("render t.obj -o no/f%d.png --turntable 4 --size 32x32").code, 1);
  EXPECT_EQ(run("render t.obj -o no/v.mp4 --turntable 4 --size 32x32").code, 1);
  EXPECT_EQ(run("render t.obj -o no/x.exr --size 32x32").code, 1);
  EXPECT_EQ(run("render none.obj -o g%d.png --turntable 4").code, 1);
  EXPECT_EQ(run("render t.obj -o /dev/full --format png --size 32x32").code, 1);
  EXPECT_EQ(run("render t.obj -n -o g%d.png --turntable 4").code, 0);
  EXPECT_EQ(contents(), before);
}

TEST_F(RenderProgram, AnInterruptedTurntableLeavesNothing) {
  const auto before = contents();
  for (const std::string name : {"g%04d.png", "v.mp4"}) {
    if (name == "v.mp4" && !has_video()) continue;
    const std::string line =
        "cd '" + folder_.string() + "' && timeout --preserve-status -s INT 1 " +
        AFX_PROGRAM " render cube.wrl -o " + name + " --turntable 100000 --size 256x256 2>err.log";
    const int status = std::system(line.c_str());
    EXPECT_EQ(WEXITSTATUS(status), 130) << name;
    EXPECT_EQ(contents(), before) << name;
  }
}

TEST_F(RenderProgram, ComparesWithAPicture) {
  ASSERT_EQ(run("render cube.wrl -o p.png --size 48x40").code, 0);
  const Outcome same = run("render cube.wrl --compare p.png");
  EXPECT_EQ(same.code, 0) << same.err;
  EXPECT_EQ(same.out, "the pictures are the same\n");
  const Outcome other = run("render cube.wrl --compare p.png --azimuth 40 -o q.png");
  EXPECT_EQ(other.code, 4);
  EXPECT_THAT(other.out, MatchesRegex("the pictures differ in [0-9,]+ pixels: PSNR [0-9.]+ dB, "
                                      "SSIM [0-9.]+, mean difference [0-9.]+, greatest [0-9]+\n"));
  EXPECT_EQ(run("compare p.png q.png").out, other.out);
  const json told = result("render cube.wrl --compare p.png --azimuth 40", 4);
  EXPECT_EQ(told.at("width"), 48);
  EXPECT_EQ(told.at("comparison").at("same"), false);
  const double psnr = told.at("comparison").at("psnr");
  const double squared = told.at("comparison").at("meanSquared");
  EXPECT_NEAR(psnr, 10 * std::log10(255 * 255 / squared), 1e-9);
  const auto code = [&](const std::string& limit, double value) {
    return run("render cube.wrl --compare p.png --azimuth 40 " + limit + std::to_string(value))
        .code;
  };
  EXPECT_EQ(code("--min-psnr ", psnr - 0.1), 0);
  EXPECT_EQ(code("--min-psnr ", psnr + 0.1), 4);
  EXPECT_EQ(code("--max-mse ", squared + 1), 0);
  EXPECT_EQ(code("--max-mse ", squared - 1), 4);
  EXPECT_EQ(run("render cube.wrl --compare p.png --min-psnr 99").code, 0);
  EXPECT_EQ(run("render cube.wrl --compare p.png --size 10x10 --min-psnr 1").code, 4);
  EXPECT_EQ(run("render cube.wrl --compare none.png").code, 1);
}

TEST_F(RenderProgram, ComparesWithPicturesWithoutAlphaOverWhite) {
  ASSERT_EQ(run("render cube.wrl -o p.jpg --size 48x40 --jpeg-quality 100").code, 0);
  const json near = result("render cube.wrl --compare p.jpg --min-psnr 40");
  EXPECT_GT(near.at("comparison").at("psnr"), 40);
  expect_usage("cube.wrl --compare p.jpg --turntable 2 -o f%d.png",
               "--compare is for one picture, not for --turntable");
  expect_usage("cube.wrl --compare p.jpg -o - --format png",
               "--compare and -o - both write to standard output");
  expect_usage("cube.wrl -o x.png --min-psnr 3", "--min-psnr needs --compare");
}

TEST_F(RenderProgram, SaysWhatDrew) {
  const Outcome outcome = run("render cube.wrl -o p.png --size 16x16 -v");
  EXPECT_THAT(outcome.err,
              MatchesRegex("p.png: 16 x 16, 8 voxels, drawn by software in [0-9.]+ ms\n"));
  const Outcome gl = run("render cube.wrl -o q.png --size 16x16 --backend gl");
  if (gl.code == 0) return;
  EXPECT_EQ(gl.code, 1);
  EXPECT_THAT(gl.err, HasSubstr("OpenGL"));
  EXPECT_FALSE(fs::exists(file("q.png")));
}

TEST_F(RenderProgram, SplatsAreDrawnAsAskedFor) {
  (void)result("render cube.wrl -o smooth.png --size 64x64");
  (void)result("render cube.wrl -o same.png --size 64x64 --splats smooth --coarseness 1");
  (void)result("render cube.wrl -o points.png --size 64x64 --splats points");
  EXPECT_EQ(read_file(file("smooth.png")), read_file(file("same.png")));
  EXPECT_NE(read_file(file("smooth.png")), read_file(file("points.png")));
}

}  // namespace
}  // namespace afx::tools
