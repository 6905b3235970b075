// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/octree_image.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "afx/known_nodes.h"
#include "afx/media_import.h"
#include "afx/node_error.h"
#include "afx/node_rotation.h"
#include "afx/octree_stream.h"
#include "afx/texture_nodes.h"
#include "nodes/traversal.h"

namespace afx {
namespace {

using nodes::NodeId;
using nodes::NodeView;
using nodes::Url;

constexpr size_t kMaxImages = 255;

/// The OctreeImage itself, where the node is a BitWrapper.
NodeView octree_of(const NodeView& node) {
  return node.type() == "BitWrapper" ? node.child("node") : node;
}

bool shows_octree(const NodeView& node) { return octree_of(node).type() == "OctreeImage"; }

Result<std::vector<uint8_t>> byte_field(const NodeView& node, const char* field) {
  const auto& values = node.get<std::vector<int32_t>>(field);
  std::vector<uint8_t> bytes(values.size());
  for (size_t i = 0; i < values.size(); ++i) {
    if (values[i] < 0 || values[i] > 255) {
      return bad_node(node, std::string("field ") + field + " has " + std::to_string(values[i]) +
                                " at position " + std::to_string(i) + " (expected 0..255)");
    }
    bytes[i] = static_cast<uint8_t>(values[i]);
  }
  return bytes;
}

Result<OctreeNode> plain_node(const NodeView& node) {
  OctreeNode octree;
  const int32_t resolution = node.get<int32_t>("octreeResolution");
  if (resolution < 1) {
    return bad_node(
        node, "field octreeResolution is " + std::to_string(resolution) + " (expected at least 1)");
  }
  octree.resolution = static_cast<uint32_t>(resolution);
  octree.images = static_cast<uint32_t>(node.get<std::vector<NodeId>>("images").size());
  auto bytes = byte_field(node, "octree");
  if (!bytes.ok()) return std::move(bytes).error();
  octree.fields.octree = std::move(bytes).value();
  auto indices = byte_field(node, "voxelImageIndex");
  if (!indices.ok()) return std::move(indices).error();
  octree.fields.voxel_image_index = std::move(indices).value();
  return octree;
}

/// Decodes the stream of a BitWrapper into `octree`, which holds the fields of its node.
Status decode_into(OctreeNode& octree, std::span<const uint8_t> stream, const NodeView& wrapper,
                   const Limits& limits, Diagnostics& diagnostics) {
  OctreeDecodeOptions options;
  options.limits = limits;
  DecodedOctreeStream decoded = decode_octree_stream(stream, options, diagnostics);
  if (!decoded.status.ok()) return decoded.status;
  if (decoded.stream.textures > octree.images) {
    return bad_node(wrapper, "its stream has numOfTextures " +
                                 std::to_string(decoded.stream.textures) + ", but its node has " +
                                 std::to_string(octree.images) + " images");
  }
  if (const size_t frames = decoded.stream.frames.size(); frames > 1) {
    diagnostics.warn("frames_left_out", Place::none(),
                     wrapper.label() + ": its stream has " + std::to_string(frames) +
                         " frames, of which the first is taken");
  }
  if (!octree.fields.octree.empty() || !octree.fields.voxel_image_index.empty()) {
    diagnostics.warn(
        "bitwrapper_fields", Place::none(),
        wrapper.label() + ": the fields of its node are replaced by those of the stream");
  }
  octree.resolution = decoded.stream.resolution;
  octree.fields = std::move(decoded.stream.frames.front());
  return {};
}

/// Whether a stream that was opened for a BitWrapper is what it can hold.
Status check_stream(const bifs::Media& stream, const NodeView& wrapper, Diagnostics& diagnostics) {
  if (const auto code = afx_object_code(stream); code != kOctreeImageCode) {
    return bad_node(wrapper,
                    code ? "its stream has the AFX object code " + std::to_string(*code) +
                               " (expected 6, OctreeImage)"
                         : "its stream is no AFX stream (expected one of OctreeImage)",
                    Errc::unsupported);
  }
  if (const size_t samples = stream.track.samples.size(); samples > 1) {
    diagnostics.warn("frames_left_out", Place::none(),
                     wrapper.label() + ": its stream has " + std::to_string(samples) +
                         " samples, of which the first is taken");
  }
  return {};
}

Status read_wrapped(OctreeNode& octree, const NodeView& wrapper, const UrlBase& base,
                    const Limits& limits, Diagnostics& diagnostics) {
  const auto& urls = wrapper.get<std::vector<Url>>("url");
  const auto& buffer = wrapper.get<std::string>("buffer");
  if (urls.empty() == buffer.empty()) {
    return bad_node(wrapper, std::string("has ") + (urls.empty() ? "neither" : "both") +
                                 " of url and buffer (expected one)");
  }
  if (const int32_t type = wrapper.get<int32_t>("type"); type != 0) {
    return bad_node(wrapper, "coding type " + std::to_string(type) + " is not known (expected 0)",
                    Errc::unsupported);
  }
  if (!buffer.empty()) {
    const auto* bytes = reinterpret_cast<const uint8_t*>(buffer.data());
    return decode_into(octree, {bytes, buffer.size()}, wrapper, limits, diagnostics);
  }
  const auto stream = open_url(urls, base, limits);
  if (!stream.ok()) return bad_node(wrapper, to_string(stream.error()), stream.error().code);
  if (stream.value().stream != nullptr) {
    const Status right = check_stream(*stream.value().stream, wrapper, diagnostics);
    if (!right.ok()) return right;
  }
  Diagnostics of_stream;
  Status status = decode_into(octree, stream.value().file.bytes(), wrapper, limits, of_stream);
  diagnostics.append(of_stream, stream.value().path);
  if (!status.ok()) status.error().file = stream.value().path;
  return status;
}

Result<ReferenceImage> read_image(const NodeView& node, const UrlBase& base, const Limits& limits,
                                  Diagnostics& diagnostics) {
  ReferenceImage image;
  if (!node.valid()) {
    diagnostics.warn("missing_picture", Place::none(), "an image of an OctreeImage is NULL");
    return image;
  }
  image.position = node.get<glm::vec3>("position");
  image.orientation = quaternion_of<float>(node.get<nodes::Rotation>("orientation"));
  image.field_of_view = node.get<glm::vec2>("fieldOfView");
  if (!node.get<bool>("orthographic")) {
    diagnostics.warn("perspective_image", Place::none(),
                     node.label() + ": orthographic is FALSE, fieldOfView is read as lengths");
  }
  auto picture = load_texture(node.child("diTexture").child("texture"), base, limits);
  if (picture.ok()) {
    image.picture = std::move(picture).value();
  } else if (picture.error().code == Errc::limit_exceeded) {
    return std::move(picture).error();
  } else {
    diagnostics.warn("missing_picture", Place::none(),
                     node.label() + ": " + to_string(picture.error()));
  }
  return image;
}

NodeId add_reference_image(nodes::Scene& scene, const ReferenceImageNode& source) {
  const NodeId image = add_known(scene, "DepthImage");
  set_known(scene, image, "position", source.image.position);
  set_known(scene, image, "orientation", rotation_of(source.image.orientation));
  set_known(scene, image, "fieldOfView", source.image.field_of_view);
  set_known(scene, image, "nearPlane", source.near_plane);
  set_known(scene, image, "farPlane", source.far_plane);
  if (source.picture_url.empty()) return image;
  const NodeId texture = add_known(scene, "ImageTexture");
  set_known(scene, texture, "url", std::vector<Url>{Url::from_text(source.picture_url)});
  const NodeId simple = add_known(scene, "SimpleTexture");
  set_known(scene, simple, "texture", texture);
  set_known(scene, image, "diTexture", simple);
  return image;
}

NodeId add_octree(nodes::Scene& scene, uint32_t resolution, const OctreeFields& fields,
                  std::vector<NodeId> images) {
  const NodeId octree = add_known(scene, "OctreeImage");
  set_known(scene, octree, "octreeResolution", static_cast<int32_t>(resolution));
  set_known(scene, octree, "octree",
            std::vector<int32_t>(fields.octree.begin(), fields.octree.end()));
  set_known(scene, octree, "voxelImageIndex",
            std::vector<int32_t>(fields.voxel_image_index.begin(), fields.voxel_image_index.end()));
  set_known(scene, octree, "images", std::move(images));
  return octree;
}

}  // namespace

std::vector<NodeView> find_octree_images(const nodes::Scene& scene) {
  std::vector<NodeView> found;
  std::vector<bool> known(scene.node_count());  // given already, or held by a BitWrapper
  const auto in_main = [&](NodeId id) { return scene.node(id).scope == nodes::Scene::kMain; };
  for (uint32_t i = 0; i < scene.node_count(); ++i) {
    if (!in_main(NodeId(i)) || scene.type_name(NodeId(i)) != "BitWrapper") continue;
    const NodeView view(scene, NodeId(i));
    if (shows_octree(view)) known[view.child("node").id().value] = true;
  }
  const auto give = [&](const NodeView& view) {
    if (!shows_octree(view) || known[view.id().value]) return;
    known[view.id().value] = true;
    found.push_back(view);
  };
  for (uint32_t i = 0; i < scene.node_count(); ++i) {
    if (in_main(NodeId(i)) && !scene.node(NodeId(i)).proto.valid())
      give(NodeView(scene, NodeId(i)));
  }
  const auto shown = nodes::find_dibr_objects(scene);
  if (!shown.ok()) return found;
  for (const nodes::DibrObject& object : shown.value()) {
    if (object.kind == nodes::DibrObject::Kind::octree_image) give(object.nodes.front());
  }
  return found;
}

Result<OctreeNode> read_octree_node(const NodeView& node, const UrlBase& base, const Limits& limits,
                                    Diagnostics& diagnostics) {
  const NodeView octree_view = octree_of(node);
  if (octree_view.type() != "OctreeImage")
    return bad_node(node, "is not an OctreeImage and holds none");
  auto octree = plain_node(octree_view);
  if (!octree.ok() || node.type() != "BitWrapper") return octree;
  if (Status status = read_wrapped(octree.value(), node, base, limits, diagnostics); !status.ok()) {
    return std::move(status).error();
  }
  return octree;
}

Result<OctreeModel> read_octree_model(const NodeView& node, const UrlBase& base,
                                      const Limits& limits, Diagnostics& diagnostics) {
  auto octree = read_octree_node(node, base, limits, diagnostics);
  if (!octree.ok()) return std::move(octree).error();
  OctreeModel model;
  model.resolution = octree.value().resolution;
  model.fields = std::move(octree.value().fields);
  const std::vector<NodeView> images = octree_of(node).children("images");
  if (images.size() > kMaxImages) {
    return bad_node(node,
                    "has " + std::to_string(images.size()) + " images (expected at most 255)");
  }
  Limits left = limits;  // for the pictures together
  for (const NodeView& view : images) {
    auto image = read_image(view, base, left, diagnostics);
    if (!image.ok()) return std::move(image).error();
    left.memory -= std::min<uint64_t>(left.memory, image.value().picture.samples.size());
    model.images.push_back(std::move(image).value());
  }
  return model;
}

NodeId add_octree_image(nodes::Scene& scene, uint32_t resolution, const OctreeFields& fields,
                        std::span<const ReferenceImageNode> images) {
  std::vector<NodeId> nodes;
  nodes.reserve(images.size());
  for (const ReferenceImageNode& image : images) nodes.push_back(add_reference_image(scene, image));
  return add_octree(scene, resolution, fields, std::move(nodes));
}

NodeId add_octree_image(nodes::Scene& scene, const OctreeNode& octree) {
  std::vector<NodeId> images;
  for (uint32_t i = 0; i < octree.images; ++i) images.push_back(add_known(scene, "DepthImage"));
  return add_octree(scene, octree.resolution, octree.fields, std::move(images));
}

}  // namespace afx
