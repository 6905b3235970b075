// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/gl/shape_shaders.h"

#include "render/gl/splat_shaders.h"

namespace afx::render {
namespace {

// See fog_leaves() in render/shading.h.
constexpr char kFog[] = R"(
uniform int has_fog, fog_is_exponential;
uniform float fog_range;
uniform vec3 fog_light;
uniform vec2 fog_middle;  // of the picture, in samples
uniform float fog_slope;  // one sample at distance 1; 0 in parallel projection

float fog_leaves(vec2 at, float depth) {
  vec2 slopes = (at - fog_middle) * fog_slope;
  float distance = depth * sqrt(1.0 + dot(slopes, slopes));
  if (!(distance < fog_range)) return 0.0;
  float left = fog_range - distance;
  return fog_is_exponential != 0 ? exp(-distance / left) : left / fog_range;
}
)";

constexpr char kVertex[] = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 colour;
#ifdef BANDS
layout(location = 2) in vec3 other_position;
layout(location = 3) in vec3 other_colour;
uniform float half_width;  // in samples
uniform int is_line;
#else
layout(location = 2) in vec3 normal;
layout(location = 3) in vec2 place_in_texture;
#endif
uniform mat3 axes;    // local directions to the camera's system
uniform vec3 origin;  // of the local system, there
uniform mat3 normals;

out vec3 seen_at, seen_colour, seen_normal;
out vec2 seen_place;

// In perspective the graphics system cuts off what is before the near plane and divides by w, the
// distance; so all is mixed between corners as it lies in space.
void show(vec3 at, vec2 aside) {
  float w = perspective != 0 ? -at.z : 1.0;
  vec2 on_screen = vec2(at.x, -at.y) * focal + (middle + aside - viewport_corner) * w;
  float z = perspective != 0 ? w - 2.0 * near_plane
                             : (-at.z - near_plane) * depth_part * 2.0 - 1.0;
  gl_Position = vec4(on_screen / viewport_size * 2.0 - w, z, w);
  seen_at = at;
}

#ifdef BANDS
void main() {
  seen_normal = vec3(0.0);
  seen_place = vec2(0.0);
  seen_at = vec3(0.0);
  seen_colour = colour;
  vec3 a = axes * position + origin, b = axes * other_position + origin;
  float before = near_plane + a.z, other_before = near_plane + b.z;
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  if (is_line == 0) {
    if (before <= 0.0) show(a, corner * half_width);
    return;
  }
  if (before > 0.0 && other_before > 0.0) return;
  // Cut off at the near plane, as exactly as it can be had, for the division below.
  vec3 from = a, to = b;
  float first = 0.0, last = 1.0;
  if (before > 0.0) first = before / (before - other_before);
  if (other_before > 0.0) last = before / (before - other_before);
  if (before > 0.0) from = vec3(mix(a.xy, b.xy, first), -near_plane);
  if (other_before > 0.0) to = vec3(mix(a.xy, b.xy, last), -near_plane);
  vec2 way = place(to) - place(from);
  float size = length(way);
  if (!(size > 0.0)) return;
  vec2 across = vec2(-way.y, way.x) / size * half_width;
  seen_colour = mix(colour, other_colour, corner.y < 0.0 ? first : last);
  show(corner.y < 0.0 ? from : to, across * corner.x);
  gl_Position.z = max(gl_Position.z, -gl_Position.w);
}
#else
void main() {
  seen_colour = colour;
  seen_normal = normals * normal;
  seen_place = place_in_texture;
  show(axes * position + origin, vec2(0.0));
}
#endif
)";

// See reflected() and surface_colour() in render/shading.h, and MipPicture.
constexpr char kFragment[] = R"(
layout(location = 0) out vec4 shown;
in vec3 seen_at, seen_colour, seen_normal;
in vec2 seen_place;
uniform float depth_part;
uniform int perspective;
uniform float samples;  // along the side of a pixel
uniform int is_lit, has_colours, components;
uniform vec3 own_colour, specular, emissive;
uniform float ambient_intensity, shininess, opacity;
uniform sampler2D picture;
uniform vec2 picture_size;
uniform mat3 texture_transform;
uniform int has_headlight, light_count;
uniform int light_numbers[64];
uniform sampler2D lights;

vec3 linear(vec3 display) {
  vec3 at = clamp(display, 0.0, 1.0);
  vec3 high = pow((at + 0.055) / 1.055, vec3(2.4));
  return mix(at / 12.92, high, greaterThan(at, vec3(0.04045)));
}

float spot(float angle, vec2 widths) {
  if (angle >= widths.y) return 0.0;
  if (angle <= widths.x) return 1.0;
  return (angle - widths.y) / (widths.x - widths.y);
}

vec3 from_light(vec3 sent, float part, vec2 intensities, vec3 way, vec3 diffuse, vec3 normal,
                vec3 to_eye) {
  vec3 sum = intensities.y * ambient_intensity * diffuse;
  float cosine = dot(normal, way);
  if (cosine > 0.0) {
    sum += intensities.x * cosine * diffuse;
    vec3 between = way + to_eye;
    float size = length(between);
    if (size > 0.0 && specular != vec3(0.0)) {
      float shine = max(0.0, dot(normal, between) / size), power = 128.0 * shininess;
      float part_of_shine = power == 0.0 ? 1.0 : shine > 0.0 ? pow(shine, power) : 0.0;
      sum += intensities.x * part_of_shine * specular;
    }
  }
  return part * sent * sum;
}

vec3 from_light_number(int number, vec3 diffuse, vec3 normal, vec3 to_eye) {
  vec4 sent = texelFetch(lights, ivec2(0, number), 0);         // colour, kind
  vec4 location = texelFetch(lights, ivec2(1, number), 0);     // and intensity
  vec4 direction = texelFetch(lights, ivec2(2, number), 0);    // and ambient intensity
  vec4 attenuation = texelFetch(lights, ivec2(3, number), 0);  // and radius
  vec2 widths = texelFetch(lights, ivec2(4, number), 0).xy;
  float part = 1.0;
  vec3 way = -direction.xyz;
  if (sent.a > 0.0) {
    vec3 from = seen_at - location.xyz;
    float d = length(from);
    if (!(d <= attenuation.w)) return vec3(0.0);
    part = 1.0 / max(1.0, attenuation.x + attenuation.y * d + attenuation.z * d * d);
    way = d > 0.0 ? -from / d : normal;
    if (sent.a > 1.0 && d > 0.0)
      part *= spot(acos(clamp(dot(from / d, direction.xyz), -1.0, 1.0)), widths);
  }
  return from_light(sent.rgb, part, vec2(location.w, direction.w), way, diffuse, normal, to_eye);
}

vec3 lit(vec3 diffuse) {
  vec3 to_eye = perspective != 0 ? -normalize(seen_at) : vec3(0.0, 0.0, 1.0);
  float size = length(seen_normal);
  vec3 normal = size > 0.0 ? seen_normal / size : to_eye;
  if (!gl_FrontFacing) normal = -normal;
  vec3 sum = emissive;
  if (has_headlight != 0)
    sum += from_light(vec3(1.0), 1.0, vec2(1.0, 0.0), vec3(0.0, 0.0, 1.0), diffuse, normal, to_eye);
  for (int k = 0; k < light_count; ++k)
    sum += from_light_number(light_numbers[k], diffuse, normal, to_eye);
  return sum;
}

vec4 texel() {
  vec2 place = (texture_transform * vec3(seen_place, 1.0)).xy;
  vec2 right = dFdx(place) * picture_size * samples, down = dFdy(place) * picture_size * samples;
  float level = 0.5 * log2(max(max(dot(right, right), dot(down, down)), 1e-20));
  vec4 found = textureLod(picture, vec2(place.x, 1.0 - place.y), max(level, 0.0));
  return found.a > 0.0 ? vec4(found.rgb / found.a, found.a) : vec4(0.0);
}

void main() {
  float depth = -seen_at.z;
  gl_FragDepth = depth * depth_part;
  vec4 surface = vec4(has_colours != 0 ? seen_colour : own_colour, opacity);
  if (components > 0) {
    vec4 found = texel();
    surface.rgb = components >= 3 ? found.rgb : found.rgb * surface.rgb;
    if (components % 2 == 0) surface.a = found.a;
  }
  if (is_lit != 0) surface.rgb = lit(surface.rgb);
  vec3 light = linear(surface.rgb);
#ifdef GLASS
  if (has_fog != 0) light = mix(fog_light, light, fog_leaves(gl_FragCoord.xy, depth));
  shown = vec4(light * surface.a, surface.a);
#else
  shown = vec4(light, 1.0);
#endif
}
)";

}  // namespace

std::string fog_part() { return kFog; }
std::string shape_vertex_shader() { return splat_vertex_part() + kVertex; }
std::string shape_fragment_shader() { return kFog + std::string(kFragment); }

}  // namespace afx::render
