// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/render_output.h"

#include <chrono>
#include <iostream>
#include <nlohmann/json.hpp>

#include "afx/picture_io.h"
#include "tools/picture_verdict.h"

namespace afx::tools {
namespace {

Picture with_alpha(const Picture& picture) {
  Picture rgba(picture.width, picture.height, 4);
  for (uint32_t y = 0; y < picture.height; ++y) {
    for (uint32_t x = 0; x < picture.width; ++x) {
      const Rgba8 colour = colour_at(picture, x, y);
      uint8_t* to = rgba.pixel(x, y);
      to[0] = colour.r;
      to[1] = colour.g;
      to[2] = colour.b;
      to[3] = colour.a;
    }
  }
  return rgba;
}

/// Lets the limits decide, where some are given.
void judge(const RenderCommand& command, Verdict& verdict) {
  if (!command.min_psnr && !command.max_mse) return;
  std::vector<std::string> broken;
  if (const auto squared = verdict.json.find("meanSquared"); squared != verdict.json.end()) {
    const bool equal = !verdict.json.contains("psnr");
    if (command.min_psnr && !equal && verdict.json["psnr"] < *command.min_psnr)
      broken.push_back("PSNR is " + fixed(verdict.json["psnr"].get<double>(), 2) +
                       " dB (expected at least " + fixed(*command.min_psnr, 2) + ")");
    if (command.max_mse && *squared > *command.max_mse)
      broken.push_back("the mean of squares is " + fixed(squared->get<double>(), 4) +
                       " (expected at most " + fixed(*command.max_mse, 4) + ")");
    verdict.different = !broken.empty();
  }
  for (const std::string& text : broken) verdict.text += "\nbeyond the limit: " + text;
  verdict.json["broken"] = std::move(broken);
}

/// Where the reference has no alpha, without it.
Result<Verdict> compare_with_reference(const RenderJob& job, const Picture& drawn) {
  const Picture& reference = *job.plan.reference;
  const Picture other = with_alpha(reference);
  auto verdict = reference.components % 2 == 0
                     ? compare_two_pictures(drawn, other)
                     : compare_two_pictures(without_alpha(drawn), without_alpha(other));
  if (verdict.ok()) judge(job.command, verdict.value());
  return verdict;
}

Status put(const RenderJob& job, const render::RenderedImage& image) {
  if (job.session.options.dry_run) return {};
  const auto bytes = encode_image(image, job.plan.format, job.command.jpeg_quality);
  if (!bytes.ok()) return bytes.error();
  return job.outputs.put(job.command.output, bytes.value());
}

/// The end: names the output, tells what there is to tell.
int finish(const RenderJob& job, const std::string& line, nlohmann::ordered_json json,
           const Verdict* verdict) {
  if (verdict != nullptr) json["comparison"] = verdict->json;
  if (!job.command.output.empty()) {
    const int code = job.session.finish(job.outputs, job.command.output, {line}, std::move(json));
    if (code != kDone) return code;
  } else {
    if (job.session.options.verbose) job.session.say(line);
    job.session.result(json);
  }
  if (verdict == nullptr) return kDone;
  if (!job.session.options.json) std::cout << verdict->text << '\n';
  return verdict->different ? kDifferent : kDone;
}

}  // namespace

Picture without_alpha(const Picture& picture) {
  Picture rgb(picture.width, picture.height, 3);
  for (size_t i = 0; i < size_t{picture.width} * picture.height; ++i) {
    for (size_t k = 0; k < 3; ++k) rgb.samples[i * 3 + k] = picture.samples[i * 4 + k];
  }
  return rgb;
}

Result<std::vector<uint8_t>> encode_image(const render::RenderedImage& image,
                                          const std::string& format, int jpeg_quality) {
  const PictureOptions options{.jpeg_quality = jpeg_quality, .depth = image.depth};
  if (format == "jpeg") return encode_picture(without_alpha(image.picture), format, options);
  return encode_picture(image.picture, format, options);
}

std::string told_time(const RenderJob& job, double seconds) {
  if (!job.session.options.verbose) return {};
  return ", drawn by " + job.drawer.name() + " in " + fixed(seconds * 1000, 1) + " ms";
}

int render_picture(RenderJob& job) {
  const auto start = std::chrono::steady_clock::now();
  render::RenderedImage image;
  const render::RenderOptions& options = job.plan.options;
  if (Status drawn = job.drawer.draw(job.camera, options, image); !drawn.ok())
    return job.session.fail(drawn.error(), job.command.input);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::optional<Verdict> verdict;
  if (job.plan.reference) {
    auto compared = compare_with_reference(job, image.picture);
    if (!compared.ok()) return job.session.fail(compared.error(), job.command.compare);
    verdict = std::move(compared).value();
  }
  if (!job.command.output.empty()) {
    if (Status written = put(job, image); !written.ok())
      return job.session.fail(written.error(), job.command.output);
  }
  nlohmann::ordered_json json;
  if (!job.command.output.empty()) json["output"] = job.command.output;
  json["width"] = options.width;
  json["height"] = options.height;
  json["voxels"] = job.drawing.voxels();
  json["camera"] = json_of(job.camera);
  const std::string name = job.command.output.empty() ? job.command.input : job.command.output;
  return finish(job,
                name + ": " + std::to_string(options.width) + " x " +
                    std::to_string(options.height) + ", " + job.drawing.size() +
                    told_time(job, seconds),
                std::move(json), verdict ? &*verdict : nullptr);
}

}  // namespace afx::tools
