// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/viewer/viewer_state.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <utility>

namespace afx::tools {
namespace {

constexpr double kZoomStep = 0.15;      // logarithm of the factor of a wheel's step
constexpr double kZoomSeconds = 0.05;   // in which all but a third of a zoom is done
constexpr double kTurnSeconds = 4;      // for half a turn by a held key
constexpr double kZoomPerSecond = 1.2;  // logarithm of the factor
constexpr double kFlyPerSecond = 0.8;   // of the target's distance
constexpr double kFast = 4;

const char* name_of(render::SplatKind kind) {
  switch (kind) {
    case render::SplatKind::smooth:
      return "smooth splats";
    case render::SplatKind::flat:
      return "flat splats";
    case render::SplatKind::points:
      break;
  }
  return "points";
}

/// The vertical angle of a viewpoint: its own is the smaller of both of the picture.
double vertical_angle(const Viewpoint& viewpoint, double aspect) {
  const double angle = std::clamp(viewpoint.field_of_view, 1e-3, 3.0);
  return aspect >= 1 ? angle : 2 * std::atan(std::tan(angle / 2) / aspect);
}

}  // namespace

void ViewerState::set_size(const glm::dvec2& size) {
  const bool first = size_ == glm::dvec2(1, 1);
  size_ = glm::max(size, glm::dvec2(1, 1));
  if (first && model_ != nullptr) go_to_start();
}

void ViewerState::show(std::shared_ptr<const ViewerModel> model) {
  model_ = std::move(model);
  ball_ = ball_of(model_->outline);
  go_to_start();
}

void ViewerState::go_to_start() {
  camera_ = {};
  zoom_left_ = 0;
  viewpoint_.reset();
  reference_.reset();
  if (model_ == nullptr) return;
  if (model_->first_viewpoint > 0) {
    go_to_viewpoint(model_->first_viewpoint - 1);
  } else {
    fit(camera_, model_->outline, size_.x / size_.y);
  }
}

Action ViewerState::key_down(int key, const Modifiers& modifiers) {
  const Action action = action_of(key, modifiers);
  fast_ = modifiers.shift;
  if (is_held(action)) {
    held_[key] = action;
    reference_.reset();
    return Action::none;
  }
  switch (action) {
    case Action::quit:
      if (key != kKeyEscape || !help_) return action;
      help_ = false;  // Escape first leaves what lies on top
      return Action::none;
    case Action::screenshot:
    case Action::window_picture:
    case Action::fullscreen:
      return action;
    default:
      act(action, key);
      return Action::none;
  }
}

void ViewerState::key_up(int key) { held_.erase(key); }

void ViewerState::release_all() {
  held_.clear();
  drag_ = Drag::none;
}

void ViewerState::act(Action action, int key) {
  switch (action) {
    case Action::help:
      help_ = !help_;
      break;
    case Action::status:
      status_ = !status_;
      break;
    case Action::reset:
    case Action::fit:
    case Action::projection:
    case Action::next_camera:
    case Action::previous_camera:
    case Action::next_viewpoint:
    case Action::previous_viewpoint:
    case Action::viewpoint:
      act_on_places(action, key);
      break;
    default:
      act_on_drawing(action);
      break;
  }
}

void ViewerState::act_on_places(Action action, int key) {
  if (model_ == nullptr) return;
  zoom_left_ = 0;
  const bool perspective = camera_.projection == render::Projection::perspective;
  switch (action) {
    case Action::reset:
      go_to_start();
      break;
    case Action::fit:
      fit(camera_, model_->outline, size_.x / size_.y);
      reference_.reset();
      break;
    case Action::projection:
      camera_.projection =
          perspective ? render::Projection::orthographic : render::Projection::perspective;
      message_ = perspective ? "parallel projection" : "perspective projection";
      break;
    case Action::next_camera:
    case Action::previous_camera:
      step_camera(action == Action::next_camera ? 1 : -1);
      break;
    case Action::viewpoint:
      go_to_viewpoint(static_cast<size_t>(key - '1'));
      break;
    default:
      step_viewpoint(action == Action::next_viewpoint ? 1 : -1);
      break;
  }
}

void ViewerState::act_on_drawing(Action action) {
  switch (action) {
    case Action::splats:
      drawn_.splats =
          static_cast<render::SplatKind>((static_cast<unsigned>(drawn_.splats) + 1) % 3);
      message_ = name_of(drawn_.splats);
      break;
    case Action::coarser:
    case Action::finer:
      set_level(action == Action::finer ? 1 : -1);
      break;
    case Action::samples:
      drawn_.samples = drawn_.samples % 4 + 1;
      message_ = std::to_string(drawn_.samples) + " x " + std::to_string(drawn_.samples) +
                 (drawn_.samples == 1 ? " sample" : " samples") + " in a pixel";
      break;
    case Action::backend:
      drawn_.backend = drawn_.backend == Backend::software ? Backend::gl : Backend::software;
      message_ = drawn_.backend == Backend::software ? "drawn by software" : "drawn by OpenGL";
      break;
    case Action::background:
      next_background();
      break;
    case Action::boxes:
      drawn_.boxes = !drawn_.boxes;
      break;
    case Action::cameras:
      drawn_.cameras = !drawn_.cameras;
      if (drawn_.cameras && model_ != nullptr && model_->cameras.empty())
        message_ = "the model has no reference images";
      break;
    default:
      break;
  }
}

void ViewerState::refuse_backend(const std::string& reason) {
  drawn_.backend = Backend::software;
  message_ = reason;
}

void ViewerState::set_level(int step) {
  const unsigned finest = model_ != nullptr ? model_->levels : 0;
  if (finest == 0) {
    message_ = "the model has no octree";
    return;
  }
  const int level = static_cast<int>(std::min(drawn_.level, finest)) + step;
  drawn_.level = static_cast<unsigned>(std::clamp(level, 0, static_cast<int>(finest)));
  message_ = "octree level " + std::to_string(drawn_.level) + " of " + std::to_string(finest);
}

void ViewerState::next_background() {
  constexpr Rgba8 kColours[] = {{255, 255, 255, 255}, {0, 0, 0, 255}, {91, 122, 153, 255}};
  const bool has_backdrop = model_ != nullptr && model_->scene.backdrop.has_value();
  background_ = (background_ + 1) % (std::size(kColours) + 1);
  drawn_.backdrop = background_ == 0;
  drawn_.background = background_ == 0 ? first_background_ : kColours[background_ - 1];
  if (background_ == 0 && has_backdrop) message_ = "the scene's background";
}

void ViewerState::go_to_viewpoint(size_t index) {
  const size_t count = model_->viewpoints.size();
  if (index >= count) {
    message_ = count == 0 ? "the scene has no viewpoints"
                          : "there is no viewpoint " + std::to_string(index + 1) +
                                " (expected 1 to " + std::to_string(count) + ")";
    return;
  }
  const Viewpoint& viewpoint = model_->viewpoints[index];
  camera_.projection = render::Projection::perspective;
  camera_.field_of_view = vertical_angle(viewpoint, size_.x / size_.y);
  place(camera_, viewpoint.position, viewpoint.orientation, ball_);
  viewpoint_ = index;
  reference_.reset();
  const std::string& name = viewpoint.description.empty() ? viewpoint.name : viewpoint.description;
  message_ = "viewpoint " + std::to_string(index + 1) + " of " + std::to_string(count) +
             (name.empty() ? "" : ": " + name);
}

void ViewerState::step_viewpoint(int step) {
  const size_t count = std::max<size_t>(model_->viewpoints.size(), 1);
  const size_t from = viewpoint_.value_or(step > 0 ? count - 1 : 0);
  go_to_viewpoint((from + count + static_cast<size_t>(step)) % count);
}

void ViewerState::step_camera(int step) {
  const size_t count = model_->cameras.size();
  if (count == 0) {
    message_ = "the model has no reference images";
    return;
  }
  const size_t from = reference_.value_or(step > 0 ? count - 1 : 0);
  const size_t index = (from + count + static_cast<size_t>(step)) % count;
  const ReferenceCamera& reference = model_->cameras[index];
  const glm::dmat3 axes(reference.right, reference.up, -reference.ahead);
  place(camera_, reference.position, glm::quat_cast(axes), ball_);
  // All of the picture is to be seen, whatever the window's shape.
  const double half = std::max(reference.half_view.y, reference.half_view.x * size_.y / size_.x);
  camera_.projection =
      reference.orthographic ? render::Projection::orthographic : render::Projection::perspective;
  if (reference.orthographic) {
    camera_.field_of_view = OrbitCamera{}.field_of_view;
    camera_.distance = half / std::tan(camera_.field_of_view / 2);
  } else {
    camera_.field_of_view = 2 * std::atan(half);
  }
  reference_ = index;
  viewpoint_.reset();
  message_ = "reference camera " + std::to_string(index + 1) + " of " + std::to_string(count);
}

void ViewerState::button_down(Button button, const Modifiers& modifiers, const glm::dvec2& at) {
  mouse_ = at;
  if (drag_ != Drag::none) return;
  drag_button_ = button;
  drag_ = button != Button::left || modifiers.shift ? Drag::pan
          : modifiers.control                       ? Drag::look
                                                    : Drag::orbit;
}

void ViewerState::button_up(Button button) {
  if (button == drag_button_) drag_ = Drag::none;
}

void ViewerState::move(const glm::dvec2& at) {
  const glm::dvec2 by = at - mouse_;
  mouse_ = at;
  if (drag_ == Drag::none || by == glm::dvec2(0) || model_ == nullptr) return;
  if (drag_ == Drag::orbit) orbit(camera_, by, size_.y);
  if (drag_ == Drag::pan) pan(camera_, by, size_.y);
  if (drag_ == Drag::look) look(camera_, by, size_.y);
  reference_.reset();
}

glm::dvec3 ViewerState::point_at(const glm::dvec2& at) const {
  const auto found = distance_at_ ? distance_at_(at) : std::nullopt;
  if (!found) return point_under(camera_, at, size_, camera_.distance);
  // In parallel projection the distance is that of the eye that draws.
  const glm::dvec3 ahead = orientation_of(camera_) * glm::dvec3(0, 0, -1);
  const glm::dvec3 on_screen = point_under(camera_, at, size_, camera_.distance);
  if (camera_.projection == render::Projection::perspective)
    return point_under(camera_, at, size_, *found);
  return on_screen + ahead * (*found - glm::dot(on_screen - camera_for_drawing().position, ahead));
}

void ViewerState::double_click(const glm::dvec2& at) {
  if (model_ == nullptr || (distance_at_ && !distance_at_(at))) return;
  centre_on(camera_, point_at(at));
  reference_.reset();
}

void ViewerState::scroll(double steps, const glm::dvec2& at) {
  if (model_ == nullptr) return;
  // A zoom under way keeps its point, unless the mouse has moved.
  if (zoom_left_ == 0 || at != mouse_) zoom_to_ = point_at(at);
  mouse_ = at;
  zoom_left_ = std::clamp(zoom_left_ - steps * kZoomStep, -3.0, 3.0);
  reference_.reset();
}

void ViewerState::hold(Action action, bool fast, double seconds) {
  const double turn = size_.y / kTurnSeconds * seconds * (fast ? 2 : 1);
  const double step = kFlyPerSecond * camera_.distance * seconds * (fast ? kFast : 1);
  const double factor = std::exp(-kZoomPerSecond * seconds * (fast ? 2 : 1));
  switch (action) {
    case Action::turn_left:
      return orbit(camera_, {-turn, 0}, size_.y);
    case Action::turn_right:
      return orbit(camera_, {turn, 0}, size_.y);
    case Action::turn_up:
      return orbit(camera_, {0, -turn}, size_.y);
    case Action::turn_down:
      return orbit(camera_, {0, turn}, size_.y);
    case Action::fly_ahead:
      return fly(camera_, {0, 0, step});
    case Action::fly_back:
      return fly(camera_, {0, 0, -step});
    case Action::fly_left:
      return fly(camera_, {-step, 0, 0});
    case Action::fly_right:
      return fly(camera_, {step, 0, 0});
    case Action::fly_up:
      return fly(camera_, {0, step, 0});
    case Action::fly_down:
      return fly(camera_, {0, -step, 0});
    case Action::zoom_in:
      return zoom(camera_, factor, camera_.target, ball_);
    case Action::zoom_out:
      return zoom(camera_, 1 / factor, camera_.target, ball_);
    default:
      return;
  }
}

void ViewerState::advance(double seconds) {
  if (model_ == nullptr) return;
  for (const auto& [key, action] : held_) hold(action, fast_, seconds);
  if (zoom_left_ == 0) return;
  double now = zoom_left_ * (1 - std::exp(-seconds / kZoomSeconds));
  if (std::abs(zoom_left_) < 2e-3) now = zoom_left_;
  zoom(camera_, std::exp(now), zoom_to_, ball_);
  zoom_left_ -= now;
}

bool ViewerState::is_moving() const { return !held_.empty() || zoom_left_ != 0; }

render::Camera ViewerState::camera_for_drawing() const {
  return tools::camera_for_drawing(camera_, ball_);
}

}  // namespace afx::tools
