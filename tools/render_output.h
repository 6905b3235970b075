// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "afx/video_writer.h"
#include "codec/error.h"
#include "codec/limits.h"
#include "render/renderer.h"
#include "tools/drawing.h"
#include "tools/frame_drawer.h"
#include "tools/render_command.h"

namespace afx::tools {

/// All that is at hand when the drawing begins.
struct RenderJob {
  const RenderCommand& command;
  const Session& session;
  const RenderPlan& plan;
  const Drawing& drawing;
  const Sight& sight;
  render::Camera camera;  ///< of a turntable: the first
  FrameDrawer& drawer;
  OutputFiles& outputs;
  VideoWriter* video;  ///< null: none is to be made
};

/// Without the alpha of RGBA.
Picture without_alpha(const Picture& picture);

/// A picture as the bytes of a file. Errors  those of encode_picture
Result<std::vector<uint8_t>> encode_image(const render::RenderedImage& image,
                                          const std::string& format, int jpeg_quality);

/// ", by software in 12.3 ms" if the user wants to know; else nothing.
std::string told_time(const RenderJob& job, double seconds);

/// Draws one picture, writes it and compares it, as the plan says. Returns an exit code.
int render_picture(RenderJob& job);

/// The video that the plan asks for, begun. Errors  those of VideoWriter::begin
Result<VideoWriter> begin_video(const RenderCommand& command, const RenderPlan& plan,
                                const Limits& limits);

/// Draws a turntable into files or a video. Returns an exit code.
int render_turntable(RenderJob& job);

}  // namespace afx::tools
