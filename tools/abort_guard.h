// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <string>

namespace afx::tools {

/// While it lives, an abort of the process (the model library's own asserts do that on some broken
/// files) ends it with one line about `path`, exit code kBadInput and no temporary file left. One
/// at a time.
class AbortGuard {
 public:
  explicit AbortGuard(const std::string& path);
  ~AbortGuard();
  AbortGuard(const AbortGuard&) = delete;
  AbortGuard& operator=(const AbortGuard&) = delete;
};

}  // namespace afx::tools
