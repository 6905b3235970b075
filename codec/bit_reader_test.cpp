// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "codec/bit_reader.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "codec/bit_writer.h"

namespace afx::codec {
namespace {

TEST(BitReader, ReadsMostSignificantBitFirst) {
  const std::vector<uint8_t> data{0b10110011, 0b01000000};
  BitReader in(data);
  EXPECT_EQ(in.u(1, "a"), 1U);
  EXPECT_EQ(in.u(3, "b"), 3U);
  EXPECT_EQ(in.u(6, "c"), 0b001101U);
  EXPECT_EQ(in.bit(), 10U);
  EXPECT_EQ(in.bits_left(), 6U);
}

TEST(BitReader, ReadsThirtyTwoBitsAcrossFiveBytes) {
  const std::vector<uint8_t> data{0x01, 0x23, 0x45, 0x67, 0x89};
  BitReader in(data);
  in.u(4, "a");
  EXPECT_EQ(in.u(32, "b"), 0x12345678U);
}

TEST(BitReader, WidthZeroIsZeroAndTakesNothing) {
  BitReader in(std::span<const uint8_t>{});
  EXPECT_EQ(in.u(0, "nothing"), 0U);
  EXPECT_TRUE(in.ok());
}

TEST(BitReader, FailsWhereTheDataEndAndSaysWhere) {
  const std::vector<uint8_t> data{0xFF};
  BitReader in(data);
  const BitReader::Scope scope(in, "header");
  in.u(5, "first");
  EXPECT_EQ(in.u(4, "second"), 0U);
  ASSERT_FALSE(in.ok());
  EXPECT_EQ(in.error().code, Errc::truncated);
  EXPECT_EQ(in.error().place, Place::at_bit(5));
  EXPECT_EQ(in.error().text, "the data end inside header/second (expected 4 bits, 3 are left)");
}

TEST(BitReader, TheFirstFailureSticks) {
  const std::vector<uint8_t> data{0xFF, 0xFF};
  BitReader in(data);
  in.u(8, "a");
  in.fail(Errc::malformed, "first");
  in.fail(Errc::truncated, "second");
  EXPECT_EQ(in.u(8, "b"), 0U);
  EXPECT_EQ(in.error().text, "first");
  EXPECT_EQ(in.error().place, Place::at_bit(0));
}

TEST(BitReader, WarnsOfBitsInAnAlign) {
  const std::vector<uint8_t> data{0b10000000, 0b10010000, 0};
  BitReader in(data);
  Diagnostics diagnostics;
  in.u(1, "a");
  in.align(diagnostics);
  EXPECT_EQ(diagnostics.count(), 0U);
  in.u(1, "b");
  in.align(diagnostics);
  ASSERT_EQ(diagnostics.count(), 1U);
  EXPECT_EQ(diagnostics.warnings()[0].place, Place::at_bit(9));
  in.align(diagnostics);
  EXPECT_EQ(in.bit(), 16U);
}

TEST(BitReader, TracesEveryElementWithItsPath) {
  const std::vector<uint8_t> data{0b01100000};
  std::string seen;
  const Trace trace = [&](const TraceElement& e) {
    seen += std::to_string(e.bit) + " " + std::to_string(e.width) + " " + std::string(e.path) +
            " " + std::to_string(e.value) + "\n";
  };
  BitReader in(data, &trace);
  in.u(1, "outside");
  {
    const BitReader::Scope scope(in, "part");
    in.u(2, "inside");
  }
  in.u(1, "after");
  EXPECT_EQ(seen, "0 1 outside 0\n1 2 part/inside 3\n3 1 after 0\n");
}

TEST(BitWriter, WritesWhatTheReaderReads) {
  std::vector<uint8_t> out;
  BitWriter writer(out);
  writer.u(5, 3);
  writer.u(0, 0);
  writer.u(0xDEADBEEF, 32);
  writer.align();
  writer.u(1, 1);
  // 101 11011110101011011011111011101111 00000 1 0000000
  EXPECT_EQ(out, (std::vector<uint8_t>{0xBB, 0xD5, 0xB7, 0xDD, 0xE0, 0x80}));
}

TEST(Error, PrintsFilePlaceAndText) {
  const Error bits{Errc::malformed, Place::at_bit(13), "odd"};
  EXPECT_EQ(to_string(bits, "a.afx"), "a.afx:1.5: odd");
  const Error text{Errc::malformed, Place::at_line(3, 7), "odd"};
  EXPECT_EQ(to_string(text, "a.wrl"), "a.wrl:3:7: odd");
  const Error bare{Errc::malformed, Place::none(), "odd"};
  EXPECT_EQ(to_string(bare), "odd");
}

TEST(Diagnostics, KeepsTheFirstHundredAndCountsAll) {
  Diagnostics diagnostics;
  for (int i = 0; i < 1000; ++i) diagnostics.warn("w", Place::none(), std::to_string(i));
  Diagnostics sum;
  sum.append(diagnostics);
  sum.append(diagnostics);
  EXPECT_EQ(sum.count(), 2000U);
  EXPECT_EQ(sum.warnings().size(), 100U);
  EXPECT_EQ(sum.warnings()[99].text, "99");
}

}  // namespace
}  // namespace afx::codec
