// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Files that the viewer opens and saves.
#include <chrono>
#include <utility>

#include "tools/viewer/viewer_window.h"

namespace afx::tools {

void Viewer::load(const std::string& file) {
  error_.clear();
  load_start_ = now();
  loader_->load(file);
}

void Viewer::take_loaded() {
  auto loaded = loader_->take();
  if (!loaded) return;
  dirty_ = true;
  if (!loaded->model.ok()) {
    load_error_ = loaded->model.error();
    error_ = to_string(*load_error_, loaded->file);
    return;
  }
  model_ = std::move(loaded->model).value();
  state_.show(model_);
  boxes_.clear();
  add_boxes(model_->scene, boxes_);
  window_.set_title(model_->file + " - afx");
  if (model_->warnings > 0)
    say(std::to_string(model_->warnings) + (model_->warnings == 1 ? " warning" : " warnings") +
        " on standard error");
}

bool Viewer::is_final() const {
  if (uses_gl()) return !coarse_;
  return source_->is_final() || !source_->problem().empty();
}

bool Viewer::can_save() const { return model_ == nullptr || (is_final() && !state_.is_moving()); }

void Viewer::save_picture() {
  if (pictures_to_save_ == 0 || !can_save()) return;
  pictures_to_save_ = 0;
  render::RenderedImage image;
  if (uses_gl()) {
    const Status drawn = gl_->draw(wanted_, state_.drawn().samples, 1, image);
    if (!drawn.ok()) return state_.refuse_backend(drawn.error().text);
  } else if (source_->is_final()) {
    image.picture = source_->shown()->image.picture;
  }
  if (!image.picture.empty()) save(std::move(image.picture), false);
}

void Viewer::save_window() {
  if (windows_to_save_ == 0 || !can_save()) return;
  windows_to_save_ = 0;
  save(read_window(window_.size()), true);
}

/// Compressing takes as long as some frames, and the first time a module is loaded.
void Viewer::save(Picture&& picture, bool window) {
  if (!saving_.empty()) saving_.back().wait();  // names are given in turn
  saving_.push_back(std::async(
      std::launch::async,
      [&host = host_, file = model_ ? model_->file : host_.file, window,
       kept = std::make_shared<const Picture>(std::move(picture))]() -> Result<std::string> {
        auto saved = host.save(file, *kept, window);
        GlfwWindow::wake();
        return saved;
      }));
}

void Viewer::take_saved() {
  while (!saving_.empty() &&
         saving_.front().wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
    const auto saved = saving_.front().get();
    saving_.pop_front();
    say(saved.ok() ? "saved " + saved.value() : "not saved: " + to_string(saved.error()));
  }
}

}  // namespace afx::tools
