// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "afx/file.h"
#include "afx/module_loader.h"
#include "afx/picture_io.h"
#include "tools/commands.h"
#include "tools/input.h"
#include "tools/picture_options.h"
#include "tools/session.h"
#include "tools/view_model.h"
#include "tools/viewer/viewer_module.h"

namespace afx::tools {
namespace {

#ifdef AFX_HAS_VIEWER
constexpr bool kHasViewer = true;
#else
constexpr bool kHasViewer = false;
#endif

struct ViewCommand {
  std::string input;
  std::string size = "1280x800";
  std::string backend = "software";
  std::string splats = "smooth";
  std::string background;
  unsigned level = 32;
  unsigned samples = 3;
  ViewQuery query;
};

/// What the window asks the program for, on threads of its own.
class Service {
 public:
  Service(const ViewCommand& command, const Session& session)
      : command_(command), session_(session) {}

  /// What the last load() that failed would have been as the end of a command.
  [[nodiscard]] int exit() const { return exit_; }

  Result<std::shared_ptr<const ViewerModel>> load(
      const std::string& file, const std::function<void(const std::string&)>& doing) {
    // What the command line says is about the file that it names.
    ViewQuery query = file == command_.input ? command_.query : ViewQuery{};
    Diagnostics diagnostics;
    auto model = load_view_model(file, query, session_, diagnostics, doing);
    if (!model.ok()) {
      session_.show(diagnostics, file);
      exit_ = session_.fail_query(model.error(), query.is_usage, file);
    } else if (const int code = session_.warn(diagnostics, file); code != kDone) {
      exit_ = code;
      return Error{Errc::malformed, Place::none(), "there are warnings (expected none, --strict)"};
    }
    return model;
  }

  /// Names the picture NAME_0001.png and so on, in the folder where the program runs.
  Result<std::string> save(const std::string& model, const Picture& picture, bool window) {
    const auto bytes = encode_picture(picture, "png");
    if (!bytes.ok()) return fail(bytes.error(), "");
    std::string stem = model.substr(model.find_last_of('/') + 1);
    stem = stem.substr(0, stem.find_last_of('.'));
    if (stem.empty() || stem == "-") stem = "view";
    for (unsigned n = 1;; ++n) {
      char number[16];
      std::snprintf(number, sizeof number, "_%04u", n);
      const std::string name = stem + (window ? "_window" : "") + number + ".png";
      if (access(name.c_str(), F_OK) == 0) continue;
      const Status written = write_file_atomically(name, bytes.value(), false);
      if (!written.ok() && access(name.c_str(), F_OK) == 0) continue;  // another was faster
      if (!written.ok()) return fail(written.error(), name);
      session_.say(name + ": " + std::to_string(picture.width) + " x " +
                   std::to_string(picture.height));
      return name;
    }
  }

 private:
  Error fail(const Error& error, const std::string& file) const {
    session_.fail(error, file);
    return error;
  }

  const ViewCommand& command_;
  const Session& session_;
  std::atomic<int> exit_ = kDone;
};

int read_options(const ViewCommand& command, const Session& session, ViewerHost& host) {
  if (!parse_size(command.size, host.width, host.height)) {
    return session.usage("--size is " + command.size + " (expected WIDTHxHEIGHT, each 1.." +
                         std::to_string(render::kMaxSide) + ")");
  }
  Drawn& drawn = host.drawn;
  if (!command.background.empty()) {
    if (!parse_colour(command.background, drawn.background)) {
      return session.usage("--background is " + command.background +
                           " (expected #rrggbb, #rrggbbaa, white, black or transparent)");
    }
    drawn.backdrop = false;
  }
  if (command.splats == "flat") drawn.splats = render::SplatKind::flat;
  if (command.splats == "points") drawn.splats = render::SplatKind::points;
  if (command.backend == "gl") drawn.backend = Backend::gl;
  drawn.level = command.level;
  drawn.samples = command.samples;
  host.file = command.input;
  host.threads = session.options.threads;
  return kDone;
}

/// What can be told about the input without reading it; returns an exit code.
int check_input(const ViewCommand& command, const Session& session) {
  constexpr const char* kInputs[] = {"wrl", "bt", "xmt", "mp4", "bifs", "afx", "oct"};
  const ViewQuery& query = command.query;
  if (const int code = check_input_format(session, query.input_format, kInputs); code != kDone)
    return code;
  if (command.input == "-") return kDone;  // can be read once only
  Diagnostics diagnostics;
  const auto input =
      open_model_input(command.input, query.input_format, session.limits, diagnostics);
  if (!input.ok()) return session.fail(input.error(), command.input);
  const OctreeQuery octree{.node = {}, .resolution = query.resolution, .frame = query.frame};
  const std::string useless = useless_option(octree, {&input.value().kind, 1});
  return useless.empty() ? kDone : session.usage(useless);
}

int not_there(const Session& session, const std::string& text) {
  return session.fail({Errc::not_available, Place::none(), text});
}

int run_view(const ViewCommand& command, const Session& session) {
  ViewerHost host;
  if (const int code = read_options(command, session, host); code != kDone) return code;
  if (!kHasViewer) return not_there(session, "this build has no viewer");
  if (const int code = check_input(command, session); code != kDone) return code;
  const ModuleSymbol module =
      find_in_module("afx_viewer", "afx_viewer_run", "the module for the window");
  if (module.symbol == nullptr) return not_there(session, module.problem);
  Service service(command, session);
  host.load = [&service](const std::string& file, const auto& doing) {
    return service.load(file, doing);
  };
  host.save = [&service](const std::string& model, const Picture& picture, bool window) {
    return service.save(model, picture, window);
  };
  ViewerEnd end;
  reinterpret_cast<afx_viewer_run_function>(module.symbol)(&host, &end);
  int code = end.load_error ? service.exit() : kDone;
  if (!end.status.ok()) code = session.fail(end.status.error());
  if (end.still_working) {
    remove_temporary_files();
    _exit(code);
  }
  return code;
}

void add_drawing_options(CLI::App& command, ViewCommand& options) {
  command.add_option("--size", options.size, "Width and height of the window")
      ->capture_default_str();
  command.add_option("--backend", options.backend, "What draws: software or gl")
      ->check(CLI::IsMember({"software", "gl"}))
      ->capture_default_str();
  command.add_option("--splats", options.splats, "smooth, flat or points")
      ->check(CLI::IsMember({"smooth", "flat", "points"}))
      ->capture_default_str();
  command
      .add_option("--level,--levels", options.level,
                  "Begin with the coarser octree of so many levels")
      ->check(CLI::Range(0U, 32U));
  command
      .add_option("--samples", options.samples,
                  "Samples along a side of a pixel when nothing moves")
      ->check(CLI::Range(1U, 8U))
      ->capture_default_str();
  command.add_option("--background", options.background,
                     "#rrggbb, #rrggbbaa, white, black or transparent, instead of the scene's");
}

}  // namespace

void add_view(CLI::App& program, Session& session) {
  auto options = std::make_shared<ViewCommand>();
  CLI::App* command =
      program.add_subcommand("view", "Interactive window; 'h' in it shows the keys");
  command
      ->add_option("IN", options->input,
                   "Scene, stream (.afx), raw octree (.oct), mesh, points (.ply) or RGB-D pictures "
                   "(.json); - = standard input")
      ->required();
  command->add_option("--input-format", options->query.input_format,
                      "Kind of the input: wrl, bt, xmt, mp4, bifs, afx or oct");
  command->add_option("--resolution", options->query.resolution, "octreeResolution of a raw octree")
      ->check(CLI::Range(1U, 2147483647U));
  command->add_option("--frame", options->query.frame, "Frame of a stream, counted from 0");
  command->add_option("--viewpoint", options->query.viewpoint,
                      "Where to begin: number, from 1, or name of a Viewpoint of the scene");
  add_drawing_options(*command, *options);
  add_common_options(*command, session, {});
  command->callback([options, &session] {
    session.command = "view";
    session.exit = run_view(*options, session);
  });
}

}  // namespace afx::tools
