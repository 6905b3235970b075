// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Pictures drawn on a thread of its own, so that the window never waits.
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "render/renderer.h"
#include "tools/viewer/viewer_model.h"

namespace afx::tools {

/// What is to be drawn.
struct DrawRequest {
  std::shared_ptr<const ViewerModel> model;
  render::Camera camera;
  render::RenderOptions options;
  double scale = 1;     ///< of the picture to the window
  uint64_t number = 0;  ///< the asker's own, to know it again
};

struct DrawResult {
  DrawRequest request;
  Status status;
  render::RenderedImage image;
  double milliseconds = 0;
};

/// One thread with one software renderer. Asked for something new before it has begun the last, it
/// forgets the last.
class DrawThread {
 public:
  /// done   called on the thread after each picture; must not wait for this object
  explicit DrawThread(std::function<void()> done);
  ~DrawThread();
  DrawThread(const DrawThread&) = delete;
  DrawThread& operator=(const DrawThread&) = delete;

  void ask(DrawRequest request);
  /// Forgets what has not been begun.
  void cancel();
  /// The newest picture that has not been taken yet.
  [[nodiscard]] std::optional<DrawResult> take();
  /// Whether it draws or is about to.
  [[nodiscard]] bool busy() const;

 private:
  void run();
  DrawResult draw(DrawRequest request);

  std::function<void()> done_;
  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::optional<DrawRequest> asked_;
  std::optional<DrawResult> drawn_;
  bool drawing_ = false;
  bool stop_ = false;
  std::unique_ptr<render::Renderer> renderer_;
  std::shared_ptr<const ViewerModel> model_;  // the renderer's
  std::thread thread_;
};

}  // namespace afx::tools
