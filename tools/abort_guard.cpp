// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/abort_guard.h"

#include <unistd.h>

#include <csignal>

#include "afx/file.h"
#include "tools/session.h"

namespace afx::tools {
namespace {

std::string g_message;  // composed beforehand: the handler may only write

extern "C" void on_abort(int /*signal*/) {
  remove_temporary_files();
  const ssize_t written = write(STDERR_FILENO, g_message.data(), g_message.size());
  (void)written;
  _exit(kBadInput);
}

}  // namespace

AbortGuard::AbortGuard(const std::string& path) {
  g_message = "afx: " + path + ": cannot be imported (the model library gave up on it)\n";
  std::signal(SIGABRT, on_abort);
}

AbortGuard::~AbortGuard() { std::signal(SIGABRT, SIG_DFL); }

}  // namespace afx::tools
