// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/drawing.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "afx/builder/mesh_shapes.h"

namespace afx::tools {
namespace {

DepthCamera depth_camera(const render::Camera& camera, const render::RenderOptions& options,
                         double far) {
  const double aspect = static_cast<double>(options.width) / options.height;
  DepthCamera result;
  result.position = camera.position;
  result.orientation = camera.orientation;
  result.orthographic = camera.projection == render::Projection::orthographic;
  result.near_plane = camera.near_plane;
  result.far_plane = far;
  if (result.orthographic) {
    result.field_of_view = {camera.view_height * aspect, camera.view_height};
  } else {
    const double slope = std::tan(camera.field_of_view / 2);
    result.field_of_view = {2 * std::atan(slope * aspect), camera.field_of_view};
  }
  return result;
}

/// The vertices that triangles use, each once.
std::vector<glm::dvec3> corners_of(const Mesh& mesh) {
  std::vector<bool> used(mesh.positions.size());
  for (const glm::uvec3& triangle : mesh.triangles)
    for (int k = 0; k < 3; ++k) used[triangle[k]] = true;
  std::vector<glm::dvec3> corners;
  for (size_t i = 0; i < used.size(); ++i)
    if (used[i]) corners.emplace_back(mesh.positions[i]);
  return corners;
}

}  // namespace

render::SceneMaker& Drawing::maker() {
  if (!maker_)
    maker_.emplace(render::SceneMakerOptions{.level = level_, .threads = session_.options.threads},
                   session_.limits);
  return *maker_;
}

Status Drawing::add_scene(Input input) {
  auto shown = ShownScene::open(std::move(input), session_.limits, diagnostics_);
  if (!shown.ok()) return std::move(shown).error();
  shown_ = std::move(shown).value();
  if (Status read = read_scene_for(std::nullopt, diagnostics_); !read.ok()) return read;
  if (depends_on_viewer_ || !scene_.voxels.empty() || !scene_.surfels.empty() ||
      !scene_.shapes.empty())
    return {};
  return Error{
      Errc::malformed, Place::none(),
      "the scene shows nothing to draw (expected a DepthImage, an OctreeImage or a Shape)"};
}

Status Drawing::set_viewer(const nodes::Viewer& viewer, Diagnostics& diagnostics) {
  return depends_on_viewer_ ? read_scene_for(viewer, diagnostics) : Status();
}

Status Drawing::read_scene_for(const std::optional<nodes::Viewer>& viewer,
                               Diagnostics& diagnostics) {
  auto read = shown_->read(viewer, diagnostics);
  if (!read.ok()) return std::move(read).error();
  VisualScene& visual = read.value();
  auto scene = maker().make(visual, diagnostics);
  if (!scene.ok()) return std::move(scene).error();
  scene_ = std::move(scene).value();
  cameras_ = render::model_cameras(visual.models);
  viewpoints_ = std::move(visual.viewpoints);
  depends_on_viewer_ = visual.depends_on_viewer;
  viewer_ = viewer;
  return {};
}

Status Drawing::add(ModelInput&& model, Shade shade) {
  if (auto* mesh = std::get_if<Mesh>(&model)) {
    mesh_ = std::make_shared<Mesh>(std::move(*mesh));
    look_ = std::make_unique<MeshLook>(*mesh_, shade);
    corners_ = corners_of(*mesh_);
    shade_ = shade;
    return {};
  }
  if (const auto* models = std::get_if<std::vector<DibrModel>>(&model)) return add(*models);
  auto surfels = surfels_of_input(std::move(model), session_, diagnostics_);
  if (!surfels.ok()) return std::move(surfels).error();
  scene_.surfels.push_back({std::make_shared<Surfels>(std::move(surfels).value()), glm::dmat4(1)});
  return {};
}

Status Drawing::add(const std::vector<DibrModel>& models) {
  auto made = maker().make(models, diagnostics_);
  if (!made.ok()) return std::move(made).error();
  const auto append = [](auto& from, auto& to) { to.insert(to.end(), from.begin(), from.end()); };
  append(made.value().voxels, scene_.voxels);
  append(made.value().surfels, scene_.surfels);
  const std::vector<render::ModelCamera> cameras = render::model_cameras(models);
  append(cameras, cameras_);
  return {};
}

Result<render::Scene> Drawing::scene() const {
  if (!mesh_) return scene_;
  auto shapes = shapes_of(mesh_, shade_, session_.limits);
  if (!shapes.ok()) return std::move(shapes).error();
  render::Scene scene;
  scene.shapes = std::move(shapes).value();
  scene.headlight = true;
  return scene;
}

std::vector<glm::dvec3> Drawing::outline() const {
  return mesh_ ? corners_ : render::outline(scene_);
}

Result<render::RenderedImage> Drawing::draw_mesh(const render::Camera& camera,
                                                 const render::RenderOptions& options) const {
  double far = 0;
  const glm::dvec3 ahead = camera.orientation * glm::dvec3(0, 0, -1);
  for (const glm::dvec3& point : corners_)
    far = std::max(far, glm::dot(point - camera.position, ahead));
  const Shot shot{depth_camera(camera, options, std::max(far, camera.near_plane) * 1.01 + 1e-6),
                  options.width, options.height};
  // 5 and 7 samples do not divide the rows of a band.
  const unsigned samples =
      options.samples == 5 || options.samples == 7 ? options.samples + 1 : options.samples;
  auto picture = draw_picture(*look_, shot, samples, options.background, session_.options.threads,
                              session_.limits);
  if (!picture.ok()) return std::move(picture).error();
  render::RenderedImage image{std::move(picture).value(), {}};
  if (!options.depth) return image;
  auto depth = draw_distances(*look_, shot, session_.options.threads, session_.limits);
  if (!depth.ok()) return std::move(depth).error();
  image.depth = std::move(depth).value();
  return image;
}

Result<render::RenderedImage> Drawing::draw(const render::Camera& camera,
                                            const render::RenderOptions& options) const {
  if (mesh_) return draw_mesh(camera, options);
  return render::render(scene_, camera, options, session_.limits);
}

uint64_t Drawing::voxels() const {
  uint64_t voxels = 0;
  for (const render::VoxelCloud& cloud : scene_.voxels) voxels += cloud.tree->voxels();
  return voxels;
}

std::string Drawing::size() const {
  if (mesh_) return counted(mesh_->triangles.size(), "triangle");
  uint64_t points = 0, triangles = 0, lines = 0;
  for (const render::SurfelCloud& cloud : scene_.surfels) points += cloud.surfels->size();
  for (const Shape& shape : scene_.shapes) {
    const Geometry::Kind kind = shape.geometry->kind;
    uint64_t& count = kind == Geometry::Kind::triangles ? triangles
                      : kind == Geometry::Kind::lines   ? lines
                                                        : points;
    count += shape.geometry->indices.size() / corners_of(kind);
  }
  std::vector<std::string> parts;
  if (voxels() > 0) parts.push_back(counted(voxels(), "voxel"));
  if (points > 0) parts.push_back(counted(points, "point"));
  if (triangles > 0) parts.push_back(counted(triangles, "triangle"));
  if (lines > 0) parts.push_back(counted(lines, "line"));
  if (parts.empty()) return counted(0, "voxel");
  std::string text = parts.front();
  for (size_t i = 1; i < parts.size(); ++i)
    text += (i + 1 < parts.size() ? ", " : " and ") + parts[i];
  return text;
}

}  // namespace afx::tools
