// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/abort_guard.h"

#include <unistd.h>

#include <array>
#include <csignal>
#include <vector>

#include "afx/file.h"
#include "tools/session.h"

namespace afx::tools {
namespace {

#ifdef AFX_ADDRESS_SANITIZER
constexpr std::array kSignals{SIGABRT};
#else
constexpr std::array kSignals{SIGABRT, SIGSEGV, SIGBUS, SIGFPE};
#endif
constexpr size_t kStackBytes = size_t{64} << 10;

std::string g_message;  // composed beforehand: the handler may only write

extern "C" void on_crash(int /*signal*/) {
  remove_temporary_files();
  const ssize_t written = write(STDERR_FILENO, g_message.data(), g_message.size());
  (void)written;
  _exit(kBadInput);
}

}  // namespace

struct AbortGuard::Before {
  std::array<struct sigaction, kSignals.size()> actions{};
  stack_t old_stack{};
  std::vector<char> stack = std::vector<char>(kStackBytes);
};

AbortGuard::AbortGuard(const std::string& path) : before_(std::make_unique<Before>()) {
  g_message =
      "afx: " + printable(path) + ": cannot be imported (the model library gave up on it)\n";
  stack_t own{};  // an overflown stack has no room for the handler
  own.ss_sp = before_->stack.data();
  own.ss_size = before_->stack.size();
  sigaltstack(&own, &before_->old_stack);
  struct sigaction action {};
  action.sa_handler = on_crash;
  action.sa_flags = SA_ONSTACK;
  sigemptyset(&action.sa_mask);
  for (size_t i = 0; i < kSignals.size(); ++i)
    sigaction(kSignals[i], &action, &before_->actions[i]);
}

AbortGuard::~AbortGuard() {
  for (size_t i = 0; i < kSignals.size(); ++i)
    sigaction(kSignals[i], &before_->actions[i], nullptr);
  sigaltstack(&before_->old_stack, nullptr);
}

}  // namespace afx::tools
