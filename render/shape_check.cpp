// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/shape_check.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

namespace afx::render {
namespace {

Error bad(const std::string& text) { return {Errc::bad_argument, Place::none(), text}; }

template <class Vector>
bool is_finite(const Vector& v) {
  for (int k = 0; k < Vector::length(); ++k)
    if (!std::isfinite(v[k])) return false;
  return true;
}

template <class Vector>
bool all_finite(const std::vector<Vector>& list) {
  return std::all_of(list.begin(), list.end(), is_finite<Vector>);
}

Status check_part(double value, const std::string& what) {
  if (value >= 0 && value <= 1) return {};
  return bad(what + " is " + std::to_string(value) + " (expected 0 to 1)");
}

Status check_picture(const Picture* picture, const std::string& whose) {
  if (picture == nullptr) return {};
  const bool fits =
      picture->components >= 1 && picture->components <= 4 && picture->width > 0 &&
      picture->height > 0 &&
      picture->samples.size() / picture->components / picture->width == picture->height &&
      picture->samples.size() % (size_t{picture->components} * picture->width) == 0;
  if (fits) return {};
  return bad("the picture of a " + whose + " has " + std::to_string(picture->samples.size()) +
             " samples for " + std::to_string(picture->width) + " x " +
             std::to_string(picture->height) + " pixels of " + std::to_string(picture->components) +
             " components");
}

Status check_lists(const Geometry& geometry) {
  const size_t count = geometry.positions.size();
  const auto fits = [count](size_t size) { return size == 0 || size == count; };
  if (!fits(geometry.normals.size()) || !fits(geometry.texture_coordinates.size()) ||
      !fits(geometry.colours.size())) {
    return bad("a shape of " + std::to_string(count) +
               " corners with other numbers of normals, texture coordinates or colours");
  }
  if (geometry.kind == Geometry::Kind::triangles && geometry.normals.size() != count)
    return bad("triangles without normals");
  if (!all_finite(geometry.positions)) return bad("a shape with a position that is not finite");
  if (!all_finite(geometry.normals) || !all_finite(geometry.texture_coordinates) ||
      !all_finite(geometry.colours))
    return bad("a shape with a normal, texture coordinate or colour that is not finite");
  return {};
}

Status check_geometry(const Geometry& geometry) {
  if (Status s = check_lists(geometry); !s.ok()) return s;
  if (geometry.indices.size() % corners_of(geometry.kind) != 0)
    return bad("a shape whose indices end inside of a primitive");
  const size_t count = geometry.positions.size();
  for (const uint32_t index : geometry.indices) {
    if (index >= count) {
      return bad("a shape names corner " + std::to_string(index) + " (expected below " +
                 std::to_string(count) + ")");
    }
  }
  return {};
}

Status check_look(const Look& look) {
  if (!is_finite(look.diffuse) || !is_finite(look.specular) || !is_finite(look.emissive))
    return bad("a look with a colour that is not finite");
  for (const auto& [value, what] :
       {std::pair{look.ambient_intensity, "ambient intensity"},
        std::pair{look.shininess, "shininess"}, std::pair{look.transparency, "transparency"}}) {
    if (Status s =
            check_part(static_cast<double>(value), std::string("the ") + what + " of a look");
        !s.ok())
      return s;
  }
  for (int column = 0; column < 3; ++column)
    if (!is_finite(look.texture_transform[column]))
      return bad("the texture transform of a look is not finite");
  return check_picture(look.texture.get(), "look");
}

/// Angles from 0 to pi, each not less than the one before.
bool are_rising(const std::vector<float>& angles) {
  constexpr float kMostAngle = 3.1416F;
  float before = 0;
  for (const float angle : angles) {
    if (!(angle >= before && angle <= kMostAngle)) return false;
    before = angle;
  }
  return true;
}

Status check_gradient(const std::vector<glm::vec3>& colours, const std::vector<float>& angles,
                      const std::string& whose) {
  if (colours.size() != angles.size() + 1) {
    return bad(std::to_string(colours.size()) + " colours of the " + whose + " for " +
               std::to_string(angles.size()) + " angles (expected one more)");
  }
  if (!all_finite(colours)) return bad("a colour of the " + whose + " is not finite");
  if (!are_rising(angles))
    return bad("the angles of the " + whose + " do not rise from 0 to at most pi");
  return {};
}

bool is_rotation(const glm::dmat3& m) {
  constexpr double kRounding = 1e-3;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (!(std::abs(glm::dot(m[i], m[j]) - (i == j ? 1 : 0)) < kRounding)) return false;
  return true;
}

}  // namespace

Status check_affine(const glm::dmat4& m, const std::string& whose) {
  bool affine = true;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 3; ++row) affine = affine && std::isfinite(m[column][row]);
    affine = affine && m[column][3] == (column == 3 ? 1 : 0);
  }
  if (affine) return {};
  return bad("the matrix of a " + whose + " is not affine or not finite");
}

Status check_shape(const Shape& shape, size_t lights) {
  if (shape.geometry == nullptr || shape.look == nullptr)
    return bad("a shape without geometry or look");
  for (const uint32_t light : shape.lights) {
    if (light >= lights) {
      return bad("a shape names light " + std::to_string(light) + " (expected below " +
                 std::to_string(lights) + ")");
    }
  }
  if (Status s = check_geometry(*shape.geometry); !s.ok()) return s;
  if (Status s = check_look(*shape.look); !s.ok()) return s;
  return check_affine(shape.to_world, "shape");
}

Status check_light(const Light& light) {
  if (!is_finite(light.colour) || !is_finite(light.location) || !is_finite(light.direction) ||
      !is_finite(light.attenuation))
    return bad("a light with a colour, place, direction or attenuation that is not finite");
  for (const auto& [value, what] : {std::pair{light.intensity, "intensity"},
                                    std::pair{light.ambient_intensity, "ambient intensity"}}) {
    if (Status s =
            check_part(static_cast<double>(value), std::string("the ") + what + " of a light");
        !s.ok())
      return s;
  }
  if (light.kind != Light::Kind::point && !(glm::length(light.direction) > 0))
    return bad("a light without a direction");
  if (!(light.radius >= 0)) return bad("a light whose radius is less than 0");
  if (!std::isfinite(light.beam_width) || !std::isfinite(light.cut_off_angle))
    return bad("a light with an angle that is not finite");
  return {};
}

Status check_fog(const Fog& fog) {
  if (!is_finite(fog.colour)) return bad("the colour of the fog is not finite");
  if (fog.visibility_range > 0) return {};
  return bad("the visibility range of the fog is " + std::to_string(fog.visibility_range) +
             " (expected more than 0)");
}

Status check_backdrop(const Backdrop& backdrop) {
  if (Status s = check_gradient(backdrop.sky_colours, backdrop.sky_angles, "sky"); !s.ok())
    return s;
  if (!backdrop.ground_colours.empty() || !backdrop.ground_angles.empty()) {
    Status s = check_gradient(backdrop.ground_colours, backdrop.ground_angles, "ground");
    if (!s.ok()) return s;
  }
  for (const auto& picture : backdrop.pictures)
    if (Status s = check_picture(picture.get(), "backdrop"); !s.ok()) return s;
  if (!is_rotation(backdrop.to_world)) return bad("the matrix of the backdrop is not a rotation");
  return {};
}

}  // namespace afx::render
