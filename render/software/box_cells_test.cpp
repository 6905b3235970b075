// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/software/box_cells.h"

#include <gtest/gtest.h>

#include <vector>

namespace afx::render {
namespace {

/// Boxes of all sizes in and around a picture of 640 x 384, always the same; some are none.
std::vector<Box> many_boxes(size_t count) {
  std::vector<Box> boxes;
  uint32_t state = 1;
  const auto random = [&](float most) {
    state = state * 1664525 + 1013904223;
    return static_cast<float>(state >> 8) / 16777216 * most;
  };
  for (size_t k = 0; k < count; ++k) {
    const float x = random(800) - 80, y = random(500) - 60, size = k % 50 == 0 ? 600.0F : 9.0F;
    boxes.push_back(k % 7 == 3 ? kNoBox : Box{x, y, x + random(size), y + random(size)});
  }
  return boxes;
}

TEST(BoxCells, EachTileHasTheBoxesThatTouchItInOrder) {
  const RenderOptions options{.width = 640, .height = 384, .samples = 1};
  const TileGrid grid(options);
  const auto side = static_cast<float>(grid.side);
  const std::vector<Box> boxes = many_boxes(40000);
  for (const unsigned threads : {1U, 4U}) {
    const BoxCells cells(boxes, grid, options.samples, threads);
    std::vector<uint32_t> got;
    for (uint32_t row = 0; row < grid.rows; ++row) {
      for (uint32_t column = 0; column < grid.columns; ++column) {
        const float left = static_cast<float>(column) * side, top = static_cast<float>(row) * side;
        std::vector<uint32_t> expected;
        for (uint32_t k = 0; k < boxes.size(); ++k) {
          const Box& b = boxes[k];
          if (b.x0 <= b.x1 && b.x1 >= left && b.x0 <= left + side && b.y1 >= top &&
              b.y0 <= top + side)
            expected.push_back(k);
        }
        cells.collect(boxes, column, row, got);
        ASSERT_EQ(got, expected) << column << " " << row;
      }
    }
  }
}

TEST(BoxCells, NoBoxesAreNoWork) {
  const RenderOptions options{.width = 640, .height = 384, .samples = 1};
  const std::vector<Box> none(5, kNoBox);
  const BoxCells cells(none, TileGrid(options), 1, 1);
  EXPECT_TRUE(cells.empty());
  std::vector<uint32_t> got{1, 2};
  cells.collect(none, 3, 3, got);
  EXPECT_TRUE(got.empty());
}

}  // namespace
}  // namespace afx::render
