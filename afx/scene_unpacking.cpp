// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <algorithm>
#include <filesystem>
#include <map>
#include <utility>

#include "afx/media_import.h"
#include "afx/node_exchange.h"
#include "afx/octree_image.h"
#include "afx/scene_packing.h"

namespace afx {
namespace {

using nodes::NodeId;
using nodes::NodeView;
using nodes::Scene;
using nodes::Url;
using Urls = std::vector<Url>;

bool is_bit_wrapper(const Scene& scene, NodeId id) {
  return !scene.node(id).proto.valid() && scene.type_name(id) == "BitWrapper";
}

/// What a symbol of an octree takes: a byte while it is decoded, and a value of the field.
constexpr uint64_t kBytesHeld = 1 + sizeof(int32_t);

/// Puts the fields of OctreeImages back.
class OctreeUnpacker {
 public:
  OctreeUnpacker(Scene& scene, const ObjectStreams& streams, const Limits& limits,
                 Diagnostics& diagnostics)
      : scene_(scene),
        streams_(streams),
        limits_(limits),
        diagnostics_(diagnostics),
        memory_left_(limits.memory) {}

  Status run() {
    find_fixed_nodes();
    const std::vector<bool> standing = standing_nodes(scene_);
    for (uint32_t i = 0; i < scene_.node_count(); ++i) {
      if (!standing[i] || !is_bit_wrapper(scene_, NodeId(i))) continue;
      if (const std::string why = why_left(NodeId(i)); !why.empty()) {
        diagnostics_.warn("bitwrapper_left", Place::none(),
                          NodeView(scene_, NodeId(i)).label() + " " + why + "; it stays as it is");
        continue;
      }
      Status unpacked = unpack(NodeId(i));
      if (!unpacked.ok()) return unpacked;
    }
    exchange_nodes(scene_, exchange_);
    return {};
  }

 private:
  void find_fixed_nodes();
  [[nodiscard]] std::string why_left(NodeId wrapper) const;
  [[nodiscard]] std::string why_not_stream(const Urls& urls) const;
  Status unpack(NodeId wrapper);
  void hand_name_on(NodeId wrapper, NodeId octree);

  Scene& scene_;
  const ObjectStreams& streams_;
  const Limits& limits_;
  Diagnostics& diagnostics_;
  uint64_t memory_left_;    ///< for all that is put back
  std::set<NodeId> fixed_;  ///< named by a ROUTE, or standing in the interface of a PROTO
  NodeExchange exchange_;
};

void OctreeUnpacker::find_fixed_nodes() {
  for (uint32_t i = 0; i < scene_.scope_count(); ++i) {
    for (const nodes::Route& route : scene_.scope(nodes::ScopeId(i)).routes)
      fixed_.insert({route.from, route.to});
  }
  for (uint32_t i = 0; i < scene_.proto_count(); ++i) {
    for (const auto& field : scene_.proto(nodes::ProtoId(i)).interface.fields())
      for_each_node(field.default_value, [&](NodeId node) { fixed_.insert(node); });
  }
}

/// Why a BitWrapper is not for here; empty if it is, or is an error.
std::string OctreeUnpacker::why_left(NodeId wrapper) const {
  const NodeId node = scene_.get<NodeId>(wrapper, "node");
  if (!node.valid()) return "holds no node";
  if (scene_.node(node).proto.valid() || scene_.type_name(node) != "OctreeImage")
    return "holds a node of type " + scene_.type_name(node) + ", whose coding is not known here";
  if (fixed_.count(wrapper) != 0) return "is named by a ROUTE or an interface";
  if (!scene_.node(wrapper).links.empty() || !scene_.node(node).links.empty())
    return "has fields that are connected by IS";
  if (const int32_t type = scene_.get<int32_t>(wrapper, "type"); type != 0)
    return "has the coding type " + std::to_string(type) + ", which is not known here";
  const auto& urls = scene_.get<Urls>(wrapper, "url");
  const bool in_band = !scene_.get<std::string>(wrapper, "buffer").empty();
  return in_band || urls.empty() ? std::string() : why_not_stream(urls);
}

std::string OctreeUnpacker::why_not_stream(const Urls& urls) const {
  for (const Url& url : urls) {
    if (!url.is_descriptor()) return "names the file \"" + url.text + '"';
    const auto found = streams_.find(static_cast<uint16_t>(url.object_descriptor));
    if (found == streams_.end()) continue;
    if (afx_object_code(found->second) == kOctreeImageCode) return {};
    return "names od:" + std::to_string(url.object_descriptor) + ", no OctreeImage stream";
  }
  return "names no stream that is there";
}

Status OctreeUnpacker::unpack(NodeId wrapper) {
  // Names of files do not come here: why_left.
  const UrlBase base({}, &streams_);
  Limits limits = limits_;
  limits.memory = memory_left_ / kBytesHeld;
  auto read = read_octree_node(NodeView(scene_, wrapper), base, limits, diagnostics_);
  if (!read.ok()) return std::move(read).error();
  const NodeId octree = scene_.get<NodeId>(wrapper, "node");
  const OctreeFields& fields = read.value().fields;
  const auto set = [&](const char* field, nodes::FieldValue value) {
    const Status status = scene_.set(octree, field, std::move(value));
    assert(status.ok());
    static_cast<void>(status);
  };
  set("octreeResolution", static_cast<int32_t>(read.value().resolution));
  set("octree", std::vector<int32_t>(fields.octree.begin(), fields.octree.end()));
  set("voxelImageIndex",
      std::vector<int32_t>(fields.voxel_image_index.begin(), fields.voxel_image_index.end()));
  const uint64_t held = kBytesHeld * (fields.octree.size() + fields.voxel_image_index.size());
  memory_left_ -= std::min(memory_left_, held);
  hand_name_on(wrapper, octree);
  scene_.node(wrapper).values.clear();
  exchange_.emplace(wrapper, octree);
  return {};
}

/// A name or an ID of its own stays with the OctreeImage.
void OctreeUnpacker::hand_name_on(NodeId wrapper, NodeId octree) {
  const std::string name = scene_.node(wrapper).name;
  static_cast<void>(scene_.set_name(wrapper, {}));
  if (scene_.node(octree).name.empty()) static_cast<void>(scene_.set_name(octree, name));
  const uint32_t id = std::exchange(scene_.node(wrapper).id, 0);
  if (scene_.node(octree).id == 0) scene_.node(octree).id = id;
}

std::string ending_of(uint8_t object_type) {
  if (object_type == bifs::object_type::kPng) return ".png";
  return object_type == bifs::object_type::kJpeg ? ".jpg" : ".jp2";
}

/// The same for all names of a file: "./a.png" is "a.png".
std::string normal(const std::string& name) {
  return std::filesystem::path(name).lexically_normal().string();
}

/// Gives names to the pictures of streams, and takes these as files.
class PictureUnpacker {
 public:
  PictureUnpacker(Scene& scene, const ObjectStreams& streams, const UnpackOptions& options,
                  Diagnostics& diagnostics)
      : scene_(scene),
        streams_(streams),
        options_(options),
        diagnostics_(diagnostics),
        memory_left_(options.limits.memory) {}

  Result<std::vector<NamedFile>> run() {
    const std::vector<bool> standing = standing_nodes(scene_);
    for (uint32_t i = 0; i < scene_.node_count(); ++i) {
      if (!standing[i] || is_bit_wrapper(scene_, NodeId(i))) continue;
      for (nodes::FieldEntry& entry : scene_.node(NodeId(i)).values) {
        auto* urls = std::get_if<Urls>(&entry.value);
        Status status = urls != nullptr ? unpack(*urls) : Status{};
        if (!status.ok()) return std::move(status).error();
      }
    }
    if (left_ > 0) {
      diagnostics_.warn("url_left", Place::none(),
                        std::to_string(left_) +
                            " urls name object descriptors that are no still pictures; they stay");
    }
    return std::move(files_);
  }

 private:
  Status unpack(Urls& urls);
  std::string name_behind(const Urls& urls, size_t place, uint16_t id);
  std::string made_name(uint16_t id, uint8_t object_type);
  Status take(uint16_t id, const bifs::Media& media, const std::string& name);
  [[nodiscard]] bool is_free(const std::string& name, uint16_t id) const {
    const auto owner = owners_.find(normal(name));
    return options_.taken.count(normal(name)) == 0 &&
           (owner == owners_.end() || owner->second == id);
  }

  Scene& scene_;
  const ObjectStreams& streams_;
  const UnpackOptions& options_;
  Diagnostics& diagnostics_;
  uint64_t memory_left_;
  uint64_t left_ = 0;                       ///< object descriptors that stay
  std::map<std::string, uint16_t> owners_;  ///< of normal names
  std::vector<NamedFile> files_;
};

Status PictureUnpacker::unpack(Urls& urls) {
  for (size_t i = 0; i < urls.size(); ++i) {
    if (!urls[i].is_descriptor()) continue;
    const auto id = static_cast<uint16_t>(urls[i].object_descriptor);
    const auto stream = streams_.find(id);
    const auto type = stream != streams_.end() ? still_picture_type(stream->second) : std::nullopt;
    if (!type || stream->second.track.samples.empty()) {
      ++left_;
      continue;
    }
    std::string name = name_behind(urls, i, id);
    const bool has_name = !name.empty();
    if (!has_name) name = made_name(id, *type);
    Status taken = take(id, stream->second, name);
    if (!taken.ok()) return taken;
    urls[i] = Url{name};
    if (has_name) urls.erase(urls.begin() + static_cast<ptrdiff_t>(i--));
  }
  return {};
}

/// The first name up to the next object descriptor that can be used; empty if there is none.
std::string PictureUnpacker::name_behind(const Urls& urls, size_t place, uint16_t id) {
  std::string refused;
  bool was_taken = false;
  for (size_t i = place + 1; i < urls.size() && !urls[i].is_descriptor(); ++i) {
    std::string name = file_name_of_url(urls[i].text);
    const bool plain = is_plain_picture_name(name);
    if (plain && is_free(name, id)) return name;
    if (refused.empty()) {
      refused = std::move(name);
      was_taken = plain;
    }
  }
  if (!refused.empty()) {
    diagnostics_.warn(was_taken ? "name_taken" : "unsafe_name", Place::none(),
                      "the picture of od:" + std::to_string(id) +
                          (was_taken ? " would have the name of another file: \""
                                     : " has a name that is not used: \"") +
                          refused + '"');
  }
  return {};
}

std::string PictureUnpacker::made_name(uint16_t id, uint8_t object_type) {
  const std::string base = options_.stem + "_od" + std::to_string(id);
  std::string name = base + ending_of(object_type);
  for (uint32_t n = 2; !is_free(name, id); ++n)
    name = base + "_" + std::to_string(n) + ending_of(object_type);
  return name;
}

/// Adds a picture to the files, once for each name that it has.
Status PictureUnpacker::take(uint16_t id, const bifs::Media& media, const std::string& name) {
  if (!owners_.emplace(normal(name), id).second) return {};
  const std::string od = "od:" + std::to_string(id);
  if (media.track.samples.front().size > memory_left_)
    return Error{Errc::limit_exceeded, Place::none(), "the pictures are beyond the limit", {}, od};
  auto bytes = media.bytes(0);
  if (!bytes.ok()) {
    if (bytes.error().file.empty()) bytes.error().file = od;
    return std::move(bytes).error();
  }
  if (media.track.samples.size() > 1) {
    diagnostics_.warn("frames_left_out", Place::none(),
                      od + " has " + std::to_string(media.track.samples.size()) +
                          " pictures, of which the first is taken");
  }
  memory_left_ -= std::min<uint64_t>(memory_left_, bytes.value().size());
  files_.push_back({name, std::move(bytes).value()});
  return {};
}

std::string lower_case(std::string text) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
  return text;
}

}  // namespace

bool is_plain_picture_name(const std::string& name) {
  if (name.empty() || name.size() > 1000 || name.front() == '/') return false;
  const bool legal = std::all_of(name.begin(), name.end(), [](char c) {
    return static_cast<unsigned char>(c) >= 0x20 && c != 0x7F && c != '\\' && c != ':';
  });
  for (size_t part = 0; part < name.size(); part = name.find('/', part) + 1) {
    if (name[part] == '.' && name.compare(part, 2, "./") != 0) return false;
    if (name.find('/', part) == std::string::npos) break;
  }
  const std::string lower = lower_case(name);
  for (const char* ending : {".png", ".jpg", ".jpeg", ".jpe", ".jfif", ".jp2", ".j2k", ".jpx"})
    if (lower.ends_with(ending)) return legal;
  return false;
}

Result<std::vector<NamedFile>> unpack_scene(Scene& scene, const ObjectStreams& streams,
                                            const UnpackOptions& options,
                                            Diagnostics& diagnostics) {
  const Status octrees = OctreeUnpacker(scene, streams, options.limits, diagnostics).run();
  if (!octrees.ok()) return octrees.error();
  return PictureUnpacker(scene, streams, options, diagnostics).run();
}

}  // namespace afx
