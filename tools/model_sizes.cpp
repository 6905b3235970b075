// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/model_sizes.h"

#include <set>
#include <vector>

#include "afx/octree_image.h"
#include "tools/scene_input.h"

namespace afx::tools {
namespace {

using Json = nlohmann::ordered_json;

/// Adds to a member that may not be there yet.
void add(Json& sizes, const char* name, uint64_t count) {
  if (count > 0) sizes[name] = sizes.value(name, uint64_t{0}) + count;
}

void add_picture(const nodes::NodeView& texture, const LoadedScene& scene, const Session& session,
                 std::set<std::string>& known, Json& sizes) {
  const auto file =
      open_url(texture.get<std::vector<nodes::Url>>("url"), scene.base(), session.limits);
  if (file.ok() && known.insert(file.value().path).second)
    add(sizes, "pictures", file.value().file.bytes().size());
}

void add_scene(const LoadedScene& scene, const Session& session, Json& sizes) {
  std::set<std::string> known;
  Diagnostics unheard;  // reading the models has said it all
  for (uint32_t i = 0; i < scene.scene.node_count(); ++i) {
    const nodes::NodeView node(scene.scene, nodes::NodeId(i));
    if (scene.scene.node(nodes::NodeId(i)).proto.valid()) continue;
    if (node.type() == "ImageTexture") add_picture(node, scene, session, known, sizes);
    if (node.type() == "PointTexture" || node.type() == "PointTextureV2")
      add(sizes, "points", node.get<std::vector<glm::vec3>>("color").size());
  }
  for (const nodes::NodeView& view : find_octree_images(scene.scene)) {
    const auto octree = read_octree_node(view, scene.base(), session.limits, unheard);
    if (!octree.ok()) continue;
    add(sizes, "octree", octree.value().fields.octree.size());
    add(sizes, "imageIndices", octree.value().fields.voxel_image_index.size());
  }
}

}  // namespace

Json model_sizes(const Input& input, const Session& session) {
  Json sizes{{"file", input.file.bytes().size()}};
  if (!is_scene(input.kind)) return sizes;
  Diagnostics unheard;
  const auto scene = read_scene(input, session.limits, unheard);
  if (scene.ok()) add_scene(scene.value(), session, sizes);
  return sizes;
}

std::string size_text(const Json& sizes) {
  std::string text;
  for (const auto& [name, count] : sizes.items()) {
    const std::string number = grouped(count.get<uint64_t>());
    if (name == "file") {
      text = number + " bytes";
    } else if (name == "points") {
      text += ", " + number + " points";
    } else {
      text += ", " + (name == "imageIndices" ? "image indices" : name) + " " + number;
    }
  }
  return text;
}

}  // namespace afx::tools
