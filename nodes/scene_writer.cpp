// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "nodes/scene_writer.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "nodes/node_text_writer.h"
#include "nodes/text_cursor.h"
#include "nodes/value_writer.h"

namespace afx::nodes {

namespace {

/// The names of a scene that is there as a whole.
class SceneNames final : public NodeNaming {
 public:
  explicit SceneNames(const Scene& scene)
      : scene_(scene), names_(scene.node_count()), written_(scene.node_count()) {
    choose_names();
  }

  bool stands_here(NodeId id) override { return std::exchange(written_[id.value], 1) == 0; }
  std::string_view name(NodeId id) override { return names_[id.value]; }
  std::string route_name(const Route& route) override {
    return is_identifier(route.name) ? route.name : std::string();
  }
  bool can_write(const Route& route) override {
    return is_written(route.from) && is_written(route.to);
  }

 private:
  [[nodiscard]] bool is_written(NodeId id) const { return id.valid() && written_[id.value] != 0; }

  // Every node gets the name it has; where it has none but stands in several places, or the name is
  // no word or not its own, a made one.
  void choose_names() {
    std::vector<uint32_t> uses(scene_.node_count());
    const auto count = [&](NodeId id) {
      uses[id.value] += id.valid() && uses[id.value] < 2 ? 1 : 0;
    };
    for (size_t s = 0; s < scene_.scope_count(); ++s)
      for (const NodeId root : scene_.scope(ScopeId{s}).roots)
        if (root.valid()) count(root);
    for (size_t n = 0; n < scene_.node_count(); ++n)
      for (const FieldEntry& entry : scene_.node(NodeId{n}).values) each_node(entry.value, count);
    for (size_t p = 0; p < scene_.proto_count(); ++p)
      for (const FieldDefinition& field : scene_.proto(ProtoId{p}).interface.fields())
        each_node(field.default_value, count);
    for (size_t s = 0; s < scene_.scope_count(); ++s)
      for (const Route& route : scene_.scope(ScopeId{s}).routes)
        for (const NodeId end : {route.from, route.to})
          if (end.valid()) uses[end.value] = 2;
    std::vector<std::set<std::string>> taken(scene_.scope_count());
    for (const bool made : {false, true})
      for (size_t n = 0; n < scene_.node_count(); ++n) choose_name(NodeId{n}, made, uses[n], taken);
  }

  void choose_name(NodeId id, bool make, uint32_t uses, std::vector<std::set<std::string>>& taken) {
    const Node& node = scene_.node(id);
    std::set<std::string>& names = taken[node.scope.value];
    std::string& name = names_[id.value];
    if (!make && is_identifier(node.name) && names.insert(node.name).second) name = node.name;
    if (!make || !name.empty() || (node.name.empty() && uses < 2)) return;
    do name = "_N" + std::to_string(++made_names_);
    while (!names.insert(name).second);
  }

  template <class Count>
  static void each_node(const FieldValue& value, const Count& count) {
    if (const auto* one = std::get_if<NodeId>(&value)) {
      if (one->valid()) count(*one);
    } else if (const auto* many = std::get_if<std::vector<NodeId>>(&value)) {
      for (const NodeId id : *many)
        if (id.valid()) count(id);
    }
  }

  const Scene& scene_;
  std::vector<std::string> names_;  ///< by node number; empty = none needed
  std::vector<uint8_t> written_;    ///< by node number
  uint64_t made_names_ = 0;
};

}  // namespace

Status write_scene_text_to(const TextSink& sink, const Scene& scene,
                           const SceneWriteOptions& options) {
  TextOut out(sink);
  SceneNames names(scene);
  NodeTextWriter writer(out, names);
  if (options.vrml_header) out.text() = "#VRML V2.0 utf8\n";
  writer.set_scene(scene);
  writer.write_scope(Scene::kMain);
  if (!out.at_line_begin()) out.text() += '\n';
  return out.finish();
}

std::string write_scene_text(const Scene& scene, const SceneWriteOptions& options) {
  std::string text;
  const TextSink keep = [&text](std::string_view piece) -> Status {
    text += piece;
    return {};
  };
  (void)write_scene_text_to(keep, scene, options);  // keeping does not fail
  return text;
}

std::string value_text(const FieldValue& value) {
  std::string out;
  append_value(out, value);
  return out;
}

}  // namespace afx::nodes
