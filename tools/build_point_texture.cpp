// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <algorithm>
#include <cmath>
#include <utility>

#include "afx/builder/depth_image_builder.h"
#include "afx/builder/view_plan.h"
#include "afx/depth_image_nodes.h"
#include "afx/surfel_layers.h"
#include "tools/build.h"
#include "tools/build_views.h"

namespace afx::tools {
namespace {

/// The reference plane: the camera that --views names, else one from the front.
Result<Shot> reference_plane(const ViewSource& source, const BuildJob& job) {
  if (!job.command.views)
    return view_from(source, {0, 0, 1}, {job.command.resolution, !job.command.perspective});
  const auto views = read_views_option(job);
  if (!views.ok()) return views.error();
  const auto& shots = views.value().shots;
  if (shots.size() == 1) return shots.front();
  return Error{Errc::bad_argument,
               Place::none(),
               "has " + counted(shots.size(), "camera") +
                   " (expected one, the reference plane of --as points)",
               {},
               *job.command.views};
}

/// Width and height of a pixel in the middle of the depths.
glm::dvec2 pixel_of(const Shot& plane) {
  const double middle = (plane.camera.near_plane + plane.camera.far_plane) / 2;
  return CameraProjection(plane.camera).extent(middle) / glm::dvec2(plane.width, plane.height);
}

/// At how many samples along its longest side a mesh has one for each pixel of the plane.
uint32_t sampling_of(const Shot& plane, const ViewSource& source, const BuildJob& job) {
  if (!job.command.views) return job.command.resolution;
  const glm::dvec2 pixel = pixel_of(plane);
  const double samples = std::round(longest_side(source) / std::min(pixel.x, pixel.y));
  return static_cast<uint32_t>(std::clamp(samples, 1.0, double{kMaxPictureResolution}));
}

unsigned depth_bits(const Shot& plane, const BuildJob& job) {
  if (job.command.depth_bits != 0) return job.command.depth_bits;
  const glm::dvec2 pixel = pixel_of(plane);
  return depth_bits_for(plane.camera.far_plane - plane.camera.near_plane,
                        std::max(pixel.x, pixel.y));
}

void describe(const PointTexture& points, uint64_t pieces, BuiltScene& scene) {
  uint64_t filled = 0;
  uint32_t most = 0;
  for (size_t i = 0; i + 1 < points.starts.size(); ++i) {
    const uint32_t count = points.starts[i + 1] - points.starts[i];
    most = std::max(most, count);
    if (count > 0) ++filled;
  }
  scene.lines.push_back("  points: " + grouped(points.depths.size()) + " of " +
                        std::to_string(points.depth_bits) + " bits on " + grouped(filled) + " of " +
                        std::to_string(points.width) + " x " + std::to_string(points.height) +
                        " pixels, up to " + std::to_string(most) + " on one; from " +
                        counted(pieces, "sample"));
  scene.json = {{"points", points.depths.size()},
                {"depthBits", points.depth_bits},
                {"width", points.width},
                {"height", points.height},
                {"filledPixels", filled},
                {"mostLayers", most},
                {"samples", pieces}};
}

}  // namespace

Result<BuiltScene> build_points_scene(ModelInput&& model, const BuildJob& job) {
  auto looked_at = LookedAt::of(std::move(model), job);
  if (!looked_at.ok()) return std::move(looked_at).error();
  const auto plane = reference_plane(looked_at.value()->views(), job);
  if (!plane.ok()) return plane.error();
  job.bar.show("sampling", 0.2);
  const uint32_t sampling = sampling_of(plane.value(), looked_at.value()->views(), job);
  const auto surfels = std::move(*looked_at.value()).surfels(sampling, job);
  if (!surfels.ok()) return surfels.error();
  job.bar.show("sorting", 0.7);
  const Shot& shot = plane.value();
  const auto image =
      layer_surfels(surfels.value(), shot, depth_bits(shot, job), job.session.limits);
  if (!image.ok()) return image.error();
  const auto& points = std::get<PointTexture>(image.value().texture);
  if (points.depths.empty()) return nothing_to_see();
  BuiltScene scene;
  const nodes::NodeId node = add_depth_image(scene.scene, image.value().camera, points);
  (void)scene.scene.append(add_transform(scene.scene, job.offset), "children",
                           node);  // known to be right
  describe(points, surfels.value().size(), scene);
  return scene;
}

}  // namespace afx::tools
