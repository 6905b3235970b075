// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/scene_input.h"

#include <map>
#include <string>
#include <utility>

#include "afx/decoded_scene.h"
#include "afx/scene_packing.h"
#include "bifs/bt_reader.h"
#include "bifs/mp4_reader.h"
#include "bifs/raw_bifs.h"
#include "bifs/xmt_reader.h"
#include "nodes/node_view.h"
#include "nodes/scene_reader.h"
#include "tools/session.h"

namespace afx::tools {
namespace {

std::string_view text_of(const Input& input) {
  const std::span<const uint8_t> bytes = input.file.bytes();
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// What is read of the text is let go of.
nodes::SceneReadOptions text_options(const Input& input, const Limits& limits) {
  nodes::SceneReadOptions options;
  options.passed = [&input](size_t offset) { input.file.let_go(offset); };
  options.load_file = [folder = input.folder(),
                       limits](std::string_view name) -> Result<std::string> {
    const nodes::Url url{std::string(name), nodes::Url::kNoDescriptor};
    const auto file = open_url({&url, 1}, folder, limits);
    if (!file.ok()) return file.error();
    const std::span<const uint8_t> bytes = file.value().file.bytes();
    return std::string(bytes.begin(), bytes.end());
  };
  return options;
}

/// What has been read is let go of: the file need not be in memory beside its content.
bifs::Mp4Source source_of(const Input& input) {
  bifs::Mp4Source source = bifs::mp4_source(input.file.bytes());
  source.passed = [&file = input.file](uint64_t offset) { file.let_go(offset); };
  return source;
}

/// For carrying commands out without telling anybody.
class NoSink final : public bifs::PresentationSink {
 public:
  Status begin(const bifs::InitialObjectDescriptor&) override { return {}; }
  Status begin_frame(uint64_t, bool) override { return {}; }
  Status add(const bifs::Command&, const nodes::Scene&) override { return {}; }
  Status end_frame() override { return {}; }
  Status object_descriptors(uint64_t, bool, const bifs::OdCommands&) override { return {}; }
  Status end() override { return {}; }
};

Result<LoadedScene> read_coded(const Input& input, const Limits& limits, Diagnostics& diagnostics) {
  auto opened = open_coded_scene(input, limits, diagnostics);
  if (!opened.ok()) return std::move(opened).error();
  LoadedScene loaded;
  loaded.folder = input.folder();
  loaded.coded = std::make_unique<CodedScene>(std::move(opened).value());
  bifs::PresentationDecodeOptions options;
  options.file_name = input.path;
  options.limits = limits;
  auto decoded = decode_scene(loaded.coded->source, loaded.coded->movie, options, diagnostics);
  if (!decoded.ok()) return in_file(std::move(decoded).error(), input.path);
  loaded.scene = std::move(decoded.value().scene);
  loaded.streams = std::move(decoded.value().streams);
  return loaded;
}

/// A plain scene is read as it stands; one with commands as a presentation that is played.
Result<nodes::Scene> read_text(const Input& input, const Limits& limits, Diagnostics& diagnostics) {
  if (input.kind == Kind::scene_text) {
    Diagnostics found;
    auto scene = nodes::read_scene_text(text_of(input), limits, found, text_options(input, limits));
    if (scene.ok() || scene.error().code != Errc::unsupported) {
      diagnostics.append(found);
      if (!scene.ok()) return in_file(std::move(scene).error(), input.path);
      return scene;
    }
  }
  auto presentation = read_presentation(input, limits, diagnostics);
  if (!presentation.ok()) return std::move(presentation).error();
  NoSink nobody;
  const Status played = bifs::play(presentation.value(), nobody, diagnostics);
  if (!played.ok()) return in_file(played.error(), input.path);
  return std::move(presentation.value().scene);
}

}  // namespace

Result<CodedScene> open_coded_scene(const Input& input, const Limits& limits,
                                    Diagnostics& diagnostics, const codec::Trace* trace) {
  CodedScene scene;
  scene.source = source_of(input);
  if (input.kind == Kind::raw_bifs) {
    const auto raw = bifs::read_raw_bifs(input.file.bytes(), limits, trace);
    if (!raw.ok()) return in_file(raw.error(), input.path);
    scene.movie = bifs::movie_of_raw_bifs(raw.value());
    return scene;
  }
  auto movie = bifs::read_mp4(scene.source, limits, diagnostics, trace);
  if (!movie.ok()) return in_file(std::move(movie).error(), input.path);
  scene.movie = std::move(movie).value();
  return scene;
}

Result<bifs::Presentation> read_presentation(const Input& input, const Limits& limits,
                                             Diagnostics& diagnostics, bool like_gpac) {
  nodes::SceneReadOptions options = text_options(input, limits);
  options.like_gpac = like_gpac;
  auto presentation = input.kind == Kind::scene_xml
                          ? bifs::read_xmt(text_of(input), limits, diagnostics)
                          : bifs::read_bt(text_of(input), limits, diagnostics, options);
  if (!presentation.ok()) return in_file(std::move(presentation).error(), input.path);
  input.file.let_go(input.file.bytes().size());
  return presentation;
}

Result<LoadedScene> read_scene(const Input& input, const Limits& limits, Diagnostics& diagnostics) {
  if (is_coded_scene(input.kind)) return read_coded(input, limits, diagnostics);
  auto scene = read_text(input, limits, diagnostics);
  if (!scene.ok()) return std::move(scene).error();
  LoadedScene loaded;
  loaded.scene = std::move(scene).value();
  loaded.folder = input.folder();
  return loaded;
}

Result<nodes::Scene> read_plain_scene(const Input& input, const Limits& limits,
                                      Diagnostics& diagnostics) {
  auto loaded = read_scene(input, limits, diagnostics);
  if (!loaded.ok()) return std::move(loaded).error();
  if (loaded.value().coded) {
    UnpackOptions options;
    options.limits = limits;
    const auto pictures =
        unpack_scene(loaded.value().scene, loaded.value().streams, options, diagnostics);
    if (!pictures.ok()) return in_file(pictures.error(), input.path);
  }
  return std::move(loaded.value().scene);
}

void warn_of_left_out(const nodes::Scene& scene, Diagnostics& diagnostics) {
  std::map<std::string, size_t> left_out;
  for (uint32_t i = 0; i < scene.node_count(); ++i) {
    const nodes::NodeId id(i);
    const std::string& type = scene.type_name(id);
    if (scene.node(id).scope != nodes::Scene::kMain || (type != "Shape" && type != "Inline"))
      continue;
    if (nodes::NodeView(scene, id).child("geometry").type() == "BitWrapper") continue;
    ++left_out[type];
  }
  for (const auto& [type, count] : left_out) {
    diagnostics.warn("left_out", Place::none(),
                     counted(count, type) + (count == 1 ? " is" : " are") +
                         " left out: a model is made of DepthImages and OctreeImages");
  }
}

}  // namespace afx::tools
