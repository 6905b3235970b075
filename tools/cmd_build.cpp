// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>

#include "afx/builder/depth_image_builder.h"
#include "afx/builder/octree_builder.h"
#include "afx/builder/reference_cameras.h"
#include "afx/builder/view_plan.h"
#include "nodes/scene_writer.h"
#include "tools/build.h"
#include "tools/build_views.h"
#include "tools/commands.h"
#include "tools/formats.h"

namespace afx::tools {
namespace {

struct Form {
  const char* name;
  Result<BuiltScene> (*build)(ModelInput&&, const BuildJob&);
  uint32_t most;  ///< the greatest --resolution
};
constexpr Form kForms[] = {{"octree", build_octree_scene, kMaxBuildResolution},
                           {"depth", build_depth_scene, kMaxPictureResolution},
                           {"points", build_points_scene, kMaxPictureResolution}};

const Form& form_of(const BuildCommand& command) {
  for (const Form& form : kForms)
    if (command.as == form.name) return form;
  return kForms[0];  // the option takes no other
}

/// A sentence about --views; empty: nothing is wrong with it, or it names a file.
std::string wrong_views(const BuildCommand& c) {
  if (!c.views) return {};
  const std::optional<uint64_t> count = count_of_views(*c.views);
  if (c.as == "points" && (count || *c.views == kAutomaticViews))
    return "--views is " + *c.views +
           " (expected a file with one camera, the reference plane of --as points)";
  if (count && (*count < 1 || *count > kMostViews))
    return "--views is " + *c.views + " (expected 1 to " + std::to_string(kMostViews) +
           ", auto or a file)";
  return {};
}

/// A sentence about options that are wrong or do not fit each other; empty: there is none.
std::string clash(const BuildCommand& c) {
  const Form& form = form_of(c);
  if (c.resolution > form.most)
    return "--resolution is " + std::to_string(c.resolution) + " (expected 1 to " +
           std::to_string(form.most) + " for --as " + c.as + ")";
  const bool octree = c.as == "octree", depth = c.as == "depth";
  const bool targets = c.target_size || c.target_psnr;
  if (!octree && (c.image_size != 0 || c.images != 0 || targets || !c.cube.empty()))
    return "--image-size, --images, --target-size, --target-psnr and --cube are for --as octree";
  if (octree && (c.views || c.perspective || c.depth_bits != 0))
    return "--views, --perspective and --depth-bits are for --as depth and --as points";
  if (!depth && (c.coverage || c.depth_in_alpha))
    return "--coverage and --depth-in-alpha are for --as depth";
  if (depth && c.depth_bits != 0 && c.depth_bits != 8 && c.depth_bits != 16)
    return "--depth-bits is " + std::to_string(c.depth_bits) + " (expected 8 or 16 for --as depth)";
  if (c.depth_in_alpha && c.image_format == "jpeg")
    return "JPEG has no alpha channel (expected --image-format png with --depth-in-alpha)";
  if (c.images != 0 && c.images < kSideViews)
    return "--images is " + std::to_string(c.images) + " (expected 0, or 6 to 127)";
  if (!std::isfinite(c.scale) || !std::isfinite(c.fit.value_or(1)))
    return "--scale or --fit is not finite (expected a number above 0)";
  if (c.fit && c.scale != 1) return "--scale and --fit exclude each other";
  if (c.target_size && c.target_psnr) return "--target-size and --target-psnr exclude each other";
  if (targets && c.image_format != "jpeg")
    return "PNG has one quality only (expected --image-format jpeg with a target)";
  if (!c.cube.empty() && !(c.cube[3] > 0)) return "the side of --cube is not above 0";
  return wrong_views(c);
}

/// Files of these kinds mean z by up more often than not; the user may not know.
std::string hint_of(const BuildCommand& command) {
  const std::string ending = ending_of(command.inputs.front());
  if (!command.up.empty() || (ending != "stl" && ending != "3ds")) return {};
  return "  up: the y axis; files of this kind often mean z, which --up z takes";
}

Result<ModelInput> read_input(const BuildJob& job) {
  const auto input =
      open_model_input(job.command.inputs.front(), {}, job.session.limits, job.diagnostics);
  if (!input.ok()) return input.error();
  if (Status right = refuse_raw_octree(input.value()); !right.ok()) return right.error();
  OctreeQuery query;
  return read_model_input(input.value(), query, job.session, job.diagnostics);
}

Result<BuiltScene> build_scene(const BuildJob& job) {
  job.bar.show("reading", 0);
  auto model = read_input(job);
  if (!model.ok()) return std::move(model).error();
  if (Status placed = place_input(model.value(), job); !placed.ok()) return placed.error();
  BuildJob placed_job = job;
  placed_job.offset = take_offset(model.value());
  return form_of(job.command).build(std::move(model).value(), placed_job);
}

/// Writes the text of the scene; gives its size.
Result<uint64_t> write_scene(const BuiltScene& built, const std::string& format,
                             const std::string& path, const Session& session,
                             OutputFiles& outputs) {
  uint64_t bytes = 0;
  OutputFiles::Sink put = [](std::span<const uint8_t>) { return Status(); };
  if (!session.options.dry_run) {
    auto begun = outputs.begin(path);
    if (!begun.ok()) return std::move(begun).error();
    put = std::move(begun).value();
  }
  const nodes::TextSink sink = [&](std::string_view text) {
    bytes += text.size();
    return put({reinterpret_cast<const uint8_t*>(text.data()), text.size()});
  };
  const Status written =
      nodes::write_scene_text_to(sink, built.scene, {.vrml_header = format != "bt"});
  if (!written.ok()) return written.error();
  return bytes;
}

int build(const BuildCommand& command, const Session& session) {
  if (command.inputs.size() > 1)
    return session.usage(
        "this version builds from one INPUT at a time (several RGB-D pictures: "
        "one .json that lists them)");
  constexpr const char* kOutputs[] = {"wrl", "bt"};
  std::string format;
  if (const int code = output_format(session, command.output, {}, kOutputs, format); code != kDone)
    return code;
  if (const std::string text = clash(command); !text.empty()) return session.usage(text);
  OutputFiles outputs(session.options.overwrite);
  if (Status free = outputs.check(command.output); !free.ok())
    return session.fail(free.error(), command.output);
  const std::string& input = command.inputs.front();
  Diagnostics diagnostics;
  ProgressBar bar(session.options.progress, session.options.quiet);
  bool option_is_wrong = false;
  auto built = build_scene({command, session, bar, outputs, diagnostics, option_is_wrong});
  if (!built.ok()) {
    session.show(diagnostics, input);
    return session.fail_query(built.error(), option_is_wrong, input);
  }
  if (const int code = session.warn(diagnostics, input); code != kDone) return code;
  const auto bytes = write_scene(built.value(), format, command.output, session, outputs);
  if (!bytes.ok()) return session.fail(bytes.error(), command.output);
  std::vector<std::string> lines{command.output + ": " + counted(bytes.value(), "byte") +
                                 " of scene text"};
  lines.insert(lines.end(), built.value().lines.begin(), built.value().lines.end());
  if (const std::string hint = hint_of(command); !hint.empty()) lines.push_back(hint);
  nlohmann::ordered_json json{{"output", command.output}, {"sceneBytes", bytes.value()}};
  json.update(built.value().json);
  return session.finish(outputs, command.output, lines, json);
}

void add_common_forms(CLI::App& command, BuildCommand& options) {
  command
      .add_option("INPUT", options.inputs,
                  "Mesh (.obj .ply .gltf .glb .dae .stl ...), points (.ply), RGB-D pictures "
                  "(.json) or a scene of DIBR nodes")
      ->required();
  command
      .add_option("-o,--output", options.output,
                  "The scene (.wrl .bt); its pictures are written beside it")
      ->required();
  command
      .add_option("--as", options.as,
                  "octree = OctreeImage, depth = DepthImages with SimpleTextures, points = one "
                  "DepthImage with a PointTexture")
      ->check(CLI::IsMember({"octree", "depth", "points"}))
      ->capture_default_str();
  command
      .add_option_function<uint32_t>(
          "--resolution",
          [&options](const uint32_t& value) {
            options.resolution = value;
            options.resolution_given = true;
          },
          "Voxels or pixels along the longest side")
      ->check(CLI::Range(1U, kMaxPictureResolution))
      ->default_str("256");
  command
      .add_option("--up", options.up,
                  "Axis of the input that points up; z, as most scans, CAD and .stl files have it, "
                  "is turned to y")
      ->check(CLI::IsMember({"y", "z"}))
      ->default_str("y");
  command.add_option("--scale", options.scale, "Makes the model so many times as large")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command
      .add_option("--fit", options.fit,
                  "Puts the model's middle at the origin and makes its longest side so long")
      ->check(CLI::PositiveNumber);
  command
      .add_option("--shade", options.shade,
                  "Soft light painted into the colours: auto = where the model has none of its own")
      ->check(CLI::IsMember({"auto", "always", "never"}))
      ->capture_default_str();
  command.add_option("--image-format", options.image_format, "Format of the colour pictures")
      ->check(CLI::IsMember({"png", "jpeg"}))
      ->capture_default_str();
  command.add_option("--jpeg-quality", options.jpeg_quality, "Quality of JPEG pictures")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
}

void add_camera_options(CLI::App& command, BuildCommand& options) {
  command
      .add_option("--views", options.views,
                  "Views of --as depth: a number spread evenly (6 = the sides of a box), auto = as "
                  "many as show all there is to see, or a file: cameras (.json) or a scene whose "
                  "cameras are taken; of --as points the file with the one camera, default: from "
                  "the front")
      ->default_str("6");
  command.add_flag("--perspective", options.perspective, "Cameras with perspective");
  command.add_flag("--coverage", options.coverage,
                   "Measures which part of the visible surface the views show");
  command
      .add_option("--depth-bits", options.depth_bits,
                  "Bits of a depth: 8 or 16 (default) for --as depth; 1 to 32 for --as points, "
                  "default: what half a pixel's side asks for")
      ->check(CLI::Range(1U, 32U));
  command.add_flag("--depth-in-alpha", options.depth_in_alpha,
                   "Depth in the alpha channel of the colour picture");
}

void add_octree_options(CLI::App& command, BuildCommand& options) {
  command
      .add_option("--images", options.images,
                  "Reference images at most, 6 to 127; 0 = as many as it is worth")
      ->check(CLI::Range(0U, 127U))
      ->capture_default_str();
  command
      .add_option("--image-size", options.image_size,
                  "Pixels along a side of the reference images, 0 = as fine as the voxels")
      ->check(CLI::Range(0U, 4096U))
      ->capture_default_str();
  command.add_option("--target-size", options.target_size,
                     "Bytes of coded octree and JPEG pictures together: finds the quality");
  command.add_option("--target-psnr", options.target_psnr,
                     "dB of the used pixels of JPEG pictures: finds the quality");
  command
      .add_option("--cube", options.cube,
                  "X Y Z SIDE: centre and side of the cube to build in, in the scene; default: "
                  "around the model, or the cube of the OctreeImage given")
      ->expected(4);
}

}  // namespace

void add_build(CLI::App& program, Session& session) {
  auto options = std::make_shared<BuildCommand>();
  CLI::App* command = program.add_subcommand(
      "build", "Mesh, points, RGB-D pictures or another scene -> scene of DIBR nodes");
  add_common_forms(*command, *options);
  add_camera_options(*command, *options);
  add_octree_options(*command, *options);
  add_common_options(*command, session, {.outputs = true, .progress = true});
  command->callback([options, &session] {
    session.command = "build";
    session.exit = build(*options, session);
  });
}

}  // namespace afx::tools
