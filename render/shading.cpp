// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/shading.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "afx/srgb.h"

namespace afx::render {
namespace {

float to_float(double value) {
  constexpr double kMost = std::numeric_limits<float>::max();
  return static_cast<float>(std::clamp(value, -kMost, kMost));
}

glm::vec3 to_float(const glm::dvec3& v) { return {to_float(v.x), to_float(v.y), to_float(v.z)}; }

float spot(const ViewLight& light, const glm::vec3& from_light) {
  const float angle = std::acos(std::clamp(glm::dot(from_light, light.direction), -1.0F, 1.0F));
  if (angle >= light.cut_off_angle) return 0;
  if (angle <= light.beam_width) return 1;
  return (angle - light.cut_off_angle) / (light.beam_width - light.cut_off_angle);
}

/// The way to the light, of length 1; where the point is the light itself, along the normal.
glm::vec3 to_light(const ViewLight& light, const SurfacePoint& point) {
  if (light.kind == Light::Kind::directional) return -light.direction;
  const glm::vec3 way = light.location - point.position;
  const float length = glm::length(way);
  return length > 0 ? way / length : point.normal;
}

/// pow in double: its last bits differ between machines, those of a float then hardly ever do.
float power(float base, float exponent) {
  return static_cast<float>(std::pow(static_cast<double>(base), static_cast<double>(exponent)));
}

constexpr size_t kSteps = 4096;  // an arc of the sRGB curve this short is straight to 3e-8

std::array<float, kSteps + 2> make_curve() {
  std::array<float, kSteps + 2> curve{};
  for (size_t k = 0; k <= kSteps; ++k)
    curve[k] = srgb_to_linear(static_cast<float>(k) / static_cast<float>(kSteps));
  curve[kSteps + 1] = 1;
  return curve;
}

}  // namespace

ViewLight view_light(const Light& light, const Lens& lens) {
  ViewLight view;
  view.kind = light.kind;
  view.colour = light.colour;
  view.intensity = light.intensity;
  view.ambient_intensity = light.ambient_intensity;
  view.location = to_float(lens.to_view * (light.location - lens.position));
  view.direction = to_float(glm::normalize(lens.to_view * light.direction));
  view.attenuation = to_float(light.attenuation);
  view.radius = to_float(light.radius);
  view.beam_width = to_float(light.beam_width);
  view.cut_off_angle = to_float(light.cut_off_angle);
  return view;
}

float arriving(const ViewLight& light, const glm::vec3& point) {
  if (light.kind == Light::Kind::directional) return 1;
  const glm::vec3 way = point - light.location;
  const float d = glm::length(way);
  if (!(d <= light.radius)) return 0;
  const glm::vec3& by = light.attenuation;
  const float part = 1 / std::max(1.0F, by.x + by.y * d + by.z * d * d);
  return light.kind == Light::Kind::spot && d > 0 ? part * spot(light, way / d) : part;
}

glm::vec3 reflected(const ViewLight& light, const Material& material, const SurfacePoint& point) {
  const float part = arriving(light, point.position);
  if (part == 0) return glm::vec3(0);
  glm::vec3 sum = light.ambient_intensity * material.ambient_intensity * material.diffuse;
  const glm::vec3 way = to_light(light, point);
  const float cosine = glm::dot(point.normal, way);
  if (cosine > 0) {
    sum += light.intensity * cosine * material.diffuse;
    const glm::vec3 half = way + point.to_eye;
    const float length = glm::length(half);
    if (material.specular != glm::vec3(0) && length > 0) {
      const float shine = std::max(0.0F, glm::dot(point.normal, half) / length);
      sum += light.intensity * power(shine, 128 * material.shininess) * material.specular;
    }
  }
  return part * light.colour * sum;
}

SurfaceColour surface_colour(const Look& look, Geometry::Kind kind, const glm::vec3* corner,
                             const glm::vec4* texel, uint32_t components) {
  const bool flat = kind == Geometry::Kind::triangles;
  SurfaceColour result{flat ? look.diffuse : look.emissive, 1 - look.transparency};
  if (corner != nullptr) result.colour = *corner;
  if (texel == nullptr || !flat) return result;
  const glm::vec3 own(*texel);
  result.colour = components >= 3 ? own : own * result.colour;
  if (components % 2 == 0) result.opacity = texel->w;
  return result;
}

float fog_leaves(const Fog& fog, float distance) {
  const auto range = to_float(fog.visibility_range);
  if (!(distance < range)) return 0;
  const float left = range - distance;
  if (!fog.exponential) return left / range;
  return static_cast<float>(std::exp(-static_cast<double>(distance / left)));
}

glm::vec3 linear_light(const glm::vec3& display) {
  static const std::array<float, kSteps + 2> curve = make_curve();
  glm::vec3 light;
  for (int k = 0; k < 3; ++k) {
    const float at = display[k] > 0 ? std::min(display[k], 1.0F) * static_cast<float>(kSteps) : 0;
    const auto step = static_cast<size_t>(at);
    light[k] = curve[step] + (curve[step + 1] - curve[step]) * (at - static_cast<float>(step));
  }
  return light;
}

}  // namespace afx::render
