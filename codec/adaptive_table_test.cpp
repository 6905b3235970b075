// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "codec/adaptive_table.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <vector>

#include "codec/arithmetic_interval.h"

namespace afx::codec {
namespace {

/// The table as the text reads.
struct Model {
  std::vector<uint32_t> frequency;
  uint32_t step, limit;
  [[nodiscard]] uint32_t cum(size_t s) const {
    return std::accumulate(frequency.begin() + static_cast<ptrdiff_t>(s), frequency.end(), 0U);
  }
  void count(size_t s) {
    frequency[s] += step;
    if (cum(0) <= limit) return;
    for (uint32_t& f : frequency) f = (f + 1) / 2;
  }
};

void compare_with_model(size_t symbols, int step, int limit, unsigned rounds) {
  AdaptiveTable table;
  table.reset(static_cast<unsigned>(symbols), step, limit);
  Model model{std::vector<uint32_t>(symbols, 1), static_cast<uint32_t>(step),
              static_cast<uint32_t>(limit)};
  std::mt19937 random(static_cast<unsigned>(symbols));
  for (unsigned round = 0; round < rounds; ++round) {
    ASSERT_EQ(table.total(), model.cum(0));
    const auto symbol =
        static_cast<uint32_t>(std::min<size_t>(random() % symbols, random() % symbols));
    const AdaptiveTable::Interval interval = table.interval(symbol);
    ASSERT_EQ(interval.low, model.cum(symbol + 1));
    ASSERT_EQ(interval.high, model.cum(symbol));
    for (const uint32_t target : {interval.low, interval.high - 1}) {
      const AdaptiveTable::Interval found = table.find(target);
      ASSERT_EQ(found.symbol, symbol);
      ASSERT_EQ(found.low, interval.low);
      ASSERT_EQ(found.high, interval.high);
    }
    table.count(symbol);
    model.count(symbol);
  }
}

TEST(AdaptiveTable, HasTheSumsOfTheTextThroughManyHalvings) {
  compare_with_model(256, 2, 8192, 20000);
  compare_with_model(256, 4, 8192, 20000);
}

TEST(AdaptiveTable, HoldsAnyNumberOfTextureSymbols) {
  for (const size_t symbols : std::initializer_list<size_t>{2, 3, 15, 16, 17, 127, 128})
    compare_with_model(symbols, 32, 512, 500);
}

TEST(AdaptiveTable, VectorSearchEqualsThePortableOne) {
  std::mt19937 random(1);
  for (int round = 0; round < 1000; ++round) {
    int16_t values[16];
    int16_t value = 0;
    for (int i = 16; i-- > 0;)
      values[i] = value = static_cast<int16_t>(value + static_cast<int>(random() % 500));
    ++values[0];
    for (int limit = 0; limit < values[0]; limit += 7) {
      ASSERT_EQ(last_greater(values, limit), last_greater_portable(values, limit));
    }
  }
}

TEST(Reciprocal, DividesExactlyAtEveryTotal) {
  for (uint32_t total = 1; total <= Reciprocal::kLargest; ++total) {
    const Reciprocal& reciprocal = reciprocal_of(total);
    const uint32_t last = 65536 * total;
    for (const uint32_t product :
         {0U, 1U, total - 1, total, last - 1, last, last / 2, last / 3 * 2}) {
      ASSERT_EQ(reciprocal.divide(product), product / total) << product << " / " << total;
    }
    for (uint32_t quotient = 1; quotient < 65536; quotient += 4111) {
      ASSERT_EQ(reciprocal.divide(quotient * total - 1), quotient - 1);
      ASSERT_EQ(reciprocal.divide(quotient * total), quotient);
    }
  }
}

/// The loop of the text, bit by bit.
unsigned renormalise_by_bits(uint32_t& low, uint32_t& high) {
  unsigned shifts = 0;
  for (;; ++shifts) {
    if (high < 0x8000) {
    } else if (low >= 0x8000) {
      low -= 0x8000;
      high -= 0x8000;
    } else if (low >= 0x4000 && high < 0xC000) {
      low -= 0x4000;
      high -= 0x4000;
    } else {
      return shifts;
    }
    low = 2 * low;
    high = 2 * high + 1;
  }
}

TEST(ArithmeticInterval, OneShiftDoesWhatTheLoopOfTheTextDoes) {
  std::mt19937 random(2);
  for (int round = 0; round < 2000000; ++round) {
    const auto word = static_cast<uint32_t>(random());
    uint32_t low = word & 0xffff;
    uint32_t high = word >> 16;
    if (round % 3 == 0) high = std::min(0xffffU, low + (high & 15));
    if (round % 3 == 1) {
      low = 0x7fff - (low & 31);
      high = 0x8000 + (high & 31);
    }
    if (low > high) std::swap(low, high);
    ArithmeticInterval interval{low, high - low + 1};
    const unsigned shifts = interval.shift().total();
    interval.renormalise(shifts);
    ASSERT_EQ(renormalise_by_bits(low, high), shifts);
    ASSERT_EQ(interval.low, low);
    ASSERT_EQ(interval.range, high - low + 1);
  }
}

}  // namespace
}  // namespace afx::codec
