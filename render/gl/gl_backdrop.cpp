// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/gl/gl_backdrop.h"

#include <algorithm>
#include <vector>

#include "render/sky.h"

namespace afx::render {
namespace {

enum Unit : int { colours_unit = 5, first_picture_unit = 6 };

constexpr char kPart[] = R"(
uniform int has_backdrop;
uniform mat3 ray_from;  // (x, y, 1) in samples to the backdrop's system
uniform sampler2D sky;  // row 0: sky, row 1: ground; colours, and angles from where they are
uniform int sky_count, ground_count;
uniform sampler2D face0, face1, face2, face3, face4, face5;
uniform int face_is_there[6];
uniform float pixel;    // its side in samples

vec3 sky_linear(vec3 display) {
  vec3 at = clamp(display, 0.0, 1.0);
  vec3 high = pow((at + 0.055) / 1.055, vec3(2.4));
  return mix(at / 12.92, high, greaterThan(at, vec3(0.04045)));
}

vec3 gradient(int row, int count, float angle) {
  vec4 before = texelFetch(sky, ivec2(0, row), 0);
  for (int k = 1; k < count; ++k) {
    vec4 next = texelFetch(sky, ivec2(k, row), 0);
    if (angle < next.a)
      return mix(before.rgb, next.rgb, (angle - before.a) / (next.a - before.a));
    before = next;
  }
  return before.rgb;
}

vec3 sky_colour(vec3 ray) {
  // The arc cosine loses digits near the poles.
  float angle = atan(length(ray.xz), ray.y), from_nadir = 3.14159265 - angle;
  if (ground_count > 1 && from_nadir <= texelFetch(sky, ivec2(ground_count - 1, 1), 0).a)
    return gradient(1, ground_count, from_nadir);
  return gradient(0, sky_count, angle);
}

int face_of(vec3 ray) {
  vec3 size = abs(ray);
  int face = ray.z > 0.0 ? 1 : 0;
  if (size.x > size.z && size.x >= size.y) face = ray.x > 0.0 ? 3 : 2;
  if (size.y > size.z && size.y > size.x) face = ray.y > 0.0 ? 4 : 5;
  return face;
}

vec2 place_on_face(int face, vec3 ray) {
  vec3 at;  // to the right, up, ahead
  if (face == 0) at = vec3(ray.x, ray.y, -ray.z);
  else if (face == 1) at = vec3(-ray.x, ray.y, ray.z);
  else if (face == 2) at = vec3(-ray.z, ray.y, -ray.x);
  else if (face == 3) at = vec3(ray.z, ray.y, ray.x);
  else if (face == 4) at = vec3(ray.x, ray.z, ray.y);
  else at = vec3(ray.x, -ray.z, -ray.y);
  return (at.xy / at.z + 1.0) / 2.0;
}

vec4 texel(sampler2D picture, vec2 place, vec2 right, vec2 down) {
  vec2 size = vec2(textureSize(picture, 0));
  right *= size;
  down *= size;
  float level = 0.5 * log2(max(max(dot(right, right), dot(down, down)), 1e-20));
  return textureLod(picture, vec2(place.x, 1.0 - place.y), max(level, 0.0));
}

vec3 backdrop_light(vec2 at) {
  vec3 ray = ray_from * vec3(at, 1.0);
  int face = face_of(ray);
  vec4 over = vec4(0.0);
  if (face_is_there[face] != 0) {
    vec2 place = place_on_face(face, ray);
    vec2 right = place_on_face(face, ray + ray_from[0] * pixel) - place;
    vec2 down = place_on_face(face, ray + ray_from[1] * pixel) - place;
    if (face == 0) over = texel(face0, place, right, down);
    else if (face == 1) over = texel(face1, place, right, down);
    else if (face == 2) over = texel(face2, place, right, down);
    else if (face == 3) over = texel(face3, place, right, down);
    else if (face == 4) over = texel(face4, place, right, down);
    else over = texel(face5, place, right, down);
    if (over.a > 0.0) over.rgb /= over.a;
  }
  return mix(sky_linear(sky_colour(ray)), sky_linear(over.rgb), over.a);
}
)";

/// Colours with the angles from where they are; the first is at 0.
std::vector<glm::vec4> row_of(const std::vector<glm::vec3>& colours,
                              const std::vector<float>& angles, size_t width) {
  std::vector<glm::vec4> row(width);
  for (size_t k = 0; k < colours.size(); ++k)
    row[k] = glm::vec4(colours[k], k == 0 || k > angles.size() ? 0 : angles[k - 1]);
  return row;
}

}  // namespace

std::string backdrop_part() { return kPart; }

GlBackdrop::GlBackdrop(const Backdrop* backdrop, const GlPictures& pictures)
    : backdrop_(backdrop), pictures_(pictures) {
  if (backdrop_ == nullptr) return;
  const Backdrop& b = *backdrop_;
  const size_t width = std::max(b.sky_colours.size(), b.ground_colours.size());
  std::vector<glm::vec4> texels = row_of(b.sky_colours, b.sky_angles, width);
  const std::vector<glm::vec4> ground = row_of(b.ground_colours, b.ground_angles, width);
  texels.insert(texels.end(), ground.begin(), ground.end());
  colours_ = GlTexture::make();
  glBindTexture(GL_TEXTURE_2D, colours_.id());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, static_cast<GLsizei>(width), 2, 0, GL_RGBA, GL_FLOAT,
               texels.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

void GlBackdrop::set_uniforms(const GlProgram& program, const GlView& view) const {
  constexpr const char* kFaces[] = {"face0", "face1", "face2", "face3", "face4", "face5"};
  // Samplers of one unit must be of one kind, so they have units of their own in any case.
  program.set("sky", colours_unit);
  for (int k = 0; k < 6; ++k) program.set(kFaces[k], first_picture_unit + k);
  program.set("has_backdrop", backdrop_ == nullptr ? 0 : 1);
  if (backdrop_ == nullptr) return;
  const SkyRays rays(*backdrop_, view.lens);
  const glm::dvec3 first = rays.at(view.corner);
  const glm::dvec3 right = rays.at(view.corner + glm::dvec2(1, 0)) - first;
  const glm::dvec3 down = rays.at(view.corner + glm::dvec2(0, 1)) - first;
  program.set("ray_from", glm::mat3(glm::dmat3(right, down, first)));
  program.set("pixel", static_cast<float>(view.options.samples));
  program.set("sky_count", static_cast<int>(backdrop_->sky_colours.size()));
  program.set("ground_count", static_cast<int>(backdrop_->ground_colours.size()));
  glActiveTexture(GL_TEXTURE0 + colours_unit);
  glBindTexture(GL_TEXTURE_2D, colours_.id());
  std::vector<int> there;
  for (size_t k = 0; k < 6; ++k) {
    const GlPicture* const picture = pictures_.find(backdrop_->pictures[k].get());
    there.push_back(picture == nullptr ? 0 : 1);
    if (picture == nullptr) continue;
    glActiveTexture(GL_TEXTURE0 + first_picture_unit + static_cast<GLenum>(k));
    picture->bind(false, false);
  }
  program.set("face_is_there", there);
  glActiveTexture(GL_TEXTURE0);
}

}  // namespace afx::render
