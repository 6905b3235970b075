// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/gl/splat_shaders.h"

namespace afx::render {
namespace {

constexpr char kVertex[] = R"(
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

constexpr char kFragment[] = R"(
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

}  // namespace

std::string voxel_vertex_shader() { return splat_vertex_part() + kVertex; }
std::string voxel_fragment_shader() { return splat_fragment_part() + kFragment; }

}  // namespace afx::render
