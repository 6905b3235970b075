// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/gl/splat_shaders.h"

namespace afx::render {
namespace {

constexpr char kVertex[] = R"(
layout(location = 0) in vec3 offset;  // of the centre from the block's
layout(location = 1) in vec3 half_u;
layout(location = 2) in vec3 half_v;
#ifdef COLOUR
layout(location = 3) in vec3 colour;
flat out vec3 light;
#endif
flat out vec4 splat;  // place, radius, depth of the centre
flat out vec4 sides;  // s and t for each sample
flat out vec4 depths;  // for each sample; nearness
flat out vec2 mixing;  // tolerance, weight

uniform mat3 axes;      // local directions to the camera's system
uniform vec3 block;     // centre of the block, there
uniform float scale;
uniform float tolerance;

struct Half {
  vec2 offset;
  float depth;
};

Half half_of(vec3 centre, vec3 side) {
  vec2 offset = side.xy;
  if (perspective != 0) offset -= centre.xy * (side.z / centre.z);
  return Half(vec2(offset.x, -offset.y) * zoom_at(-centre.z), -side.z);
}

// Makes room for a sample: the longer side at least as long as its disc, the other as high.
void widen(inout vec2 longer, inout vec2 other) {
  float size = length(longer);
  vec2 along = size > 0.0 ? longer / size : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x);
  float height = dot(other, across);
  longer = along * max(size, least_radius);
  float wanted = max(abs(height), least_radius);
  other += across * ((height < 0.0 ? -wanted : wanted) - height);
}

float reach_of(Half u, Half v, float s, float t, float depth) {
  float zoom = 1.0;
  if (perspective != 0) {
    float part = 1.0 + (s * u.depth + t * v.depth) / depth;
    if (part < 1e-6) return 1e18;
    zoom = 1.0 / part;
  }
  vec2 corner = zoom * abs(s * u.offset + t * v.offset);
  return max(corner.x, corner.y);
}

void main() {
  splat = sides = depths = vec4(0.0);
  mixing = vec2(0.0);
#ifdef COLOUR
  light = vec3(0.0);
#endif
  vec3 centre = block + axes * offset, side_u = axes * half_u, side_v = axes * half_v;
  float length_u = length(side_u), length_v = length(side_v);
  if (!in_view(centre, scale * (length_u + length_v))) {
    leave_out();
    return;
  }
  float depth = -centre.z;
  Half u = half_of(centre, scale * side_u), v = half_of(centre, scale * side_v);
  if (dot(u.offset, u.offset) < dot(v.offset, v.offset)) widen(v.offset, u.offset);
  else widen(u.offset, v.offset);
  float area = u.offset.x * v.offset.y - u.offset.y * v.offset.x;
  if (!(abs(area) < 1e37)) {
    leave_out();
    return;
  }
  float radius = max(max(reach_of(u, v, 1.0, 1.0, depth), reach_of(u, v, -1.0, 1.0, depth)),
                     max(reach_of(u, v, 1.0, -1.0, depth), reach_of(u, v, -1.0, -1.0, depth)));
  radius = min(radius, 1e18);
  vec2 s = vec2(v.offset.y, -v.offset.x) / area, t = vec2(-u.offset.y, u.offset.x) / area;
  vec2 at = place(centre);
  float longer = max(length_u, length_v);
  float shorter = longer > 0.0 ? length(cross(side_u / longer, side_v)) : 0.0;
  splat = vec4(at, radius, depth);
  sides = vec4(s, t);
  depths = vec4(s * u.depth + t * v.depth, perspective != 0 ? 1.0 / depth : 0.0, 0.0);
  mixing = vec2(tolerance * 2.0 * shorter, max(longer > 0.0 ? shorter / longer : 0.0, 1e-3));
  float nearest = depth - abs(u.depth) - abs(v.depth);
#ifdef COLOUR
  light = linear(colour);
  nearest -= mixing.x;
#endif
  put(at, radius, nearest);
}
)";

constexpr char kFragment[] = R"(
flat in vec4 splat, sides, depths;
flat in vec2 mixing;

void main() {
  vec2 d = gl_FragCoord.xy - splat.xy;
  float deeper = dot(depths.xy, d);
  float part = depths.z * deeper;
  vec2 st = vec2(dot(sides.xy, d), dot(sides.zw, d));
  if (part + max(abs(st.x), abs(st.y)) > 1.0) discard;
  float k = 1.0 / max(1e-6, 1.0 - part);
  float depth = splat.w + k * deeper;
#ifdef COLOUR
  st *= k;
  add(depth, mixing.x, mixing.y, max(st.x * st.x, st.y * st.y));
#else
  gl_FragDepth = depth * depth_part;
#endif
}
)";

}  // namespace

std::string surfel_vertex_shader() { return splat_vertex_part() + kVertex; }
std::string surfel_fragment_shader() { return splat_fragment_part() + kFragment; }

}  // namespace afx::render
