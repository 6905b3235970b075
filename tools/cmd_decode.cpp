// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "afx/file.h"
#include "afx/octree_stream.h"
#include "nodes/scene_writer.h"
#include "tools/commands.h"
#include "tools/input.h"
#include "tools/session.h"

namespace afx::tools {
namespace {

struct DecodeOptions {
  std::string input;
  std::string output;
  std::string format;
  std::string input_format;
  std::optional<uint32_t> frame;
  unsigned levels = 32;
  bool partial = false;
};

/// Where %d or %04d stands in an output name: replaced by the frame's number. No pattern: the name
/// itself.
struct NamePattern {
  std::string before, after;
  size_t digits = 0;
  bool has_number = false;

  explicit NamePattern(const std::string& name) : before(name) {
    const size_t at = name.find('%');
    const size_t end = at == std::string::npos ? at : name.find_first_not_of("0123456789", at + 1);
    if (end == std::string::npos || name[end] != 'd' || end - at > 3) return;
    has_number = true;
    before = name.substr(0, at);
    after = name.substr(end + 1);
    if (end > at + 1) digits = std::stoul(name.substr(at + 1, end - at - 1));
  }
  [[nodiscard]] std::string name(uint32_t frame) const {
    if (!has_number) return before;
    std::string number = std::to_string(frame);
    if (number.size() < digits) number.insert(0, digits - number.size(), '0');
    return before + number + after;
  }
};

std::vector<uint8_t> scene_text_of(const OctreeFields& fields, uint32_t resolution,
                                   uint32_t textures, bool header) {
  nodes::Scene scene;
  const auto group = scene.add("Group");
  const nodes::NodeId octree = add_octree_image(scene, OctreeNode{resolution, textures, fields});
  (void)scene.append(group.value(), "children", octree);  // an OctreeImage may stand there
  scene.add_root(group.value());
  const std::string text = nodes::write_scene_text(scene, {.vrml_header = header});
  return {text.begin(), text.end()};
}

/// The bytes of one frame as the output wants them; what it cannot hold is a warning.
std::vector<uint8_t> output_of(const DecodedOctreeStream& decoded, size_t i, Kind kind, bool header,
                               Diagnostics& diagnostics) {
  const OctreeFields& fields = decoded.stream.frames[i];
  if (kind == Kind::scene_text) {
    return scene_text_of(fields, decoded.infos[i].resolution, decoded.stream.textures, header);
  }
  if (!fields.voxel_image_index.empty()) {
    diagnostics.warn("lost_indices", Place::none(),
                     "a raw octree has no place for image indices: " +
                         std::to_string(fields.voxel_image_index.size()) +
                         " symbols of voxelImageIndex are left out");
  }
  return fields.octree;
}

int check_output(const DecodeOptions& options, Kind kind, const NamePattern& pattern, size_t frames,
                 const Session& session) {
  if (kind == Kind::not_yet) return session.fail(not_in_this_version(options.output));
  if (kind != Kind::scene_text && kind != Kind::raw_octree) {
    return session.usage("cannot decode to " + options.output +
                         " (expected .wrl, .bt or .oct, or --format)");
  }
  if (frames > 1 && !pattern.has_number) {
    return session.usage("the stream has " + std::to_string(frames) + " frames, but " +
                         options.output +
                         " is one file (expected a pattern such as frame_%04d.wrl, or --frame K)");
  }
  return kDone;
}

int write_frames(const DecodeOptions& options, const DecodedOctreeStream& decoded,
                 const Session& session, Diagnostics& diagnostics) {
  const NamePattern pattern(options.output);
  const std::string& named = options.format.empty() ? options.output : "x." + options.format;
  const Kind kind = kind_of_ending(named);
  if (const int code = check_output(options, kind, pattern, decoded.stream.frames.size(), session);
      code != kDone)
    return code;
  const bool header = !named.ends_with(".bt");
  OutputFiles outputs(session.options.overwrite);
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (size_t i = 0; i < decoded.stream.frames.size(); ++i) {
    const std::string name = pattern.name(decoded.infos[i].number);
    const std::vector<uint8_t> bytes = output_of(decoded, i, kind, header, diagnostics);
    if (name != "-")
      session.say(name + ": " + grouped(bytes.size()) + " bytes, resolution " +
                  std::to_string(decoded.infos[i].resolution));
    list.push_back({{"output", name},
                    {"bytes", bytes.size()},
                    {"octreeResolution", decoded.infos[i].resolution}});
    if (session.options.dry_run) continue;
    if (Status put = outputs.put(name, bytes); !put.ok()) return session.fail(put.error(), name);
  }
  if (const int code = session.warn(diagnostics, options.input); code != kDone) return code;
  if (!session.options.dry_run) {
    if (Status done = outputs.commit(); !done.ok())
      return session.fail(done.error(), options.output);
  }
  if (options.output != "-") session.result({{"outputs", list}});
  return kDone;
}

int decode(const DecodeOptions& options, const Session& session) {
  Diagnostics diagnostics;
  const auto input = open_input(options.input, options.input_format, session.limits, diagnostics);
  if (!input.ok()) return session.fail(input.error());
  if (input.value().kind != Kind::octree_stream) {
    return session.fail(
        {Errc::unsupported, Place::none(),
         std::string("is ") + describe(input.value().kind) + " (expected an OctreeImage stream)"},
        options.input);
  }
  OctreeDecodeOptions how{
      .levels = options.levels, .frame = options.frame, .threads = session.options.threads};
  how.limits = session.limits;
  const DecodedOctreeStream decoded =
      decode_octree_stream(input.value().file.bytes(), how, diagnostics);
  if (!decoded.status.ok()) {
    const int code = session.fail(decoded.status.error(), options.input);
    if (decoded.status.error().code == Errc::bad_argument) return kUsage;  // --frame
    if (!options.partial || decoded.stream.frames.empty()) return code;
    const int written = write_frames(options, decoded, session, diagnostics);
    return written == kDone ? code : written;
  }
  return write_frames(options, decoded, session, diagnostics);
}

}  // namespace

void add_decode(CLI::App& program, Session& session) {
  auto options = std::make_shared<DecodeOptions>();
  CLI::App* command = program.add_subcommand("decode", "AFX stream -> scene text or raw octree");
  command->add_option("IN", options->input, "The stream (.afx); - = standard input")->required();
  command
      ->add_option("-o,--output", options->output,
                   "Scene text (.wrl .bt) or raw octree (.oct); frame_%04d.wrl for every frame; - "
                   "= standard output")
      ->required();
  command->add_option("--format", options->format,
                      "Kind of the output where its name does not tell: wrl, bt or oct");
  command->add_option("--input-format", options->input_format, "Kind of the input: afx");
  command->add_option("--frame", options->frame, "Only this frame, counted from 0");
  command->add_option("--levels", options->levels, "Decode a coarser model of so many levels")
      ->check(CLI::Range(0U, 32U));
  command->add_flag("--partial", options->partial,
                    "Of a truncated stream write what is whole (the exit code stays 3)");
  add_common_options(*command, session, true);
  command->callback([options, &session] {
    session.command = "decode";
    session.exit = decode(*options, session);
  });
}

}  // namespace afx::tools
