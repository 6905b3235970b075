// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The viewer as a whole: window, state, pictures, files.
#pragma once

#include <deque>
#include <future>
#include <memory>
#include <string>
#include <vector>

#include "tools/viewer/gl_backend.h"
#include "tools/viewer/glfw_window.h"
#include "tools/viewer/load_thread.h"
#include "tools/viewer/overlay.h"
#include "tools/viewer/panes.h"
#include "tools/viewer/picture_source.h"
#include "tools/viewer/viewer_module.h"

namespace afx::tools {

class Viewer : private WindowEvents {
 public:
  explicit Viewer(const ViewerHost& host);
  ~Viewer() override = default;

  /// Opens the window and returns when it has been closed. Where end.still_working is set, threads
  /// work for this object, which must stay until the process ends.
  void run(ViewerEnd& end);

 private:
  void key(int key, const Modifiers& modifiers, bool down) override;
  void button(Button button, const Modifiers& modifiers, bool down, const glm::dvec2& at) override;
  void move(const glm::dvec2& at) override { state_.move(at); }
  void scroll(double steps, const glm::dvec2& at) override { state_.scroll(steps, at); }
  void lost_focus() override { state_.release_all(); }
  void damaged() override { dirty_ = true; }
  void dropped(const std::string& file) override { load(file); }

  [[nodiscard]] Status make_panes();
  void turn();
  void note_change(const Wanted& before, double time);
  void load(const std::string& file);
  void take_loaded();
  void take_saved();
  void say(const std::string& message);
  void save(Picture&& picture, bool window);
  void save_picture();
  void save_window();
  [[nodiscard]] bool is_final() const;
  [[nodiscard]] bool can_save() const;
  [[nodiscard]] bool uses_gl() const { return state_.drawn().backend == Backend::gl; }
  [[nodiscard]] std::optional<double> patience() const;
  [[nodiscard]] const render::RenderedImage* distances();
  [[nodiscard]] std::optional<double> distance_at(const glm::dvec2& at);
  /// All that paint() shows besides the picture.
  [[nodiscard]] std::string look() const;
  [[nodiscard]] OverlayText texts() const;
  [[nodiscard]] std::string status_text() const;
  void paint();
  [[nodiscard]] bool paint_model();
  void paint_lines() const;
  [[nodiscard]] double now() const;

  const ViewerHost& host_;
  GlfwLibrary glfw_;
  GlfwWindow window_;
  ViewerState state_;
  std::shared_ptr<const ViewerModel> model_;
  std::vector<Line> boxes_;  // of the model
  Wanted wanted_;
  std::unique_ptr<LoadThread> loader_;
  std::unique_ptr<PictureSource> source_;
  // What lives in the window's context, and goes before it.
  std::unique_ptr<PicturePane> picture_pane_;
  std::unique_ptr<LinePane> line_pane_;
  std::unique_ptr<Overlay> overlay_;
  std::unique_ptr<GlBackend> gl_;

  double last_turn_ = 0;
  double moved_ = 0;  // see note_change
  bool coarse_ = true;
  bool measure_ = true;
  double gl_seconds_ = 0;
  Wanted probed_;
  render::RenderedImage probe_;  // see distances()
  double last_click_ = -1;
  glm::dvec2 clicked_{0};
  std::string message_, error_;
  double message_end_ = 0;
  double load_start_ = 0;
  std::optional<Error> load_error_;
  bool quit_ = false;
  bool dirty_ = true;
  int pictures_to_save_ = 0, windows_to_save_ = 0;
  std::deque<std::future<Result<std::string>>> saving_;
  std::string painted_;  // look() of what is in the window
};

}  // namespace afx::tools
