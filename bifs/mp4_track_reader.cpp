// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/mp4_track_reader.h"

#include <algorithm>
#include <utility>

#include "bifs/mp4_sample_tables.h"

namespace afx::bifs {
namespace {

Status read_header(const Mp4Part& tkhd, Mp4Context& context, Mp4Track& track) {
  Mp4Fields in(tkhd, context);
  const auto [version, flags] = in.version(1);
  const unsigned wide = version == 1 ? 8 : 4;
  track.flags = flags;
  track.created = in.u(wide, "creation_time");
  track.modified = in.u(wide, "modification_time");
  track.id = in.u32("track_ID");
  if (in.ok() && track.id == 0) in.fail(Errc::malformed, "track_ID is 0 (expected 1 or more)");
  in.skip(4, "reserved");
  track.duration = read_duration(in, wide);
  in.skip(8, "reserved");
  track.layer = in.i16("layer");
  track.alternate_group = in.i16("alternate_group");
  track.volume = in.i16("volume");
  in.skip(2, "reserved");
  track.matrix = read_matrix(in);
  track.width = in.u32("width");
  track.height = in.u32("height");
  return in.status();
}

Status read_media_header(const Mp4Part& mdhd, Mp4Context& context, Mp4Track& track) {
  Mp4Fields in(mdhd, context);
  const unsigned wide = in.version(1).version == 1 ? 8 : 4;
  track.media_created = in.u(wide, "creation_time");
  track.media_modified = in.u(wide, "modification_time");
  track.timescale = in.u32("timescale");
  if (in.ok() && track.timescale == 0)
    in.fail(Errc::malformed, "timescale is 0 (expected 1 or more)");
  track.media_duration = read_duration(in, wide);
  track.language = in.u16("language");
  in.skip(2, "pre_defined");
  return in.status();
}

Status read_handler(const Mp4Part& hdlr, Mp4Context& context, Mp4Track& track) {
  Mp4Fields in(hdlr, context);
  in.version(0);
  in.skip(4, "pre_defined");
  track.handler = in.u32("handler_type");
  in.skip(12, "reserved");
  if (!in.ok()) return in.status();
  const auto name = in.bytes(in.left(), "name");
  track.name.assign(name.begin(), std::find(name.begin(), name.end(), 0));
  return context.charge(name.size(), hdlr);
}

Status read_edits(const Mp4Part& edts, Mp4Context& context, std::vector<Mp4Edit>& edits) {
  constexpr FourCc kWanted[] = {fourcc("elst")};
  const auto children = Mp4Children::read(edts, kWanted, context);
  if (!children.ok()) return children.error();
  const Mp4Part* elst = children.value().find(fourcc("elst"));
  if (elst == nullptr) return {};
  Mp4Fields in(*elst, context);
  const bool wide = in.version(1).version == 1;
  const uint32_t count = in.count(wide ? 160 : 96, "entry_count");
  Status charged = context.charge(count * sizeof(Mp4Edit), *elst);
  if (!charged.ok()) return charged;
  for (uint32_t i = 0; i < count && in.ok(); ++i) {
    Mp4Edit edit;
    edit.duration = in.u(wide ? 8 : 4, "segment_duration");
    const uint64_t time = in.u(wide ? 8 : 4, "media_time");
    edit.media_time = wide ? static_cast<int64_t>(time) : static_cast<int32_t>(time);
    edit.rate = in.i32("media_rate");
    edits.push_back(edit);
  }
  return in.status();
}

Status read_references(const Mp4Part& tref, Mp4Context& context,
                       std::vector<Mp4Reference>& references) {
  Mp4Fields lists(tref, context);
  while (const auto part = lists.box()) {
    Status charged = context.charge(part->bytes.size() + sizeof(Mp4Reference), *part);
    if (!charged.ok()) return charged;
    Mp4Reference reference{part->type, {}};
    Mp4Fields in(*part, context);
    while (in.ok() && in.left() > 0) reference.tracks.push_back(in.u32("track_ID"));
    if (!in.ok()) return in.status();
    references.push_back(std::move(reference));
  }
  return lists.status();
}

/// 'dinf': for each data reference whether it is this file.
Status read_data_references(const Mp4Part& dinf, Mp4Context& context, std::vector<bool>& out) {
  constexpr FourCc kWanted[] = {fourcc("dref")};
  const auto children = Mp4Children::read(dinf, kWanted, context);
  if (!children.ok()) return children.error();
  const auto dref = children.value().need(fourcc("dref"));
  if (!dref.ok()) return dref.error();
  Mp4Fields in(*dref.value(), context);
  in.version(0);
  const uint32_t count = in.count(64, "entry_count");
  for (uint32_t i = 0; i < count && in.ok(); ++i) {
    const auto part = in.box();
    if (!part) break;
    Mp4Fields entry(*part, context);
    out.push_back((entry.version(0xFF).flags & 1) != 0);
    if (!entry.ok()) return entry.status();
  }
  return in.status();
}

bool is_media_header(FourCc type) {
  for (const char* known : {"nmhd", "vmhd", "smhd", "hmhd", "sthd", "gmhd"}) {
    if (type == fourcc(known)) return true;
  }
  return false;
}

Status read_media_information(const Mp4Part& minf, Mp4Context& context, Mp4Track& track) {
  constexpr FourCc kWanted[] = {fourcc("dinf"), fourcc("stbl")};
  const auto read = Mp4Children::read(minf, kWanted, context);
  if (!read.ok()) return read.error();
  const Mp4Children& children = read.value();
  for (const Mp4Part& other : children.others()) {
    if (is_media_header(other.type)) {
      auto box = keep_box(other, context);
      if (!box.ok()) return box.error();
      track.media_header = std::move(box).value();
    } else if (other.type != fourcc("hdlr")) {  // QuickTime has one here too
      context.warn("box_ignored", other, "is not carried along");
    }
  }
  std::vector<bool> self_contained;
  const auto dinf = children.need(fourcc("dinf"));
  if (!dinf.ok()) return dinf.error();
  Status status = read_data_references(*dinf.value(), context, self_contained);
  if (!status.ok()) return status;
  const auto stbl = children.need(fourcc("stbl"));
  if (!stbl.ok()) return stbl.error();
  return read_sample_tables(*stbl.value(), self_contained, context, track);
}

using ReadPart = Status (*)(const Mp4Part&, Mp4Context&, Mp4Track&);

Status read_needed(const Mp4Children& children, FourCc type, ReadPart read, Mp4Context& context,
                   Mp4Track& track) {
  const auto part = children.need(type);
  return part.ok() ? read(*part.value(), context, track) : part.error();
}

Status read_media(const Mp4Part& mdia, Mp4Context& context, Mp4Track& track) {
  constexpr FourCc kWanted[] = {fourcc("mdhd"), fourcc("hdlr"), fourcc("minf")};
  const auto read = Mp4Children::read(mdia, kWanted, context);
  if (!read.ok()) return read.error();
  for (const Mp4Part& other : read.value().others()) {
    context.warn("box_ignored", other, "is not carried along");
  }
  Status status = read_needed(read.value(), fourcc("mdhd"), read_media_header, context, track);
  if (status.ok()) status = read_needed(read.value(), fourcc("hdlr"), read_handler, context, track);
  if (!status.ok()) return status;
  return read_needed(read.value(), fourcc("minf"), read_media_information, context, track);
}

}  // namespace

Mp4Matrix read_matrix(Mp4Fields& in) {
  Mp4Matrix matrix;
  for (int32_t& number : matrix) number = in.i32("matrix");
  return matrix;
}

uint64_t read_duration(Mp4Fields& in, unsigned bytes) {
  const uint64_t duration = in.u(bytes, "duration");
  return bytes == 4 && duration == 0xFFFFFFFF ? kMp4UnknownDuration : duration;
}

Result<Mp4Track> read_track(const Mp4Part& trak, Mp4Context& context) {
  constexpr FourCc kWanted[] = {fourcc("tkhd"), fourcc("edts"), fourcc("tref"), fourcc("mdia")};
  Status status = context.charge(sizeof(Mp4Track), trak);
  if (!status.ok()) return status.error();
  const auto read = Mp4Children::read(trak, kWanted, context);
  if (!read.ok()) return read.error();
  const Mp4Children& children = read.value();
  Mp4Track track;
  status = read_needed(children, fourcc("tkhd"), read_header, context, track);
  const Mp4Part* edts = children.find(fourcc("edts"));
  if (status.ok() && edts != nullptr) status = read_edits(*edts, context, track.edits);
  const Mp4Part* tref = children.find(fourcc("tref"));
  if (status.ok() && tref != nullptr) status = read_references(*tref, context, track.references);
  if (status.ok()) status = read_needed(children, fourcc("mdia"), read_media, context, track);
  if (!status.ok()) return status.error();
  for (const Mp4Part& other : children.others()) {
    auto box = keep_box(other, context);
    if (!box.ok()) return box.error();
    track.boxes.push_back(std::move(box).value());
  }
  return track;
}

}  // namespace afx::bifs
