// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <CLI/CLI.hpp>
#include <iostream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "afx/octree_stream.h"
#include "afx/picture_io.h"
#include "codec/octree_voxels.h"
#include "tools/commands.h"
#include "tools/info.h"
#include "tools/input.h"
#include "tools/session.h"

namespace afx::tools {
namespace {

using Json = nlohmann::ordered_json;

struct InfoOptions {
  std::string input;
  std::string input_format;
  std::optional<uint32_t> resolution;
};

/// A value as people read it.
std::string printed(const Json& value) {
  if (value.is_string()) return printable(value.get<std::string>());
  if (value.is_number_unsigned()) return grouped(value.get<uint64_t>());
  if (value.is_number_float()) return fixed(value.get<double>(), 3);
  return value.dump();
}

/// "bitsPerVoxel" -> "bits per voxel".
std::string in_words(const std::string& name) {
  std::string words;
  for (const char c : name) {
    const bool capital = c >= 'A' && c <= 'Z';
    if (capital) words += ' ';
    words += capital ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return words;
}

/// "name: value" lines; a list of objects is a block for each.
void print(const Json& object, const std::string& indent = {}) {
  for (const auto& [name, value] : object.items()) {
    const std::string label = indent + in_words(name);
    if (value.is_object()) {  // of node types: the names in it are the scene's own
      std::cout << label << ":\n";
      for (const auto& [type, what] : value.items())
        std::cout << indent << "  " << printable(type) << ": " << printed(what) << '\n';
    } else if (value.is_array() && !value.empty() && value.front().is_object()) {
      size_t number = 0;
      for (const Json& element : value) {
        std::cout << label << ' ' << number++ << ":\n";
        print(element, indent + "  ");
      }
    } else {
      std::cout << label << ": " << printed(value) << '\n';
    }
  }
}

double ratio(double a, uint64_t b) { return b == 0 ? 0 : a / static_cast<double>(b); }

Json describe_frame(const OctreeFrameInfo& info, const OctreeFields& fields, uint64_t voxels) {
  return {{"frame", info.number},
          {"byte", info.byte},
          {"bits", info.bits},
          {"nodeSymbols", info.node_symbols},
          {"textureSymbols", info.texture_symbols},
          {"voxels", voxels},
          {"bitsPerVoxel", ratio(static_cast<double>(info.bits), voxels)},
          {"fieldBytesPerStreamByte",
           ratio(static_cast<double>(fields.octree.size() + fields.voxel_image_index.size()) * 8,
                 info.bits)}};
}

int info_of_stream(const Input& input, const Session& session, Diagnostics& diagnostics,
                   Json& out) {
  OctreeDecodeOptions how{.threads = session.options.threads};
  how.limits = session.limits;
  const DecodedOctreeStream decoded = decode_octree_stream(input.file.bytes(), how, diagnostics);
  if (decoded.has_header) {
    out["resolution"] = decoded.stream.resolution;
    out["levels"] = octree_levels(decoded.stream.resolution);
    out["images"] = decoded.stream.textures;
  }
  uint64_t all_voxels = 0;
  Json frames = Json::array();
  for (size_t i = 0; i < decoded.infos.size(); ++i) {
    const OctreeFrameInfo& info = decoded.infos[i];
    const OctreeFields& fields = decoded.stream.frames[i];
    const auto counts =
        codec::octree_level_counts(fields.octree, octree_levels(info.resolution), session.limits);
    const uint64_t voxels = counts.ok() ? counts.value().back() : 0;
    all_voxels += voxels;
    frames.push_back(describe_frame(info, fields, voxels));
    if (!info.whole) frames.back()["truncatedToResolution"] = info.resolution;
  }
  out["frames"] = decoded.infos.size();
  out["voxels"] = all_voxels;
  out["bitsPerVoxel"] = ratio(static_cast<double>(input.file.bytes().size()) * 8, all_voxels);
  if (frames.size() == 1 || session.options.verbose || session.options.json) out["frame"] = frames;
  return decoded.status.ok() ? kDone : session.fail(decoded.status.error(), input.path);
}

int info_of_raw(const Input& input, const InfoOptions& options, const Session& session,
                Diagnostics& diagnostics, Json& out) {
  OctreeQuery query{.node = {}, .resolution = options.resolution, .frame = {}};
  const auto octree = read_octree(input, query, session.limits, diagnostics);
  if (!octree.ok()) return session.fail_query(octree.error(), query.missing_is_usage, input.path);
  const unsigned levels = octree_levels(octree.value().resolution);
  const auto counts =
      codec::octree_level_counts(octree.value().fields.octree, levels, session.limits);
  out["resolution"] = octree.value().resolution;
  out["levels"] = levels;
  out["nodeSymbols"] = octree.value().fields.octree.size();
  out["voxels"] = counts.value().back();
  return kDone;
}

int info_of_picture(const Input& input, const Session& session, Json& out) {
  const auto picture = decode_picture(input.file.bytes(), input.path, session.limits);
  if (!picture.ok()) return session.fail(picture.error(), input.path);
  out["format"] = picture_format_of_content(input.file.bytes());
  out["width"] = picture.value().width;
  out["height"] = picture.value().height;
  out["components"] = picture.value().components;
  return kDone;
}

int info(const InfoOptions& options, const Session& session) {
  constexpr const char* kInputs[] = {"afx", "oct", "wrl", "bt", "xmt", "mp4", "bifs", "png"};
  if (const int code = check_input_format(session, options.input_format, kInputs); code != kDone)
    return code;
  Diagnostics diagnostics;
  const auto opened = open_input(options.input, options.input_format, session.limits, diagnostics);
  if (!opened.ok()) return session.fail(opened.error());
  const Input& input = opened.value();
  const std::string useless =
      useless_option({.node = {}, .resolution = options.resolution, .frame = {}}, {&input.kind, 1});
  if (!useless.empty()) return session.usage(useless);
  Json out{
      {"file", input.path}, {"kind", describe(input.kind)}, {"bytes", input.file.bytes().size()}};
  int code = kDone;
  switch (input.kind) {
    case Kind::octree_stream:
      code = info_of_stream(input, session, diagnostics, out);
      break;
    case Kind::raw_octree:
      code = info_of_raw(input, options, session, diagnostics, out);
      break;
    case Kind::scene_text:
    case Kind::scene_xml:
      code = info_of_text_scene(input, session, diagnostics, out);
      break;
    case Kind::mp4:
    case Kind::raw_bifs:
      code = info_of_coded_scene(input, session, diagnostics, out);
      break;
    case Kind::picture:
      code = info_of_picture(input, session, out);
      break;
    case Kind::model:
    case Kind::json:
    case Kind::unknown:
      return session.fail({Errc::unsupported, Place::none(),
                           std::string("is ") + describe(input.kind) +
                               " (expected a scene, .afx, .oct or a picture)"},
                          input.path);
  }
  if (code != kUsage) {
    if (session.options.json) {
      session.result(out);
    } else {
      print(out);
    }
  }
  const int warned = session.warn(diagnostics, input.path);
  return code != kDone ? code : warned;
}

}  // namespace

void add_info(CLI::App& program, Session& session) {
  auto options = std::make_shared<InfoOptions>();
  CLI::App* command =
      program.add_subcommand("info", "What is inside a file: nodes, sizes, bits per voxel");
  command
      ->add_option("IN", options->input,
                   "Stream, raw octree, scene text or picture; - = standard input")
      ->required();
  command->add_option("--input-format", options->input_format,
                      "Kind of the input: afx, oct, wrl or bt");
  command->add_option("--resolution", options->resolution, "octreeResolution of a raw octree")
      ->check(CLI::Range(1U, 2147483647U));
  add_common_options(*command, session, {.verbose = true});
  command->callback([options, &session] {
    session.command = "info";
    session.exit = info(*options, session);
  });
}

}  // namespace afx::tools
