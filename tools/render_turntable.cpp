// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>

#include "afx/video_writer.h"
#include "codec/parallel.h"
#include "tools/progress_bar.h"
#include "tools/render_output.h"

namespace afx::tools {
namespace {

/// The frames of a turntable, as they are drawn.
class Turntable {
 public:
  explicit Turntable(RenderJob& job)
      : job_(job),
        around_(turning_point(job.command.camera, job.sight)),
        bar_(job.session.options.progress, job.session.options.quiet) {}

  [[nodiscard]] render::Camera camera(uint32_t k) const {
    return turned_camera(job_.camera, around_, 2 * std::numbers::pi * k / job_.plan.frames);
  }

  Status draw(uint32_t k, render::RenderedImage& image) {
    bar_.show("drawing", double{1} * k / job_.plan.frames);
    const auto start = std::chrono::steady_clock::now();
    Status drawn = job_.drawer.draw(camera(k), job_.plan.options, image);
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return drawn;
  }

  /// What all draw() took together.
  [[nodiscard]] double seconds() const { return seconds_; }

 private:
  RenderJob& job_;
  glm::dvec3 around_;
  ProgressBar bar_;
  double seconds_ = 0;
};

/// How many pictures are kept to be encoded at once: one for each thread, if they are not large.
uint32_t batch_of(const RenderJob& job) {
  constexpr uint64_t kMostBytes = uint64_t{512} << 20;
  const render::RenderOptions& options = job.plan.options;
  const uint64_t bytes = uint64_t{options.width} * options.height * (options.depth ? 8 : 4);
  const uint64_t fit = std::max<uint64_t>(kMostBytes / bytes, 1);
  return static_cast<uint32_t>(std::min<uint64_t>(fit, thread_count(options.threads)));
}

/// Draws one after the other, each on all threads, then encodes them side by side.
Status write_pictures(const RenderJob& job, Turntable& turntable) {
  const uint32_t batch = batch_of(job);
  std::vector<render::RenderedImage> images(batch);
  for (uint32_t first = 0; first < job.plan.frames; first += batch) {
    const uint32_t count = std::min(batch, job.plan.frames - first);
    for (uint32_t i = 0; i < count; ++i)
      if (Status drawn = turntable.draw(first + i, images[i]); !drawn.ok()) return drawn;
    std::vector<std::optional<Result<std::vector<uint8_t>>>> files(count);
    parallel_for(count, job.session.options.threads, [&](size_t i) {
      files[i] = encode_image(images[i], job.plan.format, job.command.jpeg_quality);
    });
    for (uint32_t i = 0; i < count; ++i) {
      if (!files[i]->ok()) return files[i]->error();
      Status put = job.outputs.put(job.plan.names.name(first + i), files[i]->value());
      if (!put.ok()) return put;
    }
  }
  return {};
}

Status write_video(const RenderJob& job, Turntable& turntable) {
  render::RenderedImage image;
  for (uint32_t k = 0; k < job.plan.frames; ++k) {
    if (Status drawn = turntable.draw(k, image); !drawn.ok()) return drawn;
    if (Status added = job.video->add(image.picture); !added.ok()) return added;
  }
  auto bytes = job.video->finish();
  if (!bytes.ok()) return std::move(bytes).error();
  return job.outputs.put(job.command.output, bytes.value());
}

std::vector<std::string> names_of(const RenderPlan& plan) {
  std::vector<std::string> names;
  for (uint32_t k = 0; k < plan.frames; ++k) names.push_back(plan.names.name(k));
  return names;
}

nlohmann::ordered_json result_of(const RenderJob& job, const Turntable& turntable) {
  nlohmann::ordered_json json;
  if (job.plan.is_video) {
    json["output"] = job.command.output;
    json["fps"] = job.command.fps.value_or(VideoOptions().fps);
  } else {
    json["outputs"] = names_of(job.plan);
  }
  json["frames"] = job.plan.frames;
  json["width"] = job.plan.options.width;
  json["height"] = job.plan.options.height;
  json["voxels"] = job.drawing.voxels();
  for (uint32_t k = 0; k < job.plan.frames; ++k)
    json["cameras"].push_back(json_of(turntable.camera(k)));
  return json;
}

std::string line_of(const RenderJob& job, const Turntable& turntable) {
  const std::string last = job.plan.names.name(job.plan.frames - 1);
  const std::string first = job.plan.names.name(0);
  const std::string files =
      job.plan.is_video ? job.command.output : first + (last == first ? "" : " to " + last);
  return files + ": " + counted(job.plan.frames, "picture") + " of " +
         std::to_string(job.plan.options.width) + " x " + std::to_string(job.plan.options.height) +
         ", " + job.drawing.size() +
         (job.video == nullptr || !job.session.options.verbose
              ? ""
              : ", encoded by " + job.video->encoder()) +
         told_time(job, turntable.seconds());
}

}  // namespace

Result<VideoWriter> begin_video(const RenderCommand& command, const RenderPlan& plan,
                                const Limits& limits) {
  VideoOptions options;
  options.format = plan.format;
  options.width = plan.options.width;
  options.height = plan.options.height;
  options.fps = command.fps.value_or(options.fps);
  options.quality = command.video_quality.value_or(options.quality);
  return VideoWriter::begin(options, limits);
}

int render_turntable(RenderJob& job) {
  std::optional<Turntable> turntable(std::in_place, job);
  if (!job.session.options.dry_run) {
    const Status written =
        job.video != nullptr ? write_video(job, *turntable) : write_pictures(job, *turntable);
    if (!written.ok()) {
      turntable.reset();  // takes the bar away before anything is said
      return job.session.fail(written.error(), job.command.output);
    }
  }
  const std::string line = line_of(job, *turntable);
  nlohmann::ordered_json json = result_of(job, *turntable);
  turntable.reset();
  return job.session.finish(job.outputs, job.command.output, {line}, std::move(json));
}

}  // namespace afx::tools
