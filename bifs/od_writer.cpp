// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/od_command.h"

#include <string>

#include "bifs/descriptor_writer.h"
#include "codec/bit_writer.h"

namespace afx::bifs {
namespace {

using Bytes = std::vector<uint8_t>;
using codec::BitWriter;

/// Writes the payload of a command and gives its tag.
class CommandWriter {
 public:
  explicit CommandWriter(Bytes& out) : out_(out), bits_(out) {}

  Result<uint8_t> operator()(const UnknownOdCommand& unknown) {
    const bool known = (unknown.tag <= 4) || unknown.tag == 7 || unknown.tag == 0xFF;
    if (known) {
      return bad("an UnknownOdCommand has tag " + std::to_string(unknown.tag) +
                 " (expected one without a form of its own)");
    }
    out_ = unknown.payload;
    return unknown.tag;
  }
  Result<uint8_t> operator()(const OdUpdate& update) {
    const auto objects = write_descriptors(update.objects);
    if (!objects.ok()) return objects.error();
    out_ = objects.value();
    return uint8_t{1};
  }
  Result<uint8_t> operator()(const OdRemove& remove) {
    for (const uint16_t id : remove.ids) {
      if (id > 1023) return bad_id(id);
      bits_.u(id, 10);
    }
    return uint8_t{2};
  }
  Result<uint8_t> operator()(const EsUpdate& update) {
    const auto streams = write_descriptors(update.streams);
    if (!streams.ok()) return streams.error();
    if (update.od_id > 1023) return bad_id(update.od_id);
    bits_.u(update.od_id, 10);
    if (update.aligned) bits_.align();
    for (const uint8_t byte : streams.value()) bits_.u(byte, 8);
    return uint8_t{3};
  }
  Result<uint8_t> operator()(const EsRemove& remove) {
    if (remove.od_id > 1023) return bad_id(remove.od_id);
    bits_.u(remove.od_id, 10);
    bits_.align();
    for (const uint16_t stream : remove.streams) bits_.u(stream, 16);
    return static_cast<uint8_t>(remove.references ? 7 : 4);
  }

 private:
  static Error bad(std::string text) {
    return {Errc::bad_argument, Place::none(), std::move(text)};
  }
  static Error bad_id(uint16_t id) {
    return bad("ObjectDescriptorID is " + std::to_string(id) + " (expected 0 to 1023)");
  }

  Bytes& out_;
  BitWriter bits_;
};

}  // namespace

Result<Bytes> write_od_commands(const OdCommands& commands) {
  Bytes out;
  for (const OdCommand& command : commands) {
    Bytes payload;
    CommandWriter writer(payload);
    const Result<uint8_t> tag = std::visit(writer, command.body);
    if (!tag.ok()) return tag.error();
    Status status = append_tagged(tag.value(), command.length_bytes, payload, out);
    if (!status.ok()) return status.error();
  }
  return out;
}

}  // namespace afx::bifs
