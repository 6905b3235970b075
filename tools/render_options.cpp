// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <CLI/CLI.hpp>
#include <glm/trigonometric.hpp>
#include <string>
#include <vector>

#include "tools/backend.h"
#include "tools/render_command.h"

namespace afx::tools {
namespace {

void add_input_options(CLI::App& command, RenderCommand& options) {
  command
      .add_option(
          "IN", options.input,
          "Scene, stream (.afx), raw octree (.oct), mesh, points (.ply) or RGB-D pictures (.json); "
          "- = standard input")
      ->required();
  command.add_option("--input-format", options.input_format,
                     "Kind of the input: wrl, bt, afx or oct");
  command.add_option("--resolution", options.resolution, "octreeResolution of a raw octree")
      ->check(CLI::Range(1U, 2147483647U));
  command.add_option("--frame", options.frame, "Frame of a stream, counted from 0");
}

void add_output_options(CLI::App& command, RenderCommand& options) {
  command.add_option("-o,--output", options.output,
                     "The picture (.png .jpg .exr ...), with --turntable frame_%04d.png or a video "
                     "(.mp4 .mkv .webm .avi); - = standard output");
  command.add_option("--format", options.format,
                     "Kind of the output where its name does not tell: png, jpeg, ...");
  command.add_option("--size", options.size, "Width and height in pixels")
      ->default_str("1024x1024");
  command.add_option("--jpeg-quality", options.jpeg_quality, "Quality of a JPEG picture")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  command.add_flag("--depth", options.depth,
                   "OpenEXR: also the distance to the plane through the camera, as channel Z");
}

void add_camera_options(CLI::App& command, CameraOptions& options) {
  const render::View view;
  const std::string group = "Camera";
  const auto add = [&](const char* name, auto& value, const char* text) {
    return command.add_option(name, value, text)->group(group);
  };
  add("--azimuth", options.azimuth, "Degrees to the right of the front that the camera stands")
      ->default_str(fixed(glm::degrees(view.azimuth), 4));
  add("--elevation", options.elevation, "Degrees above the horizon that the camera stands")
      ->check(CLI::Range(-90.0, 90.0))
      ->default_str(fixed(glm::degrees(view.elevation), 4));
  add("--margin", options.margin, "Free border, as a part of the picture")
      ->check(CLI::Range(0.0, 0.45))
      ->default_str(fixed(view.margin, 2));
  add("--fov", options.field_of_view, "Full vertical angle of view in degrees")
      ->check(CLI::Range(0.1, 170.0))
      ->default_str(fixed(glm::degrees(view.field_of_view), 4));
  command.add_flag("--orthographic", options.orthographic, "Parallel projection")->group(group);
  add("--position", options.position, "X,Y,Z: where the camera stands, instead of fitting it");
  add("--look-at", options.look_at,
      "X,Y,Z: the point that it looks at (default: the middle of the model)");
  add("--up", options.up, "X,Y,Z: what is up in the picture (default: 0,1,0)");
  add("--orientation", options.orientation,
      "AX,AY,AZ,ANGLE: axis and angle (radians) that turn the camera from looking along -z");
  add("--view-height", options.view_height,
      "Height of the view in scene units, with --orthographic and --position")
      ->check(CLI::PositiveNumber);
  add("--near", options.near_plane, "Distance from which on things are drawn")
      ->check(CLI::PositiveNumber);
  add("--viewpoint", options.viewpoint,
      "Name, description or number (from 1) of a Viewpoint of the scene to look from");
}

void add_look_options(CLI::App& command, RenderCommand& options) {
  const render::RenderOptions how;
  const std::string group = "Looks";
  command
      .add_option("--background", options.background,
                  "#rrggbb, #rrggbbaa, white, black or transparent (default: transparent; white "
                  "for JPEG and videos)")
      ->group(group);
  command
      .add_option("--samples", options.samples,
                  "Samples along a side of a pixel: smoothness of the edges")
      ->check(CLI::Range(1U, 8U))
      ->capture_default_str()
      ->group(group);
  command
      .add_option("--levels,--level", options.level, "Draw the coarser octree of so many levels")
      ->check(CLI::Range(0U, 32U))
      ->group(group);
  command
      .add_option("--splats", options.splats,
                  "How voxels and points are drawn: smooth, flat (each is seen) or points (small)")
      ->check(CLI::IsMember({"smooth", "flat", "points"}))
      ->default_str("smooth")
      ->group(group);
  command
      .add_option(
          "--coarseness", options.coarseness,
          "Nodes of octrees not larger than so many samples are drawn as wholes; 0 = always "
          "the finest level")
      ->check(CLI::Range(0.0, 8.0))
      ->default_str(fixed(how.coarseness, 2))
      ->group(group);
  const std::vector<std::string> backends(std::begin(kBackends), std::end(kBackends));
  command.add_option("--backend", options.backend, "What draws: software or gl")
      ->check(CLI::IsMember(backends))
      ->capture_default_str()
      ->group(group);
}

void add_turntable_options(CLI::App& command, RenderCommand& options) {
  const std::string group = "Turntable";
  command
      .add_option("--turntable", options.turntable,
                  "So many pictures from all around the model, to the right")
      ->check(CLI::Range(1U, 100000U))
      ->group(group);
  command.add_option("--fps", options.fps, "Pictures a second of a video")
      ->check(CLI::Range(0.1, 1000.0))
      ->default_str("30")
      ->group(group);
  command
      .add_option("--video-quality", options.video_quality,
                  "Constant rate factor of a video: 0 is best, 51 least")
      ->check(CLI::Range(0, 51))
      ->default_str("18")
      ->group(group);
}

void add_compare_options(CLI::App& command, RenderCommand& options) {
  const std::string group = "Comparison";
  command
      .add_option("--compare", options.compare,
                  "A picture that the one drawn is compared with; exit code 4 if they differ. Its "
                  "size is taken unless --size tells one")
      ->group(group);
  command
      .add_option("--min-psnr", options.min_psnr,
                  "Differences down to this PSNR in dB are no failure")
      ->check(CLI::Range(0.0, 1000.0))
      ->group(group);
  command
      .add_option("--max-mse", options.max_mse,
                  "Differences up to this mean of squares are no failure")
      ->check(CLI::NonNegativeNumber)
      ->group(group);
}

}  // namespace

void add_render_options(CLI::App& command, RenderCommand& options) {
  add_input_options(command, options);
  add_output_options(command, options);
  add_camera_options(command, options.camera);
  add_look_options(command, options);
  add_turntable_options(command, options);
  add_compare_options(command, options);
}

}  // namespace afx::tools
