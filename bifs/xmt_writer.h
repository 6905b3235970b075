// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <functional>
#include <memory>
#include <string_view>

#include "bifs/presentation.h"

namespace afx::bifs {

/// Writes a presentation as XMT-A, the XML form of MPEG-4 scenes, in the dialect of GPAC. read_xmt
/// (bifs/xmt_reader.h) gives the same commands, nodes, values to the bit and BIFS IDs again.
///
///   commands of time 0     stand in Body, later ones in <par begin="seconds">, isRAP="yes" at
///                          random access points behind the first
///   a node                 <Group DEF="name">; without name N<ID - 1>; binaryID="ID" where the
///                          name does not tell the ID (bifs/id_assignment.h). ROUTEs likewise, R<k>
///   its values             attributes; nodes and command buffers in an element of the field's name
///   strings                SFString as it is; in lists each in quotes, \" and \\ for quote and
///                          backslash; bytes (BitWrapper.buffer) as a data URL
///   object descriptors     od://od10
///
/// What GPAC does not write, or not as well-formed XML, is written so:
///
///     <Replace extended="fields" atNode="M"><repField atField="scale" value="2 2 2"/></Replace>
///     <Replace extended="indices" atNode="L" atField="key"><repValue position="5" value="1"/>...
///     <Replace extended="xreplace" atNode="P" atField="point" position="1" value="3 3 3"/>
///         or its place atIndexNode, atIndexField; of a node in a list atChildField, and in
///         atChildNode that node's type; the value of another field fromNode, fromField
///     <Replace extended="globalQuant">a QuantizationParameter or NULL</Replace>
///     <Insert extended="protos">ProtoDeclare elements</Insert>
///     <Delete extended="protos" protoID="1 2"/>, <Delete extended="allProtos"/>
///     <Delete extended="deleteEx" atNode="N0"/>
///     <UnknownDescriptor tag="64" src="data:..."/>, <UnknownODCommand tag="9" src="data:..."/>
///     <SLConfigDescriptor><predefined value="2"/></SLConfigDescriptor>
///     <ES_DescriptorRemove objectDescriptorId="od20" refIndex="1"/> where streams are named so
///
/// Lost are the lengths that descriptors were coded with, EsUpdate::aligned, access units without
/// commands, and that the text of a URL looks like an object descriptor but is none.
///
/// Errors  bad_argument: a node in several places without name and ID, a string with a byte of 0;
///         unsupported: a command buffer that is only text; what `write` returns
class XmtWriter final : public PresentationSink {
 public:
  using Write = std::function<Status(std::string_view text)>;
  /// `write` takes the text in pieces.
  explicit XmtWriter(Write write);
  ~XmtWriter() override;

  Status begin(const InitialObjectDescriptor& initial) override;
  Status begin_frame(uint64_t time, bool random_access) override;
  Status add(const Command& command, const nodes::Scene& before) override;
  Status end_frame() override;
  Status object_descriptors(uint64_t time, bool random_access, const OdCommands& commands) override;
  Status end() override;

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace afx::bifs
