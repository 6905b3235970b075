// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/depth_image_nodes.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "afx/known_nodes.h"
#include "afx/node_rotation.h"
#include "afx/texture_nodes.h"

namespace afx {
namespace {

using nodes::NodeId;
using nodes::NodeView;
using nodes::Url;

Error bad_node(const NodeView& node, const std::string& text, Errc code = Errc::bad_argument) {
  return {code, Place::none(), node.label() + ": " + text};
}

Error of_node(const NodeView& node, Error error) {
  error.text = node.label() + ": " + error.text;
  return error;
}

bool is_one_of(const NodeView& node, const char* type) {
  return node.type() == type || node.type() == std::string(type) + "V2";
}

// One component of a picture, alone.
DeepPicture plane_of(const DeepPicture& picture, uint32_t component) {
  DeepPicture plane{picture.width, picture.height, 1, picture.bits, {}};
  plane.samples.reserve(size_t{picture.width} * picture.height);
  for (size_t i = component; i < picture.samples.size(); i += picture.components)
    plane.samples.push_back(picture.samples[i]);
  return plane;
}

// The components before the last, with 8 bits.
Picture colours_of(const DeepPicture& picture) {
  Picture colours(picture.width, picture.height, picture.components - 1);
  const uint32_t most = (1U << picture.bits) - 1;
  size_t to = 0;
  for (size_t i = 0; i < picture.samples.size(); ++i)
    if (i % picture.components + 1 != picture.components)
      colours.samples[to++] = static_cast<uint8_t>((picture.samples[i] * 255U + most / 2) / most);
  return colours;
}

// Depth by a texture of its own.
Result<SimpleTexture> read_with_depth(const NodeView& node, const UrlBase& base,
                                      const Limits& limits) {
  auto colour = load_texture(node.child("texture"), base, limits);
  if (!colour.ok()) return of_node(node, std::move(colour).error());
  const auto depth = load_deep_texture(node.child("depth"), base, limits);
  if (!depth.ok()) return of_node(node, Error(depth.error()));
  if (depth.value().components > 2)
    return bad_node(node, "depth has " + std::to_string(depth.value().components) +
                              " components (expected one or two)");
  return SimpleTexture{std::move(colour).value(), plane_of(depth.value(), 0)};
}

// Depth in the alpha channel.
Result<SimpleTexture> read_with_alpha(const NodeView& node, const UrlBase& base,
                                      const Limits& limits) {
  const auto both = load_deep_texture(node.child("texture"), base, limits);
  if (!both.ok()) return of_node(node, Error(both.error()));
  const uint32_t components = both.value().components;
  if (components != 2 && components != 4)
    return bad_node(node, "has neither a depth field nor an alpha channel in its texture");
  return SimpleTexture{colours_of(both.value()), plane_of(both.value(), components - 1)};
}

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

Result<PointTexture> read_points(const NodeView& node, const Limits& limits,
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

NodeId add_camera(nodes::Scene& scene, const DepthCamera& camera, NodeId texture) {
  const NodeId image = add_known(scene, "DepthImage");
  set_known(scene, image, "position", glm::vec3(camera.position));
  set_known(scene, image, "orientation", rotation_of(camera.orientation));
  set_known(scene, image, "orthographic", camera.orthographic);
  set_known(scene, image, "fieldOfView", glm::vec2(camera.field_of_view));
  set_known(scene, image, "nearPlane", static_cast<float>(camera.near_plane));
  set_known(scene, image, "farPlane", static_cast<float>(camera.far_plane));
  set_known(scene, image, "diTexture", texture);
  return image;
}

NodeId add_image_texture(nodes::Scene& scene, const std::string& url) {
  const NodeId texture = add_known(scene, "ImageTexture");
  set_known(scene, texture, "url", std::vector<Url>{Url::from_text(url)});
  return texture;
}

}  // namespace

Result<DepthCamera> read_depth_camera(const NodeView& node) {
  DepthCamera camera;
  camera.position = glm::dvec3(node.get<glm::vec3>("position"));
  camera.orientation = quaternion_of<double>(node.get<nodes::Rotation>("orientation"));
  camera.orthographic = node.get<bool>("orthographic");
  camera.field_of_view = glm::dvec2(node.get<glm::vec2>("fieldOfView"));
  camera.near_plane = static_cast<double>(node.get<float>("nearPlane"));
  camera.far_plane = static_cast<double>(node.get<float>("farPlane"));
  if (Status right = check_depth_camera(camera); !right.ok())
    return of_node(node, std::move(right).error());
  return camera;
}

Result<DepthImage> read_depth_image(const NodeView& node, const UrlBase& base, const Limits& limits,
                                    Diagnostics& diagnostics) {
  if (!is_one_of(node, "DepthImage"))
    return bad_node(node, "is not coded in a way that is known (expected a DepthImage itself)",
                    Errc::unsupported);
  const auto camera = read_depth_camera(node);
  if (!camera.ok()) return camera.error();
  DepthImage image{camera.value(), {}};
  const NodeView texture = node.child("diTexture");
  if (!texture.valid()) return bad_node(node, "field diTexture is NULL (expected a texture)");
  if (is_one_of(texture, "PointTexture")) {
    auto points = read_points(texture, limits, diagnostics);
    if (!points.ok()) return std::move(points).error();
    image.texture = std::move(points).value();
  } else if (is_one_of(texture, "SimpleTexture")) {
    auto simple = texture.child("depth").valid() ? read_with_depth(texture, base, limits)
                                                 : read_with_alpha(texture, base, limits);
    if (!simple.ok()) return std::move(simple).error();
    image.texture = std::move(simple).value();
  } else {
    return bad_node(node,
                    "diTexture is of type " + std::string(texture.type()) +
                        " (expected SimpleTexture or PointTexture)",
                    Errc::unsupported);
  }
  if (Status right = check_depth_image(image); !right.ok())
    return of_node(texture, std::move(right).error());
  return image;
}

NodeId add_depth_image(nodes::Scene& scene, const DepthCamera& camera,
                       const PictureUrls& pictures) {
  const NodeId simple = add_known(scene, "SimpleTexture");
  set_known(scene, simple, "texture", add_image_texture(scene, pictures.colour));
  if (!pictures.depth.empty())
    set_known(scene, simple, "depth", add_image_texture(scene, pictures.depth));
  return add_camera(scene, camera, simple);
}

NodeId add_depth_image(nodes::Scene& scene, const DepthCamera& camera,
                       const PointTexture& texture) {
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
  return add_camera(scene, camera, points);
}

DeepPicture with_depth_as_alpha(const SimpleTexture& texture) {
  const Picture& colour = texture.colour;
  const uint32_t colours = colour.components < 3 ? 1 : 3;
  const uint32_t bits = texture.depth.bits > 8 ? 16 : 8;
  DeepPicture both{colour.width, colour.height, colours + 1, bits, {}};
  both.samples.reserve(texture.depth.samples.size() * both.components);
  for (size_t i = 0; i < texture.depth.samples.size(); ++i) {
    for (uint32_t c = 0; c < colours; ++c) {
      const uint32_t sample = colour.samples[i * colour.components + c];
      both.samples.push_back(static_cast<uint16_t>(bits == 16 ? sample * 257 : sample));
    }
    both.samples.push_back(texture.depth.samples[i]);
  }
  return both;
}

}  // namespace afx
