// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What keys and mouse do in the viewer. It knows no window: events go in, what is to be drawn comes
// out.
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "render/renderer.h"
#include "tools/viewer/orbit_camera.h"
#include "tools/viewer/viewer_keys.h"
#include "tools/viewer/viewer_model.h"

namespace afx::tools {

enum class Backend : uint8_t { software, gl };
enum class Button : uint8_t { left, right, middle };

/// How the viewer draws.
struct Drawn {
  render::SplatKind splats = render::SplatKind::smooth;
  unsigned level = 32;   ///< of octrees; those that are less fine are drawn as they are
  unsigned samples = 3;  ///< along a side of a pixel, when nothing moves: 1..8
  Backend backend = Backend::software;
  Rgba8 background{58, 64, 72, 255};
  bool backdrop = true;  ///< the scene's, if it has one, instead of `background`
  bool boxes = false;
  bool cameras = false;
  bool operator==(const Drawn&) const = default;
};

class ViewerState {
 public:
  /// The distance, along the viewing direction, of what is seen at a place of the window; none
  /// where nothing is.
  using DistanceAt = std::function<std::optional<double>(const glm::dvec2& at)>;

  explicit ViewerState(const Drawn& drawn) : drawn_(drawn), first_background_(drawn.background) {}

  /// Says what the mouse points at.
  void set_distances(DistanceAt distance_at) { distance_at_ = std::move(distance_at); }
  /// Takes the size of the picture in pixels, each >= 1.
  void set_size(const glm::dvec2& size);
  /// Shows another model from its first place. Not null.
  void show(std::shared_ptr<const ViewerModel> model);

  /// Returns what the window itself must do: quit, screenshot, ..., else none.
  Action key_down(int key, const Modifiers& modifiers);
  void key_up(int key);
  /// Places are pixels from the upper left corner.
  void button_down(Button button, const Modifiers& modifiers, const glm::dvec2& at);
  void button_up(Button button);
  void move(const glm::dvec2& at);
  void double_click(const glm::dvec2& at);
  /// steps   of a wheel, or parts of them from a touchpad; positive = away from the user = nearer
  void scroll(double steps, const glm::dvec2& at);
  /// Forgets held keys and buttons: the window is no longer the one that hears of them.
  void release_all();
  /// Lets time pass: held keys, the rest of a zoom.
  void advance(double seconds);

  /// Whether it moves by itself: advance() is to be called again soon.
  [[nodiscard]] bool is_moving() const;
  [[nodiscard]] const OrbitCamera& camera() const { return camera_; }
  [[nodiscard]] render::Camera camera_for_drawing() const;
  [[nodiscard]] const Drawn& drawn() const { return drawn_; }
  [[nodiscard]] const ViewerModel* model() const { return model_.get(); }
  [[nodiscard]] const Ball& ball() const { return ball_; }
  /// The reference camera that was gone to last, counted from 0; none since another place was.
  [[nodiscard]] std::optional<size_t> reference() const { return reference_; }
  [[nodiscard]] bool help() const { return help_; }
  [[nodiscard]] bool status() const { return status_; }
  /// What the last key did, for people ("flat splats"); empty: nothing new. Taking it forgets it.
  [[nodiscard]] std::string take_message() { return std::exchange(message_, {}); }
  /// Says why a backend is not to be had, and takes the software renderer.
  void refuse_backend(const std::string& reason);

 private:
  void act(Action action, int key);
  void act_on_places(Action action, int key);
  void act_on_drawing(Action action);
  void go_to_start();
  void go_to_viewpoint(size_t index);
  void step_viewpoint(int step);
  void step_camera(int step);
  void set_level(int step);
  void next_background();
  void hold(Action action, bool fast, double seconds);
  [[nodiscard]] glm::dvec3 point_at(const glm::dvec2& at) const;

  Drawn drawn_;
  Rgba8 first_background_;
  std::shared_ptr<const ViewerModel> model_;
  Ball ball_;
  OrbitCamera camera_;
  glm::dvec2 size_{1, 1};
  DistanceAt distance_at_;
  std::map<int, Action> held_;  // by key
  bool fast_ = false;
  enum class Drag : uint8_t { none, orbit, pan, look };
  Drag drag_ = Drag::none;
  Button drag_button_ = Button::left;
  glm::dvec2 mouse_{0};
  double zoom_left_ = 0;  // logarithm of the factor that is still to be carried out
  glm::dvec3 zoom_to_{0};
  std::optional<size_t> viewpoint_, reference_;
  size_t background_ = 0;
  bool help_ = false;
  bool status_ = true;
  std::string message_;
};

}  // namespace afx::tools
