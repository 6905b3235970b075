// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The memory that the octree coder asks for, counted at operator new.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>
#include <vector>

#include "codec/octree_decoder.h"
#include "codec/octree_encoder.h"
#include "codec/octree_voxels.h"

namespace {

std::atomic<size_t> g_live{0};
std::atomic<size_t> g_peak{0};
std::atomic<size_t> g_calls{0};

constexpr size_t kHeader =
    alignof(std::max_align_t);  // the size stands in front of what is handed out

void* counted_new(size_t size) {
  auto* memory = static_cast<size_t*>(std::malloc(size + kHeader));
  if (memory == nullptr) throw std::bad_alloc();
  *memory = size;
  const size_t live = g_live += size;
  if (live > g_peak) g_peak = live;
  ++g_calls;
  return reinterpret_cast<char*>(memory) + kHeader;
}

void counted_delete(void* memory) {
  if (memory == nullptr) return;
  auto* start = reinterpret_cast<size_t*>(static_cast<char*>(memory) - kHeader);
  g_live -= *start;
  std::free(start);
}

}  // namespace

void* operator new(size_t size) { return counted_new(size); }
void* operator new[](size_t size) { return counted_new(size); }
void operator delete(void* memory) noexcept { counted_delete(memory); }
void operator delete[](void* memory) noexcept { counted_delete(memory); }
void operator delete(void* memory, size_t) noexcept { counted_delete(memory); }
void operator delete[](void* memory, size_t) noexcept { counted_delete(memory); }

namespace afx::codec {
namespace {

struct Use {
  size_t bytes;
  size_t calls;
};

template <class Work>
Use measure(Work work) {
  const size_t before = g_live;
  const size_t calls = g_calls;
  g_peak = before;
  work();
  return {g_peak - before, g_calls - calls};
}

/// A sphere's shell of 9 levels: some 600,000 voxels, with an image a hemisphere.
struct Sphere {
  static constexpr unsigned kLevels = 9;
  OctreeFields fields;
  size_t voxels = 0;
  std::vector<uint8_t> stream;
};

Sphere make_sphere() {
  std::vector<uint64_t> codes;
  std::vector<uint8_t> images;
  const int side = 1 << Sphere::kLevels;
  for (int z = 0; z < side; ++z) {
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        const int dx = 2 * x - side;
        const int dy = 2 * y - side;
        const int dz = 2 * z - side;
        const int r = dx * dx + dy * dy + dz * dz;
        if (r >= 500 * 500 && r < 504 * 504)
          codes.push_back(morton_code({uint32_t(x), uint32_t(y), uint32_t(z)}));
      }
    }
  }
  std::sort(codes.begin(), codes.end());
  for (const uint64_t code : codes)
    images.push_back(morton_decode(code).x < unsigned(side) / 2 ? 1 : 2);
  Sphere sphere;
  sphere.voxels = codes.size();
  sphere.fields.octree = octree_from_morton(codes, Sphere::kLevels);
  sphere.fields.voxel_image_index =
      octree_image_index(sphere.fields.octree, Sphere::kLevels, images);
  return sphere;
}

TEST(OctreeMemory, CodingTakesLessThanAMegabyteBesidesFieldsAndStream) {
  Sphere sphere = make_sphere();
  ASSERT_GT(sphere.voxels, 300000U);
  const size_t fields = sphere.fields.octree.size() + sphere.fields.voxel_image_index.size();
  const Use encoding = measure([&] {
    ASSERT_TRUE(encode_octree_frame(sphere.fields, Sphere::kLevels, 2, sphere.stream).ok());
  });
  EXPECT_LT(encoding.bytes,
            3 * sphere.stream.size() + (1U << 20));  // a growing vector: old and new at once
  EXPECT_LT(encoding.calls, 60U);

  OctreeFrame frame;
  Diagnostics diagnostics;
  const Use decoding = measure([&] {
    frame =
        decode_octree_frame(sphere.stream, {.levels = Sphere::kLevels, .textures = 2}, diagnostics);
  });
  ASSERT_EQ(frame.fields, sphere.fields);
  EXPECT_LT(decoding.bytes,
            fields + fields / 2 + (1U << 20));  // the levels above are held twice while they move
  EXPECT_LT(decoding.calls, 60U);
}

TEST(OctreeMemory, VoxelsTakeLessThanTwentyBytesEachInAll) {
  const Sphere sphere = make_sphere();
  const size_t fields = sphere.fields.octree.size() + sphere.fields.voxel_image_index.size();
  const Use codes =
      measure([&] { (void)octree_morton(sphere.fields.octree, Sphere::kLevels, Sphere::kLevels); });
  EXPECT_LT(codes.bytes + fields, 20 * sphere.voxels);
  const Use voxels =
      measure([&] { (void)octree_voxels(sphere.fields.octree, Sphere::kLevels, Sphere::kLevels); });
  EXPECT_LT(voxels.bytes + fields, 20 * sphere.voxels);
}

}  // namespace
}  // namespace afx::codec
