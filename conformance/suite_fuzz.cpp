// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Suites and answers of decoders: what is read holds together, what is not gives an error that says
// something; an answer that was read is written and read the same.
#include <cstdint>
#include <span>

#include "afx/builder/json_text.h"
#include "codec/fuzz_test_support.h"
#include "conformance/decoder.h"
#include "conformance/suite.h"

namespace {

using namespace afx;
using namespace afx::conformance;

void check_suite(std::span<const uint8_t> bytes) {
  const auto suite = parse_suite(bytes, "folder");
  if (!suite.ok()) return require(!suite.error().text.empty());
  require(!suite.value().cases.empty());
  for (const Case& one : suite.value().cases) {
    require(!one.expect.empty() && suite.value().origins.contains(one.origin));
    require(!one.stream.path.starts_with('/') && !one.stream.path.starts_with("../"));
  }
}

void check_answer(std::span<const uint8_t> bytes) {
  const auto document = parse_json(bytes, {});
  if (!document.ok()) return;
  const auto answer = answer_of_json(document.value());
  if (!answer.ok()) return require(!answer.error().text.empty());
  const auto again = answer_of_json(json_of_answer(answer.value()));
  require(again.ok() && again.value().error == answer.value().error);
  require(again.value().warnings == answer.value().warnings);
  require(again.value().values == answer.value().values);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::span<const uint8_t> bytes(data, size);
  check_suite(bytes);
  check_answer(bytes);
  return 0;
}
