// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Scripts: declared fields, and the token tree turned back into text.
// Source: ISO/IEC 14496-11, SFScript (clauses not checked); spec/bifs.md 13.
#include <utility>

#include "bifs/decoder_frame.h"
#include "bifs/node_codes.h"
#include "bifs/script_syntax.h"

namespace afx::bifs {

using nodes::FieldDefinition;
using nodes::NodeId;

/// Turns the token tree of one script into text.
class ScriptDecoder {
 public:
  ScriptDecoder(FrameDecoder& in, std::vector<std::string>& identifiers)
      : in_(in), identifiers_(identifiers) {}

  std::string read() {
    while (flag("hasFunction")) {
      if (!text_.empty()) put("\n");
      put("function ");
      identifier();
      arguments();
      block();
    }
    return std::move(text_);
  }

 private:
  uint32_t u(unsigned bits, std::string_view name) { return in_.u(bits, name); }
  bool flag(std::string_view name) { return in_.u(1, name) != 0 && in_.ok(); }

  void put(std::string_view text) {
    if (in_.take(text.size(), 1)) text_ += text;
  }

  /// A sign; two signs that would grow together are kept apart.
  void put_sign(std::string_view sign) {
    if (!text_.empty() && text_.back() == sign[0]) put(" ");
    put(sign);
  }

  void identifier() {
    if (u(1, "received") == 0) {
      identifiers_.push_back(in_.read_name("identifier"));
      if (in_.take(1, sizeof(std::string))) put(identifiers_.back());
      return;
    }
    const size_t known = identifiers_.size();
    const uint32_t index = known > 0 ? u(bits_for(known - 1), "identifierCode") : 0;
    if (index >= known)
      return in_.fail(Errc::malformed, "identifier " + std::to_string(index) +
                                           " of a script that has " + std::to_string(known) +
                                           " so far");
    const std::string name = identifiers_[index];
    put(name);
  }

  /// `(a,b)` of a function, or `a,b` behind var.
  void names() {
    for (bool first = true; flag("hasArgument"); first = false) {
      if (!first) put(",");
      identifier();
    }
  }
  void arguments() {
    put("(");
    names();
    put(")");
  }

  void parameters() {
    put("(");
    for (bool first = true; flag("hasParam"); first = false) {
      if (!first) put(",");
      expression(kBindAssignment);
    }
    put(")");
  }

  void block() {
    if (!flag("isCompound")) return statement();
    put("{");
    while (flag("hasStatement")) statement();
    put("}");
  }

  void statement() {
    const FrameDecoder::Depth depth(in_);
    if (!in_.ok()) return;
    switch (static_cast<ScriptStatement>(u(3, "statementType"))) {
      case ScriptStatement::if_else:
        return if_statement();
      case ScriptStatement::for_loop:
        put("for (");
        optional_compound();
        put(";");
        optional_compound();
        put(";");
        optional_compound();
        put(")");
        return block();
      case ScriptStatement::while_loop:
        put("while (");
        compound();
        put(")");
        return block();
      case ScriptStatement::return_value:
        put("return");
        if (flag("returnValue")) {
          put(" ");
          compound();
        }
        return put(";");
      case ScriptStatement::compound:
        compound();
        return put(";");
      case ScriptStatement::break_loop:
        return put("break;");
      case ScriptStatement::continue_loop:
        return put("continue;");
      case ScriptStatement::switch_case:
        return switch_statement();
    }
  }

  void if_statement() {
    put("if (");
    compound();
    put(") ");
    block();
    if (!flag("hasElse")) return;
    put(" else ");
    block();
  }

  void switch_statement() {
    put("switch (");
    compound();
    put("){");
    const unsigned bits = u(5, "caseNbBits");
    do {
      put("case " + std::to_string(u(bits, "caseValue")) + ":");
      block();
    } while (flag("hasMoreCases"));
    if (flag("hasDefault")) {
      put("default:");
      block();
    }
    put("}");
  }

  void optional_compound() {
    if (flag("hasCompound")) compound();
  }

  void compound() {
    expression(kBindAssignment);
    while (flag("hasExpression")) {
      put(",");
      expression(kBindAssignment);
    }
  }

  /// An expression in a place that wants at least that binding.
  void expression(int wanted) {
    const FrameDecoder::Depth depth(in_);
    const uint32_t code = u(6, "expressionType");
    if (!in_.ok()) return;
    if (code > static_cast<uint32_t>(ScriptExpression::function))
      return in_.fail(Errc::malformed,
                      "script expression of type " + std::to_string(code) + " [expected 0 to 50]");
    const int binding = binding_of(code);
    if (binding < wanted) put("(");
    write(code, binding);
    if (binding < wanted) put(")");
  }

  static bool is_binary(uint32_t code) {
    return code >= static_cast<uint32_t>(ScriptExpression::first_binary) &&
           code <= static_cast<uint32_t>(ScriptExpression::last_binary);
  }
  static const ScriptOperator& operator_of(uint32_t code) {
    return script_operators()[code - static_cast<uint32_t>(ScriptExpression::first_binary)];
  }
  static int binding_of(uint32_t code) {
    if (is_binary(code)) return operator_of(code).binding;
    switch (static_cast<ScriptExpression>(code)) {
      case ScriptExpression::conditional:
        return kBindConditional;
      case ScriptExpression::negate:
      case ScriptExpression::logical_not:
      case ScriptExpression::bit_not:
      case ScriptExpression::pre_increment:
      case ScriptExpression::pre_decrement:
        return kBindUnary;
      case ScriptExpression::post_increment:
      case ScriptExpression::post_decrement:
        return kBindPostfix;
      case ScriptExpression::variables:
        return kBindAssignment;
      default:
        return kBindMember;
    }
  }

  void write(uint32_t code, int binding) {
    if (is_binary(code)) return write_binary(operator_of(code));
    switch (static_cast<ScriptExpression>(code)) {
      case ScriptExpression::parentheses:
        put("(");
        compound();
        return put(")");
      case ScriptExpression::negate:
        return write_prefix("-");
      case ScriptExpression::logical_not:
        return write_prefix("!");
      case ScriptExpression::bit_not:
        return write_prefix("~");
      case ScriptExpression::pre_increment:
        return write_prefix("++");
      case ScriptExpression::pre_decrement:
        return write_prefix("--");
      case ScriptExpression::post_increment:
        expression(binding);
        return put("++");
      case ScriptExpression::post_decrement:
        expression(binding);
        return put("--");
      case ScriptExpression::conditional:
        expression(kBindOr);
        put(" ? ");
        expression(kBindAssignment);
        put(" : ");
        return expression(kBindAssignment);
      case ScriptExpression::variables:
        put("var ");
        return names();
      default:
        return write_primary(static_cast<ScriptExpression>(code));
    }
  }

  void write_primary(ScriptExpression type) {
    switch (type) {
      case ScriptExpression::string:
        return write_string(in_.read_name("string"));
      case ScriptExpression::number:
        return number();
      case ScriptExpression::identifier:
        return identifier();
      case ScriptExpression::create:
        put("new ");
        [[fallthrough]];
      case ScriptExpression::call:
        identifier();
        return parameters();
      case ScriptExpression::member:
      case ScriptExpression::member_call:
        expression(kBindMember);
        put(".");
        identifier();
        if (type == ScriptExpression::member_call) parameters();
        return;
      case ScriptExpression::element:
        expression(kBindMember);
        put("[");
        compound();
        return put("]");
      case ScriptExpression::boolean:
        return put(u(1, "boolean") != 0 ? "true" : "false");
      default:
        put("function");
        arguments();
        return block();
    }
  }

  void write_prefix(std::string_view sign) {
    put_sign(sign);
    expression(kBindUnary);
  }

  void write_binary(const ScriptOperator& op) {
    const bool from_right = groups_from_right(op.binding);
    expression(from_right ? op.binding + 1 : op.binding);
    put_sign(op.text);
    expression(from_right ? op.binding : op.binding + 1);
  }

  void write_string(const std::string& text) {
    const std::string_view quote = text.find('\'') == std::string::npos ? "'" : "\"";
    put(quote);
    put(text);
    put(quote);
  }

  void number() {
    if (u(1, "isInteger") != 0) {
      const unsigned bits = u(5, "nbBits");
      return put(std::to_string(u(bits, "value")));
    }
    std::string digits;
    while (in_.take(1, 1)) {
      const uint32_t code = u(4, "floatChar");
      if (code == kNumberEnd) break;
      if (code >= kNumberCharacters.size())
        return in_.fail(Errc::malformed, "character " + std::to_string(code) +
                                             " in a number of a script [expected 0 to 12, or 15]");
      digits.push_back(kNumberCharacters[code]);
    }
    put(digits);
  }

  FrameDecoder& in_;
  std::vector<std::string>& identifiers_;
  std::string text_;
};

std::string FrameDecoder::read_script(NodeId script) {
  const Part part(*this, "script");
  std::vector<std::string> identifiers;
  read_script_fields(script, identifiers);
  if (u(1, "reserved") != 1) warn("reserved_bits", "a script with the reserved bit not set");
  if (!ok()) return {};
  return std::string(kScriptPrefix) + ScriptDecoder(*this, identifiers).read();
}

void FrameDecoder::read_script_fields(NodeId script, std::vector<std::string>& identifiers) {
  if (u(1, "isList") != 0) {
    while (u(1, "endFlag") == 0 && read_script_field(script, identifiers)) {
    }
    return;
  }
  const uint32_t count = u(u(4, "nbBits"), "count");
  for (uint32_t i = 0; i < count && read_script_field(script, identifiers); ++i) {
  }
}

/// Reads one declared field; where there is no Script to declare it in (a command), it is dropped.
bool FrameDecoder::read_script_field(NodeId script, std::vector<std::string>& identifiers) {
  constexpr nodes::EventKind kKinds[] = {nodes::EventKind::field, nodes::EventKind::event_in,
                                         nodes::EventKind::event_out};
  const uint32_t kind = u(2, "eventType");
  if (kind >= std::size(kKinds)) fail(Errc::malformed, "a script field of event type 3");
  const uint32_t code = u(6, "fieldType");
  const auto type = nodes::field_type_of_code(code);
  if (!type) fail(Errc::unsupported, "a script field of type " + std::to_string(code));
  if (!ok() || !take(1, sizeof(FieldDefinition))) return false;
  FieldDefinition field;
  field.kind = kKinds[kind];
  field.type = *type;
  field.default_value = zero_value(field.type);
  field.name = "_field" + std::to_string(identifiers.size());
  take_name("fieldName", field.name, false);
  const Part part(*this, field.name);
  identifiers.push_back(field.name);
  const FieldDefinition held = field;
  nodes::FieldIndex index;
  if (script.valid() && ok()) {
    index = state_.scene.own_definition(script).add(std::move(field));
    if (!index.valid()) {
      fail(Errc::malformed, "a second field of that name, or more than 65535 fields");
      return false;
    }
  }
  if (proto_.valid() && u(1, "isIS") != 0) {
    if (ok() && script.valid())
      read_link(*state_.scene.node(script).definition, index, {script, nullptr});
    return ok() && script.valid();
  }
  if (!held.has_value() || u(1, "hasValue") == 0) return ok();
  ElementCoding coding;
  coding.efficient_floats = quantizer_ != nullptr && quantizer_->efficient_floats();
  nodes::FieldValue value = read_value(held, coding, {});
  if (ok() && script.valid()) state_.scene.set_unchecked(script, index, std::move(value));
  return ok();
}

}  // namespace afx::bifs
