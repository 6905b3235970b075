// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Models read on a thread of its own while the window already shows.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "tools/viewer/viewer_module.h"

namespace afx::tools {

/// Reads one model at a time; while it does, the latest of those asked for waits. Reading cannot be
/// stopped: the thread may outlive this object, the host must outlive the thread.
class LoadThread {
 public:
  /// wake   called on the thread when there is news, not after this object's end
  LoadThread(const ViewerHost& host, std::function<void()> wake);
  ~LoadThread();
  LoadThread(const LoadThread&) = delete;
  LoadThread& operator=(const LoadThread&) = delete;

  void load(const std::string& file);
  /// What it is doing; empty: nothing.
  [[nodiscard]] std::string doing() const;
  [[nodiscard]] bool busy() const { return !doing().empty(); }

  struct Loaded {
    std::string file;
    Result<std::shared_ptr<const ViewerModel>> model;
  };
  /// What has been read since the last time.
  [[nodiscard]] std::optional<Loaded> take();

 private:
  struct Shared;
  static void run(const std::shared_ptr<Shared>& shared);
  std::shared_ptr<Shared> shared_;  // with the thread
};

}  // namespace afx::tools
