// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/mesh_shapes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>

#include "afx/builder/mesh_pictures.h"
#include "afx/shapes/face_mesh.h"
#include "afx/srgb.h"

namespace afx {
namespace {

constexpr uint32_t kNone = 0xFFFFFFFF;
constexpr float kCreaseAngle = 1.0471976F;  // 60 degrees
constexpr uint64_t kCornerBytes = 64;       // of a vertex of its own, an index, and room

Error too_large() {
  return {Errc::limit_exceeded, Place::none(), "the mesh takes more memory to draw than the limit"};
}

glm::vec3 display_colour(const glm::vec3& light) {
  const Rgba8 c = to_srgb(glm::dvec3(light));
  return glm::vec3(c.r, c.g, c.b) / 255.0F;
}

/// The pictures that materials need; those that are alike are made once.
class ShapePictures {
 public:
  ShapePictures(std::shared_ptr<const Mesh> mesh, uint64_t memory)
      : mesh_(std::move(mesh)), left_(memory) {}

  /// Null: there is no room.
  std::shared_ptr<const Picture> find(const Material& material, bool mirror_u, bool mirror_v) {
    const Picture& own = mesh_->textures[material.texture];
    const bool tint = material.colour != glm::vec3(1);
    const bool cut = own.components % 2 == 0 && !(material.alpha_cutoff > 0);
    if (!tint && !cut && !mirror_u && !mirror_v) return {mesh_, &own};
    const Key key(material.texture, material.colour.x, material.colour.y, material.colour.z, cut,
                  mirror_u, mirror_v);
    if (const auto known = known_.find(key); known != known_.end()) return known->second;
    const uint64_t bytes = uint64_t{own.width} * own.height * 4 * (mirror_u ? 2 : 1) *
                           (mirror_v ? 2 : 1) * 2;  // the tinted one is there too for a while
    if (bytes > left_) return nullptr;
    left_ -= bytes;
    Picture made = tint || cut ? tinted(own, material.colour, !cut) : own;
    if (mirror_u || mirror_v) made = with_mirror_image(made, mirror_u, mirror_v);
    return known_.emplace(key, std::make_shared<Picture>(std::move(made))).first->second;
  }

 private:
  using Key = std::tuple<uint32_t, float, float, float, bool, bool, bool>;
  std::shared_ptr<const Mesh> mesh_;
  uint64_t left_;
  std::map<Key, std::shared_ptr<const Picture>> known_;
};

class ShapeMaker {
 public:
  ShapeMaker(const std::shared_ptr<const Mesh>& mesh, Shade shade, const Limits& limits)
      : mesh_(*mesh),
        coloured_(colouring_of(mesh_) != Colouring::none),
        lit_(is_to_be_shaded(colouring_of(mesh_), shade)),
        corners_(uint64_t{3} * mesh_.triangles.size()),
        fits_(corners_ <= limits.memory / kCornerBytes),
        creases_(lit_ && corners_ <= limits.memory / kFaceCornerBytes),
        pictures_(mesh, limits.memory) {}

  Result<std::vector<Shape>> run() {
    if (!fits_) return too_large();
    std::vector<size_t> starts(mesh_.materials.size() + 1);
    for (const uint32_t material : mesh_.material_of) ++starts[material + 1];
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    std::vector<uint32_t> sorted(mesh_.triangles.size());
    std::vector<size_t> next = starts;
    for (size_t t = 0; t < sorted.size(); ++t)
      sorted[next[mesh_.material_of[t]]++] = static_cast<uint32_t>(t);
    number_.assign(mesh_.positions.size(), kNone);
    std::vector<Shape> shapes;
    for (size_t m = 0; m < mesh_.materials.size(); ++m) {
      if (starts[m] == starts[m + 1]) continue;
      auto shape =
          make(mesh_.materials[m], std::span(sorted).subspan(starts[m], starts[m + 1] - starts[m]));
      if (!shape.ok()) return std::move(shape).error();
      if (!shape.value().geometry->indices.empty()) shapes.push_back(std::move(shape).value());
    }
    return shapes;
  }

 private:
  using Triangles = std::span<const uint32_t>;

  Result<Shape> make(const Material& material, Triangles triangles) {
    const bool textured = material.texture != Material::kNoTexture && !mesh_.texture_coords.empty();
    take_vertices(triangles);
    auto geometry = creases_ ? creased(triangles, textured) : smooth(triangles, textured);
    if (!geometry.ok()) return std::move(geometry).error();
    geometry.value().solid = false;
    if (coloured_ && !textured) colour(material, geometry.value());
    Look look;
    look.lit = lit_;
    if (!lit_) look.diffuse = look.emissive = glm::vec3(1);
    if (textured) {
      if (!add_texture(material, geometry.value(), look)) return too_large();
    }
    for (const uint32_t vertex : vertices_) number_[vertex] = kNone;
    return Shape{std::make_shared<Geometry>(std::move(geometry).value()),
                 std::make_shared<Look>(std::move(look)),
                 glm::dmat4(1),
                 {}};
  }

  /// The vertices that they use, in the order in which they are met.
  void take_vertices(Triangles triangles) {
    vertices_.clear();
    for (const uint32_t t : triangles)
      for (int k = 0; k < 3; ++k) {
        const uint32_t vertex = mesh_.triangles[t][k];
        if (number_[vertex] != kNone) continue;
        number_[vertex] = static_cast<uint32_t>(vertices_.size());
        vertices_.push_back(vertex);
      }
  }

  Result<Geometry> smooth(Triangles triangles, bool textured) const {
    Geometry out;
    std::vector<glm::dvec3> sums(vertices_.size());
    for (const uint32_t t : triangles) {
      const glm::uvec3 v = mesh_.triangles[t];
      const glm::dvec3 a(mesh_.positions[v.x]), b(mesh_.positions[v.y]), c(mesh_.positions[v.z]);
      for (int k = 0; k < 3; ++k) {
        out.indices.push_back(number_[v[k]]);
        sums[number_[v[k]]] += glm::cross(b - a, c - a);
      }
    }
    for (size_t i = 0; i < vertices_.size(); ++i) {
      const uint32_t vertex = vertices_[i];
      const double length = glm::length(sums[i]);
      out.positions.push_back(mesh_.positions[vertex]);
      out.normals.emplace_back(length > 0 ? sums[i] / length : glm::dvec3(0, 0, 1));
      if (textured)
        out.texture_coordinates.push_back(mesh_.texture_coords[vertex]);
      else if (!mesh_.colours.empty())
        out.colours.push_back(mesh_.colours[vertex]);
    }
    return out;
  }

  Result<Geometry> creased(Triangles triangles, bool textured) const {
    FaceMesh faces;
    faces.crease_angle = kCreaseAngle;
    const std::vector<uint32_t> point_of = weld(faces.points);
    for (const uint32_t t : triangles) {
      for (int k = 0; k < 3; ++k) {
        const uint32_t vertex = mesh_.triangles[t][k];
        faces.corners.push_back(point_of[number_[vertex]]);
        if (textured)
          faces.texture_coordinates.push_back(mesh_.texture_coords[vertex]);
        else if (!mesh_.colours.empty())
          faces.colours.push_back(mesh_.colours[vertex]);
      }
      faces.starts.push_back(static_cast<uint32_t>(faces.corners.size()));
    }
    // Not those of the bounding box, which would part corners that are one.
    if (!textured) faces.texture_coordinates.assign(faces.corners.size(), glm::vec2(0));
    auto geometry = geometry_of(faces);
    if (geometry.ok() && !textured) geometry.value().texture_coordinates = {};
    return geometry;
  }

  /// Vertices at one place become one point: where textures or colours part, surface goes on.
  std::vector<uint32_t> weld(std::vector<glm::vec3>& points) const {
    std::vector<uint32_t> order(vertices_.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto at = [this](uint32_t i) { return mesh_.positions[vertices_[i]]; };
    std::sort(order.begin(), order.end(), [&at](uint32_t i, uint32_t j) {
      const glm::vec3 a = at(i), b = at(j);
      return std::tie(a.x, a.y, a.z, i) < std::tie(b.x, b.y, b.z, j);
    });
    std::vector<uint32_t> point_of(order.size());
    for (const uint32_t i : order) {
      if (points.empty() || points.back() != at(i)) points.push_back(at(i));
      point_of[i] = static_cast<uint32_t>(points.size() - 1);
    }
    return point_of;
  }

  /// Its colours are those of the mesh's vertices, or none.
  static void colour(const Material& material, Geometry& geometry) {
    if (geometry.colours.empty()) geometry.colours.assign(geometry.positions.size(), glm::vec3(1));
    for (glm::vec3& colour : geometry.colours) colour = display_colour(colour * material.colour);
  }

  bool add_texture(const Material& material, const Geometry& geometry, Look& look) {
    const auto goes_outside = [&geometry](int axis) {
      return std::any_of(geometry.texture_coordinates.begin(), geometry.texture_coordinates.end(),
                         [axis](const glm::vec2& at) { return !(at[axis] >= 0 && at[axis] <= 1); });
    };
    // Inside there is nothing mirrored to be seen.
    const bool u = material.wrap_u == Wrap::mirror && goes_outside(0);
    const bool v = material.wrap_v == Wrap::mirror && goes_outside(1);
    look.diffuse = glm::vec3(1);
    look.repeat_s = u || material.wrap_u == Wrap::repeat;
    look.repeat_t = v || material.wrap_v == Wrap::repeat;
    if (u) look.texture_transform[0][0] = 0.5F;
    if (v) look.texture_transform[1][1] = 0.5F;
    look.texture = pictures_.find(material, u, v);
    return look.texture != nullptr;
  }

  const Mesh& mesh_;
  bool coloured_, lit_;
  uint64_t corners_;
  bool fits_;     // into the limit at all
  bool creases_;  // there are, and they fit
  ShapePictures pictures_;
  std::vector<uint32_t> vertices_;  // of the shape that is made
  std::vector<uint32_t> number_;    // of each vertex of the mesh: its place there
};

}  // namespace

Result<std::vector<Shape>> shapes_of(const std::shared_ptr<const Mesh>& mesh, Shade shade,
                                     const Limits& limits) {
  return ShapeMaker(mesh, shade, limits).run();
}

}  // namespace afx
