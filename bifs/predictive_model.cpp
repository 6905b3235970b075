// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/predictive_model.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>

#include "nodes/definitions.h"

namespace afx::bifs {

namespace {

using nodes::FieldType;
using Kind = ElementCoding::Kind;
using Angles = std::array<int64_t, 3>;  // components without their offset, zero in the middle

constexpr uint8_t kCategoryPosition3D = 1;
constexpr uint8_t kCategoryPosition2D = 2;

size_t component_count(FieldType element, Kind kind) {
  if (kind == Kind::normal || element == FieldType::sf_vec2f) return 2;
  if (kind == Kind::rotation || element == FieldType::sf_vec3f || element == FieldType::sf_color)
    return 3;
  return 1;
}

int64_t zero_code(const PredictiveLayout& layout) {
  return layout.bits > 0 ? int64_t{1} << (layout.bits - 1) : 0;
}
/// The code of 45 degrees, less zero_code.
int64_t edge(const PredictiveLayout& layout) { return std::max<int64_t>(zero_code(layout) - 1, 0); }

Angles angles_of(const PredictiveLayout& layout, const QuantizedDirection& value) {
  Angles angles{};
  for (size_t i = 0; i < layout.components; ++i)
    angles[i] = int64_t{value.components[i]} - zero_code(layout);
  return angles;
}

/// Axes count from 0, and the components of an orientation from the axis behind it.
size_t axis_of(const PredictiveLayout& layout, size_t orientation, size_t component) {
  return (orientation + 1 + component) % (layout.components + 1);
}
size_t component_of(const PredictiveLayout& layout, size_t orientation, size_t axis) {
  const size_t axes = layout.components + 1;
  return (axis + 2 * axes - orientation - 1) % axes;
}

/// The same direction seen from the axis of component `to`, on its negative side if sign is -1.
/// Its own inverse: going back the sign is the same.
Angles turned(const PredictiveLayout& layout, const Angles& angles, size_t orientation, size_t to,
              int64_t sign) {
  const size_t target = axis_of(layout, orientation, to);
  Angles out{};
  for (size_t i = 0; i < layout.components; ++i) {
    const size_t axis = i == to ? orientation : axis_of(layout, orientation, i);
    out[component_of(layout, target, axis)] =
        i == to ? sign * 2 * edge(layout) - angles[i] : sign * angles[i];
  }
  return out;
}

bool is_beyond(const PredictiveLayout& layout, int64_t angle) {
  return std::abs(angle) > edge(layout);
}

std::optional<QuantizedDirection> predicted_direction(const PredictiveLayout& layout,
                                                      const QuantizedDirection& previous,
                                                      const PredictiveStep& step) {
  QuantizedDirection next = previous;
  next.negative = layout.has_sign() && previous.negative != step.flip;
  Angles angles = angles_of(layout, previous);
  for (size_t i = 0; i < layout.components; ++i) angles[i] += step.residual[i];
  size_t beyond = 0;
  while (beyond < layout.components && !is_beyond(layout, angles[beyond])) ++beyond;
  if (beyond < layout.components) {
    const int64_t sign = angles[beyond] < 0 ? -1 : 1;
    angles = turned(layout, angles, previous.orientation, beyond, sign);
    next.orientation = static_cast<uint32_t>(axis_of(layout, previous.orientation, beyond));
    if (layout.has_sign() && sign < 0) next.negative = !next.negative;
  }
  for (size_t i = 0; i < layout.components; ++i) {
    if (is_beyond(layout, angles[i])) return std::nullopt;
    next.components[i] = static_cast<uint32_t>(angles[i] + zero_code(layout));
  }
  return next;
}

PredictiveStep difference(const PredictiveLayout& layout, const Angles& from, const Angles& to) {
  PredictiveStep step;
  for (size_t i = 0; i < layout.components; ++i) step.residual[i] = to[i] - from[i];
  return step;
}

int64_t length(const PredictiveStep& step) {
  int64_t greatest = 0;
  for (const int64_t residual : step.residual) greatest = std::max(greatest, std::abs(residual));
  return greatest;
}

/// A step over an edge, to the positive or negative side of another axis.
PredictiveStep turning_step(const PredictiveLayout& layout, const QuantizedDirection& previous,
                            const QuantizedDirection& next) {
  const size_t over = component_of(layout, previous.orientation, next.orientation);
  const size_t back = component_of(layout, next.orientation, previous.orientation);
  std::optional<PredictiveStep> best;
  for (const int64_t sign : {1, -1}) {
    const Angles seen = turned(layout, angles_of(layout, next), next.orientation, back, sign);
    if (!is_beyond(layout, seen[over])) continue;  // exactly on the edge: from the other side only
    PredictiveStep step = difference(layout, angles_of(layout, previous), seen);
    step.flip = layout.has_sign() && (previous.negative != next.negative) != (sign < 0);
    if (!best || length(step) < length(*best)) best = step;
  }
  assert(best);
  return *best;
}

}  // namespace

PredictiveLayout::PredictiveLayout(const nodes::FieldDefinition& field, const ElementCoding& coding)
    : kind(coding.kind),
      bits(coding.bits),
      components(component_count(element_type(field.type), coding.kind)),
      bounds(field.quant_category == kCategoryPosition3D   ? 3
             : field.quant_category == kCategoryPosition2D ? 2
                                                           : 1) {}

std::optional<QuantizedDirection> predicted_value(const PredictiveLayout& layout,
                                                  const QuantizedDirection& previous,
                                                  const PredictiveStep& step) {
  if (layout.is_direction()) return predicted_direction(layout, previous, step);
  QuantizedDirection next;
  for (size_t i = 0; i < layout.components; ++i) {
    const int64_t code = int64_t{previous.components[i]} + step.residual[i];
    if (code < 0 || code >> layout.bits != 0) return std::nullopt;
    next.components[i] = static_cast<uint32_t>(code);
  }
  return next;
}

PredictiveStep step_between(const PredictiveLayout& layout, const QuantizedDirection& previous,
                            const QuantizedDirection& next) {
  if (layout.is_direction() && previous.orientation != next.orientation)
    return turning_step(layout, previous, next);
  PredictiveStep step = difference(layout, angles_of(layout, previous), angles_of(layout, next));
  step.flip = layout.has_sign() && previous.negative != next.negative;
  return step;
}

}  // namespace afx::bifs
