// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "codec/error.h"
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

/// Draws a turntable into files or a video. Returns an exit code.
int render_turntable(RenderJob& job);

}  // namespace afx::tools
