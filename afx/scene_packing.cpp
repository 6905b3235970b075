// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/scene_packing.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <utility>

#include "afx/descriptor_ids.h"
#include "afx/media_import.h"
#include "afx/node_exchange.h"
#include "afx/octree_image.h"
#include "afx/octree_stream.h"
#include "bifs/mp4_builder.h"
#include "codec/parallel.h"

namespace afx {
namespace {

using bifs::Descriptor;
using bifs::EsDescriptor;
using nodes::FieldEntry;
using nodes::NodeId;
using nodes::NodeView;
using nodes::Scene;
using nodes::Url;
using Urls = std::vector<Url>;

constexpr uint16_t kLastObjectDescriptor = 1022;
constexpr uint16_t kSceneEsId = 1;

/// An OctreeImage and its stream.
struct PackedOctree {
  NodeId node;
  uint32_t places = 0;
  std::vector<uint8_t> stream;
  Status status = {};
};

/// A picture file and the fields that name it.
struct PackedPicture {
  std::string name;
  bifs::Media media;
  std::vector<bifs::FieldRef> urls = {};
};

bool shows_pictures(const Scene& scene, NodeId id) {
  if (scene.node(id).proto.valid()) return false;
  const std::string& type = scene.type_name(id);
  return type == "ImageTexture" || type == "MovieTexture" || type == "Background" ||
         type == "Background2D";
}

class ScenePacker {
 public:
  ScenePacker(bifs::Presentation& presentation, std::string folder, const PackOptions& options,
              MediaStore& store, Diagnostics& diagnostics)
      : presentation_(presentation),
        scene_(presentation.scene),
        folder_(std::move(folder)),
        options_(options),
        store_(store),
        diagnostics_(diagnostics) {}

  Status run() {
    replacement_ = plain_scene();
    if (replacement_ == nullptr) {
      return Error{Errc::bad_argument, Place::none(),
                   "the presentation is no plain scene (expected one access unit with a scene "
                   "replacement and no object descriptors)"};
    }
    standing_ = standing_nodes(scene_, replacement_->root);
    if (options_.octrees != PackOptions::Octrees::none) find_octrees();
    if (options_.pictures) find_pictures();
    encode_octrees();
    Status fits = count_streams();
    if (!fits.ok()) return fits;
    refer_to_pictures();  // first: no octree gets the name of a picture
    wrap_octrees();
    if (!objects_.empty()) add_object_descriptors();
    return {};
  }

 private:
  bifs::SceneReplacement* plain_scene();
  void find_octrees();
  void encode_octrees();
  void find_pictures();
  void find_picture(NodeId id, const FieldEntry& entry);
  std::optional<size_t> picture_of(const UrlFile& file, const std::string& label);
  Status count_streams();
  void wrap_octrees();
  NodeId wrap(PackedOctree& octree, uint32_t& last_id);
  void name_wrapper(NodeId wrapper, NodeId octree, uint32_t& last_id);
  uint16_t store_octree(std::vector<uint8_t> stream);
  void refer_to_pictures();
  void add_object(uint16_t id, const bifs::Media& media, const std::string& name);
  void add_object_descriptors();
  EsDescriptor& scene_es();

  bifs::Presentation& presentation_;
  Scene& scene_;
  std::string folder_;
  const PackOptions& options_;
  MediaStore& store_;
  Diagnostics& diagnostics_;
  bifs::SceneReplacement* replacement_ = nullptr;
  std::vector<bool> standing_;
  std::vector<PackedOctree> octrees_;
  std::vector<PackedPicture> pictures_;
  std::map<std::string, std::optional<size_t>> picture_places_;  // by the file's true path
  FreeIds descriptor_ids_;
  FreeIds es_ids_;
  bifs::Descriptors objects_;
};

bifs::SceneReplacement* ScenePacker::plain_scene() {
  if (presentation_.units.size() != 1 ||
      bifs::object_descriptor_stream(presentation_.initial) != nullptr)
    return nullptr;
  auto* commands = std::get_if<std::vector<bifs::Command>>(&presentation_.units[0].commands);
  if (commands == nullptr || commands->size() != 1) return nullptr;
  return std::get_if<bifs::SceneReplacement>(&commands->front());
}

/// The nodes that BitWrappers hold.
std::set<NodeId> wrapped_nodes(const Scene& scene) {
  std::set<NodeId> wrapped;
  for (uint32_t i = 0; i < scene.node_count(); ++i) {
    if (!scene.node(NodeId(i)).proto.valid() && scene.type_name(NodeId(i)) == "BitWrapper")
      wrapped.insert(scene.get<NodeId>(NodeId(i), "node"));
  }
  return wrapped;
}

bool has_octree(const Scene& scene, NodeId id) {
  if (scene.node(id).proto.valid() || scene.type_name(id) != "OctreeImage") return false;
  return !scene.get<std::vector<int32_t>>(id, "octree").empty() ||
         !scene.get<std::vector<int32_t>>(id, "voxelImageIndex").empty();
}

void ScenePacker::find_octrees() {
  std::vector<uint32_t> places = count_places(scene_);
  if (replacement_->root.valid()) ++places[replacement_->root.value];
  const std::set<NodeId> wrapped = wrapped_nodes(scene_);
  size_t in_protos = 0;
  for (uint32_t i = 0; i < scene_.node_count(); ++i) {
    const NodeId id(i);
    if (!standing_[i] || !has_octree(scene_, id) || wrapped.count(id) != 0) continue;
    if (scene_.node(id).scope == Scene::kMain) {
      octrees_.push_back({id, places[i], {}});
    } else {
      ++in_protos;
    }
  }
  if (in_protos > 0) {
    diagnostics_.warn(
        "octree_in_proto", Place::none(),
        std::to_string(in_protos) +
            " OctreeImages in bodies of PROTOs are not coded as AFX; they stay fields");
  }
}

Result<std::vector<uint8_t>> encode_node(const NodeView& node, const Limits& limits) {
  Diagnostics none;  // there is nothing to warn of in a node that is not wrapped
  auto octree = read_octree_node(node, std::string(), limits, none);
  if (!octree.ok()) return std::move(octree).error();
  OctreeStream stream;
  stream.resolution = octree.value().resolution;
  const bool textured = !octree.value().fields.voxel_image_index.empty();
  stream.textures = textured ? octree.value().images : 0;
  stream.frames.push_back(std::move(octree.value().fields));
  return encode_octree_stream(stream);
}

void ScenePacker::encode_octrees() {
  parallel_for(octrees_.size(), options_.threads, [&](size_t i) {
    auto stream = encode_node(NodeView(scene_, octrees_[i].node), options_.limits);
    if (stream.ok()) {
      octrees_[i].stream = std::move(stream).value();
    } else {
      octrees_[i].status = std::move(stream).error();
    }
  });
  for (const PackedOctree& octree : octrees_) {
    if (octree.status.ok()) continue;
    diagnostics_.warn("octree_not_packed", Place::none(),
                      NodeView(scene_, octree.node).label() +
                          " stays as it is: " + to_string(octree.status.error()));
  }
  std::erase_if(octrees_, [](const PackedOctree& octree) { return !octree.status.ok(); });
}

void ScenePacker::find_pictures() {
  for (uint32_t i = 0; i < scene_.node_count(); ++i) {
    if (!standing_[i] || !shows_pictures(scene_, NodeId(i))) continue;
    for (const FieldEntry& entry : scene_.node(NodeId(i)).values) find_picture(NodeId(i), entry);
  }
}

void ScenePacker::find_picture(NodeId id, const FieldEntry& entry) {
  const auto* urls = std::get_if<Urls>(&entry.value);
  if (urls == nullptr || urls->empty() || urls->front().is_descriptor()) return;
  const std::string label = NodeView(scene_, id).label();
  const auto file = open_url(*urls, folder_, options_.limits);
  if (!file.ok()) {
    diagnostics_.warn("missing_picture", Place::none(), label + ": " + to_string(file.error()));
  } else if (const auto place = picture_of(file.value(), label)) {
    pictures_[*place].urls.push_back({id, entry.field});
  }
}

/// The place of a file in pictures_; none where it cannot be a stream.
std::optional<size_t> ScenePacker::picture_of(const UrlFile& file, const std::string& label) {
  std::error_code failure;
  const auto true_path = std::filesystem::canonical(file.path, failure);
  const auto [known, is_new] =
      picture_places_.emplace(failure ? file.path : true_path.string(), std::nullopt);
  if (!is_new) return known->second;
  auto media = import_media({file.name, {}}, folder_, options_.limits, diagnostics_);
  if (!media.ok() || !still_picture_type(media.value())) {
    const std::string why =
        media.ok() ? file.path + " is no still picture" : to_string(media.error());
    diagnostics_.warn("picture_not_packed", Place::none(), label + " keeps its file: " + why);
    return std::nullopt;
  }
  known->second = pictures_.size();
  pictures_.push_back({file.name, std::move(media).value()});
  return known->second;
}

Status ScenePacker::count_streams() {
  std::set<uint16_t> used = used_descriptors(scene_);
  used.insert(presentation_.initial.id);
  descriptor_ids_ = FreeIds(std::move(used));
  const size_t streams =
      pictures_.size() + (options_.octrees == PackOptions::Octrees::stream ? octrees_.size() : 0);
  if (const size_t left = descriptor_ids_.free_up_to(kLastObjectDescriptor); streams > left) {
    return Error{Errc::bad_argument, Place::none(),
                 "the scene needs " + std::to_string(streams) +
                     " streams for its pictures and octrees (there are IDs for " +
                     std::to_string(left) + " object descriptors)"};
  }
  if (streams == 0) return {};
  const uint16_t of_scene = scene_es().es_id;
  es_ids_ = FreeIds(std::set<uint16_t>{of_scene});
  return {};
}

/// The EsDescriptor of the scene, which is added if it is not there.
EsDescriptor& ScenePacker::scene_es() {
  bifs::Descriptors& parts = presentation_.initial.parts;
  const EsDescriptor* there = bifs::scene_stream(presentation_.initial);
  for (Descriptor& part : parts) {
    auto* es = std::get_if<EsDescriptor>(&part.body);
    if (es != nullptr && es == there) return *es;
  }
  bifs::DecoderConfig config;
  config.stream_type = bifs::stream_type::kScene;
  auto& es = parts.emplace_back().body.emplace<EsDescriptor>(
      bifs::es_descriptor_in_file(std::move(config), {}));
  es.es_id = kSceneEsId;
  return es;
}

void ScenePacker::wrap_octrees() {
  uint32_t last_id = 0;
  for (uint32_t i = 0; i < scene_.node_count(); ++i)
    last_id = std::max(last_id, scene_.node(NodeId(i)).id);
  NodeExchange exchange;
  for (PackedOctree& octree : octrees_) exchange.emplace(octree.node, wrap(octree, last_id));
  exchange_nodes(scene_, exchange);
  replacement_->root = exchanged(exchange, replacement_->root);
  for (const auto& [octree, wrapper] : exchange) {  // now that the exchange is done
    const Status set = scene_.set(wrapper, "node", octree);
    assert(set.ok());
    static_cast<void>(set);
  }
}

/// Makes the BitWrapper, still empty, and takes the coded fields from the OctreeImage.
NodeId ScenePacker::wrap(PackedOctree& octree, uint32_t& last_id) {
  const NodeId wrapper = scene_.add("BitWrapper").value();
  if (octree.places > 1) name_wrapper(wrapper, octree.node, last_id);
  Status set;
  if (options_.octrees == PackOptions::Octrees::buffer) {
    set = scene_.set(wrapper, "buffer", std::string(octree.stream.begin(), octree.stream.end()));
  } else {
    set = scene_.set(wrapper, "url", Urls{{{}, store_octree(std::move(octree.stream))}});
  }
  assert(set.ok());
  const nodes::NodeDefinition& definition = *scene_.node(octree.node).definition;
  std::erase_if(scene_.node(octree.node).values, [&](const FieldEntry& entry) {
    return definition.field(entry.field).name != "images";
  });
  return wrapper;
}

void ScenePacker::name_wrapper(NodeId wrapper, NodeId octree, uint32_t& last_id) {
  if (scene_.node(octree).id != 0) scene_.node(wrapper).id = ++last_id;
  if (scene_.node(octree).name.empty()) return;
  const std::string base = scene_.node(octree).name + "_BitWrapper";
  std::string name = base;
  for (uint32_t n = 2; !scene_.set_name(wrapper, name).ok(); ++n) name = base + std::to_string(n);
}

uint16_t ScenePacker::store_octree(std::vector<uint8_t> stream) {
  // The stream is no larger than memory was: it is no sample of 4 GB.
  bifs::Media media = one_sample_media(bifs::make_afx_track(0, {kOctreeImageCode}),
                                       MappedFile::in_memory(std::move(stream)), options_.limits)
                          .value();
  const uint16_t id = descriptor_ids_.next();
  std::string name = "octree_od" + std::to_string(id) + ".afx";
  while (store_.find(name) != nullptr) name.insert(0, 1, '_');
  add_object(id, media, name);
  store_.put(name, std::move(media));
  return id;
}

void ScenePacker::refer_to_pictures() {
  for (PackedPicture& picture : pictures_) {
    const Url url{{}, descriptor_ids_.next()};
    add_object(static_cast<uint16_t>(url.object_descriptor), picture.media, picture.name);
    for (const bifs::FieldRef& ref : picture.urls) {
      Urls urls = *std::get_if<Urls>(&scene_.value(ref.node, ref.field));
      urls.insert(urls.begin(), url);
      scene_.set_unchecked(ref.node, ref.field, std::move(urls));
    }
    store_.put(picture.name, std::move(picture.media));
  }
}

/// Adds the descriptor of an object with one stream.
void ScenePacker::add_object(uint16_t id, const bifs::Media& media, const std::string& name) {
  const EsDescriptor* in_file = bifs::es_of(media.track.entries.front());
  assert(in_file != nullptr);
  bifs::ObjectDescriptor object;
  object.in_file = false;
  object.id = id;
  auto& es = object.parts.emplace_back().body.emplace<EsDescriptor>(*in_file);
  es.source = bifs::MediaSource{name, {}};
  objects_.emplace_back().body.emplace<bifs::ObjectDescriptor>(std::move(object));
}

/// The stream of object descriptors, and its access unit before that of the scene.
void ScenePacker::add_object_descriptors() {
  bifs::DecoderConfig config;
  config.object_type = bifs::object_type::kObjectDescriptor;
  config.stream_type = bifs::stream_type::kObjectDescriptor;
  auto& es = presentation_.initial.parts.emplace_back().body.emplace<EsDescriptor>(
      bifs::es_descriptor_in_file(std::move(config), {}));
  es.es_id = es_ids_.next();
  for (Descriptor& object : objects_) {
    auto& parts = std::get_if<bifs::ObjectDescriptor>(&object.body)->parts;
    std::get_if<EsDescriptor>(&parts.front().body)->es_id = es_ids_.next();
  }
  bifs::AccessUnit unit;
  unit.time = presentation_.units.front().time;
  auto& commands = unit.commands.emplace<bifs::OdCommands>();
  commands.emplace_back().body.emplace<bifs::OdUpdate>().objects = std::move(objects_);
  presentation_.units.insert(presentation_.units.begin(), std::move(unit));
  replacement_ = nullptr;  // it has moved
}

}  // namespace

Status pack_scene(bifs::Presentation& presentation, const std::string& folder,
                  const PackOptions& options, MediaStore& store, Diagnostics& diagnostics) {
  return ScenePacker(presentation, folder, options, store, diagnostics).run();
}

}  // namespace afx
