// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <memory>
#include <string>

namespace afx::tools {

/// While it lives, a crash of the process ends it with one line about `path`, exit code kBadInput
/// and no temporary file left: the model library's own asserts abort on some broken files, and
/// deeply nested ones overflow the stack in its recursive readers. For the thread that makes it,
/// one at a time. (Under AddressSanitizer only aborts: it reports the rest itself.)
class AbortGuard {
 public:
  explicit AbortGuard(const std::string& path);
  ~AbortGuard();
  AbortGuard(const AbortGuard&) = delete;
  AbortGuard& operator=(const AbortGuard&) = delete;

 private:
  struct Before;
  std::unique_ptr<Before> before_;
};

}  // namespace afx::tools
