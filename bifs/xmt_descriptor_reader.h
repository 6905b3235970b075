// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The inside of xmt_reader.h: descriptors and the commands of their stream.
#pragma once

#include <initializer_list>
#include <string_view>

#include "bifs/descriptor.h"
#include "bifs/od_command.h"
#include "bifs/xmt_document.h"
#include "bifs/xmt_values.h"

namespace afx::bifs {

class XmtDescriptorReader {
 public:
  XmtDescriptorReader(XmtDocument& document, XmtValueReader& values)
      : document_(document), values_(values) {}

  InitialObjectDescriptor read_initial(pugi::xml_node element);
  /// Whether an element of that name is a command of the stream of object descriptors.
  static bool is_command(std::string_view name);
  OdCommand read_command(pugi::xml_node element);

 private:
  using Element = pugi::xml_node;

  void read_parts(Element parent, Descriptors& parts, std::initializer_list<std::string_view> own);
  void read_descriptor(Element element, Descriptors& parts);
  template <class T, class Fields>
  void read_fields(Element element, T& descriptor, Fields fields);
  ObjectDescriptor read_object(Element element);
  EsDescriptor read_es(Element element);
  DecoderConfig read_decoder_config(Element element);
  SlConfig read_sl_config(Element element);
  std::vector<uint8_t> read_bifs_config(Element element, uint8_t version);
  std::vector<uint8_t> read_bytes(XmtAttributes& attributes);
  std::vector<uint16_t> read_ids(XmtAttributes& attributes, const char* name,
                                 std::string_view prefix, uint64_t largest);

  XmtDocument& document_;
  XmtValueReader& values_;
  unsigned depth_ = 0;
};

}  // namespace afx::bifs
