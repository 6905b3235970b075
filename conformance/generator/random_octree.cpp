// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "conformance/generator/random_octree.h"

#include <array>
#include <bit>
#include <utility>

namespace afx::conformance {

namespace {

/// How the symbols of a frame are spread.
enum class Style : uint8_t { any, sparse, dense, few, count };

struct Shape {
  Style style = Style::any;
  size_t most_nodes = 0;  ///< about; then every node has at most one child
  std::array<uint8_t, 4> palette{};
};

size_t random_size(Choices& choices) {
  const uint32_t size = choices.below(256);
  if (size == 255) return 8000;
  if (size >= 250) return 3000;  // the third stage begins behind 2560 symbols
  return size >= 160 ? 400 : 40;
}

Shape random_shape(Choices& choices) {
  Shape shape;
  shape.style = static_cast<Style>(choices.below(static_cast<uint32_t>(Style::count)));
  shape.most_nodes = random_size(choices);
  if (shape.style == Style::few)
    for (uint8_t& symbol : shape.palette) symbol = static_cast<uint8_t>(choices.below(256));
  return shape;
}

/// 0 too: a node without children, which is legal though nobody wants it.
uint8_t random_symbol(Choices& choices, const Shape& shape) {
  switch (shape.style) {
    case Style::sparse: {
      const uint32_t draw = choices.below(64);  // one child, or the same one twice
      return static_cast<uint8_t>(1U << draw % 8 | 1U << draw / 8);
    }
    case Style::dense: {
      const uint32_t draw = choices.below(64);
      return draw < 8 ? static_cast<uint8_t>(255U ^ 1U << draw) : uint8_t{255};
    }
    case Style::few:
      return choices.of(shape.palette);
    default:
      return static_cast<uint8_t>(choices.below(256));
  }
}

/// Level by level: for each node whether it has a texture symbol.
OctreeFields random_frame(Choices& choices, unsigned levels, unsigned textures) {
  const Shape shape = random_shape(choices);
  const uint32_t named = textures > 0 ? 2 + choices.below(8) : 0;  // one in so many has an image
  OctreeFields fields;
  std::vector<uint8_t> open{textures > 0};
  for (unsigned level = 0; level <= levels; ++level) {
    std::vector<uint8_t> below;
    for (const uint8_t is_open : open) {
      uint8_t symbol = 0;
      if (level < levels) {
        symbol = random_symbol(choices, shape);
        if (fields.octree.size() + below.size() > shape.most_nodes) symbol &= uint8_t(-symbol);
        fields.octree.push_back(symbol);
      }
      uint8_t image = 0;
      if (is_open != 0) {
        if (choices.one_in(named)) image = static_cast<uint8_t>(1 + choices.below(textures));
        fields.voxel_image_index.push_back(image);
      }
      below.insert(below.end(), static_cast<size_t>(std::popcount(symbol)),
                   is_open != 0 && image == 0);
    }
    open = std::move(below);
  }
  return fields;
}

unsigned random_levels(Choices& choices) {
  return choices.one_in(16) ? choices.below(32) : choices.below(7);
}

/// Of that many levels: a power of two, or one that needs the last level as well.
uint32_t random_resolution(Choices& choices, unsigned levels) {
  if (levels == 0) return 1;
  const uint32_t half = uint32_t{1} << (levels - 1);
  if (levels == 31 || choices.one_in(4)) return half + 1 + choices.below(half - (levels == 31));
  return 2 * half;
}

unsigned random_textures(Choices& choices) {
  const uint32_t draw = choices.below(8);
  return draw < 4 ? 0 : draw < 7 ? draw - 3 : choices.below(kMaxStreamTextures + 1);
}

}  // namespace

OctreeStream random_octree(Choices& choices) {
  OctreeStream stream;
  const unsigned levels = random_levels(choices);
  stream.resolution = random_resolution(choices, levels);
  stream.textures = random_textures(choices);
  do stream.frames.push_back(random_frame(choices, levels, stream.textures));
  while (stream.frames.size() < 4 && choices.one_in(5));
  return stream;
}

}  // namespace afx::conformance
