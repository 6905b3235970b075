// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "afx/octree_stream.h"
#include "tools/commands.h"
#include "tools/input.h"
#include "tools/scene_input.h"
#include "tools/session.h"

namespace afx::tools {
namespace {

struct TraceOptions {
  std::string input;
  std::string input_format;
  bool container = false;
};

void print_text(const codec::TraceElement& element) {
  char numbers[32];
  std::snprintf(numbers, sizeof numbers, "%10llu %8u  ",
                static_cast<unsigned long long>(element.bit), element.width);
  std::string path = printable(element.path);
  constexpr size_t kColumn = 52;
  if (path.size() < kColumn) path.resize(kColumn, ' ');
  std::cout << numbers << path << ' ' << element.value << '\n';
}

/// The access units of a scene, by number; offsets count from the beginning of each. With
/// --container the boxes of the file and its descriptors come first.
int trace_scene(const TraceOptions& options, const Input& input, const Session& session,
                const codec::Trace& print, Diagnostics& diagnostics) {
  const auto coded =
      open_coded_scene(input, session.limits, diagnostics, options.container ? &print : nullptr);
  if (!coded.ok()) return session.fail(coded.error(), input.path, diagnostics);
  bifs::PresentationDecodeOptions how;
  how.limits = session.limits;
  how.trace = &print;
  const auto scene = bifs::decode_presentation(coded.value().source, coded.value().movie, how,
                                               nullptr, diagnostics);
  std::cout.flush();
  const int warned = session.warn(diagnostics, input.path);
  return scene.ok() ? warned : session.fail(scene.error(), input.path);
}

int trace(const TraceOptions& options, const Session& session) {
  constexpr const char* kInputs[] = {"afx", "mp4", "bifs"};
  if (const int code = check_input_format(session, options.input_format, kInputs); code != kDone)
    return code;
  Diagnostics diagnostics;
  const auto input = open_input(options.input, options.input_format, session.limits, diagnostics);
  if (!input.ok()) return session.fail(input.error());
  const Kind kind = input.value().kind;
  if (kind != Kind::octree_stream && !is_coded_scene(kind)) {
    return session.fail({Errc::unsupported, Place::none(),
                         std::string("is ") + describe(kind) +
                             " (expected an MP4 file, a BIFS or an OctreeImage stream)"},
                        options.input);
  }
  const bool json = session.options.json;
  if (!json)
    std::cout
        << "       bit    width  element                                              value\n";
  const codec::Trace print = [json](const codec::TraceElement& element) {
    if (!json) return print_text(element);
    const nlohmann::ordered_json line{{"bit", element.bit},
                                      {"width", element.width},
                                      {"name", std::string(element.path)},
                                      {"value", element.value}};
    constexpr auto kReplace = nlohmann::ordered_json::error_handler_t::replace;
    std::cout << line.dump(-1, ' ', false, kReplace) << '\n';  // names may be no UTF-8
  };
  if (is_coded_scene(kind)) return trace_scene(options, input.value(), session, print, diagnostics);
  OctreeDecodeOptions how{.threads = session.options.threads};
  how.limits = session.limits;
  how.trace = &print;
  const DecodedOctreeStream decoded =
      decode_octree_stream(input.value().file.bytes(), how, diagnostics);
  std::cout.flush();
  const int warned = session.warn(diagnostics, options.input);
  return decoded.status.ok() ? warned : session.fail(decoded.status.error(), options.input);
}

}  // namespace

void add_trace(CLI::App& program, Session& session) {
  auto options = std::make_shared<TraceOptions>();
  CLI::App* command =
      program.add_subcommand("trace", "Every element of a stream: bit offset, width, name, value");
  command
      ->add_option("IN", options->input,
                   "MP4 file (.mp4), BIFS (.bifs) or OctreeImage stream (.afx); - = standard input")
      ->required();
  command->add_option("--input-format", options->input_format,
                      "Kind of the input: mp4, bifs or afx");
  command->add_flag("--container", options->container,
                    "The boxes and descriptors of the file, too");
  add_common_options(*command, session, {});
  command->callback([options, &session] {
    session.command = "trace";
    session.exit = trace(*options, session);
  });
}

}  // namespace afx::tools
