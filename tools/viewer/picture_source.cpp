// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/viewer/picture_source.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace afx::tools {
namespace {

bool same(const render::Camera& a, const render::Camera& b) {
  return a.position == b.position && a.orientation == b.orientation &&
         a.projection == b.projection && a.field_of_view == b.field_of_view &&
         a.view_height == b.view_height && a.near_plane == b.near_plane;
}

bool same_but_overlay(Drawn a, const Drawn& b) {
  a.boxes = b.boxes;
  a.cameras = b.cameras;
  return a == b;
}

uint32_t scaled(uint32_t side, double scale) {
  const double length = std::max(1.0, std::round(side * scale));
  return static_cast<uint32_t>(std::min<double>(length, render::kMaxSide));
}

}  // namespace

bool same_picture(const Wanted& a, const Wanted& b) {
  return a.model == b.model && a.width == b.width && a.height == b.height &&
         same(a.camera, b.camera) && same_but_overlay(a.drawn, b.drawn);
}

render::RenderOptions draw_options(const Wanted& wanted, unsigned samples, double scale) {
  render::RenderOptions options;
  options.width = scaled(wanted.width, scale);
  options.height = scaled(wanted.height, scale);
  options.background = wanted.drawn.background;
  options.backdrop = wanted.drawn.backdrop;
  options.splats = wanted.drawn.splats;
  options.finest_level = wanted.drawn.level;
  options.samples = samples;
  options.depth = true;  // for lines behind the model, and for what the mouse points at
  options.threads = wanted.threads;
  return options;
}

void PictureSource::want(const Wanted& wanted, double now) {
  if (wanted.model == nullptr || wanted.width == 0 || wanted.height == 0) return;
  if (number_ > 0 && same_picture(wanted, wanted_)) return;
  wanted_ = wanted;
  ++number_;
  changed_ = now;
  fine_asked_ = false;
  fine_.cancel();
  ask_quick();
}

void PictureSource::ask_quick() {
  const double scale = quality_.scale();
  quick_.ask({wanted_.model, wanted_.camera, draw_options(wanted_, 1, scale), scale, number_});
}

void PictureSource::ask_fine() {
  fine_asked_ = true;
  fine_.ask(
      {wanted_.model, wanted_.camera, draw_options(wanted_, wanted_.drawn.samples, 1), 1, number_});
}

bool PictureSource::accept(DrawResult&& result, bool is_fine) {
  const uint64_t number = result.request.number;
  if (!result.status.ok()) {
    if (number == number_) problem_ = to_string(result.status.error());
    return false;
  }
  if (is_fine ? number != number_ : shown_ && number <= shown_->request.number) return false;
  problem_.clear();
  shown_ = std::move(result);
  shown_fine_ = is_fine;
  return true;
}

bool PictureSource::update(double now) {
  bool is_new = false;
  if (auto result = quick_.take()) {
    if (result->status.ok()) quality_.learn(result->request.scale, result->milliseconds);
    is_new = accept(std::move(*result), false);
  }
  if (auto result = fine_.take()) is_new = accept(std::move(*result), true) || is_new;
  if (number_ > 0 && !fine_asked_ && now >= changed_ + kStill) ask_fine();
  return is_new;
}

std::optional<double> PictureSource::due(double now) const {
  if (number_ == 0 || fine_asked_) return std::nullopt;
  return std::max(0.0, changed_ + kStill - now);
}

bool PictureSource::is_final() const {
  return shown_ && shown_fine_ && shown_->request.number == number_;
}

}  // namespace afx::tools
