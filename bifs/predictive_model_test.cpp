// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Steps from one direction to another, over the edges of the orientations too.
#include "bifs/predictive_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace afx::bifs {

namespace {

PredictiveLayout layout_of(nodes::FieldType type, ElementCoding::Kind kind, unsigned bits) {
  nodes::FieldDefinition field;
  field.type = type;
  ElementCoding coding;
  coding.kind = kind;
  coding.bits = bits;
  return {field, coding};
}
PredictiveLayout normals(unsigned bits) {
  return layout_of(nodes::FieldType::mf_vec3f, ElementCoding::Kind::normal, bits);
}
PredictiveLayout rotations(unsigned bits) {
  return layout_of(nodes::FieldType::mf_rotation, ElementCoding::Kind::rotation, bits);
}

/// All that a quantizer may give.
std::vector<QuantizedDirection> all_directions(const PredictiveLayout& layout) {
  const uint32_t last = (1U << layout.bits) - 1;
  std::vector<QuantizedDirection> all;
  for (uint32_t o = 0; o <= layout.components; ++o)
    for (const bool negative : {false, true})
      for (uint32_t a = 1; a <= last; ++a)
        for (uint32_t b = 1; b <= last; ++b)
          for (uint32_t c = 1; c <= (layout.components == 3 ? last : 1); ++c)
            if (!negative || layout.has_sign())
              all.push_back({negative, o, {a, b, layout.components == 3 ? c : 0}});
  return all;
}

void expect_all_steps_lead_there(const PredictiveLayout& layout) {
  const auto all = all_directions(layout);
  for (const QuantizedDirection& from : all) {
    for (const QuantizedDirection& to : all) {
      const auto next = predicted_value(layout, from, step_between(layout, from, to));
      ASSERT_TRUE(next);
      ASSERT_EQ(next->negative, to.negative);
      ASSERT_EQ(next->orientation, to.orientation);
      ASSERT_EQ(next->components, to.components);
    }
  }
}

int64_t length(const PredictiveStep& step) {
  int64_t greatest = 0;
  for (const int64_t r : step.residual) greatest = std::max(greatest, std::abs(r));
  return greatest;
}

}  // namespace

TEST(PredictiveStep, LeadsFromEveryNormalToEveryOther) { expect_all_steps_lead_there(normals(3)); }
TEST(PredictiveStep, LeadsFromEveryRotationToEveryOther) {
  expect_all_steps_lead_there(rotations(2));
}

TEST(PredictiveStep, OverAnEdgeIsAsShortAsWithinOne) {
  // Round a great circle in steps of 1 degree, which are 1 / 45 of 511 codes, over the edges of the
  // four sides that it meets: no step is longer than that and the rounding.
  const PredictiveLayout layout = normals(10);
  const auto at = [](int degrees) {
    const double a = (degrees + 0.5) * std::acos(-1.0) / 180;
    return quantize_normal({std::cos(a), std::sin(a), 0.1 * std::sin(a)}, 10);
  };
  int edges = 0;
  for (int degrees = 0; degrees < 360; ++degrees) {
    const PredictiveStep step = step_between(layout, at(degrees), at(degrees + 1));
    EXPECT_LE(length(step), 511 / 45 + 2) << degrees;
    EXPECT_FALSE(step.flip) << degrees;
    edges += at(degrees).orientation != at(degrees + 1).orientation ? 1 : 0;
  }
  EXPECT_EQ(edges, 4);
}

TEST(PredictiveStep, OfANormalOverTheEdgeIsTheOneWorkedOutByHand) {
  // 4 bits: zero is 8, 45 degrees is 7 steps. From x, component y at +6, z at 2; y + 3 is 9 steps,
  // beyond 7: now y is greatest, x is 2 * 7 - 9 = 5 steps from it and z stays. From y the first
  // component is z, then x.
  const QuantizedDirection from{false, 0, {8 + 6, 8 + 2, 0}};
  const auto up = predicted_value(normals(4), from, {false, {3, 0, 0}});
  ASSERT_TRUE(up);
  EXPECT_EQ(up->orientation, 1U);
  EXPECT_FALSE(up->negative);
  EXPECT_EQ(up->components, (std::array<uint32_t, 3>{8 + 2, 8 + 5, 0}));
  // The other way: y - 15 is -9 steps. -y is greatest; x / y is -5 steps, z / y the other sign.
  const auto down = predicted_value(normals(4), from, {false, {-15, 0, 0}});
  ASSERT_TRUE(down);
  EXPECT_EQ(down->orientation, 1U);
  EXPECT_TRUE(down->negative);
  EXPECT_EQ(down->components, (std::array<uint32_t, 3>{8 - 2, 8 - 5, 0}));
}

TEST(PredictiveStep, OutOfTheRangeThereIsNoValue) {
  const QuantizedDirection from{false, 0, {8, 8, 0}};
  EXPECT_FALSE(predicted_value(normals(4), from, {false, {8, 8, 0}}));  // two edges
  EXPECT_FALSE(predicted_value(normals(4), from, {false, {22, 0, 0}}));
  const PredictiveLayout number =
      layout_of(nodes::FieldType::mf_int32, ElementCoding::Kind::integer, 4);
  EXPECT_TRUE(predicted_value(number, from, {false, {7, 0, 0}}));
  EXPECT_FALSE(predicted_value(number, from, {false, {8, 0, 0}}));
  EXPECT_TRUE(predicted_value(number, from, {false, {-8, 0, 0}}));
  EXPECT_FALSE(predicted_value(number, from, {false, {-9, 0, 0}}));
}

}  // namespace afx::bifs
