// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <CLI/CLI.hpp>
#include <memory>

#include "afx/file.h"
#include "tools/commands.h"
#include "tools/encode.h"
#include "tools/formats.h"
#include "tools/name_pattern.h"
#include "tools/session.h"

namespace afx::tools {
namespace {

int check_names(const EncodeOptions& options, const OutputFiles& outputs, const Session& session,
                std::string& format) {
  constexpr const char* kOutputs[] = {"afx", "mp4", "bifs"};
  constexpr const char* kInputs[] = {"wrl", "bt", "xmt", "oct"};
  if (const int code = output_format(session, options.output, options.format, kOutputs, format);
      code != kDone)
    return code;
  if (NamePattern(options.output).has_number) {
    return session.usage("all frames go into one stream, but " + options.output +
                         " has a place for a number (expected one name)");
  }
  if (const int code = check_input_format(session, options.input_format, kInputs); code != kDone)
    return code;
  const Status free = outputs.check(options.output);
  return free.ok() ? kDone : session.fail(free.error(), options.output);
}

/// A sentence about an option that has no effect for this output; empty: there is none.
std::string useless_option(const EncodeOptions& options, const std::string& format) {
  if (format == "afx") {
    const bool scene = !options.afx.empty() || !options.pictures.empty() ||
                       options.names != "auto" || !options.quantize_bits.empty() ||
                       options.quantize || options.predictive || options.choices != "own";
    return scene ? "--afx, --pictures, --choices, --names, --predictive, --quantize and --bits are "
                   "for "
                   "scenes (.mp4, .bifs), but the output is an OctreeImage stream"
                 : "";
  }
  if (!options.node.empty() || options.resolution)
    return "--node and --resolution are for OctreeImage streams (.afx), but the output is a scene";
  return options.inputs.size() > 1 ? "a scene is encoded from one SCENE (several are the frames of "
                                     "an .afx)"
                                   : "";
}

int encode(const EncodeOptions& options, const Session& session) {
  OutputFiles outputs(session.options.overwrite);
  std::string format;
  if (const int code = check_names(options, outputs, session, format); code != kDone) return code;
  if (const std::string useless = useless_option(options, format); !useless.empty())
    return session.usage(useless);
  if (format == "afx") return encode_octrees(options, outputs, session);
  return encode_presentation(options, format, outputs, session);
}

void add_scene_options(CLI::App& command, EncodeOptions& options) {
  const std::string group = "Scenes (.mp4, .bifs)";
  command
      .add_option("--afx", options.afx,
                  "Octree fields: an AFX stream, a buffer in the scene, or none: plain BIFS fields "
                  "(default: stream; none where the text has commands or object descriptors)")
      ->check(CLI::IsMember({"stream", "buffer", "none"}))
      ->group(group);
  command
      .add_option(
          "--pictures", options.pictures,
          "Pictures that the scene names: streams, or none: left as names (default as --afx)")
      ->check(CLI::IsMember({"stream", "none"}))
      ->group(group);
  command
      .add_option("--choices", options.choices,
                  "Where the standard leaves a choice: own, or gpac: bit for bit as MP4Box encodes")
      ->check(CLI::IsMember({"own", "gpac"}))
      ->group(group);
  command
      .add_option("--names", options.names,
                  "Code the DEF names: auto (where they would be lost; not with --choices gpac), "
                  "always or never")
      ->check(CLI::IsMember({"auto", "always", "never"}))
      ->group(group);
  command
      .add_flag("--predictive", options.predictive,
                "Code quantized lists predictively where that is shorter (few players read it)")
      ->group(group);
  command
      .add_flag("--quantize", options.quantize,
                "Quantize numbers; says the largest error for each field")
      ->group(group);
  command
      .add_option("--bits", options.quantize_bits,
                  "Quantize with CATEGORY=BITS, e.g. position3D=12,color=8; 0 = not quantized")
      ->delimiter(',')
      ->group(group);
}

}  // namespace

void add_encode(CLI::App& program, Session& session) {
  auto options = std::make_shared<EncodeOptions>();
  CLI::App* command =
      program.add_subcommand("encode", "Scene text -> MP4 file, BIFS or AFX stream");
  command
      ->add_option(
          "SCENE", options->inputs,
          "Scene text (.wrl .bt .xmt) or raw octree (.oct); several are the frames of an .afx, in "
          "order")
      ->required();
  command
      ->add_option(
          "-o,--output", options->output,
          "MP4 file (.mp4), BIFS (.bifs) or OctreeImage stream (.afx); - = standard output")
      ->required();
  command->add_option("--format", options->format,
                      "Kind of the output where its name does not tell: mp4, bifs or afx");
  command->add_option("--input-format", options->input_format,
                      "Kind of the inputs: wrl, bt, xmt or oct");
  command->add_option("--node", options->node,
                      "DEF name of the OctreeImage, where a scene has several");
  command->add_option("--resolution", options->resolution, "octreeResolution of a raw octree")
      ->check(CLI::Range(1U, 2147483647U));
  add_scene_options(*command, *options);
  add_common_options(*command, session, {.outputs = true});
  command->callback([options, &session] {
    session.command = "encode";
    session.exit = encode(*options, session);
  });
}

}  // namespace afx::tools
