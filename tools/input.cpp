// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/input.h"

#include <algorithm>
#include <filesystem>

#include "afx/octree_stream.h"
#include "afx/picture_io.h"
#include "codec/octree_voxels.h"
#include "tools/scene_input.h"

namespace afx::tools {
namespace {

bool begins_with(std::span<const uint8_t> bytes, std::string_view text) {
  return bytes.size() >= text.size() && std::equal(text.begin(), text.end(), bytes.begin());
}

/// The first box says: its type stands behind its size.
bool looks_like_mp4(std::span<const uint8_t> bytes) {
  constexpr std::string_view kFirstBoxes[] = {"ftyp", "moov", "mdat", "free", "wide", "skip"};
  return bytes.size() >= 8 &&
         std::any_of(std::begin(kFirstBoxes), std::end(kFirstBoxes),
                     [&](std::string_view type) { return begins_with(bytes.subspan(4), type); });
}

/// XMT-A among the first elements; other XML is not ours.
bool looks_like_xmt(std::span<const uint8_t> bytes) {
  constexpr size_t kLookedAt = 4096;
  const std::string_view head(reinterpret_cast<const char*>(bytes.data()),
                              std::min(bytes.size(), kLookedAt));
  const size_t first = head.find('<');
  return first != std::string_view::npos &&
         head.substr(0, first).find_first_not_of("\xEF\xBB\xBF \t\r\n") == std::string_view::npos &&
         head.find("<XMT-A") != std::string_view::npos;
}

/// Opens a file; its kind may stay unknown.
Result<Input> open_any(const std::string& path, const std::string& input_format,
                       const Limits& limits, Diagnostics& diagnostics) {
  auto file = MappedFile::open(path, limits);
  if (!file.ok()) return in_file(std::move(file).error(), path);
  if (input_format.empty()) return input_of(path, std::move(file).value(), diagnostics);
  return Input{path, kind_of_format(input_format), std::move(file).value()};
}

/// Octree fields of a stream: the only frame, or the one asked for.
Result<OctreeNode> read_stream(const Input& input, OctreeQuery& query, const Limits& limits,
                               Diagnostics& diagnostics) {
  OctreeDecodeOptions options{.frame = query.frame};
  options.limits = limits;
  DecodedOctreeStream decoded = decode_octree_stream(input.file.bytes(), options, diagnostics);
  if (!decoded.status.ok()) {
    query.missing_is_usage = decoded.status.error().code == Errc::bad_argument;
    return std::move(decoded.status).error();
  }
  if (decoded.stream.frames.size() > 1) {
    query.missing_is_usage = true;
    return Error{Errc::bad_argument, Place::none(),
                 "the stream has " + std::to_string(decoded.stream.frames.size()) +
                     " frames (expected --frame K)"};
  }
  return OctreeNode{decoded.stream.resolution, decoded.stream.textures,
                    std::move(decoded.stream.frames[0])};
}

Result<OctreeNode> read_raw(const Input& input, OctreeQuery& query, const Limits& limits) {
  if (!query.resolution) {
    query.missing_is_usage = true;
    return Error{Errc::bad_argument, Place::none(),
                 "a raw octree does not tell its size (expected --resolution N)"};
  }
  OctreeNode octree;
  octree.resolution = *query.resolution;
  const std::span<const uint8_t> bytes = input.file.bytes();
  const auto counts = codec::octree_level_counts(bytes, octree_levels(octree.resolution), limits);
  if (!counts.ok()) return counts.error();
  octree.fields.octree.assign(bytes.begin(), bytes.end());
  return octree;
}

}  // namespace

Kind kind_of_content(std::span<const uint8_t> bytes) {
  if (looks_like_octree_stream(bytes)) return Kind::octree_stream;
  if (begins_with(bytes, "#VRML")) return Kind::scene_text;
  if (begins_with(bytes, "BIFS")) return Kind::raw_bifs;
  if (looks_like_mp4(bytes)) return Kind::mp4;
  if (looks_like_xmt(bytes)) return Kind::scene_xml;
  if (!picture_format_of_content(bytes).empty()) return Kind::picture;
  return Kind::unknown;
}

Input input_of(const std::string& path, MappedFile file, Diagnostics& diagnostics) {
  const Kind ending = kind_of_ending(path);
  const Kind content =
      ending == Kind::raw_octree ? Kind::raw_octree : kind_of_content(file.bytes());
  if (content != Kind::unknown && ending != Kind::unknown && content != ending) {
    diagnostics.warn("wrong_ending", Place::none(),
                     std::string("is ") + describe(content) + ", whatever its ending says");
  }
  return {path, content == Kind::unknown ? ending : content, std::move(file)};
}

std::string Input::folder() const {
  return path == "-" ? std::string() : std::filesystem::path(path).parent_path().string();
}

Error in_file(Error error, const std::string& file) {
  if (error.file.empty()) error.file = file;
  return error;
}

Result<Input> open_input(const std::string& path, const std::string& input_format,
                         const Limits& limits, Diagnostics& diagnostics) {
  auto input = open_any(path, input_format, limits, diagnostics);
  if (!input.ok() || input.value().kind != Kind::unknown) return input;
  return Error{Errc::malformed,
               Place::none(),
               "neither content nor ending tells what this is (expected .wrl, .bt, .xmt, .mp4, "
               ".bifs, .afx, .oct, a picture, or --input-format)",
               {},
               path};
}

Result<Input> open_model_input(const std::string& path, const std::string& input_format,
                               const Limits& limits, Diagnostics& diagnostics) {
  if (path == "-") return open_input(path, input_format, limits, diagnostics);
  auto input = open_any(path, input_format, limits, diagnostics);
  if (input.ok() && input.value().kind == Kind::unknown) input.value().kind = Kind::model;
  return input;
}

std::string useless_option(const OctreeQuery& query, std::span<const Kind> inputs) {
  const auto none = [&](Kind kind) {
    return std::find(inputs.begin(), inputs.end(), kind) == inputs.end();
  };
  const std::string found = std::string(", but ") +
                            (inputs.size() == 1 ? "the input is " : "none is; the first is ") +
                            describe(inputs.empty() ? Kind::unknown : inputs.front());
  if (query.resolution && none(Kind::raw_octree))
    return "--resolution is for raw octrees (.oct)" + found;
  const bool scene = std::any_of(inputs.begin(), inputs.end(), is_scene);
  if (!query.node.empty() && !scene) return "--node is for scenes" + found;
  if (query.frame && none(Kind::octree_stream))
    return "--frame is for OctreeImage streams (.afx)" + found;
  return {};
}

Result<nodes::NodeView> pick_octree_image(const nodes::Scene& scene, OctreeQuery& query) {
  const std::vector<nodes::NodeView> images = find_octree_images(scene);
  std::string list;
  for (const nodes::NodeView& view : images) {
    if (!query.node.empty() && view.node().name == query.node) return view;
    list += (list.empty() ? "" : ", ") + view.label();
  }
  if (!query.node.empty()) {
    query.missing_is_usage = true;
    return Error{Errc::bad_argument, Place::none(),
                 "there is no OctreeImage named " + query.node +
                     (list.empty() ? "" : " (there are " + list + ")")};
  }
  if (images.size() == 1) return images.front();
  if (images.empty())
    return Error{Errc::malformed, Place::none(), "the scene has no OctreeImage (expected one)"};
  return Error{Errc::malformed, Place::none(),
               "the scene has " + std::to_string(images.size()) + " OctreeImages: " + list +
                   " (expected --node NAME)"};
}

Result<OctreeNode> read_octree(const Input& input, OctreeQuery& query, const Limits& limits,
                               Diagnostics& diagnostics) {
  const auto read = [&]() -> Result<OctreeNode> {
    if (input.kind == Kind::octree_stream) return read_stream(input, query, limits, diagnostics);
    if (input.kind == Kind::raw_octree) return read_raw(input, query, limits);
    if (!is_scene(input.kind)) {
      return Error{Errc::unsupported, Place::none(),
                   std::string("is ") + describe(input.kind) + " (expected a scene, .afx or .oct)"};
    }
    const auto scene = read_scene(input, limits, diagnostics);
    if (!scene.ok()) return scene.error();
    const auto view = pick_octree_image(scene.value().scene, query);
    if (!view.ok()) return view.error();
    return read_octree_node(view.value(), scene.value().base(), limits, diagnostics);
  };
  auto octree = read();
  if (!octree.ok()) return in_file(std::move(octree).error(), input.path);
  return octree;
}

}  // namespace afx::tools
