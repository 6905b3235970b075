// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// First bytes of pictures: a header has a size, an error a place in the data; more data behind a
// header change nothing.
#include <cstdint>
#include <span>

#include "afx/picture_header.h"
#include "codec/fuzz_test_support.h"

namespace {

using afx::require;

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace afx;
  const std::span<const uint8_t> bytes(data, size);
  const auto header = read_picture_header(bytes);
  if (!header.ok()) {
    require(!header.error().text.empty());
    require(header.error().place.bit <= uint64_t{size} * 8);
    return 0;
  }
  require(header.value().width > 0 && header.value().height > 0);
  require(header.value().object_type == still_picture_type(bytes));
  return 0;
}
