// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// How much memory reading takes: the whole program's operator new is counted.
#include <gtest/gtest.h>
#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>
#include <string>

#include "nodes/definitions.h"
#include "nodes/scene_reader.h"

namespace {

std::atomic<size_t> held{0}, peak{0};

void* counted(size_t size) {
  void* const block = std::malloc(size);
  if (block == nullptr) std::abort();
  const size_t now = held += malloc_usable_size(block);
  size_t before = peak;
  while (now > before && !peak.compare_exchange_weak(before, now)) {
  }
  return block;
}

void uncounted(void* block) {
  if (block != nullptr) held -= malloc_usable_size(block);
  std::free(block);
}

}  // namespace

void* operator new(size_t size) { return counted(size); }
void* operator new[](size_t size) { return counted(size); }
void* operator new(size_t size, const std::nothrow_t&) noexcept { return counted(size); }
void* operator new[](size_t size, const std::nothrow_t&) noexcept { return counted(size); }
void operator delete(void* block) noexcept { uncounted(block); }
void operator delete[](void* block) noexcept { uncounted(block); }
void operator delete(void* block, size_t) noexcept { uncounted(block); }
void operator delete[](void* block, size_t) noexcept { uncounted(block); }

namespace afx::nodes {

namespace {

/// The most bytes held while a text is read, beyond those before.
size_t peak_of(const std::string& text) {
  (void)definitions();
  const size_t before = held;
  peak = before;
  Diagnostics diagnostics;
  const auto scene = read_scene_text(text, Limits{}, diagnostics);
  EXPECT_TRUE(scene.ok());
  return peak - before;
}

std::string repeated(const std::string& head, const std::string& number, size_t count,
                     const std::string& tail) {
  std::string text = head;
  for (size_t i = 0; i < count; ++i) text += number;
  return text + tail;
}

constexpr size_t kCount = 1'500'000;
constexpr size_t kSmall = 100'000;  // the scene around the list

}  // namespace

TEST(SceneMemory, ListsTakeLessThanTwiceTheirValues) {
  EXPECT_LT(peak_of(repeated("OctreeImage { octree [", "7 ", kCount, "] }")), 2 * kCount * 4);
  EXPECT_LT(peak_of(repeated("Coordinate { point [", "1.5, ", kCount, "] }")), 2 * kCount * 4);
  EXPECT_LT(peak_of(repeated("ScalarInterpolator { key [", "-1e3\n", kCount, "] }")),
            2 * kCount * 4);
}

TEST(SceneMemory, ListsAreNeverHeldTwice) {
  EXPECT_LT(peak_of(repeated("OctreeImage { octree [", "200 ", kCount, "] }")),
            kCount * 4 + kSmall);
  // Nor do comments make more of them.
  EXPECT_LT(
      peak_of(repeated("OctreeImage { octree [ # 1 2 3 ]\n", "200 # 1 2 3 4\n", kCount, "] }")),
      kCount * 4 + kSmall);
}

TEST(SceneMemory, ListsThatAreNotThereTakeNothing) {
  const std::string text = repeated("OctreeImage { octree [ 1 x ", "200 ", kCount, "");
  Diagnostics diagnostics;
  Limits small;
  small.memory = 1000000;
  (void)definitions();  // read at first use, and not to be counted here
  peak = held.load();
  const size_t before = held;
  EXPECT_FALSE(read_scene_text(text, small, diagnostics).ok());
  EXPECT_LT(peak - before, kSmall);
}

}  // namespace afx::nodes
