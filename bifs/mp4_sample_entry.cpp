// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/mp4_sample_entry.h"

#include <algorithm>
#include <utility>

#include "bifs/descriptor_reader.h"

namespace afx::bifs {
namespace {

/// Bytes of the fields in front of the boxes inside an entry; nothing where that is not known.
std::optional<size_t> head_size(const Mp4Part& part, FourCc handler) {
  if (part.type == fourcc("mp4s")) return 8;
  if (handler == fourcc("vide")) return 78;
  // A sound entry of version 0; QuickTime has others, with more fields.
  const bool plain = part.bytes.size() >= 28 && part.bytes[8] == 0 && part.bytes[9] == 0;
  if (handler == fourcc("soun") && plain) return 28;
  return std::nullopt;
}

bool has_descriptor(FourCc type) {
  return type == fourcc("mp4s") || type == fourcc("mp4v") || type == fourcc("mp4a");
}

Status read_inside(const Mp4Part& part, Mp4Context& context, Mp4SampleEntry& entry) {
  constexpr FourCc kWanted[] = {fourcc("esds")};
  const auto children = Mp4Children::read(part, kWanted, context);
  if (!children.ok()) return children.error();
  if (const Mp4Part* esds = children.value().find(fourcc("esds"))) {
    auto es = read_descriptor_box(*esds, context);
    if (!es.ok()) return es.error();
    entry.es = std::move(es).value();
  }
  for (const Mp4Part& other : children.value().others()) {
    auto box = keep_box(other, context);
    if (!box.ok()) return box.error();
    entry.boxes.push_back(std::move(box).value());
  }
  return {};
}

Result<Mp4SampleEntry> read_entry(const Mp4Part& part, const std::vector<bool>& self_contained,
                                  FourCc handler, Mp4Context& context) {
  Mp4SampleEntry entry;
  entry.type = part.type;
  Mp4Fields in(part, context);
  in.skip(6, "reserved");
  const uint16_t reference = in.u16("data_reference_index");
  if (in.ok() && (reference == 0 || reference > self_contained.size())) {
    in.fail(Errc::malformed, "data_reference_index is " + std::to_string(reference) +
                                 " (expected 1 to " + std::to_string(self_contained.size()) + ")");
  }
  if (!in.ok()) return in.status().error();
  entry.in_this_file = self_contained[reference - 1U];
  Status charged = context.charge(part.bytes.size() + sizeof(Mp4SampleEntry), part);
  if (!charged.ok()) return charged.error();
  const auto head = head_size(part, handler);
  if (head && *head <= part.bytes.size()) {
    entry.head.assign(part.bytes.begin(), part.bytes.begin() + static_cast<ptrdiff_t>(*head));
    Mp4Part inside = part;
    inside.bytes = part.bytes.subspan(*head);
    inside.offset += *head;
    Status status = read_inside(inside, context, entry);
    if (status.ok()) return entry;
    if (has_descriptor(part.type) || status.error().code == Errc::limit_exceeded) {
      return status.error();
    }
    entry.boxes.clear();
    entry.es.reset();
  } else if (has_descriptor(part.type) && head) {
    return mp4_error(Errc::truncated, part, part.offset,
                     "has " + std::to_string(part.bytes.size()) + " bytes (expected at least " +
                         std::to_string(*head) + ")");
  }
  context.warn("sample_entry", part, "is kept without being understood");
  entry.head.assign(part.bytes.begin(), part.bytes.end());
  return entry;
}

}  // namespace

Status read_sample_entries(const Mp4Part& stsd, const std::vector<bool>& self_contained,
                           Mp4Context& context, Mp4Track& track) {
  Mp4Fields in(stsd, context);
  in.version(1);  // 1: there may be sound entries of a later version, which are kept
  const uint32_t count = in.count(64, "entry_count");
  for (uint32_t i = 0; i < count && in.ok(); ++i) {
    const auto part = in.box();
    if (!part) {
      in.fail(Errc::truncated, "there are " + std::to_string(i) + " entries (expected " +
                                   std::to_string(count) + ")");
      break;
    }
    auto entry = read_entry(*part, self_contained, track.handler, context);
    if (!entry.ok()) return entry.error();
    track.entries.push_back(std::move(entry).value());
  }
  return in.status();
}

Result<Descriptor> read_descriptor_box(const Mp4Part& part, Mp4Context& context) {
  Mp4Fields in(part, context);
  in.version(0);
  if (!in.ok()) return in.status().error();
  const uint64_t bits = part.offset * 8;
  const codec::Trace moved = [&](const codec::TraceElement& element) {
    const std::string path = part.path + "/" + std::string(element.path);
    (*context.trace)({element.bit + bits, element.width, path, element.value});
  };
  // A descriptor takes at least two bytes; thousands of them would be no description of a stream.
  Limits limits = context.limits;
  limits.memory =
      std::min<size_t>(part.bytes.size() / 2, 4096) * sizeof(Descriptor) + part.bytes.size();
  Status charged = context.charge(limits.memory, part);
  if (!charged.ok()) return charged.error();
  const DescriptorReadOptions options{limits, context.trace != nullptr ? &moved : nullptr, 4, {}};
  Diagnostics inner;
  auto read = read_descriptors(part.bytes, options, inner);
  for (const Warning& warning : inner.warnings()) {
    context.diagnostics.warn(warning.code, Place::at_bit(warning.place.bit + bits),
                             part.path + ": " + warning.text);
  }
  if (!read.ok()) {
    Error error = std::move(read).error();
    error.place = Place::at_bit(error.place.bit + bits);
    error.text = part.path + ": " + error.text;
    return error;
  }
  if (read.value().empty()) {
    return mp4_error(Errc::truncated, part, part.offset + 4, "holds no descriptor (expected one)");
  }
  if (read.value().size() > 1) {
    context.warn("trailing_bytes", part, "holds more than one descriptor; the first is kept");
  }
  return std::move(read).value()[0];
}

}  // namespace afx::bifs
