// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/descriptor.h"

#include <gtest/gtest.h>

#include <string>

#include "bifs/descriptor_reader.h"
#include "bifs/descriptor_writer.h"

namespace afx::bifs {
namespace {

using Bytes = std::vector<uint8_t>;

Result<Descriptors> read(const Bytes& bytes, Diagnostics& diagnostics, const Limits& limits = {}) {
  return read_descriptors(bytes, {.limits = limits}, diagnostics);
}

// From the specification text of this project; the fields by hand.
const Bytes kInitial = {0x10, 0x13, 0x00, 0x4F, 0x01, 0xFE, 0x00, 0x00, 0xFE, 0x0E, 0x04,
                        0x00, 0x00, 0x00, 0x01, 0x0E, 0x04, 0x00, 0x00, 0x00, 0x02};
// The scene stream of vector 13.
const Bytes kScene = {0x03, 0x1D, 0x00, 0x00, 0x00, 0x04, 0x15, 0x01, 0x0D, 0x00, 0x00,
                      0xAE, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x05, 0x06,
                      0x10, 0x38, 0x02, 0x00, 0x01, 0x80, 0x06, 0x01, 0x02};
// SLConfig with every part: resolution 1000, 33-bit time stamps 1 and 2, a duration.
const Bytes kSl = {0x06, 0x21, 0x00, 0x81, 0x00, 0x00, 0x03, 0xE8, 0x00, 0x00, 0x00, 0x00,
                   0x21, 0x00, 0x00, 0x00, 0x00, 0x03, 0x00, 0x00, 0x00, 0x19, 0x00, 0x01,
                   0x00, 0x02, 0x00, 0x00, 0x00, 0x00, 0x80, 0x00, 0x00, 0x00, 0x80};

TEST(Descriptor, InitialObjectDescriptorOfTheTextHasTheFieldsOfTheText) {
  Diagnostics diagnostics;
  const auto read_back = read(kInitial, diagnostics);
  ASSERT_TRUE(read_back.ok()) << to_string(read_back.error());
  ASSERT_EQ(read_back.value().size(), 1U);
  const auto* object = std::get_if<InitialObjectDescriptor>(&read_back.value()[0].body);
  ASSERT_NE(object, nullptr);
  EXPECT_TRUE(object->in_file);
  EXPECT_EQ(object->id, 1);
  EXPECT_FALSE(object->url);
  EXPECT_EQ(object->od_profile, 0x01);
  EXPECT_EQ(object->scene_profile, 0xFE);
  EXPECT_EQ(object->audio_profile, 0);
  EXPECT_EQ(object->graphics_profile, 0xFE);
  ASSERT_EQ(object->parts.size(), 2U);
  EXPECT_EQ(std::get<EsIdInc>(object->parts[0].body).track_id, 1U);
  EXPECT_EQ(std::get<EsIdInc>(object->parts[1].body).track_id, 2U);
  EXPECT_EQ(diagnostics.count(), 0U);
}

TEST(Descriptor, SceneStreamHasItsDecoderConfiguration) {
  Diagnostics diagnostics;
  const auto read_back = read(kScene, diagnostics);
  ASSERT_TRUE(read_back.ok());
  const auto& es = std::get<EsDescriptor>(read_back.value()[0].body);
  const auto* config = find_part<DecoderConfig>(es.parts);
  ASSERT_NE(config, nullptr);
  EXPECT_EQ(config->object_type, object_type::kBifs);
  EXPECT_EQ(config->stream_type, stream_type::kScene);
  EXPECT_EQ(config->buffer_bytes, 0xAEU);
  EXPECT_EQ(decoder_specific_info(es), (Bytes{0x10, 0x38, 0x02, 0x00, 0x01, 0x80}));
  EXPECT_EQ(find_part<SlConfig>(es.parts)->predefined, 2);
}

TEST(Descriptor, BuiltForAFileIsWhatGpacWritesForTheSameStream) {
  DecoderConfig config;
  config.object_type = object_type::kBifs;
  config.stream_type = stream_type::kScene;
  config.buffer_bytes = 0xAE;
  const auto written =
      write_descriptors({{es_descriptor_in_file(config, {0x10, 0x38, 0x02, 0x00, 0x01, 0x80})}});
  ASSERT_TRUE(written.ok());
  EXPECT_EQ(written.value(), kScene);
}

TEST(Descriptor, SlConfigWithAllFieldsIsReadByItsWidths) {
  Diagnostics diagnostics;
  const auto read_back = read(kSl, diagnostics);
  ASSERT_TRUE(read_back.ok()) << to_string(read_back.error());
  const SlFields& sl = *std::get<SlConfig>(read_back.value()[0].body).fields;
  EXPECT_TRUE(sl.access_unit_start);
  EXPECT_TRUE(sl.has_duration);
  EXPECT_FALSE(sl.time_stamps);
  EXPECT_EQ(sl.time_stamp_resolution, 1000U);
  EXPECT_EQ(sl.time_scale, 25U);
  EXPECT_EQ(sl.access_unit_duration, 1);
  EXPECT_EQ(sl.composition_unit_duration, 2);
  EXPECT_EQ(sl.start_decoding_time, 1U);
  EXPECT_EQ(sl.start_composition_time, 2U);
  EXPECT_EQ(diagnostics.count(), 0U);
}

TEST(Descriptor, WhatIsReadWithoutAWarningIsWrittenBackByteForByte) {
  const std::vector<Bytes> cases = {
      kInitial,
      kScene,
      kSl,
      {0x01, 0x08, 0x05, 0xFF, 0x03, 'a', '.', 'b', 0x15, 0x00},  // URL, then an unknown one
      {0x11, 0x80, 0x80, 0x80, 0x02, 0x05, 0x1F},                 // the length in 4 bytes
      {0x03, 0x09, 0x00, 0x07, 0xFF, 0x00, 0x02, 0x01, 'u', 0x00, 0x03},  // every option of an ES
      {0x02, 0x05, 0x05, 0xFF, 0x02, 'o', 'k'},  // no profiles beside a URL
      {0x6A, 0x81, 0x00, 0x00},                  // cut: see below
  };
  for (size_t i = 0; i + 1 < cases.size(); ++i) {
    Diagnostics diagnostics;
    const auto read_back = read(cases[i], diagnostics);
    ASSERT_TRUE(read_back.ok()) << i << ": " << to_string(read_back.error());
    EXPECT_EQ(diagnostics.count(), 0U) << i;
    const auto written = write_descriptors(read_back.value());
    ASSERT_TRUE(written.ok()) << i;
    EXPECT_EQ(written.value(), cases[i]) << i;
  }
  Diagnostics diagnostics;
  EXPECT_FALSE(read(cases.back(), diagnostics).ok());
}

TEST(Descriptor, EveryTruncationIsAnErrorInsideTheData) {
  for (const Bytes& whole : {kInitial, kScene, kSl}) {
    for (size_t size = 1; size < whole.size(); ++size) {
      const Bytes cut(whole.begin(), whole.begin() + static_cast<ptrdiff_t>(size));
      Diagnostics diagnostics;
      const auto read_back = read(cut, diagnostics);
      ASSERT_FALSE(read_back.ok()) << size;
      EXPECT_EQ(read_back.error().code, Errc::truncated) << size;
      EXPECT_LE(read_back.error().place.bit, size * 8);
    }
  }
}

TEST(Descriptor, DamageIsNamedWithItsPlace) {
  const struct {
    Bytes bytes;
    Errc code;
    uint64_t bit;
    const char* text;
  } cases[] = {
      {{0x00, 0x00}, Errc::malformed, 0, "tag is 0"},
      {{0xFF, 0x00}, Errc::malformed, 0, "tag is 255"},
      {{0x05, 0x80, 0x80, 0x80, 0x80, 0x00}, Errc::malformed, 33, "more than 4 bytes"},
      {{0x0F, 0x01, 0x00}, Errc::truncated, 16, "ES_ID_Ref/ref_index"},
      {{0x11, 0x04, 0x00, 0x5F, 0x0F, 0x03}, Errc::truncated, 41, "ObjectDescriptor/ES_ID_Ref"},
      {{0x11, 0x03, 0x00, 0x7F, 0x02}, Errc::truncated, 32, "URLstring"},
  };
  for (const auto& damage : cases) {
    Diagnostics diagnostics;
    const auto read_back = read(damage.bytes, diagnostics);
    ASSERT_FALSE(read_back.ok()) << damage.text;
    EXPECT_EQ(read_back.error().code, damage.code) << damage.text;
    EXPECT_EQ(read_back.error().place, Place::at_bit(damage.bit)) << damage.text;
    EXPECT_NE(read_back.error().text.find(damage.text), std::string::npos)
        << read_back.error().text;
  }
}

/// ES_Descriptors, each the part of the one before; at most 24, so that lengths fit one byte.
Bytes nested(unsigned depth) {
  Bytes bytes;
  for (unsigned i = 0; i < depth; ++i) {
    Bytes outer = {0x03, static_cast<uint8_t>(bytes.size() + 3), 0, 1, 0};
    outer.insert(outer.end(), bytes.begin(), bytes.end());
    bytes = outer;
  }
  return bytes;
}

TEST(Descriptor, NestingDeeperThanTheLimitIsRefused) {
  Diagnostics diagnostics;
  EXPECT_TRUE(read(nested(kMaxDescriptorDepth), diagnostics).ok());
  const auto read_back = read(nested(kMaxDescriptorDepth + 1), diagnostics);
  ASSERT_FALSE(read_back.ok());
  EXPECT_EQ(read_back.error().code, Errc::limit_exceeded);
}

TEST(Descriptor, ManyEmptyDescriptorsStayWithinTheMemoryLimit) {
  Bytes bytes;
  for (int i = 0; i < 1000; ++i) bytes.insert(bytes.end(), {0x40, 0x00});
  Limits limits;
  limits.memory = 1000 * sizeof(Descriptor);
  Diagnostics diagnostics;
  EXPECT_TRUE(read(bytes, diagnostics, limits).ok());
  --limits.memory;
  const auto read_back = read(bytes, diagnostics, limits);
  ASSERT_FALSE(read_back.ok());
  EXPECT_EQ(read_back.error().code, Errc::limit_exceeded);
}

TEST(Descriptor, ReservedBitsAndTrailingBytesAreWarnings) {
  Diagnostics diagnostics;
  const auto read_back = read({0x11, 0x02, 0x05, 0x00, 0x0F, 0x03, 0x00, 0x01, 0x09}, diagnostics);
  ASSERT_TRUE(read_back.ok()) << to_string(read_back.error());
  ASSERT_EQ(diagnostics.warnings().size(), 2U);
  EXPECT_EQ(diagnostics.warnings()[0].code, "reserved_bits");
  EXPECT_EQ(diagnostics.warnings()[0].place, Place::at_bit(27));
  EXPECT_EQ(diagnostics.warnings()[1].code, "trailing_bytes");
  EXPECT_EQ(diagnostics.warnings()[1].place, Place::at_byte(8));
}

TEST(Descriptor, TheWriterRefusesWhatDoesNotFit) {
  ObjectDescriptor object;
  object.id = 1024;
  EsDescriptor es;
  es.url = std::string(256, 'u');
  DecoderConfig config;
  config.buffer_bytes = 1U << 24;
  SlConfig sl;
  sl.predefined = 0;
  const Descriptors cases = {{object}, {es}, {config}, {sl}, {UnknownDescriptor{0x03, {}}}};
  for (const Descriptor& descriptor : cases) {
    const auto written = write_descriptors({descriptor});
    ASSERT_FALSE(written.ok()) << int{tag_of(descriptor)};
    EXPECT_EQ(written.error().code, Errc::bad_argument);
  }
}

}  // namespace
}  // namespace afx::bifs
