// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// PointTextures of surfaces known in closed form. They are sampled as meshes are: on grids along
// all three axes, each part of the surface along the one that it faces most.
#include "afx/layer_leaning.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/gtc/constants.hpp>

#include "afx/plane_cell.h"
#include "afx/surfel_drawing.h"
#include "afx/surfel_footprint.h"
#include "afx/surfel_layers.h"
#include "afx/surfel_sources.h"
#include "afx/surfel_test_models.h"

namespace afx {
namespace {

constexpr double kRadius = 0.8;
constexpr Rgba8 kRed{200, 9, 9, 255};

// Looks along -z at a box around the origin, 2 wide in all directions.
DepthCamera reference_camera() { return {{0, 0, 2}, {1, 0, 0, 0}, true, {2, 2}, 1, 3}; }

DepthImage layers_or_fail(const Surfels& surfels, uint32_t side, unsigned bits,
                          const DepthCamera& camera = reference_camera()) {
  auto image = layer_surfels(surfels, {camera, side, side}, bits, {});
  EXPECT_TRUE(image.ok()) << image.error().text;
  return image.ok() ? std::move(image).value() : DepthImage{};
}

Surfels surfels_or_fail(const DepthImage& image, unsigned threads = 1) {
  auto surfels = surfels_of(image, threads, {});
  EXPECT_TRUE(surfels.ok()) << surfels.error().text;
  return surfels.ok() ? std::move(surfels).value() : Surfels{};
}

const PointTexture& points_of(const DepthImage& image) {
  return std::get<PointTexture>(image.texture);
}

bool is_within(const glm::dvec3& p, double half) {
  return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= half;
}

// Points without extent on the sphere around `centre`. `side` is the number of cells of the grids.
void add_sphere(Surfels& surfels, double radius, uint32_t side,
                const glm::dvec3& centre = glm::dvec3(0)) {
  const auto at = [&](uint32_t k) { return (k + 0.5) / side * 2 - 1; };
  for (int axis = 0; axis < 3; ++axis)
    for (uint32_t j = 0; j < side; ++j)
      for (uint32_t i = 0; i < side; ++i) {
        glm::dvec3 p(0);
        p[(axis + 1) % 3] = at(i) - centre[(axis + 1) % 3];
        p[(axis + 2) % 3] = at(j) - centre[(axis + 2) % 3];
        const double rest = radius * radius - glm::dot(p, p);
        if (rest < 0) continue;
        p[axis] = std::sqrt(rest);
        const glm::dvec3 a = glm::abs(p);
        if (p[axis] < 0.9 * std::max({a.x, a.y, a.z})) continue;
        const Rgba8 colour{static_cast<uint8_t>(i), static_cast<uint8_t>(j), 0, 255};
        surfels.push_back(centre + p, {}, {}, colour);
        p[axis] = -p[axis];
        surfels.push_back(centre + p, {}, {}, colour);
      }
}

// Points of the part of a plane through the origin that lies in the cube of side 1.6 around it, on
// the grid along the axis that it faces most.
Surfels plane_points(const glm::dvec3& normal, uint32_t side) {
  Surfels surfels;
  const int axis = main_axis(normal);
  for (uint32_t j = 0; j < side; ++j)
    for (uint32_t i = 0; i < side; ++i) {
      glm::dvec3 p(0);
      p[(axis + 1) % 3] = (i + 0.5) / side * 2 - 1;
      p[(axis + 2) % 3] = (j + 0.5) / side * 2 - 1;
      p[axis] = -glm::dot(p, normal) / normal[axis];
      if (is_within(p, 0.8)) surfels.push_back(p, {}, {}, {9, 9, 9, 255});
    }
  return surfels;
}

glm::dvec3 normal_of(const Surfels& surfels, size_t n) {
  return glm::normalize(glm::cross(glm::dvec3(surfels.u[n]), glm::dvec3(surfels.v[n])));
}

// How a plane leans to the reference plane, and where to, in degrees.
struct Lean {
  double tilt, turn;
};

glm::dvec3 normal_of(const Lean& lean) {
  const double a = glm::radians(lean.tilt), b = glm::radians(lean.turn);
  return {std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a)};
}

// The most that pieces lean otherwise than a plane, in degrees.
double worst_lean(const Surfels& surfels, const glm::dvec3& normal) {
  double worst = 0;
  for (size_t n = 0; n < surfels.size(); ++n) {
    const glm::dvec3& p = surfels.centres[n];
    if (!is_within(p, 0.7)) continue;
    const double straight = std::min(std::abs(glm::dot(normal_of(surfels, n), normal)), 1.0);
    worst = std::max(worst, glm::degrees(std::acos(straight)));
  }
  return worst;
}

class SteepPlane : public ::testing::TestWithParam<std::tuple<double, double>> {};

TEST_P(SteepPlane, ItsPiecesLeanAsItDoesAndLieOnIt) {
  const glm::dvec3 normal = normal_of(Lean{std::get<0>(GetParam()), std::get<1>(GetParam())});
  constexpr uint32_t kSide = 64;
  const Surfels surfels = surfels_or_fail(layers_or_fail(plane_points(normal, kSide), kSide, 16));
  EXPECT_GT(surfels.size(), 2000U);
  EXPECT_LT(worst_lean(surfels, normal), 11);
  double off = 0;
  for (const glm::dvec3& p : surfels.centres)
    if (is_within(p, 0.7)) off = std::max(off, std::abs(glm::dot(p, normal)) * kSide / 2);
  EXPECT_LT(off, 0.2);  // in pixels; those of the samples are up to a half
}

INSTANTIATE_TEST_SUITE_P(All, SteepPlane,
                         ::testing::Combine(::testing::Values(60, 70, 80, 85),
                                            ::testing::Values(0, 20, 40)));

TEST(LayerLeaning, AWallAlongTheLineOfSightStandsUpright) {
  const Surfels surfels = surfels_or_fail(layers_or_fail(plane_points({1, 0, 0}, 64), 64, 16));
  for (size_t n = 0; n < surfels.size(); ++n)
    EXPECT_NEAR(std::abs(normal_of(surfels, n).x), 1, 1e-6);
}

// A plane and, a number of pixels behind it, another in red.
Surfels two_sheets(const glm::dvec3& normal, double apart) {
  Surfels both = plane_points(normal, 64);
  const size_t one = both.size();
  for (size_t n = 0; n < one; ++n)
    both.push_back(both.centres[n] - apart / 32 * normal, {}, {}, kRed);
  return surfels_or_fail(layers_or_fail(both, 64, 16));
}

// How far, in pixels, pieces are off their sheet.
double farthest_off(const Surfels& sheets, const glm::dvec3& normal, double apart) {
  double farthest = 0;
  for (size_t n = 0; n < sheets.size(); ++n) {
    if (!is_within(sheets.centres[n], 0.7)) continue;
    const double before = 32 * glm::dot(sheets.centres[n], normal);
    farthest = std::max(farthest, std::abs(before + (sheets.colours[n] == kRed ? apart : 0)));
  }
  return farthest;
}

TEST(LayerLeaning, SheetsCloseToEachOtherStayApart) {
  for (const Lean lean : {Lean{0, 0}, {30, 0}, {30, 45}, {80, 0}, {80, 40}})
    for (const double apart : {1.2, 1.6, 2.0, 3.0}) {
      const glm::dvec3 normal = normal_of(lean);
      const Surfels sheets = two_sheets(normal, apart);
      EXPECT_GT(sheets.size(), 4000U);
      // Steep ones cannot always be told from one sheet that is thick by a pixel.
      EXPECT_LT(worst_lean(sheets, normal), lean.tilt < 45 ? 10 : 25) << lean.tilt << ' ' << apart;
      EXPECT_LT(farthest_off(sheets, normal, apart), lean.tilt < 45 ? 0.4 : 0.7)
          << lean.tilt << ' ' << apart;
    }
}

// Looks at the origin from two units away.
DepthCamera camera_at(const glm::dvec3& eye) {
  DepthCamera camera = reference_camera();
  const glm::dvec3 up = std::abs(eye.y) > 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
  camera.orientation = glm::quatLookAt(-eye, up);
  camera.position = 2.0 * eye;
  return camera;
}

struct Faults {
  size_t holes = 0;   // pixels inside the outline where nothing or what lies behind is seen
  size_t strays = 0;  // pixels more than a sample's side outside
};
Faults faults_of_sphere(const SimpleTexture& seen, const DepthCamera& camera, double sample) {
  Faults faults;
  const uint32_t side = seen.colour.width;
  for (uint32_t y = 0; y < side; ++y)
    for (uint32_t x = 0; x < side; ++x) {
      const double out = std::hypot((x + 0.5) / side * 2 - 1, (y + 0.5) / side * 2 - 1);
      const uint16_t depth = seen.depth.samples[size_t{y} * side + x];
      if (out > kRadius + sample && depth != 0) ++faults.strays;
      if (out > kRadius - sample) continue;
      const double front = std::sqrt(kRadius * kRadius - out * out);
      const double behind = depth_to_distance(depth, 65535, camera) - (2 - front);
      // Across the surface; along the line of sight it is more towards the rim.
      if (depth == 0 || behind * front / kRadius > 0.8 * sample) ++faults.holes;
    }
  return faults;
}

class SampledSphere : public ::testing::TestWithParam<uint32_t> {};

TEST_P(SampledSphere, HasNoHolesAndDoesNotGrowByMoreThanAPixel) {
  const uint32_t side = GetParam();
  Surfels points;
  add_sphere(points, kRadius, side);
  const Surfels surfels = surfels_or_fail(layers_or_fail(points, side, 12));
  for (const glm::dvec3& from :
       {glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(1, 0, 1),
        glm::dvec3(0.5, 0.3, 0.8), glm::dvec3(-0.7, 0.6, -0.4), glm::dvec3(0.9, 0.1, 0.3)}) {
    const DepthCamera camera = camera_at(glm::normalize(from));
    const uint32_t fine = 2 * side + 1;
    const auto drawn = draw_surfels(surfels, {camera, fine, fine}, 16, 1, {});
    ASSERT_TRUE(drawn.ok());
    const Faults faults =
        faults_of_sphere(std::get<SimpleTexture>(drawn.value().texture), camera, 2.0 / side);
    EXPECT_EQ(faults.holes, 0U) << from.x << ' ' << from.y << ' ' << from.z;
    EXPECT_EQ(faults.strays, 0U) << from.x << ' ' << from.y << ' ' << from.z;
  }
}

INSTANTIATE_TEST_SUITE_P(All, SampledSphere, ::testing::Values(24U, 64U, 150U));

// The camera's angle; 0: none, its lines of sight are parallel.
class OwnCameraOfLayers : public ::testing::TestWithParam<std::tuple<double, unsigned>> {
 protected:
  DepthImage image() const {
    const auto [angle, bits] = GetParam();
    DepthCamera camera = reference_camera();
    camera.orthographic = angle == 0;
    if (angle != 0) camera.field_of_view = {angle, angle};
    Surfels points;
    add_sphere(points, kRadius, 60);
    add_sphere(points, 0.3, 60, {0.31, 0.2, 0.1});
    return layers_or_fail(points, angle < 2 ? 60 : 8, bits, camera);
  }
};

TEST_P(OwnCameraOfLayers, APieceCoversNoOtherPixelAndFacesTheViewer) {
  const DepthImage layers = image();
  const Surfels surfels = surfels_or_fail(layers);
  const SurfelCamera view(layers.camera, layers.width(), layers.height());
  size_t leaning = 0;
  for (size_t n = 0; n < surfels.size(); ++n) {
    const SurfelFootprint piece = view.footprint(surfels, n);
    ASSERT_TRUE(piece.owns_pixel);
    EXPECT_GE(piece.area, -1e-6);
    if (std::abs(piece.area - 1) > 1e-3) ++leaning;
    for (uint32_t j = 0; j < layers.height(); ++j)
      for (uint32_t i = 0; i < layers.width(); ++i) {
        double at = 0;
        ASSERT_TRUE(!piece.covers(i, j, at) || (i == piece.own_i && j == piece.own_j));
      }
  }
  EXPECT_GT(leaning, surfels.size() / 2);
}

TEST_P(OwnCameraOfLayers, TheyComeBackExactly) {
  const DepthImage layers = image();
  EXPECT_GT(points_of(layers).depths.size(), 50U);
  const DepthImage again = layers_or_fail(surfels_or_fail(layers), layers.width(),
                                          points_of(layers).depth_bits, layers.camera);
  EXPECT_EQ(points_of(again), points_of(layers));
}

TEST_P(OwnCameraOfLayers, PiecesAreTheSameForAnyNumberOfThreads) {
  const DepthImage layers = image();
  const Surfels one = surfels_or_fail(layers, 1), four = surfels_or_fail(layers, 4);
  EXPECT_EQ(one.centres, four.centres);
  EXPECT_EQ(one.u, four.u);
  EXPECT_EQ(one.v, four.v);
  EXPECT_EQ(one.colours, four.colours);
}

INSTANTIATE_TEST_SUITE_P(All, OwnCameraOfLayers,
                         ::testing::Combine(::testing::Values(0, 1.2, 3.0),
                                            ::testing::Values(6U, 12U, 32U)));

}  // namespace
}  // namespace afx
