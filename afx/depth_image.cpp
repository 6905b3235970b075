// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/depth_image.h"

#include <algorithm>
#include <string>

namespace afx {
namespace {

Error bad(const std::string& text) { return {Errc::bad_argument, Place::none(), text}; }

std::string size_of(uint64_t width, uint64_t height) {
  return std::to_string(width) + " x " + std::to_string(height);
}

Status check_texture(const SimpleTexture& texture) {
  const Picture& colour = texture.colour;
  const DeepPicture& depth = texture.depth;
  const uint64_t pixels = uint64_t{colour.width} * colour.height;
  if (pixels == 0) return bad("the texture is empty");
  if (colour.components < 1 || colour.components > 4)
    return bad("the texture has " + std::to_string(colour.components) +
               " components (expected 1 to 4)");
  if (colour.width != depth.width || colour.height != depth.height)
    return bad("texture and depth differ in size: " + size_of(colour.width, colour.height) +
               " and " + size_of(depth.width, depth.height) + " pixels");
  if (depth.components != 1 || depth.bits < 1 || depth.bits > 16)
    return bad("the depth has " + std::to_string(depth.components) + " components of " +
               std::to_string(depth.bits) + " bits (expected one of 1 to 16)");
  if (colour.samples.size() != pixels * colour.components || depth.samples.size() != pixels)
    return bad("the samples do not fit the size of the picture");
  const auto most = std::max_element(depth.samples.begin(), depth.samples.end());
  if (*most > texture.dmax())
    return bad("a depth is " + std::to_string(*most) + " (expected at most " +
               std::to_string(texture.dmax()) + ")");
  return {};
}

Status check_texture(const PointTexture& texture) {
  const uint64_t pixels = uint64_t{texture.width} * texture.height;
  if (pixels == 0) return bad("the texture is empty");
  if (texture.depth_bits < 1 || texture.depth_bits > 32)
    return bad("the depths have " + std::to_string(texture.depth_bits) +
               " bits (expected 1 to 32)");
  if (texture.colours.size() != texture.depths.size())
    return bad("there are " + std::to_string(texture.colours.size()) + " colours for " +
               std::to_string(texture.depths.size()) + " depths");
  const bool none = texture.starts.empty() && texture.depths.empty();
  if (!none && (texture.starts.size() != pixels + 1 || texture.starts.front() != 0 ||
                texture.starts.back() != texture.depths.size() ||
                !std::is_sorted(texture.starts.begin(), texture.starts.end())))
    return bad("the samples do not fit the pixels");
  for (const uint32_t depth : texture.depths)
    if (depth > texture.dmax())
      return bad("a depth is " + std::to_string(depth) + " (expected at most " +
                 std::to_string(texture.dmax()) + ")");
  return {};
}

}  // namespace

uint32_t DepthImage::width() const {
  if (const auto* simple = std::get_if<SimpleTexture>(&texture)) return simple->colour.width;
  return std::get<PointTexture>(texture).width;
}

uint32_t DepthImage::height() const {
  if (const auto* simple = std::get_if<SimpleTexture>(&texture)) return simple->colour.height;
  return std::get<PointTexture>(texture).height;
}

Status check_depth_image(const DepthImage& image) {
  if (Status camera = check_depth_camera(image.camera); !camera.ok()) return camera;
  return std::visit([](const auto& texture) { return check_texture(texture); }, image.texture);
}

}  // namespace afx
