// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/gl/gl_view.h"

#include <algorithm>
#include <cmath>

#include "render/gl/gl_objects.h"
#include "render/splats.h"

namespace afx::render {
namespace {

/// A power of two, times which the distance is below 1.
float part_for(double farthest) {
  if (!std::isfinite(farthest)) farthest = 1e30;
  const int exponent = std::clamp(std::ilogb(std::max(farthest, 1e-30)) + 2, -60, 100);
  return std::ldexp(1.0F, -exponent);
}

}  // namespace

GlView::GlView(const Lens& the_lens, const RenderOptions& the_options, double farthest,
               float largest_point)
    : options(the_options),
      lens(the_lens),
      depth_part(part_for(farthest)),
      most_point(largest_point) {}

void GlView::set_tile(const GlTile& to) {
  tile = to;
  corner = glm::dvec2(to.x, to.y) * static_cast<double>(options.samples);
  size = glm::dvec2(to.width, to.height) * static_cast<double>(options.samples);
}

/// A ball of radius r at distance d, its nearest point d - r away, reaches on the screen at most
/// r sqrt(1 + x^2 + y^2) / (d - r) from its centre at the slopes x, y.
bool GlView::touches(const glm::dvec3& centre, double radius) const {
  const double distance = -centre.z;
  if (distance + radius < lens.near_plane) return false;
  double reach = radius * lens.focal;
  if (lens.perspective) {
    const double nearest = distance - radius;
    if (!(nearest > radius)) return true;
    const glm::dvec2 slopes = glm::dvec2(centre) / distance;
    reach *= (1 + glm::dot(slopes, slopes) / 2) / nearest;  // at least the root
  }
  const glm::dvec2 at = lens.place(centre) - corner;
  reach += 2;  // the least splat, and rounding
  return at.x + reach >= 0 && at.y + reach >= 0 && at.x - reach <= size.x && at.y - reach <= size.y;
}

void GlView::set_uniforms(const GlProgram& program) const {
  const double margin = std::ceil(static_cast<double>(most_point)) + 1;
  program.set("viewport_corner", glm::vec2(static_cast<float>(-margin)));
  program.set("viewport_size", glm::vec2(size + 2 * margin));
  program.set("screen", glm::vec2(size));
  program.set("middle", glm::vec2(lens.middle - corner));
  program.set("focal", static_cast<float>(lens.focal));
  program.set("perspective", lens.perspective ? 1 : 0);
  program.set("near_plane", static_cast<float>(lens.near_plane));
  program.set("slope", glm::vec2(lens.slope));
  program.set("secant", glm::vec2(lens.secant));
  program.set("depth_part", depth_part);
  program.set("most_point", most_point);
  program.set("least_radius", kLeastRadius);
  const auto side = static_cast<GLint>(margin);
  glViewport(-side, -side, static_cast<GLsizei>(size.x) + 2 * side,
             static_cast<GLsizei>(size.y) + 2 * side);
}

}  // namespace afx::render
