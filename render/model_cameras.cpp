// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/model_cameras.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace afx::render {
namespace {

DepthCamera camera_of(const ReferenceImage& image) {
  DepthCamera camera;
  camera.position = glm::dvec3(image.position);
  camera.orientation = glm::dquat(image.orientation);
  camera.orthographic = true;
  camera.field_of_view = glm::dvec2(image.field_of_view);
  const glm::dvec3 ahead = camera.orientation * glm::dvec3(0, 0, -1);
  const double middle = glm::dot(-camera.position, ahead);
  const double half = (std::abs(ahead.x) + std::abs(ahead.y) + std::abs(ahead.z)) / 2;
  camera.near_plane = middle - half;
  camera.far_plane = middle + half;
  return camera;
}

}  // namespace

std::vector<ModelCamera> model_cameras(std::span<const DibrModel> models) {
  using Kind = ModelCamera::Kind;
  std::vector<ModelCamera> cameras;
  for (size_t m = 0; m < models.size(); ++m) {
    const DibrModel& model = models[m];
    if (const OctreeModel* octree = model.octree()) {
      for (size_t i = 0; i < octree->images.size(); ++i)
        cameras.push_back(
            {Kind::reference_image, m, i, camera_of(octree->images[i]), model.to_world});
      continue;
    }
    const std::vector<DepthImage>& images = *model.depth_images();
    for (size_t i = 0; i < images.size(); ++i)
      cameras.push_back({Kind::depth_image, m, i, images[i].camera, model.to_world});
  }
  return cameras;
}

}  // namespace afx::render
