// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/quantized_values.h"

#include <algorithm>

#include "bifs/coding_quantizer.h"
#include "bifs/node_walk.h"

namespace afx::bifs {

namespace {

using nodes::FieldDefinition;
using nodes::FieldType;
using nodes::FieldValue;
using nodes::NodeDefinition;
using nodes::NodeId;
using nodes::Scene;

bool is_integer(const FieldDefinition& field) {
  return element_type(field.type) == FieldType::sf_int32 &&
         (field.quant_category == kCategoryLinearScalar || field.quant_category == kCategoryIndex);
}

bool has_inner_quantizer(const Scene& scene, NodeId root) {
  const NodeDefinition& definition = *scene.node(root).definition;
  const nodes::FieldIndex children = definition.find("children");
  return children.valid() && scene.node(root).name.empty() &&
         is_free_list(scene, root, definition.field(children));
}

class Finder {
 public:
  explicit Finder(const Presentation& presentation) : presentation_(presentation) {}

  Result<std::vector<SceneValues>> find() {
    for (size_t unit = 0; unit < presentation_.units.size(); ++unit) {
      const auto* commands = std::get_if<std::vector<Command>>(&presentation_.units[unit].commands);
      for (size_t i = 0; commands != nullptr && i < commands->size(); ++i) {
        const Command& command = (*commands)[i];
        const auto* replacement = std::get_if<SceneReplacement>(&command);
        const Status added =
            replacement != nullptr ? add_scene(*replacement, {unit, i}) : add_command(command);
        if (!added.ok()) return added.error();
      }
    }
    std::erase_if(found_,
                  [&](const SceneValues& values) { return !replacement_of(values).root.valid(); });
    return std::move(found_);
  }

 private:
  const SceneReplacement& replacement_of(const SceneValues& values) const {
    const auto& commands =
        std::get<std::vector<Command>>(presentation_.units[values.unit].commands);
    return std::get<SceneReplacement>(commands[values.command]);
  }

  Status add_scene(const SceneReplacement& command, const std::pair<size_t, size_t>& place) {
    known_.clear();
    SceneValues values;
    values.unit = place.first;
    values.command = place.second;
    SceneReplacement protos;  // their bodies come before the root
    protos.protos = command.protos;
    const Result<std::vector<NodeId>> bodies = fresh_nodes(protos);
    if (!bodies.ok()) return bodies.error();
    const Result<std::vector<NodeId>> fresh = fresh_nodes(command);
    if (!fresh.ok()) return fresh.error();
    values.has_inner_quantizer = command.root.valid() && has_inner_quantizer(scene(), command.root);
    for (const NodeId node : fresh.value()) {
      if (node == command.root && values.has_inner_quantizer) continue;
      if (!integer_saving(scene(), node))
        return Error{Errc::bad_argument, {}, misfit(scene().type_name(node))};
      add_fields(node, values.scene);
    }
    found_.push_back(std::move(values));
    return {};
  }

  Status add_command(const Command& command) {
    if (std::holds_alternative<GlobalQuantizer>(command)) return has_quantizers();
    const Result<std::vector<NodeId>> fresh = fresh_nodes(command);
    if (!fresh.ok()) return fresh.error();
    if (found_.empty()) return {};
    for (const NodeId node : fresh.value()) {
      if (!integer_saving(scene(), node) || counts_older_points(node, fresh.value()))
        found_.back().later_misfit = misfit(scene().type_name(node));
      add_fields(node, found_.back().later);
    }
    add_values_of(command);
    return {};
  }

  /// Whether a node has indices and, maybe, coordinates that came before it: commands may have
  /// changed how many there are.
  bool counts_older_points(NodeId id, const std::vector<NodeId>& fresh) const {
    const nodes::Node& node = scene().node(id);
    bool has_indices = false;
    bool has_older = false;
    for (const nodes::FieldEntry& entry : node.values) {
      has_indices |= node.definition->field(entry.field).quant_category == kCategoryIndex;
      const auto* inner = std::get_if<NodeId>(&entry.value);
      has_older |= inner != nullptr && inner->valid() &&
                   !std::binary_search(fresh.begin(), fresh.end(), *inner);
    }
    return has_indices && has_older;
  }

  void add_values_of(const Command& command) {
    if (const auto* c = std::get_if<IndexedValueInsertion>(&command)) add(c->target, c->value);
    if (const auto* c = std::get_if<FieldReplacement>(&command)) add(c->target, c->value);
    if (const auto* c = std::get_if<IndexedValueReplacement>(&command)) add(c->target, c->value);
    if (const auto* c = std::get_if<MultipleIndexedReplacement>(&command))
      for (const IndexedValue& value : c->values) add(c->target, value.value);
    if (const auto* c = std::get_if<MultipleFieldReplacement>(&command))
      for (const nodes::FieldEntry& entry : c->values) add({c->target, entry.field}, entry.value);
    if (const auto* c = std::get_if<XReplace>(&command); c != nullptr && !c->value_from)
      add(c->child_field.value_or(c->target), c->value);
  }

  /// A value in a command. Of indices the width depends on the scene at that time: they are taken
  /// for not fitting.
  void add(const FieldRef& target, const FieldValue& value) {
    const NodeDefinition& definition = *scene().node(target.node).definition;
    const FieldDefinition& field = definition.field(target.field);
    SceneValues& values = found_.back();
    if (!is_integer(field)) return add(definition, field, value, values.later);
    const auto coding = element_coding(field, &coding_quantizer().quantizer, std::nullopt);
    if (!coding.ok() || !all_fit(value, coding.value()))
      values.later_misfit = misfit(definition.name + "." + field.name);
  }

  void add_fields(NodeId node, std::vector<QuantizedValue>& out) {
    const NodeDefinition& definition = *scene().node(node).definition;
    for (const nodes::FieldEntry& entry : scene().node(node).values) {
      const FieldDefinition& field = definition.field(entry.field);
      if (!same_bits(entry.value, field.default_value)) add(definition, field, entry.value, out);
    }
  }

  static void add(const NodeDefinition& definition, const FieldDefinition& field,
                  const FieldValue& value, std::vector<QuantizedValue>& out) {
    if (field.quant_category == 0 || is_integer(field)) return;
    out.push_back({&definition, &field, &value});
  }

  /// The nodes that a command brings, in the order of their numbers, which is the same everywhere.
  /// A node that comes again with another scene may have been changed by then.
  Result<std::vector<NodeId>> fresh_nodes(const Command& command) {
    std::vector<NodeId> list;
    for (const uint32_t node : new_nodes(scene(), command, known_)) list.emplace_back(node);
    std::sort(list.begin(), list.end());
    for (const NodeId node : list) {
      if (is_quantizer(scene(), node)) return has_quantizers();
      if (!seen_.insert(node.value).second)
        return Error{Errc::bad_argument,
                     {},
                     "a " + scene().type_name(node) +
                         " comes with two scenes [expected nodes of its own in each scene]"};
    }
    return list;
  }

  static Error has_quantizers() {
    return {Errc::bad_argument,
            {},
            "the presentation has quantizers already [expected none to quantize it]"};
  }
  static std::string misfit(const std::string& what) {
    return what +
           ": an integer that cannot be coded under a quantizer [expected a value in the "
           "range of its field, for an index one of the points]";
  }

  [[nodiscard]] const Scene& scene() const { return presentation_.scene; }

  const Presentation& presentation_;
  NodeSet known_;  ///< in the scene at hand
  NodeSet seen_;   ///< in any
  std::vector<SceneValues> found_;
};

}  // namespace

Result<std::vector<SceneValues>> find_quantized_values(const Presentation& presentation) {
  return Finder(presentation).find();
}

}  // namespace afx::bifs
