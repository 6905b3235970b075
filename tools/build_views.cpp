// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/build_views.h"

#include <charconv>
#include <limits>
#include <utility>

#include "afx/builder/camera_list.h"
#include "afx/builder/mesh_surfels.h"
#include "afx/builder/view_plan.h"
#include "afx/builder/view_sources.h"
#include "tools/input.h"
#include "tools/scene_input.h"

namespace afx::tools {
namespace {

Result<std::vector<Shot>> cameras_of_scene(const Input& input, const BuildJob& job) {
  const auto scene = read_scene(input, job.session.limits, job.diagnostics);
  if (!scene.ok()) return scene.error();
  const auto models = read_dibr_models(scene.value().scene, scene.value().base(),
                                       job.session.limits, job.diagnostics);
  if (!models.ok()) return models.error();
  std::vector<Shot> shots;
  for (const DibrModel& model : models.value()) {
    const auto* images = model.depth_images();
    if (images == nullptr) continue;
    glm::dmat4 moved(1);
    moved[3] = model.to_world[3];
    if (model.to_world != moved)
      return Error{Errc::unsupported, Place::none(),
                   "its DepthImages stand under a Transform that turns or scales them (expected "
                   "one that moves them at most)"};
    for (const DepthImage& image : *images) {
      shots.push_back({image.camera, image.width(), image.height()});
      shots.back().camera.position += glm::dvec3(moved[3]);
    }
  }
  if (shots.empty())
    return Error{Errc::bad_argument, Place::none(), "has no DepthImages to take cameras from"};
  return shots;
}

Result<std::vector<Shot>> cameras_of_file(const std::string& path, const BuildJob& job) {
  const auto input = open_input(path, {}, job.session.limits, job.diagnostics);
  if (!input.ok()) return input.error();
  if (is_scene(input.value().kind)) return cameras_of_scene(input.value(), job);
  return read_camera_list(input.value().file.bytes(), job.session.limits);
}

}  // namespace

Result<std::unique_ptr<LookedAt>> LookedAt::of(ModelInput&& model, const BuildJob& job) {
  auto looked_at = std::make_unique<LookedAt>();
  const unsigned threads = job.session.options.threads;
  if (auto* mesh = std::get_if<Mesh>(&model)) {
    looked_at->mesh_ = std::move(*mesh);
    looked_at->look_.emplace(*looked_at->mesh_, shade_of(job.command.shade));
    looked_at->views_ = std::make_unique<MeshViews>(*looked_at->look_, threads, job.session.limits);
    return looked_at;
  }
  auto surfels = surfels_of_input(std::move(model), job.session, job.diagnostics);
  if (!surfels.ok()) return std::move(surfels).error();
  looked_at->surfels_ = std::move(surfels).value();
  looked_at->views_ =
      std::make_unique<SurfelViews>(looked_at->surfels_, threads, job.session.limits);
  return looked_at;
}

Result<Surfels> LookedAt::surfels(uint32_t resolution, const BuildJob& job) && {
  if (!look_) return std::move(surfels_);
  return surfels_of(*look_, resolution, job.session.options.threads, job.session.limits);
}

std::optional<uint64_t> count_of_views(const std::string& views) {
  uint64_t count = 0;
  const char* end = views.data() + views.size();
  const auto parsed = std::from_chars(views.data(), end, count);
  if (parsed.ptr != end) return {};
  return parsed.ec == std::errc() ? count : std::numeric_limits<uint64_t>::max();
}

Error nothing_to_see() {
  return {Errc::bad_argument, Place::none(),
          "nothing of the model can be seen (expected a surface before the cameras)"};
}

Result<ViewsOption> read_views_option(const BuildJob& job) {
  const std::string text = job.command.views.value_or("6");
  ViewsOption option;
  if (text == kAutomaticViews) return option;
  if (const std::optional<uint64_t> count = count_of_views(text)) {
    option.count = static_cast<unsigned>(*count);
    return option;
  }
  auto shots = cameras_of_file(text, job);
  if (!shots.ok()) return in_file(std::move(shots).error(), text);
  option.shots = std::move(shots).value();
  if (job.offset == glm::dvec3(0)) return option;
  for (Shot& shot : option.shots) {
    shot.camera.position -= job.offset;
    shot.camera = as_in_node(shot.camera);
  }
  return option;
}

}  // namespace afx::tools
