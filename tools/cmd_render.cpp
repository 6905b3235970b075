// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <CLI/CLI.hpp>
#include <charconv>
#include <chrono>
#include <glm/trigonometric.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "afx/file.h"
#include "afx/picture_io.h"
#include "render/renderer.h"
#include "tools/commands.h"
#include "tools/drawing.h"
#include "tools/input.h"
#include "tools/scene_input.h"
#include "tools/session.h"

namespace afx::tools {
namespace {

struct RenderCommand {
  std::string input;
  std::string output;
  std::string format;
  std::string input_format;
  std::optional<uint32_t> resolution;
  std::optional<uint32_t> frame;
  unsigned level = 32;
  std::string size = "1024x1024";
  std::string background;
  double azimuth = 0;
  double elevation = 0;
  double field_of_view = 0;
  double margin = 0;
  bool orthographic = false;
  unsigned samples = 3;
  int jpeg_quality = 90;
};

Status draw_scene(const Input& input, const Session& session, Diagnostics& diagnostics,
                  Drawing& drawn) {
  const auto scene = read_scene(input, session.limits, diagnostics);
  if (!scene.ok()) return scene.error();
  return drawn.add(scene.value());
}

Status draw_model(const Input& input, OctreeQuery& query, const Session& session,
                  Diagnostics& diagnostics, Drawing& drawn) {
  auto model = read_model_input(input, query, session, diagnostics);
  if (!model.ok()) return std::move(model).error();
  return drawn.add(std::move(model).value(), Shade::automatic);
}

/// "640x480".
bool parse_size(const std::string& text, uint32_t& width, uint32_t& height) {
  const char* end = text.data() + text.size();
  const auto w = std::from_chars(text.data(), end, width);
  if (w.ec != std::errc() || w.ptr == end || *w.ptr != 'x') return false;
  const auto h = std::from_chars(w.ptr + 1, end, height);
  const auto fits = [](uint32_t side) { return side >= 1 && side <= render::kMaxSide; };
  return h.ec == std::errc() && h.ptr == end && fits(width) && fits(height);
}

/// "#rrggbb", "#rrggbbaa", "transparent", "white" or "black".
bool parse_colour(const std::string& text, Rgba8& colour) {
  if (text == "transparent") colour = {0, 0, 0, 0};
  if (text == "white") colour = {255, 255, 255, 255};
  if (text == "black") colour = {0, 0, 0, 255};
  if (text == "transparent" || text == "white" || text == "black") return true;
  uint32_t value = 0;
  if (text.size() != 7 && text.size() != 9) return false;
  const auto parsed = std::from_chars(text.data() + 1, text.data() + text.size(), value, 16);
  if (text[0] != '#' || parsed.ec != std::errc() || parsed.ptr != text.data() + text.size())
    return false;
  if (text.size() == 7) value = value << 8 | 0xff;
  colour = {static_cast<uint8_t>(value >> 24), static_cast<uint8_t>(value >> 16),
            static_cast<uint8_t>(value >> 8), static_cast<uint8_t>(value)};
  return true;
}

Picture without_alpha(const Picture& picture) {
  Picture rgb(picture.width, picture.height, 3);
  for (size_t i = 0; i < size_t{picture.width} * picture.height; ++i) {
    for (size_t k = 0; k < 3; ++k) rgb.samples[i * 3 + k] = picture.samples[i * 4 + k];
  }
  return rgb;
}

Result<render::RenderedImage> render_drawn(const Drawing& drawn, const RenderCommand& command,
                                           const render::RenderOptions& options) {
  render::View view;
  view.azimuth = glm::radians(command.azimuth);
  view.elevation = glm::radians(command.elevation);
  view.field_of_view = glm::radians(command.field_of_view);
  view.margin = command.margin;
  if (command.orthographic) view.projection = render::Projection::orthographic;
  const auto camera =
      render::fit_camera(drawn.outline(), view, double{1} * options.width / options.height);
  if (!camera.ok()) return camera.error();
  return drawn.draw(camera.value(), options);
}

int read_options(const RenderCommand& command, const std::string& format, const Session& session,
                 render::RenderOptions& options) {
  if (!parse_size(command.size, options.width, options.height)) {
    return session.usage("--size is " + command.size + " (expected WIDTHxHEIGHT, each 1.." +
                         std::to_string(render::kMaxSide) + ")");
  }
  const bool opaque = format == "jpeg";
  const std::string background =
      command.background.empty() ? (opaque ? "white" : "transparent") : command.background;
  if (!parse_colour(background, options.background)) {
    return session.usage("--background is " + background +
                         " (expected #rrggbb, #rrggbbaa, white, black or transparent)");
  }
  if (opaque && options.background.a != 255)
    return session.usage("JPEG has no transparency (expected an opaque --background)");
  options.samples = command.samples;
  options.threads = session.options.threads;
  return kDone;
}

/// What can be asked before the work; returns an exit code.
int check_command(const RenderCommand& command, const OutputFiles& outputs, const Session& session,
                  std::string& format, render::RenderOptions& options) {
  constexpr const char* kOutputs[] = {"png", "jpeg", "bmp", "tga"};
  constexpr const char* kInputs[] = {"wrl", "bt", "afx", "oct"};
  if (const int code = output_format(session, command.output, command.format, kOutputs, format);
      code != kDone)
    return code;
  if (const int code = check_input_format(session, command.input_format, kInputs); code != kDone)
    return code;
  if (const int code = read_options(command, format, session, options); code != kDone) return code;
  const Status free = outputs.check(command.output);
  return free.ok() ? kDone : session.fail(free.error(), command.output);
}

/// Reads the input into `drawn`; returns an exit code.
int read_input(const RenderCommand& command, const Session& session, Diagnostics& diagnostics,
               Drawing& drawn) {
  const auto input =
      open_model_input(command.input, command.input_format, session.limits, diagnostics);
  if (!input.ok()) return session.fail(input.error(), command.input, diagnostics);
  OctreeQuery query{.node = {}, .resolution = command.resolution, .frame = command.frame};
  const std::string useless = useless_option(query, {&input.value().kind, 1});
  if (!useless.empty()) return session.usage(useless);
  const Status read = is_scene(input.value().kind)
                          ? draw_scene(input.value(), session, diagnostics, drawn)
                          : draw_model(input.value(), query, session, diagnostics, drawn);
  if (read.ok()) return session.warn(diagnostics, command.input);
  session.show(diagnostics, command.input);
  return session.fail_query(read.error(), query.missing_is_usage, command.input);
}

int run_render(const RenderCommand& command, const Session& session) {
  OutputFiles outputs(session.options.overwrite);
  std::string format;
  render::RenderOptions options;
  if (const int code = check_command(command, outputs, session, format, options); code != kDone)
    return code;
  Diagnostics diagnostics;
  Drawing drawn(session, diagnostics);
  drawn.set_level(command.level);
  if (const int code = read_input(command, session, diagnostics, drawn); code != kDone) return code;

  const auto start = std::chrono::steady_clock::now();
  const auto image = render_drawn(drawn, command, options);
  if (!image.ok()) return session.fail(image.error(), command.input);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const Picture& picture = image.value().picture;
  const auto bytes = encode_picture(format == "jpeg" ? without_alpha(picture) : picture, format,
                                    {.jpeg_quality = command.jpeg_quality});
  if (!bytes.ok()) return session.fail(bytes.error(), command.output);
  if (!session.options.dry_run) {
    if (Status put = outputs.put(command.output, bytes.value()); !put.ok())
      return session.fail(put.error(), command.output);
  }
  return session.finish(
      outputs, command.output,
      {command.output + ": " + std::to_string(options.width) + " x " +
       std::to_string(options.height) + ", " + drawn.size() +
       (session.options.verbose ? " drawn in " + fixed(seconds * 1000, 1) + " ms" : "")},
      {{"output", command.output},
       {"width", options.width},
       {"height", options.height},
       {"voxels", drawn.voxels()}});
}

void add_view_options(CLI::App& command, RenderCommand& options) {
  const render::View view;
  options.azimuth = glm::degrees(view.azimuth);
  options.elevation = glm::degrees(view.elevation);
  options.field_of_view = glm::degrees(view.field_of_view);
  options.margin = view.margin;
  command.add_flag("--orthographic", options.orthographic, "Parallel projection");
  command
      .add_option("--azimuth", options.azimuth,
                  "Degrees to the right of the front that the camera stands")
      ->capture_default_str();
  command
      .add_option("--elevation", options.elevation,
                  "Degrees above the horizon that the camera stands")
      ->check(CLI::Range(-90.0, 90.0))
      ->capture_default_str();
  command.add_option("--fov", options.field_of_view, "Full vertical angle of view in degrees")
      ->check(CLI::Range(0.1, 170.0))
      ->capture_default_str();
  command.add_option("--margin", options.margin, "Free border, as a part of the picture")
      ->check(CLI::Range(0.0, 0.45))
      ->capture_default_str();
}

}  // namespace

void add_render(CLI::App& program, Session& session) {
  auto options = std::make_shared<RenderCommand>();
  CLI::App* command =
      program.add_subcommand("render", "Scene, stream, raw octree, mesh or points -> picture");
  command
      ->add_option(
          "IN", options->input,
          "Scene, stream (.afx), raw octree (.oct), mesh, points (.ply) or RGB-D pictures (.json); "
          "- = standard input")
      ->required();
  command
      ->add_option("-o,--output", options->output,
                   "The picture (.png .jpg ...); - = standard output")
      ->required();
  command->add_option("--format", options->format,
                      "Kind of the output where its name does not tell: png, jpeg, ...");
  command->add_option("--input-format", options->input_format,
                      "Kind of the input: wrl, bt, afx or oct");
  command->add_option("--resolution", options->resolution, "octreeResolution of a raw octree")
      ->check(CLI::Range(1U, 2147483647U));
  command->add_option("--frame", options->frame, "Frame of a stream, counted from 0");
  command
      ->add_option("--levels,--level", options->level, "Draw the coarser octree of so many levels")
      ->check(CLI::Range(0U, 32U));
  command->add_option("--size", options->size, "Width and height in pixels")->capture_default_str();
  command->add_option(
      "--background", options->background,
      "#rrggbb, #rrggbbaa, white, black or transparent (default: transparent, white for JPEG)");
  add_view_options(*command, *options);
  command
      ->add_option("--samples", options->samples,
                   "Samples along a side of a pixel: smoothness of the edges")
      ->check(CLI::Range(1U, 8U))
      ->capture_default_str();
  command->add_option("--jpeg-quality", options->jpeg_quality, "Quality of a JPEG picture")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  add_common_options(*command, session, {.outputs = true, .verbose = true});
  command->callback([options, &session] {
    session.command = "render";
    session.exit = run_render(*options, session);
  });
}

}  // namespace afx::tools
