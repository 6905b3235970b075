// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// How much memory reading takes: the whole program's operator new is counted.
#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>
#include <string>
#include <vector>

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

TEST(SceneMemory, LongListsAreCountedExactly) {
  // One value more than the limit is refused, though the list is counted in parts, and numbers lie
  // across their borders.
  for (const char* const number : {"7 ", "12345,", "-1234567\n", "7 # 8 9 ]\n"}) {
    const std::string text = repeated("OctreeImage { octree [", number, 100'000, "] }");
    Diagnostics diagnostics;
    Limits limits;
    limits.scene_values = 100'002;  // the node and its field count too
    EXPECT_TRUE(read_scene_text(text, limits, diagnostics).ok()) << number;
    --limits.scene_values;
    EXPECT_FALSE(read_scene_text(text, limits, diagnostics).ok()) << number;
  }
}

TEST(SceneMemory, ToldHowFarTheTextHasBeenReadAboutOnceInAMegabyte) {
  const std::string text =
      repeated("OctreeImage { octree [", "200 ", kCount, "] voxelImageIndex [1 2] }");
  std::vector<size_t> offsets;
  SceneReadOptions options;
  options.passed = [&offsets](size_t offset) { offsets.push_back(offset); };
  Diagnostics diagnostics;
  const auto scene = read_scene_text(text, {}, diagnostics, options);
  ASSERT_TRUE(scene.ok());
  // The list is counted, then read; each time its 6 MB are told of.
  const size_t megabytes = text.size() >> 20;
  EXPECT_GE(offsets.size(), 2 * (megabytes - 1));
  EXPECT_LE(offsets.size(), 2 * (megabytes + 1));
  EXPECT_EQ(std::count_if(offsets.begin() + 1, offsets.end(),
                          [&](size_t& offset) { return offset < *(&offset - 1); }),
            1);
  for (const size_t offset : offsets) EXPECT_LE(offset, text.size());
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
