// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "codec/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <new>
#include <vector>

namespace afx {
namespace {

TEST(ParallelFor, CallsEachTaskOnce) {
  for (const unsigned threads : {1U, 2U, 7U, 200U}) {
    std::vector<std::atomic<int>> calls(100);
    parallel_for(calls.size(), threads, [&](size_t i) { ++calls[i]; });
    for (const auto& count : calls) EXPECT_EQ(count, 1);
  }
}

TEST(ParallelFor, ThrowsAgainWhatATaskThrows) {
  for (const unsigned threads : {1U, 4U}) {
    const auto fail = [](size_t i) {
      if (i == 7) throw std::bad_alloc();
    };
    EXPECT_THROW(parallel_for(1000, threads, fail), std::bad_alloc) << threads;
  }
}

TEST(ThreadCount, ZeroMeansAllCores) {
  EXPECT_GE(thread_count(0), 1U);
  EXPECT_EQ(thread_count(3), 3U);
}

}  // namespace
}  // namespace afx
