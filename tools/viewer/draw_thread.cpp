// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/viewer/draw_thread.h"

#include <chrono>
#include <new>
#include <utility>

namespace afx::tools {

DrawThread::DrawThread(std::function<void()> done)
    : done_(std::move(done)), renderer_(render::make_software_renderer()) {
  thread_ = std::thread([this] { run(); });
}

DrawThread::~DrawThread() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void DrawThread::ask(DrawRequest request) {
  {
    const std::lock_guard lock(mutex_);
    asked_ = std::move(request);
  }
  wake_.notify_one();
}

void DrawThread::cancel() {
  const std::lock_guard lock(mutex_);
  asked_.reset();
}

std::optional<DrawResult> DrawThread::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(drawn_, std::nullopt);
}

bool DrawThread::busy() const {
  const std::lock_guard lock(mutex_);
  return drawing_ || asked_.has_value();
}

DrawResult DrawThread::draw(DrawRequest request) {
  const auto start = std::chrono::steady_clock::now();
  DrawResult result;
  try {
    if (request.model != model_) {
      model_ = request.model;
      result.status = renderer_->set_scene(model_->scene);
      if (!result.status.ok()) model_.reset();
    }
    if (result.status.ok())
      result.status = renderer_->draw(request.camera, request.options, result.image);
  } catch (const std::bad_alloc&) {  // at the end of a thread nobody else would catch it
    model_.reset();
    result.status = Error{Errc::no_memory, Place::none(), "there is not enough memory to draw"};
  }
  result.request = std::move(request);
  result.milliseconds =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return result;
}

void DrawThread::run() {
  std::unique_lock lock(mutex_);
  for (;;) {
    wake_.wait(lock, [this] { return stop_ || asked_.has_value(); });
    if (stop_) return;
    DrawRequest request = std::move(*asked_);
    asked_.reset();
    drawing_ = true;
    lock.unlock();
    DrawResult result = draw(std::move(request));
    lock.lock();
    drawn_ = std::move(result);
    drawing_ = false;
    lock.unlock();
    done_();
    lock.lock();
  }
}

}  // namespace afx::tools
