// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/od_command.h"

#include <gtest/gtest.h>

namespace afx::bifs {
namespace {

using Bytes = std::vector<uint8_t>;

OdCommands read(const Bytes& bytes) {
  Diagnostics diagnostics;
  auto commands = read_od_commands(bytes, {}, diagnostics);
  EXPECT_TRUE(commands.ok()) << to_string(commands.error());
  EXPECT_EQ(diagnostics.count(), 0U);
  return commands.ok() ? commands.value() : OdCommands{};
}

Bytes write(const OdCommands& commands) {
  auto bytes = write_od_commands(commands);
  EXPECT_TRUE(bytes.ok());
  return bytes.ok() ? bytes.value() : Bytes{};
}

// The samples of vector 13 (GPAC); what they say is in its scene.bt.
const Bytes kUpdate = {0x01, 0x16, 0x11, 0x06, 0x05, 0x1F, 0x0F, 0x02, 0x00, 0x01, 0x11, 0x0C,
                       0x05, 0xFF, 0x09, 'o',  't',  'h',  'e',  'r',  '.',  'm',  'p',  '4'};
const Bytes kEsUpdate = {0x03, 0x06, 0x05, 0x03, 0xC0, 0x80, 0x00, 0x80};
const Bytes kEsRemove = {0x07, 0x04, 0x05, 0x00, 0x00, 0x02};
const Bytes kRemove = {0x02, 0x03, 0x05, 0x01, 0x70};

TEST(OdCommand, SamplesOfTheVectorSayWhatItsTextSays) {
  ObjectDescriptor still;
  still.id = 20;
  still.parts.push_back({EsIdRef{1}});
  ObjectDescriptor remote;
  remote.id = 23;
  remote.url = "other.mp4";
  EXPECT_EQ(read(kUpdate), (OdCommands{{OdUpdate{{{still}, {remote}}}}}));
  EXPECT_EQ(read(kEsUpdate), (OdCommands{{EsUpdate{20, false, {{EsIdRef{2}}}}}}));
  EXPECT_EQ(read(kEsRemove), (OdCommands{{EsRemove{20, true, {2}}}}));
  EXPECT_EQ(read(kRemove), (OdCommands{{OdRemove{{20, 23}}}}));
}

TEST(OdCommand, AnAlignedStreamUpdateIsReadToo) {
  const Bytes reference = {0x03, 0x06, 0x05, 0x00, 0x0F, 0x02, 0x00, 0x02};
  EXPECT_EQ(read(reference), (OdCommands{{EsUpdate{20, true, {{EsIdRef{2}}}}}}));
  EXPECT_EQ(write(read(reference)), reference);
  // Unaligned tag 3: six zero bits, then 11.
  EsDescriptor es;
  es.es_id = 7;
  for (const bool aligned : {false, true}) {
    const OdCommands update = {{EsUpdate{20, aligned, {{es}}}}};
    EXPECT_EQ(read(write(update)), update) << aligned;
  }
}

TEST(OdCommand, WhatIsReadWithoutAWarningIsWrittenBackByteForByte) {
  Bytes all;
  for (const Bytes& one : {kUpdate, kEsUpdate, kEsRemove, kRemove}) {
    EXPECT_EQ(write(read(one)), one);
    all.insert(all.end(), one.begin(), one.end());
  }
  EXPECT_EQ(write(read(all)), all);
  const Bytes unknown = {0x05, 0x80, 0x02, 0xAB, 0xCD, 0x04, 0x04, 0x05, 0x00, 0x00, 0x1F};
  EXPECT_EQ(write(read(unknown)), unknown);
}

TEST(OdCommand, EveryTruncationIsACleanErrorOrAWholeCommand) {
  for (const Bytes& whole : {kUpdate, kEsUpdate, kEsRemove, kRemove}) {
    for (size_t size = 1; size < whole.size(); ++size) {
      const Bytes cut(whole.begin(), whole.begin() + static_cast<ptrdiff_t>(size));
      Diagnostics diagnostics;
      const auto commands = read_od_commands(cut, {}, diagnostics);
      ASSERT_FALSE(commands.ok());
      EXPECT_EQ(commands.error().code, Errc::truncated);
      EXPECT_LE(commands.error().place.bit, size * 8);
    }
  }
}

TEST(OdCommand, ErrorsInAShiftedDescriptorHaveTheirTruePlace) {
  // As kEsUpdate with a length of 3: the descriptor begins at bit 10 of the payload, its length
  // ends at bit 16 + 10 + 16; the last element read begins 7 bits before that.
  const Bytes bytes = {0x03, 0x06, 0x05, 0x03, 0xC0, 0xC0, 0x00, 0x80};
  Diagnostics diagnostics;
  const auto commands = read_od_commands(bytes, {}, diagnostics);
  ASSERT_FALSE(commands.ok());
  EXPECT_EQ(commands.error().place, Place::at_bit(16 + 10 + 16 - 7));
  EXPECT_EQ(
      commands.error().text,
      "ES_DescriptorUpdate/ES_ID_Ref: ends behind the data that it is in (expected 3 bytes, 2 "
      "are left)");
}

TEST(OdCommand, TheWriterRefusesWhatDoesNotFit) {
  const OdCommands cases = {{OdRemove{{1024}}},
                            {EsUpdate{1024, false, {}}},
                            {EsRemove{1024, false, {}}},
                            {UnknownOdCommand{1, {}}}};
  for (const OdCommand& command : cases) {
    const auto written = write_od_commands({command});
    ASSERT_FALSE(written.ok());
    EXPECT_EQ(written.error().code, Errc::bad_argument);
  }
}

}  // namespace
}  // namespace afx::bifs
