// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Which pictures the viewer draws when: quick ones while the view moves, a fine one when it is
// still.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "tools/viewer/draw_thread.h"
#include "tools/viewer/moving_quality.h"
#include "tools/viewer/viewer_state.h"

namespace afx::tools {

/// A view to be drawn.
struct Wanted {
  std::shared_ptr<const ViewerModel> model;
  render::Camera camera;
  Drawn drawn;
  uint32_t width = 0, height = 0;
  unsigned threads = 0;
};

/// Whether both are the same picture. Boxes and cameras are laid over it and change nothing.
[[nodiscard]] bool same_picture(const Wanted& a, const Wanted& b);

/// The options for a picture of it. scale   of width and height
[[nodiscard]] render::RenderOptions draw_options(const Wanted& wanted, unsigned samples,
                                                 double scale);

/// Two threads draw: one quickly, one finely; so that a fine picture under way does not keep the
/// next move waiting. Times are seconds of one clock.
class PictureSource {
 public:
  static constexpr double kStill = 0.15;  ///< seconds without change until the fine picture

  /// wake   called on a thread when a picture is ready
  explicit PictureSource(const std::function<void()>& wake) : quick_(wake), fine_(wake) {}

  /// Says what is to be seen now; the same again changes nothing.
  void want(const Wanted& wanted, double now);
  /// Takes what is ready and asks for what is due. Returns whether shown() is another one.
  bool update(double now);
  /// Seconds until update() has something to do by itself; none: when it is woken.
  [[nodiscard]] std::optional<double> due(double now) const;

  /// The picture to show; null before the first.
  [[nodiscard]] const DrawResult* shown() const { return shown_ ? &*shown_ : nullptr; }
  /// Whether it is the fine one of what is wanted.
  [[nodiscard]] bool is_final() const;
  /// Whether a picture is being drawn, which cannot be stopped.
  [[nodiscard]] bool busy() const { return quick_.busy() || fine_.busy(); }
  /// Why the last one could not be drawn; empty: it could.
  [[nodiscard]] const std::string& problem() const { return problem_; }

 private:
  void ask_quick();
  void ask_fine();
  bool accept(DrawResult&& result, bool is_fine);

  Wanted wanted_;
  uint64_t number_ = 0;  // of what is wanted; 0: nothing
  double changed_ = 0;   // when
  bool fine_asked_ = false;
  MovingQuality quality_;
  std::optional<DrawResult> shown_;
  bool shown_fine_ = false;
  std::string problem_;
  DrawThread quick_, fine_;
};

}  // namespace afx::tools
