// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/info.h"

#include <map>

#include "afx/decoded_scene.h"
#include "afx/octree_image.h"
#include "bifs/config.h"
#include "bifs/mp4_reader.h"
#include "bifs/node_sizes.h"
#include "bifs/od_command.h"
#include "codec/octree_voxels.h"
#include "tools/scene_input.h"

namespace afx::tools {
namespace {

using Json = nlohmann::ordered_json;

/// Describes an OctreeImage into `out`, as far as it can be read.
Status describe_octree_image(const nodes::NodeView& view, const UrlBase& base,
                             const Session& session, Diagnostics& diagnostics, Json& out) {
  out["node"] = view.label();
  const auto octree = read_octree_node(view, base, session.limits, diagnostics);
  if (!octree.ok()) return octree.error();
  const OctreeNode& node = octree.value();
  const unsigned levels = octree_levels(node.resolution);
  out["resolution"] = node.resolution;
  out["levels"] = levels;
  out["images"] = node.images;
  out["octreeBytes"] = node.fields.octree.size();
  out["voxelImageIndexSymbols"] = node.fields.voxel_image_index.size();
  const auto images = codec::octree_voxel_images(node.fields, levels, levels, session.limits);
  if (!images.ok()) {
    Error error = images.error();
    error.text = view.label() + ": " + error.text;
    return error;
  }
  out["voxels"] = images.value().size();
  return {};
}

/// What is in a scene, and its OctreeImages; returns an exit code.
int describe_scene(const LoadedScene& loaded, const Input& input, const Session& session,
                   Diagnostics& diagnostics, Json& out) {
  const nodes::Scene& scene = loaded.scene;
  std::map<std::string, uint64_t> types;
  for (uint32_t i = 0; i < scene.node_count(); ++i) ++types[scene.type_name(nodes::NodeId(i))];
  out["nodes"] = scene.node_count();
  out["routes"] = scene.scope().routes.size();
  out["protos"] = scene.proto_count();
  out["nodeTypes"] = types;
  Json octrees = Json::array();
  int code = kDone;
  for (const nodes::NodeView& view : find_octree_images(scene)) {
    Json& octree = octrees.emplace_back(Json::object());
    const Status described =
        describe_octree_image(view, loaded.base(), session, diagnostics, octree);
    if (described.ok()) continue;
    octree["problem"] = described.error().text;
    const int failed = session.fail(described.error(), input.path);
    if (code == kDone) code = failed;
  }
  if (!octrees.empty()) out["octreeImage"] = octrees;
  return code;
}

/// "BIFS", "PNG pictures": what a track's stream is.
std::string stream_kind(const bifs::DecoderConfig* config) {
  namespace type = bifs::object_type;
  if (config == nullptr) return "unknown";
  struct Known {
    uint8_t stream, object;
    const char* name;
  };
  constexpr uint8_t kScene = bifs::stream_type::kScene, kVisual = bifs::stream_type::kVisual;
  constexpr Known kKnown[] = {{kScene, type::kBifs, "BIFS scene"},
                              {kScene, type::kBifsV2, "BIFS scene, version 2"},
                              {kScene, type::kBifsExtended, "BIFS scene, extended"},
                              {kScene, type::kAfx, "AFX stream"},
                              {kVisual, type::kJpeg, "JPEG pictures"},
                              {kVisual, type::kPng, "PNG pictures"},
                              {kVisual, type::kJpeg2000, "JPEG 2000 pictures"},
                              {kVisual, type::kMpeg4Visual, "MPEG-4 video"},
                              {kVisual, type::kAvc, "AVC video"},
                              {kVisual, type::kHevc, "HEVC video"}};
  if (config->stream_type == bifs::stream_type::kObjectDescriptor) return "object descriptors";
  for (const Known& known : kKnown)
    if (known.stream == config->stream_type && known.object == config->object_type)
      return known.name;
  return "stream type " + std::to_string(config->stream_type) + ", object type " +
         std::to_string(config->object_type);
}

Json describe_track(const bifs::Mp4Track& track) {
  const bifs::DecoderConfig* config =
      track.entries.empty() ? nullptr : bifs::decoder_config_of(track.entries[0]);
  uint64_t bytes = 0;
  for (const bifs::Mp4Sample& sample : track.samples) bytes += sample.size;
  Json out{{"id", track.id},
           {"handler", bifs::to_string(track.handler)},
           {"stream", stream_kind(config)},
           {"timescale", track.timescale},
           {"accessUnits", track.samples.size()},
           {"bytes", bytes}};
  if (!track.samples.empty()) out["lastTime"] = track.samples.back().time;
  if (config != nullptr && config->object_type == bifs::object_type::kAfx &&
      config->stream_type == bifs::stream_type::kScene) {
    const auto info = bifs::decoder_specific_info(*bifs::es_of(track.entries[0]));
    if (!info.empty()) out["afxObjectCode"] = info[0];
  }
  for (const bifs::Mp4Reference& reference : track.references)
    out["references_" + bifs::to_string(reference.type)] = reference.tracks;
  return out;
}

/// Hears what is decoded: object descriptors, and the bits that each type of node takes.
class SceneSurvey final : public bifs::PresentationSink {
 public:
  explicit SceneSurvey(bool with_units) : with_units_(with_units) {}

  Json descriptors = Json::array();
  Json units = Json::array();  ///< only if they are wanted: they are many

  Status begin(const bifs::InitialObjectDescriptor&) override { return {}; }
  Status begin_frame(uint64_t time, bool random_access) override {
    if (with_units_)
      units.push_back(
          {{"time", time}, {"randomAccess", random_access}, {"commands", Json::array()}});
    return {};
  }
  Status add(const bifs::Command& command, const nodes::Scene&) override {
    if (with_units_) units.back()["commands"].push_back(std::string(bifs::command_name(command)));
    return {};
  }
  Status end_frame() override { return {}; }
  Status object_descriptors(uint64_t time, bool, const bifs::OdCommands& commands) override {
    for (const bifs::OdCommand& command : commands) {
      const auto* update = std::get_if<bifs::OdUpdate>(&command.body);
      for (const bifs::Descriptor& part : update != nullptr ? update->objects : bifs::Descriptors())
        if (const auto* object = std::get_if<bifs::ObjectDescriptor>(&part.body))
          descriptors.push_back(describe(time, *object));
    }
    return {};
  }
  Status end() override { return {}; }

 private:
  static Json describe(uint64_t time, const bifs::ObjectDescriptor& object) {
    Json out{{"id", object.id}, {"time", time}};
    if (object.url) out["url"] = *object.url;
    Json tracks = Json::array();
    for (const bifs::Descriptor& part : object.parts)
      if (const auto* es = std::get_if<bifs::EsDescriptor>(&part.body)) tracks.push_back(es->es_id);
    if (!tracks.empty()) out["tracks"] = tracks;
    return out;
  }

  bool with_units_;
};

/// Bytes by type of node, the largest first.
Json describe_sizes(const std::map<std::string, bifs::NodeSize>& sizes) {
  std::vector<std::pair<std::string, bifs::NodeSize>> sorted(sizes.begin(), sizes.end());
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.second.bits > b.second.bits; });
  Json out = Json::object();
  for (const auto& [type, size] : sorted) {
    const std::string bytes = counted((size.bits + 7) / 8, "byte");
    out[type] = size.count == 0 ? bytes : grouped(size.count) + " in " + bytes;
  }
  return out;
}

}  // namespace

int info_of_text_scene(const Input& input, const Session& session, Diagnostics& diagnostics,
                       Json& out) {
  const auto loaded = read_scene(input, session.limits, diagnostics);
  if (!loaded.ok()) return session.fail(loaded.error(), input.path);
  return describe_scene(loaded.value(), input, session, diagnostics, out);
}

int info_of_coded_scene(const Input& input, const Session& session, Diagnostics& diagnostics,
                        Json& out) {
  Diagnostics first;  // the warnings come again when the scene is read
  auto coded = open_coded_scene(input, session.limits, first);
  if (!coded.ok()) return session.fail(coded.error(), input.path, first);
  const bifs::Mp4Movie& movie = coded.value().movie;
  Json tracks = Json::array();
  for (const bifs::Mp4Track& track : movie.tracks) tracks.push_back(describe_track(track));
  out["track"] = tracks;

  SceneSurvey survey(session.options.json || session.options.verbose);
  bifs::NodeSizes sizes;
  const codec::Trace measure = [&sizes](const codec::TraceElement& element) {
    sizes.hear(element);
  };
  bifs::PresentationDecodeOptions how;
  how.limits = session.limits;
  how.drop_coding_quantizers = false;
  how.trace = &measure;
  const auto decoded = bifs::decode_presentation(coded.value().source, movie, how, &survey, first);
  if (!survey.descriptors.empty()) out["objectDescriptor"] = survey.descriptors;
  if (!survey.units.empty()) out["accessUnit"] = survey.units;
  out["nodeSizes"] = describe_sizes(sizes.sizes());
  if (!decoded.ok()) return session.fail(decoded.error(), input.path, first);

  const auto loaded = read_scene(input, session.limits, diagnostics);
  if (!loaded.ok()) return session.fail(loaded.error(), input.path);
  return describe_scene(loaded.value(), input, session, diagnostics, out);
}

}  // namespace afx::tools
