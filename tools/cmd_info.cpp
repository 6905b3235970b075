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
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_unsigned()) return grouped(value.get<uint64_t>());
  if (value.is_number_float()) return fixed(value.get<double>(), 3);
  return value.dump();
}

/// "name: value" lines; a list of objects is a block for each.
void print(const Json& object, const std::string& indent = {}) {
  for (const auto& [name, value] : object.items()) {
    if (value.is_array() && !value.empty() && value.front().is_object()) {
      size_t number = 0;
      for (const Json& element : value) {
        std::cout << indent << name << ' ' << number++ << ":\n";
        print(element, indent + "  ");
      }
    } else if (value.is_object()) {
      std::cout << indent << name << ":\n";
      print(value, indent + "  ");
    } else {
      std::cout << indent << name << ": " << printed(value) << '\n';
    }
  }
}

double ratio(double a, uint64_t b) { return b == 0 ? 0 : a / static_cast<double>(b); }

Json describe_frame(const OctreeFrameInfo& info, const OctreeFields& fields, uint64_t voxels) {
  return {{"frame", info.number},
          {"byte", info.byte},
          {"bits", info.bits},
          {"node symbols", info.node_symbols},
          {"texture symbols", info.texture_symbols},
          {"voxels", voxels},
          {"bits per voxel", ratio(static_cast<double>(info.bits), voxels)},
          {"field bytes per stream byte",
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
    if (!info.whole) frames.back()["truncated to resolution"] = info.resolution;
  }
  out["frames"] = decoded.infos.size();
  out["voxels"] = all_voxels;
  out["bits per voxel"] = ratio(static_cast<double>(input.file.bytes().size()) * 8, all_voxels);
  if (frames.size() == 1 || session.options.verbose || session.options.json) out["frame"] = frames;
  return decoded.status.ok() ? kDone : session.fail(decoded.status.error(), input.path);
}

int info_of_raw(const Input& input, const InfoOptions& options, const Session& session,
                Diagnostics& diagnostics, Json& out) {
  OctreeQuery query{.node = {}, .resolution = options.resolution, .frame = {}};
  const auto octree = read_octree(input, query, session.limits, diagnostics);
  if (!octree.ok()) {
    const int code = session.fail(octree.error());
    return query.missing_is_usage ? kUsage : code;
  }
  const unsigned levels = octree_levels(octree.value().resolution);
  const auto counts =
      codec::octree_level_counts(octree.value().fields.octree, levels, session.limits);
  out["resolution"] = octree.value().resolution;
  out["levels"] = levels;
  out["node symbols"] = octree.value().fields.octree.size();
  out["voxels"] = counts.value().back();
  return kDone;
}

Json describe_octree_image(const nodes::NodeView& view, const Input& input, const Session& session,
                           Diagnostics& diagnostics) {
  Json out{{"node", view.label()}};
  const auto octree = read_octree_node(view, input.folder(), session.limits, diagnostics);
  if (!octree.ok()) {
    out["problem"] = octree.error().text;
    return out;
  }
  const OctreeNode& node = octree.value();
  const unsigned levels = octree_levels(node.resolution);
  out["resolution"] = node.resolution;
  out["levels"] = levels;
  out["images"] = node.images;
  out["octree bytes"] = node.fields.octree.size();
  out["voxelImageIndex symbols"] = node.fields.voxel_image_index.size();
  const auto images = codec::octree_voxel_images(node.fields, levels, levels, session.limits);
  if (images.ok()) {
    out["voxels"] = images.value().size();
  } else {
    out["problem"] = images.error().text;
  }
  return out;
}

int info_of_scene(const Input& input, const Session& session, Diagnostics& diagnostics, Json& out) {
  const auto scene = read_scene(input, session.limits, diagnostics);
  if (!scene.ok()) return session.fail(scene.error());
  std::map<std::string, uint64_t> types;
  for (uint32_t i = 0; i < scene.value().node_count(); ++i)
    ++types[scene.value().type_name(nodes::NodeId(i))];
  out["nodes"] = scene.value().node_count();
  out["routes"] = scene.value().scope().routes.size();
  out["protos"] = scene.value().proto_count();
  out["node types"] = types;
  Json octrees = Json::array();
  for (const nodes::NodeView& view : find_octree_images(scene.value())) {
    octrees.push_back(describe_octree_image(view, input, session, diagnostics));
  }
  if (!octrees.empty()) out["octree image"] = octrees;
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
  Diagnostics diagnostics;
  const auto opened = open_input(options.input, options.input_format, session.limits, diagnostics);
  if (!opened.ok()) return session.fail(opened.error());
  const Input& input = opened.value();
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
      code = info_of_scene(input, session, diagnostics, out);
      break;
    case Kind::picture:
      code = info_of_picture(input, session, out);
      break;
    case Kind::model:
    case Kind::not_yet:
    case Kind::unknown:
      return session.fail({Errc::unsupported, Place::none(),
                           std::string("is ") + describe(input.kind) +
                               " (expected .afx, .oct, scene text or a picture)"},
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
  add_common_options(*command, session, false);
  command->callback([options, &session] {
    session.command = "info";
    session.exit = info(*options, session);
  });
}

}  // namespace afx::tools
