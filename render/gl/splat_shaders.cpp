// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/gl/splat_shaders.h"

namespace afx::render {
namespace {

// A splat is put where the rasterizer finds all samples of the square around it. A quarter of a
// sample more on each side makes up for the rasterizer's own rounding; the fragment shader decides
// what is inside. A point whose centre lies outside of the viewport is not drawn at all, so the
// viewport is larger than the tile, by the radius of the largest point.
constexpr char kVertexCommon[] = R"(
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
  gl_PointSize = 2.0 * radius + 0.5;
#endif
  float depth = clamp(nearest * depth_part * 0.999999, 0.0, 1.0);
  gl_Position = vec4((to - viewport_corner) / viewport_size * 2.0 - 1.0, depth * 2.0 - 1.0, 1.0);
}

vec3 linear(vec3 srgb) {
  return mix(srgb / 12.92, pow((srgb + 0.055) / 1.055, vec3(2.4)), greaterThan(srgb, vec3(0.04045)));
}
)";

constexpr char kVoxelVertex[] = R"(
layout(location = 0) in uvec2 cell;  // x, y, z of 21 bits each, from the lowest bit on
#ifdef COLOUR
layout(location = 1) in vec3 colour;  // of voxels; from +x
#ifdef SIDES
layout(location = 2) in vec3 colour1;
layout(location = 3) in vec3 colour2;
layout(location = 4) in vec3 colour3;
layout(location = 5) in vec3 colour4;
layout(location = 6) in vec3 colour5;
#endif
flat out vec3 light;
#endif
flat out vec4 disc;  // place, 1 / radius^2, depth of the centre

// Of the level of the nodes, the one above it, and that above: a cell near the eye, and the
// centre of that cell in the camera's system. Centres are reckoned from there, so that they are the
// more exact the nearer they are.
uniform ivec3 anchor0, anchor1, anchor2;
uniform vec3 centre0, centre1, centre2;
uniform mat3 axes;       // one step from cell to cell
uniform mat3 diagonals;  // three of the four, from the centre to a corner
uniform vec3 diagonal3;
uniform float reach, half_depth, flat_radius, bulge, tolerance, scale, ball;
uniform vec2 last_from;  // nodes of this level and the one above are drawn as they are from these
                         // distances of their parents on
uniform mat3 to_cube;

float squared(vec2 slopes, vec3 h) {
  vec2 d = h.xy + slopes * h.z;
  return dot(d, d);
}

float radius_of(vec3 centre, float distance) {
  if (perspective == 0) return flat_radius;
  if (distance < 2.0 * half_depth) return focal * reach / distance;
  vec2 slopes = centre.xy / distance;
  float longest = max(max(squared(slopes, diagonals[0]), squared(slopes, diagonals[1])),
                      max(squared(slopes, diagonals[2]), squared(slopes, diagonal3)));
  return focal * sqrt(longest) / (distance - half_depth);
}

#ifdef SIDES
vec3 seen_from(vec3 eye) {
  vec3 to_eye = to_cube * eye;
  float square = dot(to_eye, to_eye);
  if (!(square > 0.0)) return linear(colour);
  vec3 part = to_eye * to_eye / square;
  return part.x * linear(to_eye.x < 0.0 ? colour1 : colour) +
         part.y * linear(to_eye.y < 0.0 ? colour3 : colour2) +
         part.z * linear(to_eye.z < 0.0 ? colour5 : colour4);
}
#endif

void main() {
  ivec3 at = ivec3(uvec3(cell.x, cell.x >> 21 | cell.y << 11, cell.y >> 10) & 0x1fffffu);
  disc = vec4(0.0);
#ifdef COLOUR
  light = vec3(0.0);
#endif
  vec3 parent = centre1 + 2.0 * axes * vec3((at >> 1) - anchor1);
  vec3 above = centre2 + 4.0 * axes * vec3((at >> 2) - anchor2);
  // Where rounding leaves it open both levels are drawn rather than neither.
  if (-parent.z < last_from.x * 0.999998 || -above.z >= last_from.y * 1.000002) {
    leave_out();
    return;
  }
  vec3 centre = centre0 + axes * vec3(at - anchor0);
  // What is clearly before the eye is wanted wherever its disc touches the picture.
  bool far = -parent.z > 8.0 * reach && -parent.z - 4.0 * reach > near_plane;
  if (!far && !in_view(centre, ball)) {
    leave_out();
    return;
  }
  float distance = -centre.z;
  float radius = clamp(radius_of(centre, distance) * scale, least_radius, 1e18);
  vec2 middle_of_disc = place(centre);
  disc = vec4(middle_of_disc, 1.0 / (radius * radius), distance);
#ifdef COLOUR
#ifdef SIDES
  light = seen_from(perspective != 0 ? -parent : vec3(0.0, 0.0, 1.0));
#else
  light = linear(colour);
#endif
  put(middle_of_disc, radius, distance - tolerance);
#else
  put(middle_of_disc, radius, distance);
#endif
}
)";

// Flat splats have no tolerance, and what is reckoned twice may differ in the last bits.
constexpr char kFragmentCommon[] = R"(
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

constexpr char kVoxelFragment[] = R"(
flat in vec4 disc;
uniform float bulge, tolerance;

void main() {
  vec2 d = gl_FragCoord.xy - disc.xy;
  float outer = dot(d, d) * disc.z;
  if (outer > 1.0) discard;
  float depth = disc.w + bulge * outer;
#ifdef COLOUR
  add(depth, tolerance, 1.0, outer);
#else
  gl_FragDepth = depth * depth_part;
#endif
}
)";

constexpr char kSurfelVertex[] = R"(
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

constexpr char kSurfelFragment[] = R"(
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

std::string voxel_vertex_shader() { return std::string(kVertexCommon) + kVoxelVertex; }
std::string voxel_fragment_shader() { return std::string(kFragmentCommon) + kVoxelFragment; }
std::string surfel_vertex_shader() { return std::string(kVertexCommon) + kSurfelVertex; }
std::string surfel_fragment_shader() { return std::string(kFragmentCommon) + kSurfelFragment; }

}  // namespace afx::render
