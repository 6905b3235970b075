// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "conformance/decoder.h"
#include "conformance/json_difference.h"
#include "conformance/suite.h"

namespace afx::conformance {

enum class Verdict { passed, failed, not_run };
const char* to_string(Verdict verdict);

/// Pictures to look at, as PNG files.
struct PicturesApart {
  std::vector<uint8_t> expected;
  std::vector<uint8_t> found;
  std::vector<uint8_t> difference;  ///< absolute, eight times as strong
};

/// What came of one check.
struct Outcome {
  Verdict verdict = Verdict::passed;
  std::string text = {};  ///< failed, not_run: why, in a sentence
  std::optional<JsonDifference> difference = {};
  std::optional<uint64_t> bit = {};  ///< of the file: where the value that differs is coded
  std::optional<PicturesApart> pictures = {};
};

/// Finds the bit of the file at which the value at a JSON pointer of an answer is coded; nothing
/// where it cannot be told. May be called by several threads at once.
using LocateValue =
    std::function<std::optional<uint64_t>(const Question& question, const std::string& pointer)>;

/// Asks a decoder what a check wants to know, and judges its answer.
Outcome judge(const Suite& suite, const Case& one, const Check& check, const Decoder& decoder,
              const LocateValue& locate);

}  // namespace afx::conformance
