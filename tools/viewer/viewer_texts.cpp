// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What stands in the viewer's window.
#include <cmath>

#include "tools/viewer/viewer_window.h"

namespace afx::tools {
namespace {

const char* name_of(render::SplatKind kind) {
  if (kind == render::SplatKind::points) return "points";
  return kind == render::SplatKind::flat ? "flat splats" : "smooth splats";
}

/// "truck.wrl" of "models/truck.wrl".
std::string file_name(const std::string& path) {
  const size_t slash = path.find_last_of('/');
  return slash == std::string::npos ? path : path.substr(slash + 1);
}

std::string picture_text(const DrawResult& shown) {
  const render::RenderOptions& options = shown.request.options;
  const std::string samples = std::to_string(options.samples);
  return std::to_string(options.width) + " x " + std::to_string(options.height) + ", " +
         (options.samples == 1 ? "1 sample" : samples + " x " + samples + " samples") + ", " +
         std::to_string(std::lround(shown.milliseconds)) + " ms";
}

}  // namespace

std::string Viewer::status_text() const {
  const Drawn& drawn = state_.drawn();
  std::string text = file_name(model_->file) + ": " + model_->size;
  if (uses_gl()) {
    text += "\n" + std::to_string(std::lround(gl_seconds_ * 1000)) + " ms, " + gl_->name();
  } else if (source_->shown() != nullptr) {
    text += "\n" + picture_text(*source_->shown()) + ", software";
  }
  text += std::string("\n") + name_of(drawn.splats);
  if (model_->levels > 0)
    text += ", octree level " + std::to_string(std::min(drawn.level, model_->levels)) + " of " +
            std::to_string(model_->levels);
  if (state_.camera().projection == render::Projection::orthographic) text += ", parallel";
  return text + "\nh: help";
}

OverlayText Viewer::texts() const {
  OverlayText text;
  text.help = state_.help();
  text.message = message_;
  text.error = error_.empty() ? source_->problem() : error_;
  if (model_ != nullptr && state_.status()) text.status = status_text();
  const std::string doing = loader_->doing();
  if (!doing.empty()) {
    const int seconds = static_cast<int>(now() - load_start_);
    text.waiting = doing + (seconds > 0 ? ", " + std::to_string(seconds) + " s" : "");
  } else if (model_ == nullptr) {
    text.waiting = "drop a file here, q quits";
  } else if (source_->shown() == nullptr && !uses_gl() && source_->problem().empty()) {
    text.waiting = "drawing";
  }
  return text;
}

}  // namespace afx::tools
