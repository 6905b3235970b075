// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "afx/builder/model_reader.h"
#include "afx/builder/octree_builder.h"
#include "afx/file.h"
#include "afx/octree_image.h"
#include "afx/picture_io.h"
#include "nodes/scene_writer.h"
#include "tools/abort_guard.h"
#include "tools/commands.h"
#include "tools/input.h"
#include "tools/progress_bar.h"
#include "tools/session.h"

namespace afx::tools {
namespace {

struct BuildCommand {
  std::vector<std::string> inputs;
  std::string output;
  uint32_t resolution = 256;
  uint32_t image_size = 0;
  std::string image_format = "png";
  int jpeg_quality = 90;
  std::string shade = "auto";
  std::string up;  ///< empty: not given, y
};

/// The scene of a built model, in the input's own coordinates.
nodes::Scene compose(const BuiltOctree& built, const std::vector<std::string>& pictures) {
  std::vector<ReferenceImageNode> images;
  for (size_t i = 0; i < pictures.size(); ++i) {
    images.push_back({built.model.images[i], pictures[i], kReferenceNearPlane, kReferenceFarPlane});
  }
  nodes::Scene scene;
  const auto top = scene.add("Group");  // BIFS has no Transform at the top
  const auto transform = scene.add("Transform");
  const nodes::NodeId octree =
      add_octree_image(scene, built.model.resolution, built.model.fields, images);
  const auto side = static_cast<float>(built.statistics.side);
  // All of it is known to be right: the fields exist and an OctreeImage may stand under a
  // Transform.
  (void)scene.set(transform.value(), "translation", glm::vec3(built.statistics.centre));
  (void)scene.set(transform.value(), "scale", glm::vec3(side));
  (void)scene.append(transform.value(), "children", octree);
  (void)scene.append(top.value(), "children", transform.value());
  scene.add_root(top.value());
  return scene;
}

/// Where a picture goes: beside the scene, with its name in front.
std::string picture_name(const BuildCommand& command, const std::string& name) {
  const std::string stem = std::filesystem::path(command.output).stem().string();
  return stem + "_" + name + (command.image_format == "jpeg" ? ".jpg" : ".png");
}

Result<BuiltOctree> build_from_file(const BuildCommand& command, const Session& session,
                                    Diagnostics& diagnostics) {
  ProgressBar bar(session.options.progress, session.options.quiet);
  bar.show("reading", 0);
  const auto source = [&] {
    const AbortGuard guard(command.inputs.front());
    return read_source_model(command.inputs.front(), session.limits, diagnostics);
  }();
  if (!source.ok()) return source.error();
  BuildOptions options;
  options.resolution = command.resolution;
  options.image_size = command.image_size;
  options.threads = session.options.threads;
  options.up = command.up == "z" ? UpAxis::z : UpAxis::y;
  if (command.shade == "always") options.shade = Shade::always;
  if (command.shade == "never") options.shade = Shade::never;
  options.limits = session.limits;
  options.progress = [&bar](const char* stage, double done) { bar.show(stage, done); };
  return std::visit([&](const auto& model) { return build_octree(model, options, diagnostics); },
                    source.value());
}

/// What there is to say of it, for people.
std::vector<std::string> lines_of(const BuildCommand& command, const BuiltOctree& built,
                                  uint64_t image_bytes, uint64_t scene_bytes) {
  const BuildStatistics& s = built.statistics;
  const double seen =
      s.exposed == 0 ? 100 : 100.0 * static_cast<double>(s.seen) / static_cast<double>(s.exposed);
  std::vector<std::string> lines{
      command.output + ": " + counted(scene_bytes, "byte") + " of scene text",
      "  voxels: " + grouped(s.voxels) + " at resolution " +
          std::to_string(built.model.resolution) + ", from " + grouped(s.primitives) +
          " triangles or points",
      "  octree: " + counted(built.model.fields.octree.size(), "byte") +
          "; image indices: " + counted(built.model.fields.voxel_image_index.size(), "symbol"),
      "  images: " + std::to_string(built.model.images.size()) + ", " +
          counted(image_bytes, "byte") + "; they show " + fixed(seen, 1) +
          " % of the outside, colours at " + fixed(s.psnr, 1) + " dB"};
  const std::string ending = ending_of(command.inputs.front());
  if (command.up.empty() && (ending == "stl" || ending == "3ds")) {
    lines.push_back("  up: the y axis; files of this kind often mean z, which --up z takes");
  }
  return lines;
}

nlohmann::ordered_json json_of(const BuildCommand& command, const BuiltOctree& built,
                               uint64_t image_bytes, uint64_t scene_bytes) {
  const BuildStatistics& s = built.statistics;
  return {{"output", command.output},
          {"sceneBytes", scene_bytes},
          {"octreeResolution", built.model.resolution},
          {"primitives", s.primitives},
          {"voxels", s.voxels},
          {"octreeBytes", built.model.fields.octree.size()},
          {"voxelImageIndexSymbols", built.model.fields.voxel_image_index.size()},
          {"images", built.model.images.size()},
          {"imageBytes", image_bytes},
          {"exposedVoxels", s.exposed},
          {"seenVoxels", s.seen},
          {"psnr", s.psnr},
          {"shaded", s.shaded}};
}

/// Encodes the pictures and puts everything in; returns an exit code.
int write(const BuildCommand& command, const std::string& format, const BuiltOctree& built,
          OutputFiles& outputs, const Session& session) {
  const std::filesystem::path folder = std::filesystem::path(command.output).parent_path();
  std::vector<std::string> names;
  uint64_t image_bytes = 0;
  for (size_t i = 0; i < built.model.images.size(); ++i) {
    names.push_back(picture_name(command, built.names[i]));
    const auto bytes = encode_picture(built.model.images[i].picture, command.image_format,
                                      {.jpeg_quality = command.jpeg_quality});
    if (!bytes.ok()) return session.fail(bytes.error(), names.back());
    image_bytes += bytes.value().size();
    if (session.options.dry_run) continue;
    if (Status put = outputs.put((folder / names.back()).string(), bytes.value()); !put.ok())
      return session.fail(put.error());
  }
  const nodes::Scene scene = compose(built, names);
  const std::string text = nodes::write_scene_text(scene, {.vrml_header = format != "bt"});
  if (!session.options.dry_run) {
    const auto* bytes = reinterpret_cast<const uint8_t*>(text.data());
    if (Status put = outputs.put(command.output, {bytes, text.size()}); !put.ok())
      return session.fail(put.error());
  }
  return session.finish(outputs, command.output, lines_of(command, built, image_bytes, text.size()),
                        json_of(command, built, image_bytes, text.size()));
}

/// Asks before the long work whether the outputs may be written.
Status check_outputs(const BuildCommand& command, const OutputFiles& outputs) {
  const std::filesystem::path folder = std::filesystem::path(command.output).parent_path();
  for (unsigned i = 0; i < kSideViews; ++i) {
    if (Status free = outputs.check((folder / picture_name(command, reference_name(i))).string());
        !free.ok())
      return free;
  }
  return outputs.check(command.output);
}

/// Refuses what certainly is no mesh, before the model library finds words for it.
Status check_input(const std::string& path, const Limits& limits) {
  const auto file = MappedFile::open(path, limits);
  if (!file.ok()) return file.error();
  const Kind content = kind_of_content(file.value().bytes());
  const Kind kind = content == Kind::unknown ? kind_of_ending(path) : content;
  if (kind == Kind::model || kind == Kind::unknown) return {};
  return Error{Errc::unsupported,
               Place::none(),
               std::string("is ") + describe(kind) + " (expected a mesh or coloured points)",
               {},
               path};
}

int build(const BuildCommand& command, const Session& session) {
  if (command.inputs.size() > 1)
    return session.usage("this version builds from one INPUT at a time");
  constexpr const char* kOutputs[] = {"wrl", "bt"};
  std::string format;
  if (const int code = output_format(session, command.output, {}, kOutputs, format); code != kDone)
    return code;
  OutputFiles outputs(session.options.overwrite);
  if (Status free = check_outputs(command, outputs); !free.ok())
    return session.fail(free.error(), command.output);
  const std::string& input = command.inputs.front();
  if (Status fits = check_input(input, session.limits); !fits.ok())
    return session.fail(fits.error(), input);
  Diagnostics diagnostics;
  const auto built = build_from_file(command, session, diagnostics);
  if (!built.ok()) return session.fail(built.error(), input, diagnostics);
  if (const int code = session.warn(diagnostics, input); code != kDone) return code;
  return write(command, format, built.value(), outputs, session);
}

}  // namespace

void add_build(CLI::App& program, Session& session) {
  auto options = std::make_shared<BuildCommand>();
  CLI::App* command =
      program.add_subcommand("build", "Mesh or point cloud -> scene with an OctreeImage");
  command
      ->add_option("INPUT", options->inputs,
                   "Mesh (.obj .ply .gltf .glb .dae .stl ...) or coloured points (.ply)")
      ->required();
  command
      ->add_option("-o,--output", options->output,
                   "The scene (.wrl .bt); its pictures are written beside it")
      ->required();
  command->add_option("--resolution", options->resolution, "Voxels along the longest side")
      ->check(CLI::Range(1U, kMaxBuildResolution))
      ->capture_default_str();
  command
      ->add_option("--image-size", options->image_size,
                   "Pixels along a side of the reference images, 0 = as fine as the voxels")
      ->check(CLI::Range(0U, 4096U))
      ->capture_default_str();
  command->add_option("--image-format", options->image_format, "Format of the reference images")
      ->check(CLI::IsMember({"png", "jpeg"}))
      ->capture_default_str();
  command->add_option("--jpeg-quality", options->jpeg_quality, "Quality of JPEG images")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  command
      ->add_option(
          "--up", options->up,
          "Axis of the input that points up: y (default) or z, as most scans, CAD and .stl "
          "files have it")
      ->check(CLI::IsMember({"y", "z"}));
  command
      ->add_option(
          "--shade", options->shade,
          "Soft light painted into the colours: auto = where the model has none of its own")
      ->check(CLI::IsMember({"auto", "always", "never"}))
      ->capture_default_str();
  add_common_options(*command, session, {.outputs = true, .progress = true});
  command->callback([options, &session] {
    session.command = "build";
    session.exit = build(*options, session);
  });
}

}  // namespace afx::tools
