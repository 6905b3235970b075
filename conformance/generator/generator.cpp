// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "conformance/generator/generator.h"

#include <algorithm>
#include <utility>

#include "codec/parallel.h"
#include "conformance/generator/shrink.h"

namespace afx::conformance {

namespace {

constexpr uint64_t kBlock = 256;  ///< cases at a time

FailedCase smallest(const Property& property, uint64_t seed, uint64_t number) {
  Choices made(seed, number);
  (void)property(made);
  const Fails fails = [&](Choices& choices) { return property(choices).has_value(); };
  FailedCase found{number, shrink(made.draws(), fails), {}};
  Choices again(found.draws);
  if (auto failure = property(again)) found.failure = std::move(*failure);
  return found;
}

}  // namespace

std::optional<FailedCase> find_failure(const Property& property, const GenerateOptions& options) {
  for (uint64_t done = 0; done < options.cases; done += kBlock) {
    const uint64_t first = options.first + done;
    std::vector<uint8_t> failed(std::min(kBlock, options.cases - done));
    parallel_for(failed.size(), options.threads, [&](size_t i) {
      Choices choices(options.seed, first + i);
      failed[i] = property(choices).has_value() ? 1 : 0;
    });
    const auto found = std::find(failed.begin(), failed.end(), 1);
    if (found != failed.end())
      return smallest(property, options.seed,
                      first + static_cast<uint64_t>(found - failed.begin()));
    if (options.progress)
      options.progress(static_cast<double>(done + failed.size()) /
                       static_cast<double>(options.cases));
  }
  return std::nullopt;
}

}  // namespace afx::conformance
