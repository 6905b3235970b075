// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "codec/adaptive_table.h"

namespace afx::codec {

void AdaptiveTable::reset(unsigned symbols, int step, int limit) {
  step_ = static_cast<int16_t>(step);
  limit_ = static_cast<int16_t>(limit);
  groups_ = static_cast<uint16_t>((symbols + 15) / 16);
  inside_ = {};
  group_ = {};
  for (unsigned g = 16; g-- > 0;) {
    for (unsigned k = 16; k-- > 0;) {
      const int frequency = g * 16 + k < symbols ? 1 : 0;
      inside_[g][k] = static_cast<int16_t>(inside_[g][k + 1] + frequency);
    }
    group_[g] = static_cast<int16_t>(group_[g + 1] + inside_[g][0]);
  }
}

void AdaptiveTable::halve() {
  for (unsigned g = groups_; g-- > 0;) {
    auto& inside = inside_[g];
    int next = 0;  // the frequency sum of the symbols after k, before and after halving
    int sum = 0;
    for (unsigned k = 16; k-- > 0;) {
      const int frequency = inside[k] - next;
      next = inside[k];
      sum += (frequency + 1) / 2;
      inside[k] = static_cast<int16_t>(sum);
    }
    group_[g] = static_cast<int16_t>(group_[g + 1] + sum);
  }
}

}  // namespace afx::codec
