// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/gl/gl_shapes.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

#include "render/gl/shape_shaders.h"
#include "render/shading.h"

namespace afx::render {
namespace {

enum Unit : int { picture_unit = 12, lights_unit = 13 };

/// As the software renderer has it (ShapeView): the inverse transposed, but for a positive factor.
glm::dmat3 normal_matrix(const glm::dmat3& m, bool mirrored) {
  const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]),
                             glm::cross(m[0], m[1]));
  // Only the direction counts, and a float must hold it.
  const double most = std::max(
      {glm::length(cofactors[0]), glm::length(cofactors[1]), glm::length(cofactors[2]), 1e-300});
  return cofactors / (mirrored ? -most : most);
}

GlTexture lights_texture(const Scene& scene, const Lens& lens) {
  std::vector<glm::vec4> texels;
  for (const Light& light : scene.lights) {
    const ViewLight v = view_light(light, lens);
    texels.emplace_back(v.colour, static_cast<float>(v.kind));
    texels.emplace_back(v.location, v.intensity);
    texels.emplace_back(v.direction, v.ambient_intensity);
    texels.emplace_back(v.attenuation, v.radius);
    texels.emplace_back(v.beam_width, v.cut_off_angle, 0, 0);
  }
  if (texels.empty()) texels.resize(5);
  GlTexture texture = GlTexture::make();
  glBindTexture(GL_TEXTURE_2D, texture.id());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, 5, static_cast<GLsizei>(texels.size() / 5), 0, GL_RGBA,
               GL_FLOAT, texels.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  return texture;
}

GlShapes::Item item_of(const Shape& shape, const GlGeometry& geometry, const GlPictures& pictures,
                       const Lens& lens) {
  GlShapes::Item item{};
  const Look& look = *shape.look;
  item.shape = &shape;
  item.geometry = &geometry;
  if (!geometry.is_bands() && !shape.geometry->texture_coordinates.empty())
    item.picture = pictures.find(look.texture.get());
  const bool by_picture = item.picture != nullptr && item.picture->components % 2 == 0;
  item.transparent = by_picture ? !item.picture->opaque : look.transparency > 0;
  item.axes = lens.to_view * glm::dmat3(shape.to_world);
  item.origin = lens.to_view * (glm::dvec3(shape.to_world[3]) - lens.position);
  item.mirrored = glm::dot(item.axes[0], glm::cross(item.axes[1], item.axes[2])) < 0;
  item.normals = normal_matrix(item.axes, item.mirrored);
  return item;
}

/// A ball around an item in the camera's system.
std::pair<glm::dvec3, double> ball_of(const GlShapes::Item& item) {
  const glm::dmat3& m = item.axes;
  const double stretch =
      std::sqrt(glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2]));
  return {m * item.geometry->centre() + item.origin, stretch * item.geometry->radius()};
}

}  // namespace

Result<GlShapes> GlShapes::make(const GlFeatures& features) {
  GlShapes shapes;
  for (unsigned variant = 0; variant < shapes.programs_.size(); ++variant) {
    std::string defines = (variant & 1U) != 0 ? "#define BANDS\n" : "";
    if ((variant & 2U) != 0) defines += "#define GLASS\n";
    auto program =
        GlProgram::make(features, defines, shape_vertex_shader(), shape_fragment_shader());
    if (!program.ok()) return program.error();
    shapes.programs_[variant] = std::move(program).value();
  }
  return shapes;
}

void GlShapes::set_scene(const Scene& scene) {
  std::map<const Geometry*, std::unique_ptr<GlGeometry>> geometries;
  for (const Shape& shape : scene.shapes) {
    std::unique_ptr<GlGeometry>& geometry = geometries[shape.geometry.get()];
    if (geometry == nullptr) geometry = std::move(geometries_[shape.geometry.get()]);
    if (geometry == nullptr) geometry = std::make_unique<GlGeometry>(shape.geometry);
  }
  geometries_ = std::move(geometries);
}

GlShapes::Frame GlShapes::frame(const Scene& scene, const GlPictures& pictures,
                                const Lens& lens) const {
  Frame frame;
  if (scene.shapes.empty()) return frame;
  for (const Shape& shape : scene.shapes) {
    if (shape.geometry->indices.empty()) continue;
    frame.items.push_back(item_of(shape, *geometries_.at(shape.geometry.get()), pictures, lens));
    const auto [centre, radius] = ball_of(frame.items.back());
    frame.farthest = std::max(frame.farthest, radius - centre.z);
    frame.has_walls = frame.has_walls || !frame.items.back().transparent;
  }
  frame.lights = lights_texture(scene, lens);
  sort_glass(frame, lens);
  return frame;
}

/// The farthest first, by the distance of their middle from the eye or its plane.
void GlShapes::sort_glass(Frame& frame, const Lens& lens) {
  struct Primitive {
    double nearness;
    size_t item, number;
  };
  std::vector<Primitive> order;
  for (size_t i = 0; i < frame.items.size(); ++i) {
    const Item& item = frame.items[i];
    if (!item.transparent) continue;
    const Geometry& g = item.geometry->geometry();
    const size_t each = corners_of(g.kind);
    for (size_t k = 0; k < g.indices.size(); k += each) {
      glm::dvec3 middle(0);
      for (size_t c = 0; c < each; ++c) middle += glm::dvec3(g.positions[g.indices[k + c]]);
      middle = item.axes * (middle / static_cast<double>(each)) + item.origin;
      order.push_back({lens.perspective ? -glm::length(middle) : middle.z, i, k / each});
    }
  }
  std::stable_sort(order.begin(), order.end(),
                   [](const Primitive& a, const Primitive& b) { return a.nearness < b.nearness; });
  std::vector<uint32_t> indices;
  for (const Primitive& p : order) {
    const Geometry& g = frame.items[p.item].geometry->geometry();
    const bool flat = g.kind == Geometry::Kind::triangles;
    const bool joins = flat && !frame.glass.empty() && frame.glass.back().item == p.item;
    if (!joins) frame.glass.push_back({p.item, flat ? indices.size() : p.number, flat ? 0U : 1U});
    if (!flat) continue;
    frame.glass.back().count += 3;
    for (size_t c = 0; c < 3; ++c) indices.push_back(g.indices[3 * p.number + c]);
  }
  if (indices.empty()) return;
  frame.glass_indices = GlBuffer::make();
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, frame.glass_indices.id());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(uint32_t)),
               indices.data(), GL_STREAM_DRAW);
}

void GlShapes::set_fog(const GlProgram& program, const Scene& scene, const GlView& view) {
  program.set("has_fog", scene.fog ? 1 : 0);
  if (!scene.fog) return;
  program.set("fog_is_exponential", scene.fog->exponential ? 1 : 0);
  program.set("fog_range", static_cast<float>(std::min(scene.fog->visibility_range, 3e38)));
  program.set("fog_light", linear_light(scene.fog->colour));
  program.set("fog_middle", glm::vec2(view.lens.middle - view.corner));
  program.set("fog_slope", view.lens.perspective ? static_cast<float>(1 / view.lens.focal) : 0.0F);
}

const GlProgram& GlShapes::begin(const Frame& frame, const Scene& scene, const GlView& view,
                                 bool bands, bool glass) const {
  const GlProgram& program = programs_[(bands ? 1U : 0U) + (glass ? 2U : 0U)];
  program.use();
  view.set_uniforms(program);
  set_fog(program, scene, view);
  program.set("samples", static_cast<float>(view.options.samples));
  program.set("half_width", static_cast<float>(view.options.samples) / 2);
  program.set("has_headlight", scene.headlight ? 1 : 0);
  program.set("picture", picture_unit);
  program.set("lights", lights_unit);
  glActiveTexture(GL_TEXTURE0 + lights_unit);
  glBindTexture(GL_TEXTURE_2D, frame.lights.id());
  glActiveTexture(GL_TEXTURE0 + picture_unit);
  return program;  // the unit of pictures stays the current one
}

void GlShapes::set_item(const GlProgram& program, const Item& item) const {
  const Look& look = *item.shape->look;
  const Geometry& g = item.geometry->geometry();
  const bool flat = !item.geometry->is_bands();
  program.set("axes", glm::mat3(item.axes));
  program.set("origin", glm::vec3(item.origin));
  program.set("normals", glm::mat3(item.normals));
  program.set("is_line", g.kind == Geometry::Kind::lines ? 1 : 0);
  program.set("is_lit", look.lit && flat ? 1 : 0);
  program.set("has_colours", g.colours.empty() ? 0 : 1);
  program.set("own_colour", flat ? look.diffuse : look.emissive);
  program.set("specular", look.specular);
  program.set("emissive", look.emissive);
  program.set("ambient_intensity", look.ambient_intensity);
  program.set("shininess", look.shininess);
  program.set("opacity", 1 - look.transparency);
  program.set("texture_transform", look.texture_transform);
  program.set("components",
              item.picture == nullptr ? 0 : static_cast<int>(item.picture->components));
  if (item.picture != nullptr) {
    program.set("picture_size", item.picture->size);
    item.picture->bind(look.repeat_s, look.repeat_t);
  }
  std::vector<int> numbers(item.shape->lights.begin(), item.shape->lights.end());
  numbers.resize(std::min(numbers.size(), kMostLights));
  program.set("light_count", static_cast<int>(numbers.size()));
  program.set("light_numbers", numbers);
  // Rows run down: what runs counter-clockwise in the world runs clockwise here.
  glFrontFace(item.mirrored ? GL_CCW : GL_CW);
  glCullFace(GL_BACK);
  (flat && g.solid ? glEnable : glDisable)(GL_CULL_FACE);
}

void GlShapes::draw_walls(const Frame& frame, const Scene& scene, const GlView& view) const {
  for (const bool bands : {false, true}) {
    const GlProgram* program = nullptr;
    for (const Item& item : frame.items) {
      if (item.transparent || item.geometry->is_bands() != bands) continue;
      const auto [centre, radius] = ball_of(item);
      if (!view.touches(centre, radius)) continue;
      if (program == nullptr) program = &begin(frame, scene, view, bands, false);
      set_item(*program, item);
      item.geometry->bind();
      const Geometry& g = item.geometry->geometry();
      const auto count = static_cast<GLsizei>(g.indices.size());
      if (!bands) {
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, item.geometry->indices());
        glDrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, nullptr);
      } else {
        glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4,
                              count / static_cast<GLsizei>(corners_of(g.kind)));
      }
    }
  }
  glDisable(GL_CULL_FACE);
}

void GlShapes::draw_glass(const Frame& frame, const Scene& scene, const GlView& view) const {
  size_t last = frame.items.size();
  const GlProgram* program = nullptr;
  bool last_bands = false;
  for (const GlassRun& run : frame.glass) {
    const Item& item = frame.items[run.item];
    const bool bands = item.geometry->is_bands();
    if (program == nullptr || bands != last_bands) {
      program = &begin(frame, scene, view, bands, true);
      last = frame.items.size();
    }
    if (last != run.item) set_item(*program, item);
    last = run.item;
    last_bands = bands;
    item.geometry->bind(run.first);
    if (bands) {
      glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(run.count));
      continue;
    }
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, frame.glass_indices.id());
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(run.count), GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(run.first * sizeof(uint32_t)));
  }
  glDisable(GL_CULL_FACE);
}

}  // namespace afx::render
