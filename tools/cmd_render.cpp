// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <utility>

#include "tools/backend.h"
#include "tools/commands.h"
#include "tools/drawing.h"
#include "tools/input.h"
#include "tools/render_command.h"
#include "tools/render_output.h"

namespace afx::tools {
namespace {

Status read_model_into(const Input& input, OctreeQuery& query, const Session& session,
                       Diagnostics& diagnostics, Drawing& drawn) {
  auto model = read_model_input(input, query, session, diagnostics);
  if (!model.ok()) return std::move(model).error();
  return drawn.add(std::move(model).value(), Shade::automatic);
}

/// Reads the input into `drawn` and `sight`; returns an exit code.
int read_input(const RenderCommand& command, const Session& session, Diagnostics& diagnostics,
               Drawing& drawn, Sight& sight) {
  auto input = open_model_input(command.input, command.input_format, session.limits, diagnostics);
  if (!input.ok()) return session.fail(input.error(), command.input, diagnostics);
  OctreeQuery query{.node = {}, .resolution = command.resolution, .frame = command.frame};
  const std::string useless = useless_option(query, {&input.value().kind, 1});
  if (!useless.empty()) return session.usage(useless);
  const Status read = is_scene(input.value().kind)
                          ? drawn.add_scene(std::move(input).value())
                          : read_model_into(input.value(), query, session, diagnostics, drawn);
  sight.outline = drawn.outline();
  sight.viewpoints = drawn.viewpoints();
  if (read.ok()) return session.warn(diagnostics, command.input);
  session.show(diagnostics, command.input);
  return session.fail_query(read.error(), query.missing_is_usage, command.input);
}

/// A sentence about an option that does nothing for a mesh; empty: there is none.
std::string useless_for_mesh(const RenderCommand& command) {
  if (command.level) return "--levels is for octrees, not for meshes";
  if (!command.splats.empty()) return "--splats is for voxels and points, not for meshes";
  if (command.coarseness) return "--coarseness is for octrees, not for meshes";
  return {};
}

/// What may be missing on a machine, so it is asked for before the work.
struct Tools {
  std::unique_ptr<render::Renderer> renderer;
  std::optional<VideoWriter> video;
};

/// Returns an exit code.
int get_tools(const RenderCommand& command, const Session& session, const RenderPlan& plan,
              Tools& tools) {
  auto renderer = make_renderer(command.backend, session.limits);
  if (!renderer.ok()) return session.fail(renderer.error());
  tools.renderer = std::move(renderer).value();
  if (!plan.is_video) return kDone;
  auto video = begin_video(command, plan, session.limits);
  if (!video.ok()) return session.fail(video.error(), command.output);
  tools.video.emplace(std::move(video).value());
  return kDone;
}

/// Reads a scene that depends on the viewer for the one that has this camera. Returns an exit code.
int show_to(const render::Camera& camera, const RenderCommand& command, const Session& session,
            Drawing& drawn) {
  Diagnostics diagnostics;
  const Status shown = drawn.set_viewer(viewer_of(camera), diagnostics);
  if (!shown.ok()) return session.fail(shown.error(), command.input, diagnostics);
  return session.warn(diagnostics, command.input);
}

int draw(const RenderCommand& command, const Session& session, const RenderPlan& plan,
         Drawing& drawn, const Sight& sight, Tools& tools, OutputFiles& outputs) {
  const bool turns = plan.frames > 0;
  render::Camera camera;
  const int code =
      choose_camera(command.camera, sight, plan.aspect(), turns, session, command.input, camera);
  if (code != kDone) return code;
  // The camera is made of the scene as it is without a viewer.
  if (const int seen = show_to(camera, command, session, drawn); seen != kDone) return seen;
  auto drawer = FrameDrawer::make(drawn, std::move(tools.renderer), command.backend == "software");
  if (!drawer.ok()) return session.fail(drawer.error(), command.input);
  VideoWriter* const video = tools.video ? &*tools.video : nullptr;
  RenderJob job{command, session, plan, drawn, sight, camera, drawer.value(), outputs, video};
  return turns ? render_turntable(job) : render_picture(job);
}

int run_render(const RenderCommand& command, const Session& session) {
  OutputFiles outputs(session.options.overwrite);
  RenderPlan plan;
  if (const int code = make_plan(command, outputs, session, plan); code != kDone) return code;
  Tools tools;
  if (const int code = get_tools(command, session, plan, tools); code != kDone) return code;
  Diagnostics diagnostics;
  Drawing drawn(session, diagnostics);
  if (command.level) drawn.set_level(*command.level);
  Sight sight;
  if (const int code = read_input(command, session, diagnostics, drawn, sight); code != kDone)
    return code;
  if (const std::string useless = drawn.is_mesh() ? useless_for_mesh(command) : "";
      !useless.empty())
    return session.usage(useless);
  return draw(command, session, plan, drawn, sight, tools, outputs);
}

}  // namespace

void add_render(CLI::App& program, Session& session) {
  auto options = std::make_shared<RenderCommand>();
  CLI::App* command = program.add_subcommand(
      "render", "Scene, stream, raw octree, mesh or points -> picture, turntable or video");
  add_render_options(*command, *options);
  add_common_options(*command, session, {.outputs = true, .verbose = true, .progress = true});
  command->callback([options, &session] {
    session.command = "render";
    session.exit = run_render(*options, session);
  });
}

}  // namespace afx::tools
