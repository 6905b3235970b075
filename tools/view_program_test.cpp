// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The viewer as a user meets it: a real window on a display of the test's own, real keys and mouse.
#include <fcntl.h>

#include <csignal>
#include <memory>
#include <thread>

#include "afx/picture_io.h"
#include "tools/program_fixture.h"

namespace afx::tools {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using std::chrono::steady_clock;

constexpr seconds kPatience(120);  // other programs may be busy

/// An X server without a screen.
class VirtualDisplay {
 public:
  VirtualDisplay() {
    int ends[2];
    if (pipe(ends) != 0) return;
    pid_ = fork();
    if (pid_ == 0) {
      const int nowhere = open("/dev/null", O_WRONLY);
      dup2(nowhere, STDOUT_FILENO);
      dup2(nowhere, STDERR_FILENO);
      const std::string fd = std::to_string(ends[1]);
      execlp("Xvfb", "Xvfb", "-displayfd", fd.c_str(), "-nolisten", "tcp", "-screen", "0",
             "1000x800x24", nullptr);
      _exit(127);
    }
    close(ends[1]);
    std::string number;  // comes when it is ready
    for (char c = 0; read(ends[0], &c, 1) == 1 && c != '\n';) number += c;
    close(ends[0]);
    if (!number.empty()) name_ = ":" + number;
  }
  ~VirtualDisplay() {
    if (pid_ <= 0) return;
    kill(pid_, SIGTERM);
    waitpid(pid_, nullptr, 0);
  }
  VirtualDisplay(const VirtualDisplay&) = delete;
  VirtualDisplay& operator=(const VirtualDisplay&) = delete;

  /// ":7"; empty: there is none.
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  pid_t pid_ = -1;
  std::string name_;
};

class ViewProgram : public Program {
 protected:
  static void SetUpTestSuite() { display_ = std::make_unique<VirtualDisplay>(); }
  static void TearDownTestSuite() { display_.reset(); }

  void SetUp() override {
    Program::SetUp();
    if (AFX_HAS_VIEWER == 0) GTEST_SKIP() << "this build has no viewer";
    if (display_->name().empty()) GTEST_SKIP() << "Xvfb is not there";
    if (std::system("command -v xdotool >/dev/null") != 0) GTEST_SKIP() << "xdotool is not there";
    write_file(file("t.obj"), kTetrahedron);
    (void)result("build t.obj -o m.wrl --resolution 64");
  }
  void TearDown() override {
    if (viewer_ > 0) {
      kill(viewer_, SIGKILL);
      waitpid(viewer_, nullptr, 0);
    }
    Program::TearDown();
  }

  /// Starts the viewer and waits until it shows the file `shown` (or its window, where empty).
  void view(const std::string& words, const std::string& shown) {
    // Leaks of the graphics libraries are not ours.
    const std::string line = "cd '" + folder_.string() + "' && DISPLAY=" + display_->name() +
                             " LIBGL_ALWAYS_SOFTWARE=1 ASAN_OPTIONS=detect_leaks=0 exec " +
                             AFX_PROGRAM + " view " + words + " >out.log 2>err.log";
    viewer_ = fork();
    if (viewer_ == 0) {
      execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
      _exit(127);
    }
    ASSERT_EQ(tool("search --sync --onlyvisible --class afx windowfocus --sync"), 0);
    if (shown.empty()) return;
    ASSERT_EQ(tool("search --sync --name '" + shown + " - afx'"), 0);
  }
  int tool(const std::string& words) const {
    const std::string line = "DISPLAY=" + display_->name() + " timeout " +
                             std::to_string(kPatience.count()) + " xdotool " + words +
                             " >/dev/null 2>tool.log";
    return std::system(("cd '" + folder_.string() + "' && " + line).c_str());
  }
  void press(const std::string& keys) const { ASSERT_EQ(tool("key " + keys), 0); }
  /// Drags the mouse from the middle of the window.
  void drag(int button, int x, int y) const {
    const std::string b = std::to_string(button);
    ASSERT_EQ(tool("mousemove 200 150 mousedown " + b + " sleep 0.1 mousemove_relative -- " +
                   std::to_string(x) + " " + std::to_string(y) + " sleep 0.1 mouseup " + b),
              0);
  }
  /// The exit code; -1: it does not end.
  int code() {
    const auto end = steady_clock::now() + kPatience;
    for (int status = 0; steady_clock::now() < end;) {
      if (waitpid(viewer_, &status, WNOHANG) == viewer_) {
        viewer_ = -1;
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
      }
      std::this_thread::sleep_for(milliseconds(20));
    }
    return -1;
  }
  /// Waits until standard error has the text.
  bool says(const std::string& text) const {
    const auto end = steady_clock::now() + kPatience;
    while (steady_clock::now() < end) {
      if (read_file(folder_ / "err.log").find(text) != std::string::npos) return true;
      std::this_thread::sleep_for(milliseconds(20));
    }
    return false;
  }
  /// Presses a key that saves a picture, and reads that.
  Picture saved(const std::string& key, const std::string& stem) {
    char number[24];
    std::snprintf(number, sizeof number, "_%04d.png", ++pictures_[stem]);
    const std::string name = stem + number;
    press(key);
    EXPECT_TRUE(says(name + ": ")) << name;
    auto picture = read_picture(file(name).string());
    EXPECT_TRUE(picture.ok());
    return picture.ok() ? std::move(picture).value() : Picture();
  }
  Picture picture() { return saved("p", "m"); }
  Picture window() { return saved("F12", "m_window"); }

  static std::unique_ptr<VirtualDisplay> display_;
  pid_t viewer_ = -1;
  std::map<std::string, int> pictures_;  // how many are there, by the beginnings of their names
};
std::unique_ptr<VirtualDisplay> ViewProgram::display_;

/// Pixels whose colours differ by more than a rounding; all, where the sizes do.
size_t differing(const Picture& a, const Picture& b) {
  if (a.width != b.width || a.height != b.height) return size_t{a.width} * a.height;
  size_t count = 0;
  for (uint32_t y = 0; y < a.height; ++y) {
    for (uint32_t x = 0; x < a.width; ++x) {
      const Rgba8 p = colour_at(a, x, y), q = colour_at(b, x, y);
      count += std::abs(p.r - q.r) > 2 || std::abs(p.g - q.g) > 2 || std::abs(p.b - q.b) > 2;
    }
  }
  return count;
}

TEST_F(ViewProgram, ShowsTheModelAsRenderDrawsIt) {
  view("m.wrl --size 400x300 --background '#204060'", "m.wrl");
  press("Tab");
  const Picture in_window = window();
  const Picture alone = picture();
  press("q");
  EXPECT_EQ(code(), 0);
  ASSERT_EQ(run("render m.wrl -o r.png --size 400x300 --background '#204060'").code, 0);
  const auto drawn = read_picture(file("r.png").string());
  ASSERT_TRUE(drawn.ok());
  EXPECT_LT(differing(alone, drawn.value()), 40U);  // cameras are rounded differently
  EXPECT_EQ(differing(in_window, alone), 0U);
  Picture ground(400, 300, 3);
  for (size_t i = 0; i < ground.samples.size(); ++i)
    ground.samples[i] = static_cast<uint8_t>(0x20 * (i % 3 + 1));
  EXPECT_GT(differing(alone, ground), 10000U);
  EXPECT_LT(differing(alone, ground), 100000U);
}

TEST_F(ViewProgram, DraggingTurnsItAndResetBringsItBackExactly) {
  view("m.wrl --size 400x300", "m.wrl");
  const Picture first = picture();
  drag(1, 60, 20);
  EXPECT_GT(differing(picture(), first), 1000U);
  press("r");
  EXPECT_EQ(picture().samples, first.samples);
  drag(3, 50, 10);  // the picture is shifted
  const Picture shifted = picture();
  size_t same = 0;
  for (uint32_t y = 20; y < 300; ++y)
    for (uint32_t x = 60; x < 400; ++x)
      same += colour_at(shifted, x, y) == colour_at(first, x - 50, y - 10);
  EXPECT_GT(same, 340U * 280 * 9 / 10);
  press("r");
  ASSERT_EQ(tool("mousemove 200 150 click 4 click 4 sleep 0.5"), 0);
  const Picture near = picture();
  EXPECT_GT(differing(near, first), 1000U);
  press("r");
  ASSERT_EQ(tool("keydown w sleep 0.3 keyup w"), 0);
  EXPECT_GT(differing(picture(), first), 100U);
  press("Escape");
  EXPECT_EQ(code(), 0);
}

TEST_F(ViewProgram, KeysChangeWhatIsDrawn) {
  view("m.wrl --size 400x300", "m.wrl");
  const Picture first = picture();
  press("k");
  EXPECT_GT(differing(picture(), first), 50U);
  press("k k l l l");
  EXPECT_GT(differing(picture(), first), 500U);
  press("shift+l shift+l shift+l o");
  EXPECT_GT(differing(picture(), first), 500U);
  press("o y");
  const Picture white = picture();
  EXPECT_EQ(colour_at(white, 0, 0), (Rgba8{255, 255, 255, 255}));
  press("y y y");
  EXPECT_EQ(picture().samples, first.samples);
}

TEST_F(ViewProgram, BoxesCamerasAndHelpLieOverThePicture) {
  view("m.wrl --size 700x500", "m.wrl");
  press("Tab");
  const Picture plain = window();
  press("b");
  const Picture boxes = window();
  EXPECT_GT(differing(boxes, plain), 500U);
  press("b i");
  EXPECT_GT(differing(window(), plain), 100U);
  EXPECT_EQ(differing(picture(), plain), 0U);
  press("i h");
  EXPECT_GT(differing(window(), plain), 50000U);
  press("Escape");  // the help
  EXPECT_EQ(differing(picture(), plain), 0U);
  press("q");
  EXPECT_EQ(code(), 0);
}

TEST_F(ViewProgram, TheWindowCanBeResizedAndPicturesAreOfItsSize) {
  view("m.wrl --size 400x300", "m.wrl");
  EXPECT_EQ(picture().width, 400U);
  ASSERT_EQ(tool("search --class afx windowsize --sync 300 500"), 0);
  const Picture high = picture();
  EXPECT_EQ(high.width, 300U);
  EXPECT_EQ(high.height, 500U);
}

TEST_F(ViewProgram, NothingIsOverwritten) {
  write_file(file("m_0001.png"), "mine");
  view("m.wrl --size 100x100", "m.wrl");
  pictures_["m"] = 1;
  EXPECT_EQ(picture().width, 100U);
  EXPECT_EQ(read_file(file("m_0001.png")), "mine");
}

TEST_F(ViewProgram, ViewpointsOfTheScene) {
  const std::string model = read_file(file("m.wrl"));
  write_file(file("m.wrl"), model +
                                "DEF FAR Viewpoint { position 0 0 30 description \"from afar\" }\n"
                                "Transform { translation 0.25 0.25 0 children [ DEF NEAR "
                                "Viewpoint { position 0 0 4 } ] }\n");
  view("m.wrl --size 200x200 --viewpoint NEAR", "m.wrl");
  const Picture near = picture();
  press("1");
  const Picture far = picture();
  EXPECT_GT(differing(far, near), 1000U);
  press("Next");
  EXPECT_EQ(picture().samples, near.samples);
  press("Prior");
  EXPECT_EQ(picture().samples, far.samples);
  press("q");
  EXPECT_EQ(code(), 0);
  view("m.wrl --viewpoint 7", "");
  EXPECT_TRUE(says("there is no viewpoint '7' (expected 'FAR', 'NEAR', or a number from 1 to 2)"));
  press("q");
  EXPECT_EQ(code(), 2);
}

TEST_F(ViewProgram, MeshesAndShapesAreShown) {
  write_file(file("box.wrl"), "#VRML V2.0 utf8\nShape { geometry Box {} }\n");
  const Picture ground(200, 200, 3);  // black
  for (const std::string name : {"t.obj", "box.wrl"}) {
    view(name + " --size 200x200 --background black", name);
    const Picture shown = saved("p", name.substr(0, name.find('.')));
    EXPECT_GT(differing(shown, ground), 4000U) << name;
    press("q");
    EXPECT_EQ(code(), 0);
  }
}

TEST_F(ViewProgram, WhatCannotBeShownIsSaidInTheWindowAndOnStandardError) {
  write_file(file("bad.wrl"),
             "#VRML V2.0 utf8\nOctreeImage { octreeResolution 2 octree [ 2 2 2 ] }");
  view("bad.wrl --size 400x300", "");
  EXPECT_TRUE(says("afx: bad.wrl: field octree has 3 bytes"));
  const Picture error = saved("F12", "bad_window");
  size_t red = 0;
  for (uint32_t y = 150; y < error.height; ++y)
    for (uint32_t x = 0; x < error.width; ++x)
      red += colour_at(error, x, y).r > 200 && colour_at(error, x, y).b < 160 ? 1 : 0;
  EXPECT_GT(red, 50U);
  press("p q");
  EXPECT_EQ(code(), 3);
  EXPECT_EQ(run("view no.wrl").code, 1);
}

TEST_F(ViewProgram, WrongOptionsAreUsageErrors) {
  for (const char* words : {"--size 3", "--background puce", "--backend x", "--splats x",
                            "--level 33", "--samples 9", "--frame 0", "--resolution 4"})
    EXPECT_EQ(run(std::string("view m.wrl ") + words).code, 2) << words;
}

TEST_F(Program, ViewWithoutDisplayIsOneLine) {
  write_file(file("m.wrl"), "OctreeImage { octreeResolution 2 octree 255 }");
  const std::string line = "cd '" + folder_.string() +
                           "' && env -u DISPLAY -u WAYLAND_DISPLAY " AFX_PROGRAM
                           " view m.wrl >out.log 2>err.log";
  EXPECT_EQ(WEXITSTATUS(std::system(line.c_str())), 1);
  const std::string error = read_file(file("err.log"));
  if (AFX_HAS_VIEWER == 0) {
    EXPECT_EQ(error, "afx: this build has no viewer\n");
    return;
  }
  EXPECT_THAT(error, testing::StartsWith("afx: there is no display: "));
  EXPECT_THAT(error, testing::EndsWith(" ('afx render' makes pictures without one)\n"));
  EXPECT_EQ(std::count(error.begin(), error.end(), '\n'), 1);
}

}  // namespace
}  // namespace afx::tools
