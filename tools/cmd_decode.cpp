// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <CLI/CLI.hpp>
#include <iterator>
#include <memory>

#include "afx/file.h"
#include "tools/commands.h"
#include "tools/decode.h"
#include "tools/name_pattern.h"

namespace afx::tools {
namespace {

/// What can be asked before the work: are the kinds right, may the output be written?
int check_names(const DecodeOptions& options, const OutputFiles& outputs, const Session& session,
                std::string& format) {
  constexpr const char* kOutputs[] = {"wrl", "bt", "xmt", "json", "oct", "ply"};
  constexpr const char* kInputs[] = {"afx", "mp4", "bifs", "wrl", "bt", "xmt"};
  if (const int code = output_format(session, options.output, options.format, kOutputs, format);
      code != kDone)
    return code;
  const size_t inputs = format == "ply" ? std::size(kInputs) : 3;  // points of any scene
  if (const int code = check_input_format(session, options.input_format, {kInputs, inputs});
      code != kDone)
    return code;
  // Frame 0 is always there; how many follow, the stream will tell.
  const std::string first = NamePattern(options.output).name(options.frame.value_or(0));
  const Status free = outputs.check(first);
  return free.ok() ? kDone : session.fail(free.error(), first);
}

/// A sentence about an output or option that does not go with this input; empty: there is none.
std::string useless_option(const DecodeOptions& options, const std::string& format, Kind input) {
  const std::string found = std::string(", but the input is ") + describe(input);
  if (format == "ply" && (options.levels || options.partial))
    return "--levels and --partial are for scene text and raw octrees, not for points";
  if (format == "ply" && NamePattern(options.output).has_number)
    return "points are one file, not a pattern in the name (expected --frame K for one of several)";
  if (input == Kind::octree_stream) {
    return format == "xmt" || format == "json"
               ? "." + format + " is for scenes (.mp4, .bifs)" + found
               : std::string();
  }
  if (format == "oct") return ".oct is for OctreeImage streams (.afx)" + found;
  if (options.frame || options.levels || options.partial)
    return "--frame, --levels and --partial are for OctreeImage streams (.afx)" + found;
  return NamePattern(options.output).has_number
             ? "a pattern in the name is for OctreeImage streams (.afx)" + found
             : std::string();
}

int decode(const DecodeOptions& options, const Session& session) {
  OutputFiles outputs(session.options.overwrite);
  std::string format;
  if (const int code = check_names(options, outputs, session, format); code != kDone) return code;
  Diagnostics diagnostics;
  const bool points = format == "ply";
  const auto opened = (points ? open_model_input : open_input)(options.input, options.input_format,
                                                               session.limits, diagnostics);
  if (!opened.ok()) return session.fail(opened.error(), options.input, diagnostics);
  const Input& input = opened.value();
  if (!points && input.kind != Kind::octree_stream && !is_coded_scene(input.kind)) {
    const Error error{Errc::unsupported, Place::none(),
                      std::string("is ") + describe(input.kind) +
                          " (expected an MP4 file, a BIFS or an OctreeImage stream)"};
    return session.fail(error, options.input, diagnostics);
  }
  if (const std::string useless = useless_option(options, format, input.kind); !useless.empty())
    return session.usage(useless);
  if (points) return decode_points(options, input, outputs, session, diagnostics);
  if (input.kind == Kind::octree_stream)
    return decode_octrees(options, format, input, outputs, session, diagnostics);
  return decode_presentation(options, format, input, outputs, session, diagnostics);
}

}  // namespace

void add_decode(CLI::App& program, Session& session) {
  auto options = std::make_shared<DecodeOptions>();
  CLI::App* command = program.add_subcommand(
      "decode", "MP4 file, BIFS or AFX stream -> text, JSON, raw octree, points");
  command
      ->add_option("IN", options->input,
                   "MP4 file (.mp4), BIFS (.bifs) or OctreeImage stream (.afx); - = standard input")
      ->required();
  command
      ->add_option(
          "-o,--output", options->output,
          "Scene text (.wrl .bt), XMT-A (.xmt), decoded values (.json), raw octree (.oct) or, of "
          "any scene with DIBR nodes, points (.ply); "
          "frame_%04d.wrl for every frame of an .afx; - = standard output")
      ->required();
  command->add_option(
      "--format", options->format,
      "Kind of the output where its name does not tell: wrl, bt, xmt, json, oct or ply");
  command->add_option("--input-format", options->input_format,
                      "Kind of the input: mp4, bifs or afx; for points also wrl, bt or xmt");
  command->add_option("--frame", options->frame, "Only this frame, counted from 0");
  command->add_option("--levels", options->levels, "Decode a coarser model of so many levels")
      ->check(CLI::Range(0U, 32U));
  command->add_flag("--partial", options->partial,
                    "Of a truncated stream write what is whole (the exit code stays 3)");
  add_common_options(*command, session, {.outputs = true});
  command->callback([options, &session] {
    session.command = "decode";
    session.exit = decode(*options, session);
  });
}

}  // namespace afx::tools
