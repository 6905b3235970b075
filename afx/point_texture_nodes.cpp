// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/point_texture_nodes.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "afx/known_nodes.h"
#include "afx/node_error.h"

namespace afx {
namespace {

using nodes::NodeId;
using nodes::NodeView;

// The list of depths of a PointTexture, which holds the count of each pixel in front of its depths.
class DepthListReader {
 public:
  DepthListReader(const NodeView& node, const std::vector<int32_t>& list, PointTexture& texture)
      : node_(node), list_(list), texture_(texture) {}

  Status read() {
    const uint64_t pixels = uint64_t{texture_.width} * texture_.height;
    texture_.starts.reserve(pixels + 1);
    texture_.starts.push_back(0);
    for (pixel_ = 0; pixel_ < pixels; ++pixel_)
      if (Status status = read_pixel(); !status.ok()) return status;
    if (at_ != list_.size())
      return bad_node(node_, "field depth has " + std::to_string(list_.size() - at_) +
                                 " values left over after the last pixel");
    return {};
  }

  [[nodiscard]] uint64_t zeros() const { return zeros_; }

 private:
  Status read_pixel() {
    if (at_ == list_.size()) return ends_inside();
    const int32_t count = list_[at_++];
    if (count < 0) return wrong("has " + std::to_string(count) + " depths", "0 or more");
    if (static_cast<uint64_t>(count) > list_.size() - at_) return ends_inside();
    for (int32_t n = 0; n < count; ++n)
      if (Status status = read_depth(list_[at_++]); !status.ok()) return status;
    texture_.starts.push_back(static_cast<uint32_t>(texture_.depths.size()));
    return {};
  }

  Status read_depth(int32_t value) {
    // 32 bits of depth: the sign bit of the field is the highest bit of the depth.
    const bool whole = texture_.depth_bits == 32;
    if (value < 0 && !whole) return wrong("has the depth " + std::to_string(value), "0 or more");
    const auto depth = static_cast<uint32_t>(value);
    if (depth > texture_.dmax())
      return wrong("has the depth " + std::to_string(depth),
                   "at most " + std::to_string(texture_.dmax()));
    if (depth == 0) ++zeros_;
    texture_.depths.push_back(std::max(depth, 1U));
    return {};
  }

  [[nodiscard]] std::string place() const {
    return "field depth: pixel (" + std::to_string(pixel_ % texture_.width) + ", " +
           std::to_string(pixel_ / texture_.width) + ") ";
  }
  [[nodiscard]] Error wrong(const std::string& what, const std::string& expected) const {
    return bad_node(node_, place() + what + " (expected " + expected + ")");
  }
  [[nodiscard]] Error ends_inside() const {
    return bad_node(node_, "field depth ends inside pixel (" +
                               std::to_string(pixel_ % texture_.width) + ", " +
                               std::to_string(pixel_ / texture_.width) + "), after " +
                               std::to_string(list_.size()) + " values");
  }

  const NodeView& node_;
  const std::vector<int32_t>& list_;
  PointTexture& texture_;
  uint64_t pixel_ = 0;
  size_t at_ = 0;
  uint64_t zeros_ = 0;
};

uint8_t byte_of(float part) {
  return static_cast<uint8_t>(std::lround(std::clamp(part, 0.0F, 1.0F) * 255.0F));
}

Status read_size(const NodeView& node, PointTexture& texture, const Limits& limits) {
  for (const char* field : {"width", "height"}) {
    const int32_t side = node.get<int32_t>(field);
    if (side < 1)
      return bad_node(node, std::string("field ") + field + " is " + std::to_string(side) +
                                " (expected at least 1)");
    (field[0] == 'w' ? texture.width : texture.height) = static_cast<uint32_t>(side);
  }
  const uint64_t pixels = uint64_t{texture.width} * texture.height;
  if (pixels > limits.picture_pixels || pixels > limits.memory / sizeof(uint32_t))
    return bad_node(node, "has " + std::to_string(pixels) + " pixels, more than the limit",
                    Errc::limit_exceeded);
  const int32_t bits = node.get<int32_t>("depthNbBits");
  if (bits < 0 || bits > 31)
    return bad_node(node, "field depthNbBits is " + std::to_string(bits) + " (expected 0 to 31)");
  texture.depth_bits = static_cast<unsigned>(bits) + 1;
  return {};
}

}  // namespace

Result<PointTexture> read_point_texture(const NodeView& node, const Limits& limits,
                                        Diagnostics& diagnostics) {
  PointTexture texture;
  if (Status size = read_size(node, texture, limits); !size.ok()) return size.error();
  const auto& list = node.get<std::vector<int32_t>>("depth");
  const uint64_t pixels = uint64_t{texture.width} * texture.height;
  if (list.size() < pixels)  // a pixel takes one value at least: before memory for all is asked for
    return bad_node(node, "field depth has " + std::to_string(list.size()) + " values for " +
                              std::to_string(pixels) + " pixels (expected at least one a pixel)");
  DepthListReader reader(node, list, texture);
  if (Status status = reader.read(); !status.ok()) return status.error();
  if (reader.zeros() > 0)
    diagnostics.warn("zero_depth", Place::none(),
                     node.label() + ": " + std::to_string(reader.zeros()) +
                         " depths are 0 and taken as the far plane");
  const auto& colours = node.get<std::vector<glm::vec3>>("color");
  if (colours.size() != texture.depths.size())
    return bad_node(node, "field color has " + std::to_string(colours.size()) + " colours for " +
                              std::to_string(texture.depths.size()) + " depths");
  texture.colours.reserve(colours.size());
  for (const glm::vec3& c : colours)
    texture.colours.push_back({byte_of(c.x), byte_of(c.y), byte_of(c.z), 255});
  return texture;
}

NodeId add_point_texture(nodes::Scene& scene, const PointTexture& texture) {
  const size_t pixels = size_t{texture.width} * texture.height;
  std::vector<int32_t> list;
  list.reserve(pixels + texture.depths.size());
  for (size_t pixel = 0; pixel < pixels; ++pixel) {
    const uint32_t from = texture.starts.empty() ? 0 : texture.starts[pixel];
    const uint32_t to = texture.starts.empty() ? 0 : texture.starts[pixel + 1];
    list.push_back(static_cast<int32_t>(to - from));
    for (uint32_t n = from; n < to; ++n) list.push_back(static_cast<int32_t>(texture.depths[n]));
  }
  std::vector<glm::vec3> colours;
  colours.reserve(texture.colours.size());
  for (const Rgba8& c : texture.colours) colours.push_back(glm::vec3(c.r, c.g, c.b) / 255.0F);
  const NodeId points = add_known(scene, "PointTexture");
  set_known(scene, points, "width", static_cast<int32_t>(texture.width));
  set_known(scene, points, "height", static_cast<int32_t>(texture.height));
  set_known(scene, points, "depthNbBits", static_cast<int32_t>(texture.depth_bits) - 1);
  set_known(scene, points, "depth", std::move(list));
  set_known(scene, points, "color", std::move(colours));
  return points;
}

}  // namespace afx
