// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/descriptor_reader.h"

#include <optional>
#include <utility>

#include "bifs/tagged_reader.h"

namespace afx::bifs {
namespace {

using codec::BitReader;

const char* name_of(uint8_t tag) {
  switch (tag) {
    case descriptor_tag::kObject:
    case descriptor_tag::kObjectInFile:
      return "ObjectDescriptor";
    case descriptor_tag::kInitialObject:
    case descriptor_tag::kInitialObjectInFile:
      return "InitialObjectDescriptor";
    case descriptor_tag::kEs:
      return "ES_Descriptor";
    case descriptor_tag::kDecoderConfig:
      return "DecoderConfigDescriptor";
    case descriptor_tag::kDecoderSpecificInfo:
      return "DecoderSpecificInfo";
    case descriptor_tag::kSlConfig:
      return "SLConfigDescriptor";
    case descriptor_tag::kEsIdInc:
      return "ES_ID_Inc";
    case descriptor_tag::kEsIdRef:
      return "ES_ID_Ref";
    default:
      return "descriptor";
  }
}

class DescriptorReader {
 public:
  DescriptorReader(std::span<const uint8_t> data, const DescriptorReadOptions& options,
                   Diagnostics& diagnostics)
      : data_(data),
        trace_(options.trace),
        diagnostics_(diagnostics),
        memory_left_(options.limits.memory) {}

  /// The descriptors from here to the end of `in`.
  Descriptors parts(BitReader& in, const std::string& path, unsigned depth) {
    Descriptors parts;
    while (in.ok() && !error_ && in.bits_left() > 0) parts.push_back(descriptor(in, path, depth));
    if (!in.ok() && !error_) error_ = in.error();
    return parts;
  }

  std::optional<Error> error_;  // the first one

 private:
  Descriptor descriptor(BitReader& in, const std::string& path, unsigned depth);
  void body(uint8_t tag, BitReader& in, const std::string& path, unsigned depth, Descriptor& out);
  ObjectDescriptor object(BitReader& in, const std::string& path, unsigned depth);
  InitialObjectDescriptor initial_object(BitReader& in, const std::string& path, unsigned depth);
  EsDescriptor es(BitReader& in, const std::string& path, unsigned depth);
  DecoderConfig decoder_config(BitReader& in, const std::string& path, unsigned depth);
  SlConfig sl_config(BitReader& in);
  SlFields sl_fields(BitReader& in);
  std::vector<uint8_t> bytes(BitReader& in, uint64_t count, const char* name);
  std::string text(BitReader& in);
  void reserved(BitReader& in, unsigned bits, uint32_t expected);
  void charge(BitReader& in, uint64_t amount);

  std::span<const uint8_t> data_;
  const codec::Trace* trace_;
  Diagnostics& diagnostics_;
  uint64_t memory_left_;
};

void DescriptorReader::charge(BitReader& in, uint64_t amount) {
  if (amount > memory_left_) {
    in.fail(Errc::limit_exceeded, "the descriptors take more memory than the limit allows");
  } else {
    memory_left_ -= amount;
  }
}

std::vector<uint8_t> DescriptorReader::bytes(BitReader& in, uint64_t count, const char* name) {
  if (in.ok() && count > in.bits_left() / 8) {
    in.fail(Errc::truncated, std::string("the data end inside ") + name + " (expected " +
                                 std::to_string(count) + " bytes, " +
                                 std::to_string(in.bits_left() / 8) + " are left)");
  }
  charge(in, count);
  if (!in.ok()) return {};
  const auto part = data_.subspan(in.bit() / 8, count);
  in.seek(in.bit() + count * 8);
  return {part.begin(), part.end()};
}

std::string DescriptorReader::text(BitReader& in) {
  const std::vector<uint8_t> raw = bytes(in, in.u(8, "URLlength"), "URLstring");
  return {raw.begin(), raw.end()};
}

void DescriptorReader::reserved(BitReader& in, unsigned bits, uint32_t expected) {
  const uint64_t at = in.bit();
  if (in.u(bits, "reserved") != expected && in.ok()) {
    diagnostics_.warn("reserved_bits", Place::at_bit(at),
                      "reserved bits are not as they should be");
  }
}

Descriptor DescriptorReader::descriptor(BitReader& in, const std::string& path, unsigned depth) {
  Descriptor out;
  const auto [tag, name, length, length_bytes] =
      read_tagged_header(in, name_of, path.empty() ? "" : path + "/", "data that it is in");
  if (depth >= kMaxDescriptorDepth) {
    in.fail(Errc::limit_exceeded, name + ": descriptors stand more than " +
                                      std::to_string(kMaxDescriptorDepth) + " deep in each other");
  }
  charge(in, sizeof(Descriptor));
  if (!in.ok()) return out;
  out.length_bytes = length_bytes;
  const uint64_t end = in.bit() + length * 8;
  BitReader inner(data_.first(end / 8), trace_);
  inner.seek(in.bit());
  body(tag, inner, name, depth, out);
  if (!inner.ok() && !error_) error_ = inner.error();
  if (!error_ && inner.bits_left() > 0) {
    diagnostics_.warn(
        "trailing_bytes", Place::at_bit(inner.bit()),
        name + " has " + std::to_string(inner.bits_left() / 8) + " bytes behind its last field");
  }
  in.seek(end);
  return out;
}

void DescriptorReader::body(uint8_t tag, BitReader& in, const std::string& path, unsigned depth,
                            Descriptor& out) {
  const BitReader::Scope scope(in, path);
  switch (tag) {
    case descriptor_tag::kObject:
    case descriptor_tag::kObjectInFile:
      out.body = object(in, path, depth);
      std::get<ObjectDescriptor>(out.body).in_file = tag == descriptor_tag::kObjectInFile;
      return;
    case descriptor_tag::kInitialObject:
    case descriptor_tag::kInitialObjectInFile:
      out.body = initial_object(in, path, depth);
      std::get<InitialObjectDescriptor>(out.body).in_file =
          tag == descriptor_tag::kInitialObjectInFile;
      return;
    case descriptor_tag::kEs:
      out.body = es(in, path, depth);
      return;
    case descriptor_tag::kDecoderConfig:
      out.body = decoder_config(in, path, depth);
      return;
    case descriptor_tag::kDecoderSpecificInfo:
      out.body = DecoderSpecificInfo{bytes(in, in.bits_left() / 8, "bytes")};
      return;
    case descriptor_tag::kSlConfig:
      out.body = sl_config(in);
      return;
    case descriptor_tag::kEsIdInc:
      out.body = EsIdInc{in.u(32, "Track_ID")};
      return;
    case descriptor_tag::kEsIdRef:
      out.body = EsIdRef{static_cast<uint16_t>(in.u(16, "ref_index"))};
      return;
    default:
      out.body = UnknownDescriptor{tag, bytes(in, in.bits_left() / 8, "payload")};
      return;
  }
}

ObjectDescriptor DescriptorReader::object(BitReader& in, const std::string& path, unsigned depth) {
  ObjectDescriptor object;
  object.id = static_cast<uint16_t>(in.u(10, "ObjectDescriptorID"));
  const bool has_url = in.u(1, "URL_Flag") != 0;
  reserved(in, 5, 0x1F);
  if (has_url) object.url = text(in);
  object.parts = parts(in, path, depth + 1);
  return object;
}

InitialObjectDescriptor DescriptorReader::initial_object(BitReader& in, const std::string& path,
                                                         unsigned depth) {
  InitialObjectDescriptor object;
  object.id = static_cast<uint16_t>(in.u(10, "ObjectDescriptorID"));
  const bool has_url = in.u(1, "URL_Flag") != 0;
  object.inline_profiles = in.u(1, "includeInlineProfileLevelFlag") != 0;
  reserved(in, 4, 0xF);
  if (has_url) {
    object.url = text(in);
  } else {
    object.od_profile = static_cast<uint8_t>(in.u(8, "ODProfileLevelIndication"));
    object.scene_profile = static_cast<uint8_t>(in.u(8, "sceneProfileLevelIndication"));
    object.audio_profile = static_cast<uint8_t>(in.u(8, "audioProfileLevelIndication"));
    object.visual_profile = static_cast<uint8_t>(in.u(8, "visualProfileLevelIndication"));
    object.graphics_profile = static_cast<uint8_t>(in.u(8, "graphicsProfileLevelIndication"));
  }
  object.parts = parts(in, path, depth + 1);
  return object;
}

EsDescriptor DescriptorReader::es(BitReader& in, const std::string& path, unsigned depth) {
  EsDescriptor es;
  es.es_id = static_cast<uint16_t>(in.u(16, "ES_ID"));
  const bool depends = in.u(1, "streamDependenceFlag") != 0;
  const bool has_url = in.u(1, "URL_Flag") != 0;
  const bool has_ocr = in.u(1, "OCRstreamFlag") != 0;
  es.priority = static_cast<uint8_t>(in.u(5, "streamPriority"));
  if (depends) es.depends_on = static_cast<uint16_t>(in.u(16, "dependsOn_ES_ID"));
  if (has_url) es.url = text(in);
  if (has_ocr) es.ocr_es_id = static_cast<uint16_t>(in.u(16, "OCR_ES_Id"));
  es.parts = parts(in, path, depth + 1);
  return es;
}

DecoderConfig DescriptorReader::decoder_config(BitReader& in, const std::string& path,
                                               unsigned depth) {
  DecoderConfig config;
  config.object_type = static_cast<uint8_t>(in.u(8, "objectTypeIndication"));
  config.stream_type = static_cast<uint8_t>(in.u(6, "streamType"));
  config.up_stream = in.u(1, "upStream") != 0;
  reserved(in, 1, 1);
  config.buffer_bytes = in.u(24, "bufferSizeDB");
  config.max_bitrate = in.u(32, "maxBitrate");
  config.avg_bitrate = in.u(32, "avgBitrate");
  config.parts = parts(in, path, depth + 1);
  return config;
}

SlConfig DescriptorReader::sl_config(BitReader& in) {
  SlConfig config;
  config.predefined = static_cast<uint8_t>(in.u(8, "predefined"));
  if (config.predefined == 0) config.fields = sl_fields(in);
  if (in.ok()) config.rest = bytes(in, in.bits_left() / 8, "rest");
  return config;
}

/// Up to 64 bits.
uint64_t wide(BitReader& in, unsigned bits, const char* name) {
  const uint64_t high = bits > 32 ? in.u(bits - 32, name) : 0;
  return high << 32 | in.u(bits > 32 ? 32 : bits, name);
}

SlFields DescriptorReader::sl_fields(BitReader& in) {
  SlFields sl;
  sl.access_unit_start = in.u(1, "useAccessUnitStartFlag") != 0;
  sl.access_unit_end = in.u(1, "useAccessUnitEndFlag") != 0;
  sl.random_access_point = in.u(1, "useRandomAccessPointFlag") != 0;
  sl.random_access_units_only = in.u(1, "hasRandomAccessUnitsOnlyFlag") != 0;
  sl.padding = in.u(1, "usePaddingFlag") != 0;
  sl.time_stamps = in.u(1, "useTimeStampsFlag") != 0;
  sl.idle = in.u(1, "useIdleFlag") != 0;
  sl.has_duration = in.u(1, "durationFlag") != 0;
  sl.time_stamp_resolution = in.u(32, "timeStampResolution");
  sl.ocr_resolution = in.u(32, "OCRResolution");
  sl.time_stamp_bits = static_cast<uint8_t>(in.u(8, "timeStampLength"));
  if (sl.time_stamp_bits > 64) in.fail(Errc::malformed, "timeStampLength is more than 64");
  sl.ocr_bits = static_cast<uint8_t>(in.u(8, "OCRLength"));
  if (sl.ocr_bits > 64) in.fail(Errc::malformed, "OCRLength is more than 64");
  sl.au_length_bits = static_cast<uint8_t>(in.u(8, "AU_Length"));
  if (sl.au_length_bits > 32) in.fail(Errc::malformed, "AU_Length is more than 32");
  sl.instant_bitrate_bits = static_cast<uint8_t>(in.u(8, "instantBitrateLength"));
  sl.degradation_priority_bits = static_cast<uint8_t>(in.u(4, "degradationPriorityLength"));
  sl.au_sequence_bits = static_cast<uint8_t>(in.u(5, "AU_seqNumLength"));
  if (sl.au_sequence_bits > 16) in.fail(Errc::malformed, "AU_seqNumLength is more than 16");
  sl.packet_sequence_bits = static_cast<uint8_t>(in.u(5, "packetSeqNumLength"));
  if (sl.packet_sequence_bits > 16) in.fail(Errc::malformed, "packetSeqNumLength is more than 16");
  reserved(in, 2, 3);
  if (sl.has_duration) {
    sl.time_scale = in.u(32, "timeScale");
    sl.access_unit_duration = static_cast<uint16_t>(in.u(16, "accessUnitDuration"));
    sl.composition_unit_duration = static_cast<uint16_t>(in.u(16, "compositionUnitDuration"));
  }
  if (!sl.time_stamps && in.ok()) {
    sl.start_decoding_time = wide(in, sl.time_stamp_bits, "startDecodingTimeStamp");
    sl.start_composition_time = wide(in, sl.time_stamp_bits, "startCompositionTimeStamp");
  }
  in.align(diagnostics_);
  return sl;
}

}  // namespace

Result<Descriptors> read_descriptors(std::span<const uint8_t> data,
                                     const DescriptorReadOptions& options,
                                     Diagnostics& diagnostics) {
  BitReader in(data, options.trace);
  in.seek(uint64_t{options.begin} * 8);
  DescriptorReader reader(data, options, diagnostics);
  Descriptors descriptors = reader.parts(in, options.path, 0);
  if (reader.error_) return *reader.error_;
  return descriptors;
}

}  // namespace afx::bifs
