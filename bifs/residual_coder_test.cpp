// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The arithmetic code of predictive fields by hand, and against the coder of H.263 Annex E written
// out bit by bit.
#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <string>

#include "bifs/residual_decoder.h"
#include "bifs/residual_encoder.h"

namespace afx::bifs {

namespace {

std::string text(const std::vector<bool>& bits) {
  std::string out;
  for (const bool bit : bits) out += bit ? '1' : '0';
  return out;
}

std::vector<uint8_t> bytes(const std::string& bits) {
  std::vector<uint8_t> out((bits.size() + 7) / 8);
  for (size_t i = 0; i < bits.size(); ++i)
    if (bits[i] == '1') out[i / 8] = static_cast<uint8_t>(out[i / 8] | 0x80U >> i % 8);
  return out;
}

std::string encoded(uint32_t symbols, const std::vector<uint32_t>& message) {
  std::vector<bool> bits;
  FrequencyModel model(symbols);
  ResidualEncoder encoder(bits);
  for (const uint32_t symbol : message) encoder.encode(model, symbol);
  encoder.finish();
  return text(bits);
}

/// One bit at a time, with frequencies in a plain array.
std::string slowly_encoded(uint32_t symbols, const std::vector<uint32_t>& message) {
  std::vector<long> frequency(symbols, 1);
  long low = 0, high = 65535, opposite = 0, zeros = 0;
  std::string out;
  const auto put = [&](bool bit) {
    if (zeros == 22) out += '1';
    if (zeros == 22) zeros = 0;
    out += bit ? '1' : '0';
    zeros = bit ? 0 : zeros + 1;
  };
  const auto put_all = [&](bool bit) {
    put(bit);
    for (; opposite > 0; --opposite) put(!bit);
  };
  for (const uint32_t symbol : message) {
    const long total = std::accumulate(frequency.begin(), frequency.end(), 0L);
    const long above = std::accumulate(frequency.begin() + symbol + 1, frequency.end(), 0L);
    const long length = high - low + 1;
    high = low + length * (above + frequency[symbol]) / total - 1;
    low += length * above / total;
    for (;;) {
      if (high < 32768) {
        put_all(false);
      } else if (low >= 32768) {
        put_all(true);
        low -= 32768;
        high -= 32768;
      } else if (low >= 16384 && high < 49152) {
        ++opposite;
        low -= 16384;
        high -= 16384;
      } else {
        break;
      }
      low *= 2;
      high = 2 * high + 1;
    }
    if (total == 16383)
      for (long& f : frequency) f = (f + 1) / 2;
    ++frequency[symbol];
  }
  ++opposite;
  put_all(low >= 16384);
  return out;
}

}  // namespace

TEST(ResidualCode, OfThreeBinarySymbolsIsTheOneWorkedOutByHand) {
  // 0 of {1, 1}: the upper half, 1. 0 of {2, 1}: [21845, 65535], nothing. 1 of {3, 1}: the lowest
  // quarter of that, [21845, 32766], 01 and [21844, 65531]. The end: low >= 16384, 10.
  EXPECT_EQ(encoded(2, {0, 0, 1}), "10110");
}

TEST(ResidualCode, A1IsStuffedBehind22Zeros) {
  // 8191 of 8192 is [0, 7]: 13 zeros and [0, 65535]. Then 2 of 8193, [0, 14]: 12 zeros. The end 01.
  const std::string zeros(22, '0');
  EXPECT_EQ(encoded(8192, {8191, 8191}), zeros + "1" + "0000" + "1");
  const std::vector<uint8_t> good = bytes(zeros + "100001");
  const std::vector<uint8_t> bad = bytes(zeros + "000001");
  for (const auto& data : {good, bad}) {
    FrequencyModel model(8192);
    ResidualDecoder decoder(data, 0);
    EXPECT_EQ(decoder.decode(model), 8191U);
    EXPECT_TRUE(decoder.is_stuffed_well());  // the code of one symbol ends before the stuffing
    EXPECT_EQ(decoder.bits(), 15U);
    EXPECT_EQ(decoder.decode(model), 8191U);
    EXPECT_EQ(decoder.bits(), 28U);
    EXPECT_EQ(decoder.is_stuffed_well(), data == good);
  }
}

TEST(ResidualCode, IsThatOfTheCoderBitByBitAndComesBack) {
  std::mt19937 random(11);
  for (const uint32_t symbols : {1U, 2U, 16U, 256U, 8192U}) {
    std::vector<uint32_t> message(17000);       // enough to halve the frequencies
    if (symbols == 8192) message.resize(9000);  // full after 8191 symbols
    for (uint32_t& symbol : message) {
      const uint32_t r = static_cast<uint32_t>(random());
      symbol = r % 4 == 0 ? r / 4 % symbols : symbols - 1;  // the last one gives runs of zeros
    }
    const std::string expected = slowly_encoded(symbols, message);
    ASSERT_EQ(encoded(symbols, message), expected) << symbols;
    const std::vector<uint8_t> data = bytes("101" + expected + "1111");  // not at a byte
    FrequencyModel model(symbols);
    ResidualDecoder decoder(data, 3);
    for (const uint32_t symbol : message) ASSERT_EQ(decoder.decode(model), symbol) << symbols;
    EXPECT_EQ(decoder.bits(), expected.size());
    EXPECT_TRUE(decoder.ends_well());
    EXPECT_TRUE(decoder.is_stuffed_well());
  }
}

TEST(ResidualCode, PastTheEndOfTheDataAreZeros) {
  const std::vector<uint8_t> data = bytes("10110");
  FrequencyModel model(2);
  ResidualDecoder decoder(data, 0);
  EXPECT_TRUE(decoder.looked_past_end());  // 16 bits of 8
  for (const uint32_t symbol : {0U, 0U, 1U}) EXPECT_EQ(decoder.decode(model), symbol);
  EXPECT_EQ(decoder.bits(), 5U);
  for (int i = 0; i < 100000; ++i) (void)decoder.decode(model);
  EXPECT_GT(decoder.bits(), 8U);
}

}  // namespace afx::bifs
