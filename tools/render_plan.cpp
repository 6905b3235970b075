// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <algorithm>

#include "afx/picture_io.h"
#include "afx/video_writer.h"
#include "tools/formats.h"
#include "tools/picture_options.h"
#include "tools/render_command.h"

namespace afx::tools {
namespace {

bool has_alpha(const Picture& picture) { return picture.components % 2 == 0; }

/// A sentence about options that do not go together; empty: there is none.
std::string wrong_options(const RenderCommand& command, const RenderPlan& plan) {
  if (std::string wrong = wrong_camera_option(command.camera); !wrong.empty()) return wrong;
  if (command.output.empty() && command.compare.empty())
    return "there is nothing to do (expected --output, --compare or both)";
  if (command.output.empty() && !command.format.empty()) return "--format needs --output";
  if (command.compare.empty() && command.min_psnr) return "--min-psnr needs --compare";
  if (command.compare.empty() && command.max_mse) return "--max-mse needs --compare";
  if (!command.compare.empty() && command.turntable)
    return "--compare is for one picture, not for --turntable";
  if (!command.compare.empty() && command.output == "-")
    return "--compare and -o - both write to standard output";
  if (command.depth && plan.format != "exr")
    return "--depth is for .exr, which alone holds depth" +
           (plan.format.empty() ? "" : ", not for ." + plan.format);
  if (!plan.is_video && command.fps) return "--fps is for videos";
  if (!plan.is_video && command.video_quality) return "--video-quality is for videos";
  if (plan.is_video && !command.turntable)
    return "a video is of several pictures (expected --turntable N)";
  return {};
}

/// A sentence about the name for several pictures; empty: it is right.
std::string wrong_names(const RenderCommand& command, const RenderPlan& plan) {
  if (plan.is_video || plan.frames < 2 || plan.names.has_number) return {};
  return std::to_string(plan.frames) + " pictures cannot all be " + command.output +
         " (expected a number in the name, such as frame_%04d." +
         (plan.format == "jpeg" ? "jpg" : plan.format) + ", or a video, such as turn.mp4)";
}

int read_reference(const RenderCommand& command, const Session& session, RenderPlan& plan) {
  if (command.compare.empty()) return kDone;
  auto picture = read_picture(command.compare, session.limits);
  if (!picture.ok()) return session.fail(picture.error(), command.compare);
  plan.reference = std::move(picture).value();
  return kDone;
}

int plan_size(const RenderCommand& command, const Session& session, RenderPlan& plan) {
  std::string size = command.size.empty() ? "1024x1024" : command.size;
  if (command.size.empty() && plan.reference)
    size = std::to_string(plan.reference->width) + "x" + std::to_string(plan.reference->height);
  const std::string sides = "WIDTHxHEIGHT, each 1.." + std::to_string(render::kMaxSide);
  if (!parse_size(size, plan.options.width, plan.options.height))
    return session.usage("--size is " + size + " (expected " + sides + ")");
  if (plan.is_video && (plan.options.width % 2 != 0 || plan.options.height % 2 != 0))
    return session.usage("--size is " + size + " (expected even numbers for a video)");
  return kDone;
}

int plan_background(const RenderCommand& command, const Session& session, RenderPlan& plan) {
  const bool must_be = plan.format == "jpeg" || plan.is_video;
  const bool opaque =
      must_be || (plan.format.empty() && plan.reference && !has_alpha(*plan.reference));
  const std::string background =
      command.background.empty() ? (opaque ? "white" : "transparent") : command.background;
  if (!parse_colour(background, plan.options.background))
    return session.usage("--background is " + background +
                         " (expected #rrggbb, #rrggbbaa, white, black or transparent)");
  if (must_be && plan.options.background.a != 255)
    return session.usage(std::string(plan.is_video ? "a video" : "JPEG") +
                         " has no transparency (expected an opaque --background)");
  return kDone;
}

/// Whether all outputs can be written.
int check_outputs(const RenderCommand& command, const OutputFiles& outputs, const Session& session,
                  const RenderPlan& plan) {
  if (command.output.empty()) return kDone;
  const uint32_t files = plan.is_video ? 1 : std::max<uint32_t>(plan.frames, 1);
  const bool numbered = !plan.is_video && plan.frames > 0;
  for (uint32_t k = 0; k < files; ++k) {
    const std::string name = numbered ? plan.names.name(k) : command.output;
    if (const Status free = outputs.check(name); !free.ok())
      return session.fail(free.error(), name);
  }
  return kDone;
}

int plan_format(const RenderCommand& command, const Session& session, RenderPlan& plan) {
  constexpr const char* kOutputs[] = {"png", "jpeg", "bmp",  "tga", "exr",
                                      "mp4", "mkv",  "webm", "avi"};
  constexpr const char* kInputs[] = {"wrl", "bt", "afx", "oct"};
  if (!command.output.empty()) {
    const int code = output_format(session, command.output, command.format, kOutputs, plan.format);
    if (code != kDone) return code;
  }
  plan.is_video = is_video_format(plan.format);
  plan.frames = command.turntable.value_or(0);
  plan.names = NamePattern(command.output);
  return check_input_format(session, command.input_format, kInputs);
}

void plan_looks(const RenderCommand& command, const Session& session,
                render::RenderOptions& options) {
  options.samples = command.samples;
  options.depth = command.depth;
  options.threads = session.options.threads;
  if (command.coarseness) options.coarseness = *command.coarseness;
  if (command.splats == "flat") options.splats = render::SplatKind::flat;
  if (command.splats == "points") options.splats = render::SplatKind::points;
}

}  // namespace

int make_plan(const RenderCommand& command, const OutputFiles& outputs, const Session& session,
              RenderPlan& plan) {
  if (const int code = plan_format(command, session, plan); code != kDone) return code;
  for (const std::string& wrong : {wrong_options(command, plan), wrong_names(command, plan)})
    if (!wrong.empty()) return session.usage(wrong);
  if (const int code = read_reference(command, session, plan); code != kDone) return code;
  if (const int code = plan_size(command, session, plan); code != kDone) return code;
  if (const int code = plan_background(command, session, plan); code != kDone) return code;
  plan_looks(command, session, plan.options);
  return check_outputs(command, outputs, session, plan);
}

}  // namespace afx::tools
