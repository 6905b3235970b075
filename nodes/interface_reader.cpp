// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "nodes/interface_reader.h"

#include <utility>

#include "nodes/nearest_name.h"

namespace afx::nodes {

void InterfaceReader::read_interface(NodeDefinition& out) {
  const size_t opened = (in_.skip_space(), in_.offset());
  if (!in_.expect('[', "the name")) return;
  while (!in_.accept(']')) {
    if (in_.at_end()) return in_.fail_unclosed(opened, "']'");
    const size_t begin = in_.offset();
    FieldDefinition field = read_head();
    read_value_and_coding(field);
    if (!in_.ok() || !values_.budget().take(in_, 1, sizeof(FieldDefinition) + field.name.size()))
      return;
    const std::string name = field.name;
    if (!out.add(std::move(field)).valid())
      return in_.fail(Errc::malformed, begin,
                      "a second field " + quoted(name) + ", or more than 65535 fields");
  }
}

FieldDefinition InterfaceReader::read_head() {
  FieldDefinition field;
  const auto kind = find_event_kind(in_.peek_word());
  if (!kind) {
    in_.fail_expected("field, exposedField, eventIn or eventOut");
    return field;
  }
  in_.take_word();
  field.kind = *kind;
  read_type(field);
  if (in_.peek_word().empty()) in_.fail_expected("the name of the field");
  field.name = std::string(in_.take_word());
  return field;
}

void InterfaceReader::read_type(FieldDefinition& field) {
  const size_t begin = (in_.skip_space(), in_.offset());
  const std::string_view name = in_.take_word();
  if (name.empty()) return in_.fail_expected("the type of the field");
  if (const auto type = find_field_type(name)) {
    field.type = *type;
  } else if (rules_.data_type && name.size() > 6 && name.ends_with("Node") && name[1] == 'F' &&
             (name[0] == 'S' || name[0] == 'M')) {
    field.type = name[0] == 'M' ? FieldType::mf_node : FieldType::sf_node;
    std::string single(name);
    single[0] = 'S';
    const auto data_type = rules_.data_type(single);
    if (!data_type) return in_.fail(Errc::malformed, begin, "too many node data types");
    field.data_type = *data_type;
  } else {
    NearestName nearest(name);
    for (unsigned code = 0; code < 64; ++code)
      if (const auto type_of_code = field_type_of_code(code))
        nearest.offer(to_string(*type_of_code));
    return in_.fail(Errc::malformed, begin, "no field type " + quoted(name) + nearest.hint());
  }
  field.default_value = zero_value(field.type);
}

bool InterfaceReader::value_follows(FieldType type) {
  if (rules_.values_required) return true;
  const char next = in_.peek();
  const bool coding = next == '{' && type != FieldType::sf_command_buffer;
  return next != ']' && !coding && !find_event_kind(in_.peek_word());
}

void InterfaceReader::read_value_and_coding(FieldDefinition& field) {
  if (field.has_value() && in_.ok() && value_follows(field.type)) {
    const TextCursor::Context outer = std::exchange(in_.context, {in_.context.node, field.name});
    if (is_node(field.type)) {
      field.default_value = rules_.read_nodes(field);
    } else {
      field.default_value = values_.read(field.type);
    }
    in_.context = outer;
  }
  if (in_.peek() == '{') read_coding(field);
}

void InterfaceReader::read_coding(FieldDefinition& field) {
  const size_t opened = in_.offset();
  in_.accept('{');
  while (!in_.accept('}')) {
    if (in_.at_end()) return in_.fail_unclosed(opened, "'}'");
    if (in_.accept_word("QP")) {
      field.quant_category = read_number(15, "QP");
    } else if (in_.accept_word("nbBits")) {
      field.quant_bits = read_number(32, "nbBits");
    } else if (in_.accept_word("ANIM")) {
      field.anim_category = read_number(15, "ANIM");
    } else if (in_.accept_word("b")) {
      read_bounds(field);
    } else if (rules_.data_type && in_.accept_word("BYTES")) {
      field.bytes = true;
    } else {
      in_.fail_expected("QP, nbBits, b { }, ANIM or '}'");
    }
  }
}

void InterfaceReader::read_bounds(FieldDefinition& field) {
  Bounds bounds;
  if (!in_.expect('{', "b")) return;
  bounds.lower = in_.float64();
  bounds.upper = in_.float64();
  if (!in_.accept('}')) return in_.fail_expected("'}' after two bounds");
  const bool open = in_.accept_word("OPEN");
  bounds.lower_open = open || in_.accept_word("OPENMIN");
  bounds.upper_open = open || in_.accept_word("OPENMAX");
  field.bounds = bounds;
}

uint8_t InterfaceReader::read_number(int32_t largest, std::string_view what) {
  const size_t begin = (in_.skip_space(), in_.offset());
  const int32_t number = in_.int32();
  if (number < 0 || number > largest)
    in_.fail(Errc::malformed, begin,
             std::string(what) + " " + std::to_string(number) + " [expected 0 to " +
                 std::to_string(largest) + "]");
  return in_.ok() ? static_cast<uint8_t>(number) : uint8_t{0};
}

}  // namespace afx::nodes
