// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// How light falls on shapes, and fog between: the formulas that all renderers share. What is
// written here as C++ a GL renderer has as GLSL. Source: ISO/IEC 14772-1:1997 (VRML97), lighting
// model, PointLight, SpotLight, Fog (clauses not checked).
//
// All is reckoned in the camera's system: the eye in the origin, looking along -z with +y up,
// lengths in world units. Colours are display values (sRGB), 0..1, as VRML97 reckons with them,
// until linear_light() turns them into what is mixed and averaged.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "afx/shape.h"
#include "afx/surroundings.h"
#include "render/lens.h"

namespace afx::render {

/// A light in the camera's system; the fields are those of afx::Light.
struct ViewLight {
  Light::Kind kind = Light::Kind::directional;
  glm::vec3 colour{1};
  float intensity = 1;
  float ambient_intensity = 0;
  glm::vec3 location{0};
  glm::vec3 direction{0, 0, -1};
  glm::vec3 attenuation{1, 0, 0};
  float radius = 0;
  float beam_width = 0;
  float cut_off_angle = 0;
};

/// light   one that check_scene finds right
[[nodiscard]] ViewLight view_light(const Light& light, const Lens& lens);
/// White and directional, along the viewing direction, without ambient light.
[[nodiscard]] inline ViewLight headlight() { return {}; }

/// What reflects light at a point of a surface.
struct Material {
  glm::vec3 diffuse{0.8F};
  glm::vec3 specular{0};
  float ambient_intensity = 0.2F;
  float shininess = 0.2F;
};

/// A point of a surface and how it is seen. Directions have length 1.
struct SurfacePoint {
  glm::vec3 position{0};
  glm::vec3 normal{0, 0, 1};  ///< towards the side that is seen
  glm::vec3 to_eye{0, 0, 1};
};

/// What part of a light comes to a point: attenuation times spot, in 0..1.
///
/// directional     1
/// point, spot     0 farther away than the radius, else 1 / max(1, a + b d + c d^2)
/// spot, besides   by the angle w between the axis and the way to the point: 1 where
///                 w <= beam_width, 0 where w >= cut_off_angle,
///                 else (w - cut_off_angle) / (beam_width - cut_off_angle)
[[nodiscard]] float arriving(const ViewLight& light, const glm::vec3& point);

/// What a surface sends from one light to the eye; not clamped. With N the normal, L the way to the
/// light, V that to the eye, i = intensity, ia = ambient intensity:
///
///   arriving * colour * (ia * material.ambient_intensity * diffuse + i * diffuse * max(0, N.L)
///                        + i * specular * max(0, N.H)^(128 * shininess)),   H = (L + V) / |L + V|
///
/// The last term only where N.L > 0, as OpenGL has it: else surfaces that the light does not reach
/// would shine.
[[nodiscard]] glm::vec3 reflected(const ViewLight& light, const Material& material,
                                  const SurfacePoint& point);

/// A colour as a shape has it at a point before light falls on it.
struct SurfaceColour {
  glm::vec3 colour{1};  ///< lit: diffuse; else what is shown
  float opacity = 1;    ///< 0..1
};

/// The colour by VRML97's tables of what replaces and what multiplies what. Triangles: the corners'
/// colour or the diffuse one, where a texture has not its own. Lines, points: the corners' colour
/// or the emissive one; they have no textures.
///
/// corner       the colour between the corners', or null
/// texel        the texture's colour and opacity there, straight, or null
/// components   of the texture, 1..4
[[nodiscard]] SurfaceColour surface_colour(const Look& look, Geometry::Kind kind,
                                           const glm::vec3* corner, const glm::vec4* texel,
                                           uint32_t components);

/// How much of a colour fog leaves at a distance from the eye, 0..1:
/// (V - d) / V or exp(-d / (V - d)); from d = V on nothing. The rest is the fog's colour. Both are
/// mixed in linear light, as all is here that lies before something else.
[[nodiscard]] float fog_leaves(const Fog& fog, float distance);

/// Linear light of display values, which are clamped to 0..1; right to 1e-6.
[[nodiscard]] glm::vec3 linear_light(const glm::vec3& display);

}  // namespace afx::render
