// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/shapes/look_nodes.h"

#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "afx/node_error.h"
#include "afx/shapes/field_reader.h"
#include "afx/texture_nodes.h"

namespace afx {
namespace {

using nodes::NodeView;

void make_unlit(Look& look, const glm::vec3& colour) {
  look.lit = false;
  look.diffuse = look.emissive = colour;
}

Status read_material(const NodeView& material, Look& look) {
  FieldReader fields(material);
  look.diffuse = fields.colour("diffuseColor");
  look.specular = fields.colour("specularColor");
  look.emissive = fields.colour("emissiveColor");
  look.ambient_intensity = fields.clamped("ambientIntensity", 0, 1);
  look.shininess = fields.clamped("shininess", 0, 1);
  look.transparency = fields.clamped("transparency", 0, 1);
  return fields.ok() ? Status() : Status(fields.error());
}

Status read_material_2d(const NodeView& material, Look& look) {
  FieldReader fields(material);
  make_unlit(look, fields.colour("emissiveColor"));
  look.transparency = fields.clamped("transparency", 0, 1);
  return fields.ok() ? Status() : Status(fields.error());
}

}  // namespace

Result<Look> read_look(const NodeView& appearance) {
  Look look;
  const NodeView material = appearance.child("material"), texture = appearance.child("texture");
  Status status;
  if (material.type() == "Material") {
    status = read_material(material, look);
  } else if (material.type() == "Material2D") {
    status = read_material_2d(material, look);
  } else {
    make_unlit(look, glm::vec3(1));
  }
  if (!status.ok()) return status.error();
  if (const auto* repeat = texture.find<bool>("repeatS")) look.repeat_s = *repeat;
  if (const auto* repeat = texture.find<bool>("repeatT")) look.repeat_t = *repeat;
  const auto transform = read_texture_transform(appearance.child("textureTransform"));
  if (!transform.ok()) return transform.error();
  look.texture_transform = transform.value();
  return look;
}

Result<glm::mat3> read_texture_transform(const NodeView& transform) {
  if (transform.type() != "TextureTransform") return glm::mat3(1);
  FieldReader fields(transform);
  const glm::dvec2 center = fields.finite2("center"), scale = fields.finite2("scale"),
                   translation = fields.finite2("translation");
  const double angle = fields.finite("rotation");
  if (!fields.ok()) return fields.error();
  const double c = std::cos(angle), s = std::sin(angle);
  const glm::dvec2 moved = translation + center;
  const glm::dvec2 origin(scale.x * (c * moved.x - s * moved.y) - center.x,
                          scale.y * (s * moved.x + c * moved.y) - center.y);
  constexpr double kMost = std::numeric_limits<float>::max();
  if (std::abs(origin.x) > kMost || std::abs(origin.y) > kMost)
    return bad_node(transform, "moves the texture beyond all size");
  // Columns; the last is where (0, 0) goes.
  return glm::mat3(
      glm::dmat3(scale.x * c, scale.y * s, 0, -scale.x * s, scale.y * c, 0, origin.x, origin.y, 1));
}

Result<std::shared_ptr<const Picture>> read_texture(const NodeView& texture, const UrlBase& base,
                                                    const Limits& limits,
                                                    Diagnostics& diagnostics) {
  using Shared = std::shared_ptr<const Picture>;
  if (!texture.valid()) return Shared();
  auto picture = load_texture(texture, base, limits);
  if (picture.ok())
    return picture.value().empty() ? Shared()
                                   : std::make_shared<const Picture>(std::move(picture).value());
  const Error& error = picture.error();
  const std::string text = error.file.empty() ? error.text : error.file + ": " + error.text;
  if (error.code == Errc::limit_exceeded) return bad_node(texture, text, error.code);
  diagnostics.warn("texture_not_shown", Place::none(),
                   texture.label() + ": " + text + "; it is drawn without");
  return Shared();
}

}  // namespace afx
