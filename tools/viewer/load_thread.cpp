// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/viewer/load_thread.h"

#include <new>
#include <thread>
#include <utility>

namespace afx::tools {

struct LoadThread::Shared {
  const ViewerHost& host;
  std::mutex mutex;
  std::function<void()> wake;       // empty: nobody listens any more
  std::optional<std::string> next;  // file
  std::string doing;
  std::optional<Loaded> loaded;

  void tell() {
    if (wake) wake();
  }
};

LoadThread::LoadThread(const ViewerHost& host, std::function<void()> wake)
    : shared_(new Shared{host, {}, std::move(wake), {}, {}, {}}) {}

LoadThread::~LoadThread() {
  const std::lock_guard lock(shared_->mutex);
  shared_->wake = nullptr;
  shared_->next.reset();
}

void LoadThread::load(const std::string& file) {
  const std::lock_guard lock(shared_->mutex);
  shared_->next = file;
  if (!shared_->doing.empty()) return;
  shared_->doing = "opening " + file;
  try {
    std::thread([shared = shared_] { run(shared); }).detach();
  } catch (const std::system_error&) {  // no more threads are to be had
    shared_->doing.clear();
    shared_->next.reset();
    shared_->loaded = Loaded{
        file, Error{Errc::no_memory, Place::none(), "no thread can be had to read it", {}, file}};
  }
}

void LoadThread::run(const std::shared_ptr<Shared>& shared) {
  const auto doing = [&shared](const std::string& what) {
    const std::lock_guard lock(shared->mutex);
    shared->doing = what;
    shared->tell();
  };
  std::unique_lock lock(shared->mutex);
  while (shared->next) {
    const std::string file = *std::exchange(shared->next, std::nullopt);
    lock.unlock();
    Result<std::shared_ptr<const ViewerModel>> model =
        Error{Errc::no_memory, Place::none(), "there is not enough memory", {}, file};
    try {
      model = shared->host.load(file, doing);
    } catch (const std::bad_alloc&) {  // at the end of a thread nobody else would catch it
    } catch (const std::exception& error) {
      model = Error{Errc::not_available, Place::none(), error.what(), {}, file};
    }
    lock.lock();
    shared->loaded = Loaded{file, std::move(model)};
  }
  shared->doing.clear();
  shared->tell();
}

std::string LoadThread::doing() const {
  const std::lock_guard lock(shared_->mutex);
  return shared_->doing;
}

std::optional<LoadThread::Loaded> LoadThread::take() {
  const std::lock_guard lock(shared_->mutex);
  return std::exchange(shared_->loaded, std::nullopt);
}

}  // namespace afx::tools
