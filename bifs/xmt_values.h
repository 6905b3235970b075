// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Field values as attributes of XMT-A hold them.
#pragma once

#include <string>
#include <string_view>

#include "bifs/xmt_document.h"
#include "codec/limits.h"
#include "nodes/node_definition.h"
#include "nodes/value_reader.h"

namespace afx::bifs {

/// Reads values of all types but nodes and command buffers, and counts what is used up.
class XmtValueReader {
 public:
  XmtValueReader(XmtDocument& document, const Limits& limits)
      : document_(document), limits_(limits), budget_(limits) {}

  /// The value in an attribute, as it is written. `node`: for messages, the name of what the field
  /// is in.
  nodes::FieldValue read(std::string_view attribute, const nodes::FieldDefinition& field,
                         std::string_view node);
  /// The bytes that a data URL stands for; %00 stands for a byte.
  std::string read_bytes(std::string_view attribute);
  /// Takes memory. False, and a failure, beyond the limits.
  bool take(std::string_view where, uint64_t count, uint64_t bytes_each);
  /// A number with a decimal point.
  double read_double(std::string_view attribute);

 private:
  template <class Read>
  auto with_cursor(std::string_view attribute, const std::string& text, size_t shift, Read read);
  nodes::FieldValue read_text(std::string_view attribute, std::string text,
                              const nodes::FieldDefinition& field);

  XmtDocument& document_;
  const Limits& limits_;
  nodes::Budget budget_;
};

/// Appends a value as an attribute holds it, not yet escaped: any type but nodes and command
/// buffers. `bytes` as FieldDefinition has it.
void append_xmt_value(std::string& out, const nodes::FieldValue& value, nodes::FieldType type,
                      bool bytes);

/// Appends text as an attribute in double quotes may hold it. All of it comes back except bytes of
/// 0, which no XML text can hold.
void append_escaped(std::string& out, std::string_view text);

/// "data:application/octet-string,%00%FF"
std::string xmt_text_of_bytes(std::string_view bytes);

}  // namespace afx::bifs
