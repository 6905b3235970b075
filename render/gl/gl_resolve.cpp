// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/gl/gl_resolve.h"

#include "afx/srgb.h"
#include "render/gl/gl_shapes.h"
#include "render/gl/shape_shaders.h"

namespace afx::render {
namespace {

// A triangle that holds the whole viewport.
constexpr char kVertex[] = R"(
void main() {
  gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0);
}
)";

constexpr char kFragment[] = R"(
layout(location = 0) out vec4 colour;
#ifdef DEPTH
layout(location = 1) out float depth;
#endif
uniform sampler2D sums, depths;
uniform int samples;
uniform ivec2 corner;    // of the viewport
uniform int last_row;    // of the tile where row 0 is its bottom, otherwise -1
uniform vec4 background; // linear
uniform vec3 back_srgb;  // the same as it was given
uniform float depth_part;
uniform int finished;    // samples are colours times their coverage, otherwise sums of splats

vec3 srgb(vec3 linear) {
  vec3 high = 1.055 * pow(max(linear, vec3(1e-9)), vec3(1.0 / 2.4)) - 0.055;
  return mix(linear * 12.92, high, greaterThan(linear, vec3(0.0031308)));
}

// To the nearest of 256 steps, which do not depend on how the framebuffer rounds.
vec4 bytes(vec4 value) { return floor(clamp(value, 0.0, 1.0) * 255.0 + 0.5) / 255.0; }

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy) - corner;
  if (last_row >= 0) at.y = last_row - at.y;
  vec4 mean = vec4(0.0);
  float nearest = 1.0;
  for (int y = 0; y < samples; ++y) {
    for (int x = 0; x < samples; ++x) {
      ivec2 from = at * samples + ivec2(x, y);
      vec4 sum = texelFetch(sums, from, 0);
      if (finished != 0) mean += sum;
      else if (sum.a > 0.0) mean += vec4(sum.rgb / sum.a, 1.0);
#ifdef DEPTH
      nearest = min(nearest, texelFetch(depths, from, 0).r);
#endif
    }
  }
  float count = float(samples * samples);
  if (has_backdrop != 0) {
    if (mean.a < count)
      mean.rgb += (count - mean.a) * backdrop_light((vec2(at) + 0.5) * float(samples));
    mean.a = count;
  }
  float through = (count - mean.a) * background.a;
  float opaque = mean.a + through;
  colour = opaque == 0.0
      ? vec4(back_srgb, 0.0)
      : bytes(vec4(srgb((mean.rgb + through * background.rgb) / opaque), opaque / count));
#ifdef DEPTH
  depth = nearest < 1.0 ? nearest / depth_part : -1.0;  // nothing
#endif
}
)";

// Splats hide walls, which they lie before; fog is mixed into both by the depth.
constexpr char kFinish[] = R"(
layout(location = 0) out vec4 colour;
uniform sampler2D sums, depths, walls, wall_colours;
uniform int has_walls;
uniform float depth_part;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 sum = texelFetch(sums, at, 0);
  colour = vec4(0.0);
  if (sum.a > 0.0) colour = vec4(sum.rgb / sum.a, 1.0);
  else if (has_walls != 0 && texelFetch(walls, at, 0).r < 1.0)
    colour = vec4(texelFetch(wall_colours, at, 0).rgb, 1.0);
  if (has_fog != 0 && colour.a > 0.0) {
    float depth = texelFetch(depths, at, 0).r / depth_part;
    colour.rgb = mix(fog_light, colour.rgb, fog_leaves(gl_FragCoord.xy, depth));
  }
}
)";

glm::vec4 colour_of(Rgba8 c) { return glm::vec4(c.r, c.g, c.b, c.a) / 255.0F; }

}  // namespace

Result<GlResolve> GlResolve::make(const GlFeatures& features) {
  GlResolve resolve;
  auto colours = GlProgram::make(features, "", kVertex, backdrop_part() + kFragment);
  if (!colours.ok()) return colours.error();
  auto depths = GlProgram::make(features, "#define DEPTH\n", kVertex, backdrop_part() + kFragment);
  if (!depths.ok()) return depths.error();
  resolve.colours_ = std::move(colours).value();
  resolve.with_depths_ = std::move(depths).value();
  auto finish = GlProgram::make(features, "", kVertex, fog_part() + kFinish);
  if (!finish.ok()) return finish.error();
  resolve.finish_ = std::move(finish).value();
  resolve.nothing_ = GlArray::make();
  return resolve;
}

void GlResolve::finish(const GlView& view, const Scene& scene, bool walls) const {
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  finish_.use();
  finish_.set("sums", 0);
  finish_.set("depths", 1);
  finish_.set("walls", 2);
  finish_.set("wall_colours", 3);
  finish_.set("has_walls", walls ? 1 : 0);
  finish_.set("depth_part", view.depth_part);
  GlShapes::set_fog(finish_, scene, view);
  glBindVertexArray(nothing_.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void GlResolve::draw(const GlView& view, const GlBackdrop& backdrop, int x, int y, bool top_first,
                     bool depth, bool finished) const {
  const Rgba8 back = view.options.background;
  const glm::vec4 srgb = colour_of(back);
  const GlProgram& program = depth ? with_depths_ : colours_;
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  program.use();
  backdrop.set_uniforms(program, view);
  program.set("finished", finished ? 1 : 0);
  program.set("sums", 0);
  program.set("depths", 1);
  program.set("samples", static_cast<int>(view.options.samples));
  program.set("corner", glm::ivec2(x, y));
  program.set("last_row", top_first ? -1 : static_cast<int>(view.tile.height) - 1);
  program.set("background", glm::vec4(glm::vec3(linear_light(back)), srgb.a));
  program.set("back_srgb", glm::vec3(srgb));
  program.set("depth_part", view.depth_part);
  glBindVertexArray(nothing_.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace afx::render
