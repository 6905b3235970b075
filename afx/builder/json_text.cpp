// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/json_text.h"

namespace afx {
namespace {

constexpr uint64_t kJsonGrowth = 64;  // bytes of a document in memory for one of the file

/// at   number of the byte, from 1
Place place_of(std::span<const uint8_t> bytes, size_t at) {
  uint32_t line = 1, column = 1;
  for (const uint8_t byte : bytes.first(std::min(bytes.size(), std::max<size_t>(at, 1) - 1))) {
    if (byte == '\n') {
      ++line;
      column = 1;
    } else if ((byte & 0xC0) != 0x80) {  // not the rest of a character
      ++column;
    }
  }
  return Place::at_line(line, column);
}

}  // namespace

Result<nlohmann::json> parse_json(std::span<const uint8_t> bytes, const Limits& limits) {
  if (bytes.size() > limits.memory / kJsonGrowth)
    return Error{Errc::limit_exceeded, Place::none(), "the JSON is larger than the limit"};
  try {
    return nlohmann::json::parse(bytes.begin(), bytes.end());
  } catch (const nlohmann::json::parse_error& problem) {
    return Error{Errc::malformed, place_of(bytes, problem.byte), "this is not JSON"};
  } catch (const nlohmann::json::exception&) {
    return Error{Errc::malformed, Place::none(), "a number of the JSON is too large"};
  }
}

}  // namespace afx
