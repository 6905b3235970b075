// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Object descriptors: which elementary streams there are and how each is coded. ISO/IEC 14496-1
// (clauses not checked); in MP4 files as ISO/IEC 14496-14 stores them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace afx::bifs {

struct Descriptor;

/// Descriptors and what stands inside them, in the order of the stream.
using Descriptors = std::vector<Descriptor>;

/// streamType of a DecoderConfigDescriptor.
namespace stream_type {
constexpr uint8_t kObjectDescriptor = 1, kClockReference = 2, kScene = 3, kVisual = 4, kAudio = 5,
                  kInteraction = 10;
}  // namespace stream_type

/// objectTypeIndication; the numbers below 0x20 hold together with a stream type.
namespace object_type {
constexpr uint8_t kBifs = 0x01, kBifsV2 = 0x02, kBifsExtended = 0x04;  ///< stream type scene
constexpr uint8_t kAfx = 0x05;                                         ///< stream type scene
constexpr uint8_t kObjectDescriptor = 0x01;  ///< stream type object descriptor
constexpr uint8_t kMpeg4Visual = 0x20, kAvc = 0x21, kHevc = 0x23, kJpeg = 0x6C, kPng = 0x6D,
                  kJpeg2000 = 0x6E;  ///< stream type visual
}  // namespace object_type

/// Tags of the descriptors that have a form of their own here.
namespace descriptor_tag {
constexpr uint8_t kObject = 0x01, kInitialObject = 0x02, kEs = 0x03, kDecoderConfig = 0x04,
                  kDecoderSpecificInfo = 0x05, kSlConfig = 0x06, kEsIdInc = 0x0E, kEsIdRef = 0x0F,
                  kInitialObjectInFile = 0x10, kObjectInFile = 0x11;
}  // namespace descriptor_tag

/// ObjectDescriptor: one object, such as an image, and its streams.
struct ObjectDescriptor {
  bool in_file = true;  ///< the form of MP4 files (tag 0x11), otherwise of streams (tag 1)
  uint16_t id = 1;      ///< 0..1023; 0 is forbidden, 1023 reserved
  std::optional<std::string> url;  ///< up to 255 bytes: the object is described there
  Descriptors parts;               ///< ES_Descriptor, EsIdRef (in files) and others
  bool operator==(const ObjectDescriptor&) const = default;
};

/// InitialObjectDescriptor: where reading a presentation begins; names the scene stream and the
/// stream of object descriptors.
struct InitialObjectDescriptor {
  bool in_file = true;             ///< tag 0x10, otherwise tag 2
  uint16_t id = 1;                 ///< 0..1023
  bool inline_profiles = false;    ///< the profiles hold for inlined scenes too
  std::optional<std::string> url;  ///< up to 255 bytes; then there are no profiles
  uint8_t od_profile = 0xFF;       ///< 0xFE unspecified, 0xFF none required
  uint8_t scene_profile = 0xFE;    ///< likewise, as the three below
  uint8_t audio_profile = 0xFF;
  uint8_t visual_profile = 0xFE;
  uint8_t graphics_profile = 0xFE;
  Descriptors parts;  ///< ES_Descriptor, EsIdInc (in files) and others
  bool operator==(const InitialObjectDescriptor&) const = default;
};

/// Where a text says the access units of a stream are to be taken from (MuxInfo of BT, StreamSource
/// of XMT-A). It stands in no bitstream.
struct MediaSource {
  std::string file;    ///< a picture, an AFX stream; "scene.mp4#20": track 20 of that file
  std::string format;  ///< streamFormat: what it is, where its content does not tell; mostly empty
  bool operator==(const MediaSource&) const = default;
};

/// ES_Descriptor: one elementary stream.
struct EsDescriptor {
  uint16_t es_id = 0;                  ///< 0 in MP4 files, where the track ID stands for it
  std::optional<uint16_t> depends_on;  ///< ES_ID of the stream this one needs
  std::optional<std::string> url;      ///< up to 255 bytes
  std::optional<uint16_t> ocr_es_id;   ///< ES_ID of the clock reference stream
  uint8_t priority = 0;                ///< 0..31
  Descriptors parts;                   ///< DecoderConfig, SlConfig, then others
  std::optional<MediaSource> source = std::nullopt;  ///< in texts only
  bool operator==(const EsDescriptor&) const = default;
};

/// DecoderConfigDescriptor: what decoder a stream needs.
struct DecoderConfig {
  uint8_t object_type = 0;    ///< objectTypeIndication, see object_type
  uint8_t stream_type = 0;    ///< 0..63, see stream_type
  bool up_stream = false;     ///< goes from the receiver to the sender
  uint32_t buffer_bytes = 0;  ///< bufferSizeDB, 24 bits
  uint32_t max_bitrate = 0;   ///< bits a second
  uint32_t avg_bitrate = 0;   ///< bits a second, 0: varies
  Descriptors parts;          ///< DecoderSpecificInfo and others
  bool operator==(const DecoderConfig&) const = default;
};

/// DecoderSpecificInfo: bytes for the decoder, e.g. a BIFSConfig.
struct DecoderSpecificInfo {
  std::vector<uint8_t> bytes;
  bool operator==(const DecoderSpecificInfo&) const = default;
};

/// The fields of an SLConfigDescriptor that is not predefined.
struct SlFields {
  bool access_unit_start = false;
  bool access_unit_end = false;
  bool random_access_point = false;
  bool random_access_units_only = false;
  bool padding = false;
  bool time_stamps = true;
  bool idle = false;
  bool has_duration = false;
  uint32_t time_stamp_resolution = 1000;  ///< ticks a second
  uint32_t ocr_resolution = 0;
  uint8_t time_stamp_bits = 0;  ///< 0..64
  uint8_t ocr_bits = 0;         ///< 0..64
  uint8_t au_length_bits = 0;   ///< 0..32
  uint8_t instant_bitrate_bits = 0;
  uint8_t degradation_priority_bits = 0;  ///< 0..15
  uint8_t au_sequence_bits = 0;           ///< 0..16
  uint8_t packet_sequence_bits = 0;       ///< 0..16
  uint32_t time_scale = 0;                ///< these three: has_duration
  uint16_t access_unit_duration = 0;
  uint16_t composition_unit_duration = 0;
  uint64_t start_decoding_time = 0;  ///< these two: not time_stamps; in time_stamp_bits
  uint64_t start_composition_time = 0;
  bool operator==(const SlFields&) const = default;
};

/// SLConfigDescriptor: how access units are packed. In MP4 files predefined is 2 and nothing
/// follows.
struct SlConfig {
  uint8_t predefined = 2;          ///< 0: `fields` are there, otherwise they are not
  std::optional<SlFields> fields;  ///< layout from general knowledge of 14496-1, not verified
  std::vector<uint8_t> rest;       ///< bytes behind that, kept
  bool operator==(const SlConfig&) const = default;
};

/// ES_ID_Inc: in an MP4 file, a stream by its track.
struct EsIdInc {
  uint32_t track_id = 0;
  bool operator==(const EsIdInc&) const = default;
};

/// ES_ID_Ref: in an MP4 file, a stream by its place in the 'mpod' reference of the track with the
/// object descriptors.
struct EsIdRef {
  uint16_t index = 0;  ///< from 1
  bool operator==(const EsIdRef&) const = default;
};

/// Any other descriptor: kept and written back.
struct UnknownDescriptor {
  uint8_t tag = 0;
  std::vector<uint8_t> payload;
  bool operator==(const UnknownDescriptor&) const = default;
};

/// One descriptor of any kind.
struct Descriptor {
  std::variant<UnknownDescriptor, ObjectDescriptor, InitialObjectDescriptor, EsDescriptor,
               DecoderConfig, DecoderSpecificInfo, SlConfig, EsIdInc, EsIdRef>
      body;
  uint8_t length_bytes = 0;  ///< bytes its length takes, 1..4; 0: as few as it needs
  bool operator==(const Descriptor&) const = default;
};

/// The tag a descriptor is written with.
uint8_t tag_of(const Descriptor& descriptor);

/// The first part of a kind, e.g. find_part<DecoderConfig>(es.parts); null where there is none.
/// Valid as long as `parts` is left alone.
template <class T>
const T* find_part(const Descriptors& parts) {
  for (const Descriptor& part : parts) {
    if (const T* found = std::get_if<T>(&part.body)) return found;
  }
  return nullptr;
}

/// The bytes of the DecoderSpecificInfo of a stream; empty where there is none.
std::vector<uint8_t> decoder_specific_info(const EsDescriptor& es);

/// An ES_Descriptor as MP4 files hold it: ES_ID 0, the configuration with its DecoderSpecificInfo
/// (left out where `info` is empty), SLConfig predefined 2.
EsDescriptor es_descriptor_in_file(DecoderConfig config, std::vector<uint8_t> info);

}  // namespace afx::bifs
