// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/gl/splat_shaders.h"

namespace afx::render {
namespace {

// A splat is put where the rasterizer finds all samples of the square around it. A quarter of a
// sample more on each side makes up for the rasterizer's own rounding; the fragment shader decides
// what is inside. A point whose centre lies outside of the viewport is not drawn at all, so the
// viewport is larger than the tile, by the radius of the largest point.
constexpr char kVertex[] = R"(
uniform vec2 viewport_corner, viewport_size;  // in samples
uniform vec2 screen;         // size of the tile
uniform vec2 middle;         // of the picture
uniform float focal;         // samples for each unit of length, in perspective at distance 1
uniform int perspective;
uniform float near_plane;
uniform vec2 slope, secant;  // of the sides of the view
uniform float depth_part;    // from distances to the depth buffer
uniform float most_point;    // the largest radius of a point
uniform float least_radius;

float zoom_at(float distance) { return perspective != 0 ? focal / distance : focal; }
vec2 place(vec3 point) { return middle + vec2(point.x, -point.y) * zoom_at(-point.z); }

bool in_view(vec3 centre, float radius) {
  float distance = -centre.z;
  if (!(distance >= near_plane)) return false;
  if (perspective == 0) return true;
  vec2 beyond = abs(centre.xy) - slope * distance;
  return beyond.x <= radius * secant.x && beyond.y <= radius * secant.y;
}

void leave_out() {
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
#ifndef QUADS
  gl_PointSize = 1.0;
#endif
}

void put(vec2 at, float radius, float nearest) {
#ifdef QUADS
  if (!(radius > most_point)) {
    leave_out();
    return;
  }
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  vec2 to = clamp(at + corner * (radius + 0.25), vec2(-1.0), screen + 1.0);
#else
  if (!(radius <= most_point)) {
    leave_out();
    return;
  }
  vec2 to = at;
  gl_PointSize = 2.0 * radius + 0.125;
#endif
  float depth = clamp(nearest * depth_part * 0.999999, 0.0, 1.0);
  gl_Position = vec4((to - viewport_corner) / viewport_size * 2.0 - 1.0, depth * 2.0 - 1.0, 1.0);
}

vec3 linear(vec3 srgb) {
  vec3 high = pow((srgb + 0.055) / 1.055, vec3(2.4));
  return mix(srgb / 12.92, high, greaterThan(srgb, vec3(0.04045)));
}
)";

// Flat splats have no tolerance, and what is reckoned twice may differ in the last bits.
constexpr char kFragment[] = R"(
#ifdef DEPTH_IS_GREATER
#extension GL_ARB_conservative_depth : enable
layout(depth_greater) out float gl_FragDepth;
#endif
uniform float depth_part;
#ifdef COLOUR
layout(location = 0) out vec4 sum;  // weight * light, weight
uniform int has_walls;
uniform sampler2D walls;  // depths of opaque shapes
flat in vec3 light;

void add(float depth, float tolerance, float weight, float outer) {
  if (has_walls != 0 &&
      !(depth * depth_part < texelFetch(walls, ivec2(gl_FragCoord.xy), 0).r)) discard;
  gl_FragDepth = (depth - max(tolerance, 3e-7 * depth)) * depth_part;
  float inner = max(0.0, 1.0 - outer);
  weight *= inner * inner + 1e-3;
  sum = vec4(light * weight, weight);
}
#endif
)";

}  // namespace

std::string splat_vertex_part() { return kVertex; }
std::string splat_fragment_part() { return kFragment; }

}  // namespace afx::render
