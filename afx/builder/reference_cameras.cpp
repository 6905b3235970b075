// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/reference_cameras.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

namespace afx {
namespace {

// A view: the direction to its camera, and the camera's turn about x or y.
struct SideRow {
  const char* name;
  glm::vec3 to_camera;
  glm::quat turn;  // w, x, y, z
};

const float kHalf = std::sqrt(0.5F);

const std::array<SideRow, kSideViews> kSides{{
    {"front", {0, 0, 1}, {1, 0, 0, 0}},
    {"back", {0, 0, -1}, {0, 0, 1, 0}},
    {"right", {1, 0, 0}, {kHalf, 0, kHalf, 0}},
    {"left", {-1, 0, 0}, {kHalf, 0, -kHalf, 0}},
    {"top", {0, 1, 0}, {kHalf, -kHalf, 0, 0}},
    {"bottom", {0, -1, 0}, {kHalf, kHalf, 0, 0}},
}};

// Pixels that the cube takes along an axis of a picture.
uint32_t extent(const glm::dvec3& axis, uint32_t size) {
  const double length = std::abs(axis.x) + std::abs(axis.y) + std::abs(axis.z);
  return static_cast<uint32_t>(std::ceil(length * size));
}

}  // namespace

std::string reference_name(unsigned view) {
  if (view < kSideViews) return kSides[view].name;
  const std::string number = std::to_string(view + 1);
  return (number.size() < 2 ? "view0" : "view") + number;
}

ReferenceCamera side_camera(unsigned view, uint32_t size) {
  ReferenceCamera camera{{}, size, size};
  camera.image.position = kSides[view].to_camera * kReferenceDistance;
  camera.image.orientation = kSides[view].turn;
  camera.image.field_of_view = {1, 1};
  return camera;
}

ReferenceCamera slanting_camera(const glm::dvec3& to_camera, uint32_t size) {
  const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), to_camera));
  const glm::dvec3 up = glm::cross(to_camera, right);
  ReferenceCamera camera{{}, extent(right, size), extent(up, size)};
  camera.image.position = glm::vec3(to_camera * double{kReferenceDistance});
  camera.image.orientation = glm::quat(glm::quat_cast(glm::dmat3(right, up, to_camera)));
  camera.image.field_of_view = {static_cast<float>(camera.width) / static_cast<float>(size),
                                static_cast<float>(camera.height) / static_cast<float>(size)};
  return camera;
}

ReferenceCamera cropped(const ReferenceCamera& camera, uint32_t left, uint32_t top, uint32_t width,
                        uint32_t height) {
  ReferenceCamera part{camera.image, width, height};
  const glm::dvec2 pixel = glm::dvec2(camera.image.field_of_view) /
                           glm::dvec2(camera.width, camera.height);  // the size of one
  const glm::dvec2 middle(left + 0.5 * width - 0.5 * camera.width,
                          0.5 * camera.height - (top + 0.5 * height));
  const glm::dquat turn = glm::normalize(glm::dquat(camera.image.orientation));
  const glm::dvec3 shift = turn * glm::dvec3(middle.x * pixel.x, middle.y * pixel.y, 0);
  part.image.position = glm::vec3(glm::dvec3(camera.image.position) + shift);
  part.image.field_of_view = glm::vec2(pixel.x * width, pixel.y * height);
  return part;
}

}  // namespace afx
