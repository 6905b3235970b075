// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// MeshLook against the hits of another program's rays (Embree): what is seen, how far it is, and
// the picture that it makes.
#include <embree3/rtcore.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "afx/builder/mesh_look.h"
#include "afx/builder/test_meshes.h"
#include "afx/srgb.h"

namespace afx {
namespace {

/// The triangles of a mesh as Embree holds them.
class RayScene {
 public:
  explicit RayScene(const Mesh& mesh) : device_(rtcNewDevice(nullptr)) {
    scene_ = rtcNewScene(device_);
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* corners = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                3 * sizeof(float), mesh.positions.size()));
    for (const glm::vec3& p : mesh.positions)
      for (int k = 0; k < 3; ++k) *corners++ = p[k];
    auto* indices = static_cast<uint32_t*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(uint32_t), mesh.triangles.size()));
    for (const glm::uvec3& t : mesh.triangles)
      for (int k = 0; k < 3; ++k) *indices++ = t[k];
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
  }
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;
  ~RayScene() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }

  /// along   with a length of 1 along the viewing direction, so that distances are planes'
  [[nodiscard]] SeenSurface cast(const glm::dvec3& from, const glm::dvec3& along,
                                 double near) const {
    RTCRayHit ray{};
    ray.ray.org_x = static_cast<float>(from.x);
    ray.ray.org_y = static_cast<float>(from.y);
    ray.ray.org_z = static_cast<float>(from.z);
    ray.ray.dir_x = static_cast<float>(along.x);
    ray.ray.dir_y = static_cast<float>(along.y);
    ray.ray.dir_z = static_cast<float>(along.z);
    ray.ray.tnear = static_cast<float>(near);
    ray.ray.tfar = std::numeric_limits<float>::infinity();
    ray.ray.mask = 0xFFFFFFFF;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene_, &context, &ray);
    if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    return {static_cast<double>(ray.ray.tfar), ray.hit.primID, ray.hit.u, ray.hit.v};
  }

 private:
  RTCDevice device_;
  RTCScene scene_ = nullptr;
};

/// What the centres of all pixels see.
std::vector<SeenSurface> seen_by_rays(const Mesh& mesh, const DepthCamera& camera, uint32_t width,
                                      uint32_t height) {
  const RayScene scene(mesh);
  const CameraProjection projection(camera);
  std::vector<SeenSurface> all;
  for (uint32_t y = 0; y < height; ++y)
    for (uint32_t x = 0; x < width; ++x) {
      ScreenPoint at{(x + 0.5) / width, 1 - (y + 0.5) / height, 0};
      const glm::dvec3 from = projection.point(at);
      at.distance = 1;
      all.push_back(scene.cast(from, projection.point(at) - from, camera.near_plane));
    }
  return all;
}

std::vector<SeenSurface> seen_by_look(const MeshLook& look, const DepthCamera& camera,
                                      uint32_t width, uint32_t height) {
  const auto raster = MeshRaster::of(look.mesh(), camera, width, height, 1, {});
  EXPECT_TRUE(raster.ok());
  std::vector<SeenSurface> all, band;
  for (uint32_t k = 0; k < raster.value().bands(); ++k) {
    look.see(raster.value(), k, band);
    all.insert(all.end(), band.begin(), band.end());
  }
  return all;
}

/// How a camera sees triangles, in pixels.
class Screen {
 public:
  Screen(const MeshLook& look, const DepthCamera& camera, uint32_t width, uint32_t height)
      : look_(look), projection_(camera), width_(width), height_(height) {}

  /// How far a pixel's centre is from the edges of a triangle, in pixels.
  [[nodiscard]] double edge_distance(uint32_t triangle, size_t pixel) const {
    const glm::dvec2 at(static_cast<double>(pixel % width_) + 0.5,
                        static_cast<double>(pixel / width_) + 0.5);
    double nearest = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k) {
      const glm::dvec2 a = corner(triangle, k), side = corner(triangle, (k + 1) % 3) - a;
      const double along = glm::dot(at - a, side) / std::max(glm::dot(side, side), 1e-30);
      nearest = std::min(nearest, glm::distance(at, a + side * std::clamp(along, 0.0, 1.0)));
    }
    return nearest;
  }
  /// The height of a pixel at that distance.
  [[nodiscard]] double pixel(double distance) const {
    return projection_.extent(distance).y / height_;
  }
  /// The cosine between surface and line of sight.
  [[nodiscard]] double facing(uint32_t triangle) const {
    const glm::dvec3 place(look_.mesh().positions[look_.mesh().triangles[triangle].x]);
    return std::abs(glm::dot(look_.normal(triangle), projection_.towards_viewer(place)));
  }
  /// The texels under a pixel, as mesh_look.h takes the mean over them.
  [[nodiscard]] double texels(const SeenSurface& seen) const {
    const glm::dvec2 extent = projection_.extent(seen.distance);
    const double area = extent.x / width_ * extent.y / height_;
    return look_.texel_density(seen.triangle) * area *
           std::min(4.0, 1 / std::max(facing(seen.triangle), 1e-9));
  }

 private:
  [[nodiscard]] glm::dvec2 corner(uint32_t triangle, int k) const {
    const uint32_t vertex = look_.mesh().triangles[triangle][k];
    const ScreenPoint at = projection_.project(glm::dvec3(look_.mesh().positions[vertex]));
    return {at.u * width_, (1 - at.v) * height_};
  }

  const MeshLook& look_;
  CameraProjection projection_;
  uint32_t width_, height_;
};

/// A ball with bumps and windows, 49 rings of 50 quads, in a checked texture; a box and a smaller
/// ball are seen through the windows.
Mesh bumpy_ball() {
  constexpr uint32_t kRings = 50, kSides = 50;
  Picture checks(64, 64, 3);
  for (uint32_t y = 0; y < 64; ++y)
    for (uint32_t x = 0; x < 64; ++x)
      for (uint32_t k = 0; k < 3; ++k)
        checks.pixel(x, y)[k] = (x / 8 + y / 8) % 2 == 0 ? static_cast<uint8_t>(60 * k + x) : 230;
  Mesh mesh;
  mesh.textures.push_back(checks);
  mesh.has_colours = true;
  mesh.materials = {{.texture = 0}, {.colour = {0.8F, 0.2F, 0.1F}}};
  for (uint32_t i = 0; i <= kRings; ++i)
    for (uint32_t j = 0; j <= kSides; ++j) {
      const double u = double{1} * j / kSides, v = double{1} * i / kRings;
      const double around = 2 * std::numbers::pi * u, down = std::numbers::pi * v;
      const double r = 1 + 0.1 * std::sin(5 * around) * std::sin(4 * down);
      mesh.positions.emplace_back(r * std::sin(down) * std::cos(around), r * std::cos(down),
                                  -r * std::sin(down) * std::sin(around));
      mesh.texture_coords.emplace_back(3 * u, 2 * (1 - v));
    }
  for (uint32_t i = 0; i < kRings; ++i)
    for (uint32_t j = 0; j < kSides; ++j) {
      if (i % 9 < 3 && j % 8 < 3) continue;  // a window
      const uint32_t a = i * (kSides + 1) + j, b = a + kSides + 1;
      add_triangle(mesh, a, b, a + 1);
      add_triangle(mesh, a + 1, b, b + 1);
    }
  for (const Mesh& part : {box_mesh({-0.4F, -0.5F, -0.3F}, {0.5F, 0.3F, 0.4F}), sphere_mesh(3)}) {
    const auto first = static_cast<uint32_t>(mesh.positions.size());
    const float scale = part.positions.size() > 8 ? 0.6F : 1;
    for (const glm::vec3& p : part.positions) {
      mesh.positions.push_back(p * scale);
      mesh.texture_coords.emplace_back(0, 0);
    }
    for (const glm::uvec3& t : part.triangles)
      add_triangle(mesh, first + t.x, first + t.y, first + t.z);
    std::fill(mesh.material_of.end() - static_cast<std::ptrdiff_t>(part.triangles.size()),
              mesh.material_of.end(), 1U);
  }
  return mesh;
}

DepthCamera camera_at(const glm::dvec3& position, const glm::dquat& orientation,
                      bool orthographic) {
  DepthCamera camera;
  camera.position = position;
  camera.orientation = orientation;
  camera.orthographic = orthographic;
  camera.field_of_view = orthographic ? glm::dvec2(2.6, 2.6) : glm::dvec2(0.6, 0.6);
  camera.near_plane = 0.1;
  camera.far_plane = 10;
  return camera;
}

/// From the front, the right and above.
const glm::dquat kAside =
    glm::angleAxis(0.7, glm::dvec3(0, 1, 0)) * glm::angleAxis(-0.4, glm::dvec3(1, 0, 0));

std::vector<DepthCamera> cameras() {
  return {camera_at({0.01, 0.02, 4.1}, {1, 0, 0, 0}, false),
          camera_at(kAside * glm::dvec3(0.05, -0.03, 3.9), kAside, false),
          camera_at(kAside * glm::dvec3(0, 0, 3), kAside, true)};
}

/// Embree rounds to single precision, the raster lays corners on a grid of 1/256 of a pixel: where
/// they see different triangles an edge must be no farther away than that makes of it.
void expect_same_surface(const Mesh& mesh, const DepthCamera& camera) {
  constexpr uint32_t kSize = 500;
  const MeshLook look(mesh, Shade::automatic);
  const Screen screen(look, camera, kSize, kSize);
  const auto rays = seen_by_rays(mesh, camera, kSize, kSize);
  const auto raster = seen_by_look(look, camera, kSize, kSize);
  ASSERT_EQ(rays.size(), raster.size());
  size_t both = 0, others = 0;
  for (size_t i = 0; i < rays.size(); ++i) {
    const bool hit = std::isfinite(rays[i].distance), drawn = std::isfinite(raster[i].distance);
    if (!hit && !drawn) continue;
    if (hit && drawn && rays[i].triangle == raster[i].triangle) {
      ++both;
      const double d = rays[i].distance, f = screen.facing(rays[i].triangle);
      const double slope = std::sqrt(1 - std::min(1.0, f * f)) / std::max(f, 1e-9);
      const double grid = screen.pixel(d) * std::sqrt(0.5) / 256 * slope;
      ASSERT_NEAR(raster[i].distance, d, 1e-5 * d + grid)
          << "pixel " << i % kSize << " " << i / kSize;
      continue;
    }
    ++others;
    double edge = std::numeric_limits<double>::infinity();
    if (hit) edge = std::min(edge, screen.edge_distance(rays[i].triangle, i));
    if (drawn) edge = std::min(edge, screen.edge_distance(raster[i].triangle, i));
    ASSERT_LT(edge, 1.0 / 256) << "pixel " << i % kSize << " " << i / kSize;
  }
  EXPECT_GT(both, rays.size() / 4);
  EXPECT_LT(others, both / 200);
}

TEST(MeshLookAndEmbree, SeeTheSameSurfaceOfABumpyBall) {
  const Mesh mesh = bumpy_ball();
  EXPECT_GT(mesh.triangles.size(), 4500U);
  for (const DepthCamera& camera : cameras()) expect_same_surface(mesh, camera);
}

TEST(MeshLookAndEmbree, SeeTheSameSurfaceOfABoxAndASphere) {
  for (const DepthCamera& camera : cameras()) {
    expect_same_surface(box_mesh({-0.8F, -0.7F, -0.6F}, {0.5F, 0.9F, 0.7F}), camera);
    expect_same_surface(sphere_mesh(4), camera);
  }
}

TEST(MeshLookAndEmbree, MakeTheSamePicture) {
  constexpr uint32_t kSize = 200, kSamples = 3;
  constexpr Rgba8 kBackground{30, 60, 90, 255};
  const Mesh mesh = bumpy_ball();
  const MeshLook look(mesh, Shade::automatic);
  for (const DepthCamera& camera : cameras()) {
    const auto drawn = draw_picture(look, {camera, kSize, kSize}, kSamples, kBackground, 1, {});
    ASSERT_TRUE(drawn.ok());
    constexpr uint32_t kSide = kSize * kSamples;
    const Screen screen(look, camera, kSide, kSide);
    const auto rays = seen_by_rays(mesh, camera, kSide, kSide);
    std::vector<glm::dvec3> light(size_t{kSize} * kSize);
    for (uint32_t y = 0; y < kSide; ++y)
      for (uint32_t x = 0; x < kSide; ++x) {
        const SeenSurface& seen = rays[size_t{y} * kSide + x];
        const Rgba8 colour =
            std::isfinite(seen.distance) ? look.colour(seen, screen.texels(seen)) : kBackground;
        light[size_t{y / kSamples} * kSize + x / kSamples] += linear_light(colour);
      }
    double sum = 0;
    for (size_t i = 0; i < light.size(); ++i) {
      const Rgba8 colour = to_srgb(light[i] / double{kSamples * kSamples});
      const uint8_t* is = drawn.value().samples.data() + i * 4;
      sum += std::abs(is[0] - colour.r) + std::abs(is[1] - colour.g) + std::abs(is[2] - colour.b);
    }
    EXPECT_LT(sum / static_cast<double>(3 * light.size()), 0.02);
  }
}

}  // namespace
}  // namespace afx
