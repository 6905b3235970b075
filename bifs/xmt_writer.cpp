// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/xmt_writer.h"

#include <utility>

#include "bifs/xmt_descriptor_writer.h"
#include "bifs/xmt_output.h"
#include "bifs/xmt_scene_writer.h"
#include "nodes/value_writer.h"

namespace afx::bifs {

class XmtWriter::State {
 public:
  explicit State(Write write) : out(std::move(write)), scene(out) {}

  struct Stream {
    uint32_t ticks = 1000;
    bool begun = false;
  };

  /// The first access unit of a stream stands in Body if that says all of it.
  void begin_unit(Stream& stream, uint64_t time, bool random_access) {
    const bool first = !std::exchange(stream.begun, true);
    in_par = !(first && time == 0 && random_access);
    if (!in_par) return;
    std::string seconds;
    nodes::append_number(seconds, static_cast<double>(time) / stream.ticks);
    out.open("par");
    out.attribute("begin", seconds);
    if (random_access != first) out.attribute("isRAP", random_access ? "yes" : "no");
  }
  void end_unit() {
    if (in_par) out.close();
  }

  XmtOutput out;
  XmtSceneWriter scene;
  Stream scene_stream, descriptor_stream;
  bool in_par = false;
};

XmtWriter::XmtWriter(Write write) : state_(std::make_unique<State>(std::move(write))) {}
XmtWriter::~XmtWriter() = default;

Status XmtWriter::begin(const InitialObjectDescriptor& initial) {
  XmtOutput& out = state_->out;
  state_->scene_stream.ticks = timestamp_resolution(scene_stream(initial));
  state_->descriptor_stream.ticks = timestamp_resolution(object_descriptor_stream(initial));
  out.line("<?xml version=\"1.0\" encoding=\"UTF-8\"?>");
  out.open("XMT-A");
  out.attribute("xmlns", "urn:mpeg:mpeg4:xmta:schema:2002");
  out.attribute("xmlns:xsi", "http://www.w3.org/2001/XMLSchema-instance");
  out.attribute("xsi:schemaLocation", "urn:mpeg:mpeg4:xmta:schema:2002 xmt-a.xsd");
  out.open("Header");
  write_xmt_initial(out, initial);
  out.close();
  out.open("Body");
  return out.status();
}

Status XmtWriter::begin_frame(uint64_t time, bool random_access) {
  state_->begin_unit(state_->scene_stream, time, random_access);
  return state_->out.status();
}

Status XmtWriter::add(const Command& command, const nodes::Scene& before) {
  state_->scene.write(command, before);
  return state_->out.status();
}

Status XmtWriter::end_frame() {
  state_->end_unit();
  return state_->out.status();
}

Status XmtWriter::object_descriptors(uint64_t time, bool random_access,
                                     const OdCommands& commands) {
  state_->begin_unit(state_->descriptor_stream, time, random_access);
  for (const OdCommand& command : commands) write_xmt_od_command(state_->out, command);
  state_->end_unit();
  return state_->out.status();
}

Status XmtWriter::end() {
  state_->out.close();
  state_->out.close();
  state_->out.flush();
  return state_->out.status();
}

}  // namespace afx::bifs
