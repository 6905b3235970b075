// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/shapes/shape_cache.h"

#include "afx/shapes/geometry_nodes.h"
#include "afx/shapes/look_nodes.h"
#include "afx/shapes/surroundings_nodes.h"

namespace afx {
namespace {

using nodes::NodeView;

constexpr uint64_t kEntryBytes = 128;  // of a map, and what shares it

}  // namespace

template <class T>
Result<std::shared_ptr<const T>> ShapeCache::keep(std::map<Path, std::shared_ptr<const T>>& known,
                                                  Path path, std::shared_ptr<const T> value,
                                                  uint64_t bytes) {
  const uint64_t all = bytes + path.size() * sizeof(uint32_t) + kEntryBytes;
  if (all > left_.memory)
    return Error{Errc::limit_exceeded, Place::none(),
                 "the shapes of the scene take more memory than the limit"};
  left_.memory -= all;
  return known.emplace(std::move(path), std::move(value)).first->second;
}

Result<std::shared_ptr<const Geometry>> ShapeCache::geometry(const NodeView& node) {
  Path path = node.path();
  if (const auto known = geometries_.find(path); known != geometries_.end()) return known->second;
  auto read = read_geometry(node, left_);
  if (!read.ok()) return std::move(read).error();
  const uint64_t bytes = bytes_of(read.value());
  return keep(geometries_, std::move(path),
              std::shared_ptr<const Geometry>(std::make_shared<Geometry>(std::move(read).value())),
              bytes);
}

Result<std::shared_ptr<const Look>> ShapeCache::look(const NodeView& appearance,
                                                     Diagnostics& diagnostics) {
  Path path = appearance.path();
  if (const auto known = looks_.find(path); known != looks_.end()) return known->second;
  auto read = read_look(appearance);
  if (!read.ok()) return std::move(read).error();
  auto picture = texture(appearance.child("texture"), diagnostics);
  if (!picture.ok()) return std::move(picture).error();
  read.value().texture = std::move(picture).value();
  return keep(looks_, std::move(path),
              std::shared_ptr<const Look>(std::make_shared<Look>(std::move(read).value())),
              sizeof(Look));
}

Result<std::shared_ptr<const Picture>> ShapeCache::texture(const NodeView& node,
                                                           Diagnostics& diagnostics) {
  Path path = node.path();
  if (const auto known = textures_.find(path); known != textures_.end()) return known->second;
  auto read = read_texture(node, base_, left_, diagnostics);
  if (!read.ok()) return std::move(read).error();
  const uint64_t bytes = read.value() ? read.value()->samples.size() : 0;
  return keep(textures_, std::move(path), std::move(read).value(), bytes);
}

Result<std::shared_ptr<const Backdrop>> ShapeCache::backdrop(const NodeView& node,
                                                             Diagnostics& diagnostics) {
  Path path = node.path();
  if (const auto known = backdrops_.find(path); known != backdrops_.end()) return known->second;
  auto read = read_backdrop(node, base_, left_, diagnostics);
  if (!read.ok()) return std::move(read).error();
  uint64_t bytes = sizeof(Backdrop);
  for (const auto& picture : read.value().pictures) bytes += picture ? picture->samples.size() : 0;
  return keep(backdrops_, std::move(path),
              std::shared_ptr<const Backdrop>(std::make_shared<Backdrop>(std::move(read).value())),
              bytes);
}

}  // namespace afx
