// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "afx/file.h"
#include "afx/octree_stream.h"
#include "tools/commands.h"
#include "tools/input.h"
#include "tools/session.h"

namespace afx::tools {
namespace {

struct EncodeOptions {
  std::vector<std::string> inputs;
  std::string output;
  std::string format;
  std::string input_format;
  std::string node;
  std::optional<uint32_t> resolution;
};

/// Adds a frame to the stream; the first one decides resolution and number of images.
Status add_frame(OctreeStream& stream, OctreeNode octree) {
  const uint32_t textures = octree.fields.voxel_image_index.empty() ? 0 : octree.images;
  const auto differs = [](const char* what, uint64_t here, uint64_t first) {
    return Error{Errc::bad_argument, Place::none(),
                 std::string(what) + " is " + std::to_string(here) + ", but " +
                     std::to_string(first) +
                     " in the first frame (frames of one stream must agree)"};
  };
  if (stream.frames.empty()) {
    stream.resolution = octree.resolution;
    stream.textures = textures;
  }
  if (octree.resolution != stream.resolution) {
    return differs("octreeResolution", octree.resolution, stream.resolution);
  }
  if (textures != stream.textures)
    return differs("the number of images with indices", textures, stream.textures);
  stream.frames.push_back(std::move(octree.fields));
  return {};
}

/// Reads all inputs as frames; returns an exit code.
int read_frames(const EncodeOptions& options, const Session& session, OctreeStream& stream) {
  for (const std::string& path : options.inputs) {
    Diagnostics diagnostics;
    const auto input = open_input(path, options.input_format, session.limits, diagnostics);
    if (!input.ok()) return session.fail(input.error());
    if (input.value().kind == Kind::octree_stream) {
      return session.fail({Errc::unsupported, Place::none(),
                           "is an OctreeImage stream already (expected scene text or .oct)"},
                          path);
    }
    OctreeQuery query{.node = options.node, .resolution = options.resolution, .frame = {}};
    auto octree = read_octree(input.value(), query, session.limits, diagnostics);
    if (!octree.ok()) {
      const int code = session.fail(octree.error());
      return query.missing_is_usage ? kUsage : code;
    }
    if (const int code = session.warn(diagnostics, path); code != kDone) return code;
    if (Status status = add_frame(stream, std::move(octree).value()); !status.ok())
      return session.fail(status.error(), path);
  }
  return kDone;
}

int encode(const EncodeOptions& options, const Session& session) {
  const Kind kind =
      options.format.empty() ? kind_of_ending(options.output) : kind_of_format(options.format);
  if (kind == Kind::not_yet) return session.fail(not_in_this_version(options.output));
  if (kind != Kind::octree_stream) {
    return session.usage("cannot encode to " + options.output +
                         ": this version writes .afx streams (expected -o NAME.afx"
                         " or --format afx)");
  }
  OutputFiles outputs(session.options.overwrite);
  if (Status free = outputs.check(options.output); !free.ok())
    return session.fail(free.error(), options.output);
  OctreeStream stream;
  if (const int code = read_frames(options, session, stream); code != kDone) return code;
  const auto encoded = encode_octree_stream(stream, session.options.threads);
  if (!encoded.ok()) return session.fail(encoded.error(), options.inputs.front());

  uint64_t fields = 0;
  for (const OctreeFields& frame : stream.frames)
    fields += frame.octree.size() + frame.voxel_image_index.size();
  session.say(options.output + ": " + grouped(encoded.value().size()) + " bytes from " +
              grouped(fields) + " bytes of fields, " + std::to_string(stream.frames.size()) +
              (stream.frames.size() == 1 ? " frame" : " frames"));
  session.result({{"output", options.output},
                  {"bytes", encoded.value().size()},
                  {"fieldBytes", fields},
                  {"frames", stream.frames.size()},
                  {"octreeResolution", stream.resolution},
                  {"numOfTextures", stream.textures}});
  if (session.options.dry_run) return kDone;
  if (Status put = outputs.put(options.output, encoded.value()); !put.ok())
    return session.fail(put.error(), options.output);
  if (Status done = outputs.commit(); !done.ok()) return session.fail(done.error(), options.output);
  return kDone;
}

}  // namespace

void add_encode(CLI::App& program, Session& session) {
  auto options = std::make_shared<EncodeOptions>();
  CLI::App* command = program.add_subcommand("encode", "Scene text or raw octrees -> AFX stream");
  command
      ->add_option("SCENE", options->inputs,
                   "Scene text (.wrl .bt) or raw octree (.oct); several are the frames, in order")
      ->required();
  command->add_option("-o,--output", options->output, "The stream (.afx); - = standard output")
      ->required();
  command->add_option("--format", options->format,
                      "Kind of the output where its name does not tell: afx");
  command->add_option("--input-format", options->input_format,
                      "Kind of the inputs: wrl, bt or oct");
  command->add_option("--node", options->node,
                      "DEF name of the OctreeImage, where a scene has several");
  command->add_option("--resolution", options->resolution, "octreeResolution of a raw octree")
      ->check(CLI::Range(1U, 2147483647U));
  add_common_options(*command, session, true);
  command->callback([options, &session] {
    session.command = "encode";
    session.exit = encode(*options, session);
  });
}

}  // namespace afx::tools
