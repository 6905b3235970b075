// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "codec/bit_reader.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "codec/bit_writer.h"

namespace afx::codec {
namespace {

/// Numbers as the bits that they are to become, and those as bytes: by hand, bit by bit.
class BitText {
 public:
  void add(uint32_t value, unsigned bits) {
    for (unsigned bit = bits; bit-- > 0;) text_ += (value >> bit & 1U) != 0 ? '1' : '0';
  }
  [[nodiscard]] std::vector<uint8_t> bytes() const {
    std::vector<uint8_t> bytes((text_.size() + 7) / 8);
    for (size_t i = 0; i < text_.size(); ++i)
      bytes[i / 8] = static_cast<uint8_t>(bytes[i / 8] | (text_[i] - '0') << (7 - i % 8));
    return bytes;
  }

 private:
  std::string text_;
};

uint32_t some_number(size_t i, unsigned bits) {
  const uint32_t mixed = static_cast<uint32_t>(i + 1) * 2654435761U;
  return bits == 32 ? mixed : mixed & ((uint32_t{1} << bits) - 1);
}

constexpr size_t kRunLength = 13;

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

TEST(BitReader, ReadsAllWidthsAtAllAlignments) {
  for (unsigned bits = 0; bits <= 32; ++bits) {
    for (unsigned before = 0; before < 8; ++before) {
      BitText text;
      text.add(some_number(0, before), before);
      for (size_t i = 0; i < kRunLength; ++i) text.add(some_number(i, bits), bits);
      const std::vector<uint8_t> data = text.bytes();
      BitReader single(data), run_reader(data);
      EXPECT_EQ(single.u(before, "before"), some_number(0, before));
      run_reader.u(before, "before");
      ASSERT_TRUE(run_reader.has_run(kRunLength, bits));
      BitReader::Run run = run_reader.run(kRunLength, bits);
      for (size_t i = 0; i < kRunLength; ++i) {
        EXPECT_EQ(single.u(bits, "number"), some_number(i, bits)) << bits << ' ' << before;
        EXPECT_EQ(run.u(), some_number(i, bits)) << bits << ' ' << before;
      }
      EXPECT_TRUE(single.ok());
      EXPECT_EQ(run_reader.bit(), single.bit());
    }
  }
}

TEST(BitReader, ARunIsThereOnlyIfAllOfItIsAndNobodyListens) {
  const std::vector<uint8_t> data(8);
  const Trace trace = [](const TraceElement&) {};
  EXPECT_TRUE(BitReader(data).has_run(2, 32));
  EXPECT_FALSE(BitReader(data).has_run(3, 32));
  EXPECT_FALSE(BitReader(data).has_run(UINT64_MAX, 8));
  EXPECT_TRUE(BitReader(data).has_run(UINT64_MAX, 0));
  EXPECT_FALSE(BitReader(data, &trace).has_run(2, 32));
  BitReader failed(data);
  failed.fail(Errc::malformed, "odd");
  EXPECT_FALSE(failed.has_run(2, 32));
}

TEST(BitReader, AfterARunFailuresAreAtItsLastNumber) {
  const std::vector<uint8_t> data(8);
  BitReader in(data);
  (void)in.run(4, 7);
  in.fail(Errc::malformed, "odd");
  EXPECT_EQ(in.error().place, Place::at_bit(21));
}

TEST(BitReader, ReadsBytesAtAllAlignments) {
  for (unsigned before = 0; before < 8; ++before) {
    BitText text;
    text.add(0, before);
    for (size_t i = 0; i < kRunLength; ++i) text.add(some_number(i, 8), 8);
    const std::vector<uint8_t> data = text.bytes();
    size_t heard = 0;
    const Trace trace = [&](const TraceElement& e) { heard += e.path == "bytes" ? 1 : 0; };
    for (const Trace* listener : {static_cast<const Trace*>(nullptr), &trace}) {
      BitReader in(data, listener);
      in.u(before, "before");
      std::vector<uint8_t> out(kRunLength);
      in.bytes(out, "bytes");
      EXPECT_TRUE(in.ok());
      EXPECT_EQ(in.bit(), before + kRunLength * 8);
      for (size_t i = 0; i < kRunLength; ++i) EXPECT_EQ(out[i], some_number(i, 8)) << before;
    }
    EXPECT_EQ(heard, kRunLength);
  }
}

TEST(BitReader, SaysWhereBytesEnd) {
  const std::vector<uint8_t> data(3);
  BitReader in(data);
  in.u(1, "flag");
  std::vector<uint8_t> out(3, 7);
  in.bytes(out, "text");
  ASSERT_FALSE(in.ok());
  EXPECT_EQ(in.error().place, Place::at_bit(1));
  EXPECT_EQ(in.error().text, "the data end inside text (expected 3 bytes, 2 are left)");
  EXPECT_EQ(out, std::vector<uint8_t>(3, 7));
}

TEST(BitWriter, WritesAllWidthsAtAllAlignments) {
  for (unsigned bits = 0; bits <= 32; ++bits) {
    for (unsigned before = 0; before < 8; ++before) {
      BitText text;
      std::vector<uint8_t> one_by_one, as_run;
      BitWriter single(one_by_one), run_writer(as_run);
      text.add(some_number(0, before), before);
      single.u(some_number(0, before), before);
      run_writer.u(some_number(0, before), before);
      {
        BitWriter::Run run(run_writer, kRunLength, bits);
        for (size_t i = 0; i < kRunLength; ++i) {
          text.add(some_number(i, bits), bits);
          single.u(some_number(i, bits), bits);
          run.u(some_number(i, bits));
        }
      }
      EXPECT_EQ(one_by_one, text.bytes()) << bits << ' ' << before;
      EXPECT_EQ(as_run, text.bytes()) << bits << ' ' << before;
      text.add(5, 3);  // and what follows stands right behind
      single.u(5, 3);
      run_writer.u(5, 3);
      EXPECT_EQ(one_by_one, text.bytes()) << bits << ' ' << before;
      EXPECT_EQ(as_run, text.bytes()) << bits << ' ' << before;
    }
  }
}

TEST(BitWriter, WritesBytesAtAllAlignments) {
  const std::vector<uint8_t> data{0x01, 0xFE, 0x80, 0x7F, 0x55};
  for (unsigned before = 0; before < 8; ++before) {
    BitText text;
    std::vector<uint8_t> out;
    BitWriter writer(out);
    text.add(some_number(0, before), before);
    writer.u(some_number(0, before), before);
    for (const uint8_t byte : data) text.add(byte, 8);
    writer.bytes(data);
    text.add(1, 2);
    writer.u(1, 2);
    EXPECT_EQ(out, text.bytes()) << before;
  }
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
