// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/depth_image_nodes.h"

#include <utility>
#include <vector>

#include "afx/known_nodes.h"
#include "afx/node_error.h"
#include "afx/node_rotation.h"
#include "afx/point_texture_nodes.h"
#include "afx/texture_nodes.h"

namespace afx {
namespace {

using nodes::NodeId;
using nodes::NodeView;
using nodes::Url;

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

// A depth on a longer scale: the far plane stays 1, the near plane becomes `most`.
uint16_t scaled(uint16_t depth, uint64_t dmax, uint64_t most) {
  if (depth == 0 || dmax == most) return depth;
  if (dmax <= 1) return static_cast<uint16_t>(most);
  return static_cast<uint16_t>(1 + ((depth - 1U) * (most - 1) + (dmax - 1) / 2) / (dmax - 1));
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
    auto points = read_point_texture(texture, limits, diagnostics);
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
  return add_camera(scene, camera, add_point_texture(scene, texture));
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
    both.samples.push_back(scaled(texture.depth.samples[i], texture.dmax(), (1U << bits) - 1));
  }
  return both;
}

}  // namespace afx
