// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/abort_guard.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>

namespace afx::tools {
namespace {

TEST(AbortGuard, TurnsAnAbortIntoOneLineAndExitThree) {
  EXPECT_EXIT(
      {
        const AbortGuard guard("bad.obj");
        std::abort();
      },
      testing::ExitedWithCode(3), "^afx: bad.obj: cannot be imported");
}

#ifndef AFX_ADDRESS_SANITIZER
TEST(AbortGuard, TurnsBadMemoryIntoTheSame) {
  for (const int signal : {SIGSEGV, SIGBUS}) {
    EXPECT_EXIT(
        {
          const AbortGuard guard("bad\x1b.obj");
          std::raise(signal);
        },
        testing::ExitedWithCode(3), "^afx: bad.x1b.obj: cannot be imported");
  }
}
#endif

TEST(AbortGuard, IsGoneWithItsScope) {
  EXPECT_EXIT(
      {
        { const AbortGuard guard("bad.obj"); }
        std::abort();
      },
      testing::KilledBySignal(6), "");
}

}  // namespace
}  // namespace afx::tools
