// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Runs a property over random cases: each is made of its seed and number alone, so it can be made
// again without the others, and what is found is the same for any number of threads.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "conformance/generator/choices.h"
#include "conformance/generator/keep_case.h"

namespace afx::conformance {

/// What does not hold of a case.
struct Failure {
  std::string text;  ///< in words, on one line
  KeptCase kept;     ///< the case for a suite
};

/// Makes a case of choices and checks it. May be called by several threads at once.
using Property = std::function<std::optional<Failure>(Choices& choices)>;

struct GenerateOptions {
  uint64_t seed = 1;
  uint64_t first = 0;  ///< number of the first case
  uint64_t cases = 1000;
  unsigned threads = 1;                            ///< 0 = all cores
  std::function<void(double done)> progress = {};  ///< 0..1; calls do not overlap
};

struct FailedCase {
  uint64_t number = 0;
  std::vector<uint32_t> draws;  ///< of the smallest case that still fails
  Failure failure;              ///< of that
};

/// The first case by number that fails, made smaller; nothing where all hold.
std::optional<FailedCase> find_failure(const Property& property, const GenerateOptions& options);

}  // namespace afx::conformance
