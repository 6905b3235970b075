// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/shapes/light_nodes.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "afx/shapes/field_reader.h"
#include "afx/shapes/matrix_parts.h"

namespace afx {
namespace {

using nodes::NodeView;

glm::dvec3 direction_in(const glm::dmat4& to_world, glm::dvec3 direction) {
  if (!(glm::length(direction) > 0)) direction = {0, 0, -1};
  const glm::dvec3 turned = glm::dmat3(to_world) * direction;
  const double length = glm::length(turned);
  return length > 0 && std::isfinite(length) ? turned / length : glm::normalize(direction);
}

void read_place(FieldReader& fields, const glm::dmat4& to_world, Light& light) {
  const double scale = uniform_scale(to_world);
  light.location = glm::dvec3(to_world * glm::dvec4(fields.finite3("location"), 1));
  light.radius = static_cast<double>(fields.at_least("radius", 0)) * scale;
  light.attenuation = glm::dvec3(fields.sizes3("attenuation"));
  if (!(scale > 0)) return;
  // The same at a world distance of scale * d as at d where the node stands.
  light.attenuation.y /= scale;
  light.attenuation.z /= scale * scale;
}

}  // namespace

Result<Light> read_light(const NodeView& node, const glm::dmat4& to_world) {
  Light light;
  FieldReader fields(node);
  light.colour = fields.colour("color");
  light.intensity = fields.clamped("intensity", 0, 1);
  light.ambient_intensity = fields.clamped("ambientIntensity", 0, 1);
  light.kind = node.type() == "PointLight"  ? Light::Kind::point
               : node.type() == "SpotLight" ? Light::Kind::spot
                                            : Light::Kind::directional;
  if (light.kind != Light::Kind::directional) read_place(fields, to_world, light);
  if (light.kind != Light::Kind::point)
    light.direction = direction_in(to_world, glm::dvec3(fields.finite3("direction")));
  if (light.kind == Light::Kind::spot) {
    constexpr auto kQuarterTurn = static_cast<float>(std::numbers::pi / 2);
    light.beam_width = fields.clamped("beamWidth", 0, kQuarterTurn);
    light.cut_off_angle = fields.clamped("cutOffAngle", 0, kQuarterTurn);
  }
  if (!fields.ok()) return fields.error();
  return light;
}

}  // namespace afx
