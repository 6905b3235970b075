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
#include "tools/session.h"

namespace afx::tools {
namespace {

struct TraceOptions {
  std::string input;
  std::string input_format;
};

void print_text(const codec::TraceElement& element) {
  char line[256];
  std::snprintf(line, sizeof line, "%10llu %8u  %-52.*s %llu",
                static_cast<unsigned long long>(element.bit), element.width,
                static_cast<int>(element.path.size()), element.path.data(),
                static_cast<unsigned long long>(element.value));
  std::cout << line << '\n';
}

int trace(const TraceOptions& options, const Session& session) {
  constexpr const char* kInputs[] = {"afx"};
  if (const int code = check_input_format(session, options.input_format, kInputs); code != kDone)
    return code;
  Diagnostics diagnostics;
  const auto input = open_input(options.input, options.input_format, session.limits, diagnostics);
  if (!input.ok()) return session.fail(input.error());
  if (input.value().kind != Kind::octree_stream) {
    return session.fail(
        {Errc::unsupported, Place::none(),
         std::string("is ") + describe(input.value().kind) + " (expected an OctreeImage stream)"},
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
    std::cout << line.dump() << '\n';
  };
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
  CLI::App* command = program.add_subcommand(
      "trace", "Every header element of a stream, and the bits of each level");
  command->add_option("IN", options->input, "The stream (.afx); - = standard input")->required();
  command->add_option("--input-format", options->input_format, "Kind of the input: afx");
  add_common_options(*command, session, {});
  command->callback([options, &session] {
    session.command = "trace";
    session.exit = trace(*options, session);
  });
}

}  // namespace afx::tools
