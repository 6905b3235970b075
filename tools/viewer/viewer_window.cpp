// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/viewer/viewer_window.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

namespace afx::tools {
namespace {

constexpr double kMessageSeconds = 4;
constexpr double kDoubleClickSeconds = 0.35;
constexpr double kFrame = 1.0 / 120;  // while something moves by itself
constexpr double kLineWidth = 1.5;
constexpr double kProbeScale = 0.25;  // of a picture for its distances alone
constexpr Rgba8 kCameraColour{240, 90, 160, 255};

}  // namespace

Viewer::Viewer(const ViewerHost& host) : host_(host), state_(host.drawn) {
  state_.set_distances([this](const glm::dvec2& at) { return distance_at(at); });
}

double Viewer::now() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void Viewer::run(ViewerEnd& end) {
  end.status = glfw_.start();
  if (!end.status.ok()) return;
  // The model is read while the window opens.
  loader_ = std::make_unique<LoadThread>(host_, [] { GlfwWindow::wake(); });
  load(host_.file);
  end.status = window_.open(host_.width, host_.height, *this);
  if (end.status.ok()) end.status = make_panes();
  if (end.status.ok()) {
    source_ = std::make_unique<PictureSource>([] { GlfwWindow::wake(); });
    last_turn_ = now();
    do {
      window_.wait(patience());
      turn();
    } while (!quit_ || pictures_to_save_ > 0 || windows_to_save_ > 0 || !saving_.empty());
  }
  if (model_ == nullptr) end.load_error = load_error_;
  end.still_working = loader_->busy() || (source_ && source_->busy());
  if (end.still_working) window_.hide();
}

Status Viewer::make_panes() {
  picture_pane_ = std::make_unique<PicturePane>();
  line_pane_ = std::make_unique<LinePane>();
  overlay_ = std::make_unique<Overlay>(window_.text_scale());
  gl_ = std::make_unique<GlBackend>();
  for (const std::string& problem : {picture_pane_->problem(), line_pane_->problem()}) {
    if (!problem.empty())
      return Error{Errc::not_available, Place::none(), "OpenGL refuses a shader: " + problem};
  }
  return {};
}

std::optional<double> Viewer::patience() const {
  const double time = now();
  if (dirty_ || last_turn_ == 0) return 0;
  if (state_.is_moving()) return kFrame;
  double most = std::numeric_limits<double>::infinity();
  if (const auto due = source_->due(time); due && !uses_gl()) most = *due;
  if (uses_gl() && coarse_) most = std::max(moved_ + PictureSource::kStill - time, 0.0);
  if (!message_.empty()) most = std::min(most, std::max(message_end_ - time, 0.0));
  if (loader_->busy() || !saving_.empty()) most = std::min(most, 0.1);
  if (most == std::numeric_limits<double>::infinity()) return std::nullopt;
  return std::max(most, 1e-3);
}

/// Once around: time passes, news are taken, what is no longer right is painted.
void Viewer::turn() {
  const double time = now();
  state_.advance(std::min(time - std::exchange(last_turn_, time), 0.1));
  quit_ = quit_ || window_.wants_to_close();
  take_loaded();
  take_saved();
  const glm::ivec2 size = window_.size();
  if (size.x < 1 || size.y < 1) {  // hidden: nothing to see, nothing to save
    pictures_to_save_ = windows_to_save_ = 0;
    return;
  }
  state_.set_size(size);
  const Wanted before = wanted_;
  wanted_ = {model_,
             state_.camera_for_drawing(),
             state_.drawn(),
             static_cast<uint32_t>(size.x),
             static_cast<uint32_t>(size.y),
             host_.threads};
  if (uses_gl()) {
    note_change(before, time);
  } else {
    source_->want(wanted_, time);
  }
  if (source_->update(time)) {
    picture_pane_->upload(source_->shown()->image);
    dirty_ = true;
  }
  if (const std::string said = state_.take_message(); !said.empty()) say(said);
  if (time > message_end_) message_.clear();
  if (dirty_ || look() != painted_) {
    paint();
    painted_ = look();
  }
  save_picture();
}

std::string Viewer::look() const {
  const OverlayText text = texts();
  const Drawn& drawn = state_.drawn();
  std::string all = text.status + '\n' + text.waiting + '\n' + text.message + '\n' + text.error;
  return all += {text.help ? 'h' : ' ', drawn.boxes ? 'b' : ' ', drawn.cameras ? 'c' : ' '};
}

/// For the OpenGL renderer, which draws when the window is painted: one sample while the view
/// moves.
void Viewer::note_change(const Wanted& before, double time) {
  if (!same_picture(before, wanted_)) {
    moved_ = time;
    coarse_ = dirty_ = measure_ = true;
  } else if (coarse_ && time >= moved_ + PictureSource::kStill) {
    coarse_ = false;
    dirty_ = measure_ = true;
  }
}

void Viewer::key(int key, const Modifiers& modifiers, bool down) {
  if (!down) return state_.key_up(key);
  dirty_ = true;
  switch (state_.key_down(key, modifiers)) {
    case Action::quit:
      quit_ = true;
      break;
    case Action::screenshot:
      if (model_ == nullptr) return say("there is no picture yet");
      ++pictures_to_save_;
      break;
    case Action::window_picture:
      ++windows_to_save_;
      break;
    case Action::fullscreen:
      window_.switch_fullscreen();
      break;
    default:
      break;
  }
}

void Viewer::button(Button button, const Modifiers& modifiers, bool down, const glm::dvec2& at) {
  if (!down) return state_.button_up(button);
  const double time = now();
  const bool plain = button == Button::left && !modifiers.shift && !modifiers.control;
  if (plain && time - last_click_ < kDoubleClickSeconds && glm::length(at - clicked_) < 5) {
    state_.double_click(at);
    last_click_ = -1;
    return;
  }
  last_click_ = plain ? time : -1;
  clicked_ = at;
  state_.button_down(button, modifiers, at);
}

void Viewer::say(const std::string& message) {
  message_ = message;
  message_end_ = now() + kMessageSeconds;
}

/// The picture with the distances of what is seen; null where there is none.
const render::RenderedImage* Viewer::distances() {
  if (!uses_gl()) {
    const DrawResult* shown = source_ ? source_->shown() : nullptr;
    return shown != nullptr ? &shown->image : nullptr;
  }
  if (model_ == nullptr) return nullptr;
  if (!same_picture(probed_, wanted_) || probe_.depth.empty()) {
    probed_ = wanted_;
    if (!gl_->draw(wanted_, 1, kProbeScale, probe_).ok()) probe_ = {};
  }
  return &probe_;
}

std::optional<double> Viewer::distance_at(const glm::dvec2& at) {
  const render::RenderedImage* image = distances();
  if (image == nullptr || image->depth.empty()) return std::nullopt;
  const Picture& picture = image->picture;
  const double scale = picture.height / static_cast<double>(std::max(1U, wanted_.height));
  const glm::dvec2 pixel = at * scale;
  if (!(pixel.x >= 0 && pixel.y >= 0 && pixel.x < picture.width && pixel.y < picture.height))
    return std::nullopt;
  const float distance =
      image->depth[static_cast<size_t>(pixel.y) * picture.width + static_cast<size_t>(pixel.x)];
  if (!(distance < std::numeric_limits<float>::infinity())) return std::nullopt;
  return distance;
}

void Viewer::paint() {
  dirty_ = false;
  const glm::ivec2 size = window_.size();
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, size.x, size.y);
  const Rgba8 ground = state_.drawn().background;
  glClearColor(static_cast<float>(ground.r) / 255, static_cast<float>(ground.g) / 255,
               static_cast<float>(ground.b) / 255, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  if (model_ != nullptr && paint_model()) paint_lines();
  overlay_->draw(texts(), size);
  save_window();
  window_.show_painted();
}

/// Returns whether there is a picture.
bool Viewer::paint_model() {
  if (uses_gl()) {
    const double start = now();
    const Status drawn = gl_->present(wanted_, coarse_ ? 1 : state_.drawn().samples);
    if (measure_) {
      glFinish();
      gl_seconds_ = now() - start;
      measure_ = false;
    }
    if (drawn.ok()) return true;
    state_.refuse_backend(drawn.error().text);
    dirty_ = true;
  }
  if (source_->shown() == nullptr) return false;
  picture_pane_->draw(window_.size());
  return true;
}

void Viewer::paint_lines() const {
  const Drawn& drawn = state_.drawn();
  std::vector<Line> lines;
  if (drawn.boxes) lines = boxes_;
  for (size_t i = 0; drawn.cameras && i < model_->cameras.size(); ++i) {
    if (state_.reference() == i) continue;  // one stands in it
    add_frustum(model_->cameras[i], state_.ball().radius * 0.12, kCameraColour, lines);
  }
  // As the picture was seen, not as the next one will be.
  const render::Camera camera = uses_gl() ? wanted_.camera : source_->shown()->request.camera;
  const double width = kLineWidth * window_.text_scale();
  line_pane_->draw(line_triangles(lines, camera, window_.size(), width),
                   camera.projection == render::Projection::perspective, width,
                   uses_gl() ? picture_pane_->no_depths() : picture_pane_->depths(),
                   window_.size());
}

}  // namespace afx::tools
