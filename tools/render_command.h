// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The parts of `afx render`: what its command line says, and the plan that is made of it before
// any work is done.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "afx/file.h"
#include "afx/picture.h"
#include "render/renderer.h"
#include "tools/name_pattern.h"
#include "tools/render_camera.h"
#include "tools/session.h"

namespace afx::tools {

/// The options of `afx render`.
struct RenderCommand {
  std::string input;
  std::string output;  ///< empty: none, only compared
  std::string format;
  std::string input_format;
  std::optional<uint32_t> resolution;
  std::optional<uint32_t> frame;

  CameraOptions camera;
  std::string size;
  std::string background;
  unsigned samples = 3;
  std::optional<unsigned> level;
  std::string splats;  ///< empty: smooth
  std::optional<double> coarseness;
  std::string backend = "software";

  int jpeg_quality = 90;
  bool depth = false;
  std::optional<uint32_t> turntable;
  std::optional<double> fps;
  std::optional<int> video_quality;

  std::string compare;
  std::optional<double> min_psnr;
  std::optional<double> max_mse;
};

void add_render_options(CLI::App& command, RenderCommand& options);

/// What is to be done.
struct RenderPlan {
  std::string format;                ///< of the output, "png", "mp4"; empty: there is none
  bool is_video = false;             ///< one file for all frames
  uint32_t frames = 0;               ///< of a turntable; 0: a single picture
  NamePattern names{""};             ///< of the frames, where they are files of their own
  std::optional<Picture> reference;  ///< to compare with
  render::RenderOptions options;

  [[nodiscard]] double aspect() const { return double{1} * options.width / options.height; }
};

/// Checks everything that can be checked before the input is read. Returns an exit code.
int make_plan(const RenderCommand& command, const OutputFiles& outputs, const Session& session,
              RenderPlan& plan);

}  // namespace afx::tools
