// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/texture_nodes.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "afx/picture_io.h"

namespace afx {
namespace {

using nodes::NodeView;
using nodes::Url;

/// Whether it is a node that has a still picture.
Status check_texture(const NodeView& texture) {
  if (!texture.valid()) return Error{Errc::bad_argument, Place::none(), "has no texture"};
  if (texture.type() == "PixelTexture" || texture.type() == "ImageTexture") return {};
  return Error{Errc::unsupported, Place::none(),
               "has a texture of type " + std::string(texture.type()) +
                   " (expected ImageTexture or PixelTexture)"};
}

DeepPicture deep(Picture picture) {
  return {picture.width,
          picture.height,
          picture.components,
          8,
          {picture.samples.begin(), picture.samples.end()}};
}

}  // namespace

Picture picture_of(const nodes::Image& image) {
  if (image.samples.empty()) return {};
  Picture picture(image.width, image.height, image.components);
  const size_t row = size_t{image.width} * image.components;
  for (uint32_t y = 0; y < image.height; ++y) {
    std::copy_n(image.samples.data() + row * (image.height - 1 - y), row, picture.pixel(0, y));
  }
  return picture;
}

Result<Picture> load_texture(const NodeView& texture, const UrlBase& base, const Limits& limits) {
  if (Status usable = check_texture(texture); !usable.ok()) return usable.error();
  if (texture.type() == "PixelTexture") return picture_of(texture.get<nodes::Image>("image"));
  const auto file = open_url(texture.get<std::vector<Url>>("url"), base, limits);
  if (!file.ok()) return file.error();
  return decode_picture(file.value().file.bytes(), file.value().path, limits);
}

Result<DeepPicture> load_deep_texture(const NodeView& texture, const UrlBase& base,
                                      const Limits& limits) {
  if (Status usable = check_texture(texture); !usable.ok()) return usable.error();
  if (texture.type() == "PixelTexture") return deep(picture_of(texture.get<nodes::Image>("image")));
  const auto file = open_url(texture.get<std::vector<Url>>("url"), base, limits);
  if (!file.ok()) return file.error();
  return decode_deep_picture(file.value().file.bytes(), file.value().path, limits);
}

}  // namespace afx
