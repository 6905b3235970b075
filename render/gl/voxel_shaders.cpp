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
layout(location = 7) in vec3 normal;  // of the facet, parts of 127
layout(location = 8) in vec3 shift;
flat out vec4 disc;  // place, depth of the centre, bulge
flat out vec3 form;  // a, b, c of Tilt (render/splats.h), with y upwards
flat out vec3 lean;  // depth_x, depth_y, nearness

// Of the level of the nodes, the one above it, and that above: a cell near the eye, and the
// centre of that cell in the camera's system. Centres are reckoned from there, so that they are the
// more exact the nearer they are.
uniform ivec3 anchor0, anchor1, anchor2;
uniform vec3 centre0, centre1, centre2;
uniform mat3 axes;       // one step from cell to cell
uniform mat3 diagonals;  // three of the four, from the centre to a corner
uniform vec3 diagonal3;
uniform float reach, half_depth, flat_radius, facet_radius, bulge, tolerance, scale, ball;
uniform mat3 to_shift, normals;
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

// A disc that faces the viewer; returns its radius.
float face_viewer(vec3 centre, float distance) {
  float radius = clamp(radius_of(centre, distance) * scale, least_radius, 1e18);
  float inverse = 1.0 / (radius * radius);
  form = vec3(inverse, 0.0, inverse);
  lean = vec3(0.0);
  disc.w = bulge;
  return radius;
}

// A disc at right angles to n, as OctreeView::tilt has it; returns how far it is seen around its
// place, and in `deep` how much nearer than its centre it may be.
float stand_on(vec3 n, vec3 centre, float distance, out float deep) {
  float w = 1.0 / zoom_at(distance);  // scene units of a sample
  float radius = max(facet_radius, least_radius * w);
  vec3 ray = perspective != 0 ? vec3(centre.xy / distance, -1.0) : vec3(0.0, 0.0, -1.0);
  float straight = dot(n, ray);
  float facing = max(abs(straight), least_radius * w / radius * ((1.0 + dot(ray, ray)) / 2.0));
  if (straight < 0.0) facing = -facing;
  lean = vec3(-w * n.xy / facing, perspective != 0 ? 1.0 / distance : 0.0);
  vec3 along_x = lean.x * ray + vec3(w, 0.0, 0.0);
  vec3 along_y = lean.y * ray + vec3(0.0, w, 0.0);
  form = vec3(dot(along_x, along_x), dot(along_x, along_y), dot(along_y, along_y)) /
         (radius * radius);
  disc.w = 0.0;
  deep = radius * length(n.xy);
  float part = 1.0 - radius * lean.z;
  if (part <= 0.25) return 1e18;
  return radius / w * (1.0 + dot(ray.xy, ray.xy) / 2.0) / part;
}

void main() {
  ivec3 at = ivec3(uvec3(cell.x, cell.x >> 21 | cell.y << 11, cell.y >> 10) & 0x1fffffu);
  disc = vec4(0.0);
  form = lean = vec3(0.0);
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
  vec3 centre = centre0 + axes * vec3(at - anchor0) + to_shift * shift;
  // What is clearly before the eye is wanted wherever its disc touches the picture.
  bool far = -parent.z > 8.0 * reach && -parent.z - 4.0 * reach > near_plane;
  if (!far && !in_view(centre, ball)) {
    leave_out();
    return;
  }
  float distance = -centre.z;
  vec2 middle_of_disc = place(centre);
  disc.xyz = vec3(middle_of_disc, distance);
  vec3 n = normals * normal;
  float square = dot(n, n);
  float deep = 0.0;
  float radius = scale > 0.0 && square > 0.0 ? stand_on(n / sqrt(square), centre, distance, deep)
                                             : face_viewer(centre, distance);
#ifdef COLOUR
#ifdef SIDES
  light = seen_from(perspective != 0 ? -parent : vec3(0.0, 0.0, 1.0));
#else
  light = linear(colour);
#endif
  put(middle_of_disc, radius, distance - deep - tolerance);
#else
  put(middle_of_disc, radius, distance - deep);
#endif
}
)";

constexpr char kFragment[] = R"(
flat in vec4 disc;
flat in vec3 form;
flat in vec3 lean;
uniform float tolerance;

void main() {
  vec2 d = vec2(gl_FragCoord.x - disc.x, disc.y - gl_FragCoord.y);
  float deeper = dot(lean.xy, d);
  float k = 1.0 / max(1e-6, 1.0 - lean.z * deeper);
  float outer = k * k * (d.x * (form.x * d.x + 2.0 * form.y * d.y) + form.z * d.y * d.y);
  if (outer > 1.0) discard;
  float depth = disc.z + k * deeper + disc.w * outer;
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
