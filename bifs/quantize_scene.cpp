// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/quantize_scene.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "bifs/quantized_values.h"
#include "bifs/quantizer_choice.h"

namespace afx::bifs {

namespace {

using nodes::FieldIndex;
using nodes::FieldValue;
using nodes::NodeDefinition;
using nodes::NodeId;
using nodes::Scene;

/// The rows of the report: what a quantizer does to each field.
std::vector<QuantizedField> rows_of(const std::vector<QuantizedValue>& values,
                                    const Quantizer& quantizer) {
  std::map<std::tuple<uint8_t, std::string, std::string>, QuantizedField> rows;
  for (const QuantizedValue& value : values) {
    const Result<ElementCoding> coding = element_coding(*value.field, &quantizer, std::nullopt);
    if (!coding.ok() || coding.value().kind == ElementCoding::Kind::plain) continue;
    const uint8_t category = value.field->quant_category;
    QuantizedField& row = rows[{category, value.node->name, value.field->name}];
    row.category = category_name(category);
    row.node = value.node->name;
    row.field = value.field->name;
    row.values += element_count(*value.value);
    row.bits = coding.value().bits;
    row.bound = std::max(row.bound, bound_of(*value.field, coding.value()));
    row.largest_error = std::max(row.largest_error, largest_error(coding.value(), *value.value));
  }
  std::vector<QuantizedField> list;
  for (auto& [key, row] : rows) list.push_back(std::move(row));
  return list;
}

bool is_reached(const std::vector<QuantizedValue>& values, const Quantizer& quantizer) {
  return std::any_of(values.begin(), values.end(), [&](const QuantizedValue& value) {
    const Result<ElementCoding> coding = element_coding(*value.field, &quantizer, std::nullopt);
    return coding.ok() && coding.value().kind != ElementCoding::Kind::plain;
  });
}

SceneReplacement& replacement_of(Presentation& presentation, const SceneValues& at) {
  auto& commands = std::get<std::vector<Command>>(presentation.units[at.unit].commands);
  return std::get<SceneReplacement>(commands[at.command]);
}

/// Puts quantizers into the scenes and between the commands of a presentation.
class Inserter {
 public:
  Inserter(Presentation& presentation, const std::vector<nodes::FieldEntry>& fields)
      : presentation_(presentation), fields_(fields) {}

  void insert(const SceneValues& at, bool with_later) {
    // Behind first: it moves nothing that comes before it.
    if (with_later) {
      auto& commands = std::get<std::vector<Command>>(presentation_.units[at.unit].commands);
      commands.insert(commands.begin() + static_cast<ptrdiff_t>(at.command) + 1,
                      GlobalQuantizer{new_quantizer()});
    }
    NodeId& root = replacement_of(presentation_, at).root;
    root = at.has_inner_quantizer ? put_into(root) : put_around(root);
  }

 private:
  Scene& scene() { return presentation_.scene; }

  NodeId new_quantizer() {
    const NodeId node = scene().add(quantizer_definition());
    for (const nodes::FieldEntry& entry : fields_)
      scene().set_unchecked(node, entry.field, entry.value);
    return node;
  }

  NodeId put_into(NodeId root) {
    const FieldIndex children = scene().node(root).definition->find("children");
    auto list = std::get<std::vector<NodeId>>(scene().value(root, children));
    list.insert(list.begin(), new_quantizer());
    scene().set_unchecked(root, children, std::move(list));
    return root;
  }

  NodeId put_around(NodeId root) {
    const NodeDefinition& definition = *scene().node(root).definition;
    const NodeId holder = scene().add(definition);
    scene().set_unchecked(holder, definition.find("children"),
                          std::vector<NodeId>{new_quantizer(), root});
    return holder;
  }

  Presentation& presentation_;
  const std::vector<nodes::FieldEntry>& fields_;
};

/// Whether a quantizer and the root itself may stand in the children of a node of the root's type.
Status check_root(const nodes::Node& root) {
  const NodeDefinition& definition = *root.definition;
  const FieldIndex children = definition.find("children");
  const auto may_stand = [&](const NodeDefinition& child) {
    return contains(child.data_types, definition.field(children).data_type);
  };
  if (!root.proto.valid() && children.valid() && may_stand(definition) &&
      may_stand(quantizer_definition()))
    return {};
  return Error{Errc::bad_argument,
               {},
               "the root is a " + definition.name +
                   " [expected a grouping node, which can hold a quantizer]"};
}

}  // namespace

Result<QuantizeReport> quantize_scene(Presentation& presentation, const QuantizeOptions& options) {
  const Status checked = check_choices(options.categories);
  if (!checked.ok()) return checked.error();
  Result<std::vector<SceneValues>> found = find_quantized_values(presentation);
  if (!found.ok()) return found.error();
  QuantizeReport report;
  std::vector<QuantizedValue> all;
  for (SceneValues& values : found.value()) {
    if (!values.later_misfit.empty()) {
      report.commands_left_out = values.later_misfit;
      values.later.clear();
    }
    all.insert(all.end(), values.scene.begin(), values.scene.end());
    all.insert(all.end(), values.later.begin(), values.later.end());
  }
  const QuantizerChoice choice = choose_quantizer(all, options, report.left_out);
  if (!choice.is_any_on) return report;
  for (const SceneValues& values : found.value()) {
    const nodes::NodeId root = replacement_of(presentation, values).root;
    const Status fits = check_root(presentation.scene.node(root));
    if (!fits.ok()) return fits.error();
  }
  report.fields = rows_of(all, choice.quantizer);
  Inserter inserter(presentation, choice.fields);
  for (auto values = found.value().rbegin(); values != found.value().rend(); ++values)
    inserter.insert(*values, is_reached(values->later, choice.quantizer));
  return report;
}

}  // namespace afx::bifs
