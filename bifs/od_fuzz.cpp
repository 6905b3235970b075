// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Any bytes as an access unit of object descriptors, and as descriptors. What is read is written,
// reads the same with somebody listening, and where there was no warning it is the same bytes.
#include <algorithm>
#include <cstdint>

#include "bifs/descriptor_reader.h"
#include "bifs/descriptor_writer.h"
#include "bifs/od_command.h"
#include "codec/fuzz_test_support.h"

namespace {

using namespace afx;
using namespace afx::bifs;

Limits small_limits() {
  Limits limits;
  limits.memory = 4U << 20;
  return limits;
}

void check_error(const Error& error, size_t size) {
  require(!error.text.empty());
  require(error.place.kind == Place::Kind::bit && error.place.bit <= uint64_t{size} * 8);
}

void run_commands(std::span<const uint8_t> data) {
  Diagnostics diagnostics;
  const auto commands = read_od_commands(data, small_limits(), diagnostics);
  if (!commands.ok()) return check_error(commands.error(), data.size());
  const auto written = write_od_commands(commands.value());
  require(written.ok());
  if (diagnostics.count() == 0) {
    require(std::equal(written.value().begin(), written.value().end(), data.begin(), data.end()));
  }
  const codec::Trace trace = [&](const codec::TraceElement& element) {
    require(element.bit + element.width <= uint64_t{8} * written.value().size());
  };
  const auto again = read_od_commands(written.value(), small_limits(), diagnostics, &trace);
  require(again.ok() && again.value() == commands.value());
}

void run_descriptors(std::span<const uint8_t> data) {
  Diagnostics diagnostics;
  DescriptorReadOptions options;
  options.limits = small_limits();
  const auto descriptors = read_descriptors(data, options, diagnostics);
  if (!descriptors.ok()) return check_error(descriptors.error(), data.size());
  const auto written = write_descriptors(descriptors.value());
  require(written.ok());
  if (diagnostics.count() == 0) {
    require(std::equal(written.value().begin(), written.value().end(), data.begin(), data.end()));
  }
  const auto again = read_descriptors(written.value(), options, diagnostics);
  require(again.ok() && again.value() == descriptors.value());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::span<const uint8_t> bytes(data, size);
  run_commands(bytes);
  run_descriptors(bytes);
  return 0;
}
