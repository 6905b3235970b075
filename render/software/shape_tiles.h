// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Which triangles, lines and points touch which tile of the picture.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/lens.h"
#include "render/mip_picture.h"
#include "render/scene.h"
#include "render/shading.h"
#include "render/software/box_cells.h"
#include "render/software/piece.h"
#include "render/software/shape_view.h"

namespace afx::render {

/// All primitives of a picture by tiles: 24 bytes for each position, up to 32 for each primitive.
/// What needs more is made again for each tile.
class ShapeTiles {
 public:
  /// All checked; they must outlive it. Fewer than 2^30 primitives.
  ShapeTiles(const Scene& scene, const Lens& lens, const RenderOptions& options,
             const MipPictures& pictures);

  [[nodiscard]] bool empty() const { return opaque_.empty() && transparent_.empty(); }
  [[nodiscard]] const std::vector<ShapeView>& views() const { return views_; }
  /// Those of the scene, in the camera's system.
  [[nodiscard]] const std::vector<ViewLight>& lights() const { return lights_; }

  /// Replaces `pieces` by those of the opaque shapes that touch a tile, in the scene's order.
  void collect_opaque(uint32_t column, uint32_t row, std::vector<Piece>& pieces) const;
  /// Those that may be transparent, the farthest first, by the distance of their middle from the
  /// eye; in parallel projection from its plane.
  void collect_transparent(uint32_t column, uint32_t row, std::vector<Piece>& pieces) const;

 private:
  /// A run of a shape's positions or primitives.
  struct Chunk {
    size_t shape, first, count;
  };
  template <class Count>
  [[nodiscard]] std::vector<Chunk> chunks(const Count& count) const;
  void place_corners(unsigned threads);
  void make_boxes(unsigned threads);
  [[nodiscard]] std::span<const Box> opaque_boxes() const { return {boxes_.data(), opaque_count_}; }
  [[nodiscard]] std::span<const Box> transparent_boxes() const {
    return {boxes_.data() + opaque_count_, boxes_.size() - opaque_count_};
  }
  void collect(const std::vector<uint32_t>& numbers, size_t offset,
               std::vector<Piece>& pieces) const;
  [[nodiscard]] double distance(const Piece& piece) const;

  const Lens& lens_;
  unsigned samples_;
  std::vector<ShapeView> views_;  // the opaque shapes first
  std::vector<size_t> firsts_;    // of each shape: the number of its first primitive
  std::vector<ViewLight> lights_;
  std::vector<Box> boxes_;  // of all primitives
  size_t opaque_count_ = 0;
  BoxCells opaque_, transparent_;
};

}  // namespace afx::render
