// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/descriptor_writer.h"

#include <algorithm>
#include <optional>
#include <string>

#include "codec/bit_writer.h"

namespace afx::bifs {
namespace {

using codec::BitWriter;
using Bytes = std::vector<uint8_t>;

bool is_known(uint8_t tag) {
  return (tag >= descriptor_tag::kObject && tag <= descriptor_tag::kSlConfig) ||
         (tag >= descriptor_tag::kEsIdInc && tag <= descriptor_tag::kObjectInFile);
}

/// Writes the payload of a descriptor. The first failure sticks.
class BodyWriter {
 public:
  explicit BodyWriter(Bytes& out) : out_(out), bits_(out) {}

  void operator()(const UnknownDescriptor& unknown) {
    if (is_known(unknown.tag) || unknown.tag == 0 || unknown.tag == 0xFF) {
      fail("an UnknownDescriptor has tag " + std::to_string(unknown.tag) +
           " (expected one without a form of its own)");
    }
    bytes(unknown.payload);
  }
  void operator()(const ObjectDescriptor& object) {
    number(object.id, 10, "ObjectDescriptorID");
    flag(object.url.has_value());
    bits_.u(0x1F, 5);
    if (object.url) text(*object.url);
    parts(object.parts);
  }
  void operator()(const InitialObjectDescriptor& object) {
    number(object.id, 10, "ObjectDescriptorID");
    flag(object.url.has_value());
    flag(object.inline_profiles);
    bits_.u(0xF, 4);
    if (object.url) {
      text(*object.url);
    } else {
      for (const uint8_t profile : {object.od_profile, object.scene_profile, object.audio_profile,
                                    object.visual_profile, object.graphics_profile}) {
        bits_.u(profile, 8);
      }
    }
    parts(object.parts);
  }
  void operator()(const EsDescriptor& es) {
    bits_.u(es.es_id, 16);
    flag(es.depends_on.has_value());
    flag(es.url.has_value());
    flag(es.ocr_es_id.has_value());
    number(es.priority, 5, "streamPriority");
    if (es.depends_on) bits_.u(*es.depends_on, 16);
    if (es.url) text(*es.url);
    if (es.ocr_es_id) bits_.u(*es.ocr_es_id, 16);
    parts(es.parts);
  }
  void operator()(const DecoderConfig& config) {
    bits_.u(config.object_type, 8);
    number(config.stream_type, 6, "streamType");
    flag(config.up_stream);
    flag(true);
    number(config.buffer_bytes, 24, "bufferSizeDB");
    bits_.u(config.max_bitrate, 32);
    bits_.u(config.avg_bitrate, 32);
    parts(config.parts);
  }
  void operator()(const DecoderSpecificInfo& info) { bytes(info.bytes); }
  void operator()(const SlConfig& config) {
    if (config.fields.has_value() != (config.predefined == 0)) {
      fail(
          "SLConfigDescriptor/predefined does not go with the fields (expected fields where it is "
          "0 "
          "and only there)");
    }
    bits_.u(config.predefined, 8);
    if (config.fields) sl_fields(*config.fields);
    bytes(config.rest);
  }
  void operator()(const EsIdInc& inc) { bits_.u(inc.track_id, 32); }
  void operator()(const EsIdRef& ref) { bits_.u(ref.index, 16); }

  std::optional<Error> error_;

 private:
  void fail(std::string text) {
    if (!error_) error_ = Error{Errc::bad_argument, Place::none(), std::move(text)};
  }
  void flag(bool value) { bits_.u(value ? 1 : 0, 1); }
  void number(uint32_t value, unsigned bits, const char* name, uint32_t most = 0xFFFFFFFF) {
    if ((bits < 32 && value >> bits != 0) || value > most) {
      fail(std::string(name) + " is " + std::to_string(value) + ", which does not fit its field");
      value = 0;
    }
    bits_.u(value, bits);
  }
  void wide(uint64_t value, unsigned bits, const char* name) {
    if (bits < 64 && value >> bits != 0) {
      fail(std::string(name) + " is " + std::to_string(value) + ", which does not fit its " +
           std::to_string(bits) + " bits");
      value = 0;
    }
    if (bits > 32) bits_.u(static_cast<uint32_t>(value >> 32), bits - 32);
    bits_.u(static_cast<uint32_t>(value), std::min(bits, 32U));
  }
  void bytes(const Bytes& value) { out_.insert(out_.end(), value.begin(), value.end()); }
  void text(const std::string& value) {
    if (value.size() > 255) return fail("a URL has more than 255 bytes");
    bits_.u(static_cast<uint32_t>(value.size()), 8);
    out_.insert(out_.end(), value.begin(), value.end());
  }
  void parts(const Descriptors& parts) {
    const auto written = write_descriptors(parts);
    if (!written.ok()) {
      if (!error_) error_ = written.error();
      return;
    }
    bytes(written.value());
  }
  void sl_fields(const SlFields& sl);

  Bytes& out_;
  BitWriter bits_;
};

void BodyWriter::sl_fields(const SlFields& sl) {
  for (const bool value :
       {sl.access_unit_start, sl.access_unit_end, sl.random_access_point,
        sl.random_access_units_only, sl.padding, sl.time_stamps, sl.idle, sl.has_duration}) {
    flag(value);
  }
  bits_.u(sl.time_stamp_resolution, 32);
  bits_.u(sl.ocr_resolution, 32);
  number(sl.time_stamp_bits, 8, "timeStampLength", 64);
  number(sl.ocr_bits, 8, "OCRLength", 64);
  number(sl.au_length_bits, 8, "AU_Length", 32);
  bits_.u(sl.instant_bitrate_bits, 8);
  number(sl.degradation_priority_bits, 4, "degradationPriorityLength");
  number(sl.au_sequence_bits, 5, "AU_seqNumLength", 16);
  number(sl.packet_sequence_bits, 5, "packetSeqNumLength", 16);
  bits_.u(3, 2);
  if (sl.has_duration) {
    bits_.u(sl.time_scale, 32);
    bits_.u(sl.access_unit_duration, 16);
    bits_.u(sl.composition_unit_duration, 16);
  }
  if (!sl.time_stamps && sl.time_stamp_bits <= 64) {
    wide(sl.start_decoding_time, sl.time_stamp_bits, "startDecodingTimeStamp");
    wide(sl.start_composition_time, sl.time_stamp_bits, "startCompositionTimeStamp");
  }
  bits_.align();
}

}  // namespace

Status append_tagged(uint8_t tag, uint8_t length_bytes, const Bytes& payload, Bytes& out) {
  if (payload.size() >> 28 != 0) {
    return Error{Errc::bad_argument, Place::none(),
                 "a descriptor has 2^28 bytes or more, which its length cannot say"};
  }
  unsigned count = 1;
  while (payload.size() >> (7 * count) != 0) ++count;
  count = std::max<unsigned>(count, std::min<unsigned>(length_bytes, 4));
  out.push_back(tag);
  for (unsigned i = count; i-- > 0;) {
    const auto seven = static_cast<uint8_t>(payload.size() >> (7 * i) & 0x7F);
    out.push_back(static_cast<uint8_t>(seven | (i > 0 ? 0x80 : 0)));
  }
  out.insert(out.end(), payload.begin(), payload.end());
  return {};
}

Result<Bytes> write_descriptors(const Descriptors& descriptors) {
  Bytes out;
  for (const Descriptor& descriptor : descriptors) {
    Bytes payload;
    BodyWriter writer(payload);
    std::visit(writer, descriptor.body);
    if (writer.error_) return *writer.error_;
    Status status = append_tagged(tag_of(descriptor), descriptor.length_bytes, payload, out);
    if (!status.ok()) return status.error();
  }
  return out;
}

}  // namespace afx::bifs
