// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "nodes/byte_text.h"

#include <cstdint>

namespace afx::nodes {

namespace {

constexpr std::string_view kData = "data:application/octet-string";
constexpr std::string_view kBase64 = ";base64,";
constexpr std::string_view kDigits64 =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

Error malformed(std::string text) { return {Errc::malformed, {}, std::move(text), {}, {}}; }

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

Result<std::string> from_hex(std::string_view digits) {
  if (digits.size() % 2 != 0) return malformed("bytes with an odd number of hex digits");
  std::string bytes;
  bytes.reserve(digits.size() / 2);
  for (size_t i = 0; i < digits.size(); i += 2) {
    const int high = hex_digit(digits[i]), low = hex_digit(digits[i + 1]);
    if (high < 0 || low < 0)
      return malformed(
          "bytes that are not hex digits [expected data:application/octet-string, 0x or hex "
          "digits]");
    bytes += static_cast<char>(high * 16 + low);
  }
  return bytes;
}

Result<std::string> from_base64(std::string_view text) {
  while (text.ends_with('=')) text.remove_suffix(1);
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  uint32_t held = 0;
  unsigned bits = 0;
  for (const char c : text) {
    const size_t digit = kDigits64.find(c);
    if (digit == std::string_view::npos) return malformed("bytes that are not base64");
    held = held << 6 | static_cast<uint32_t>(digit);
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(held >> bits & 0xFF);
  }
  if (bits == 6) return malformed("bytes in base64 that end inside a byte");
  return bytes;
}

}  // namespace

Result<std::string> bytes_of_text(std::string_view text) {
  if (text.starts_with(kData)) {
    text.remove_prefix(kData.size());
    if (text.starts_with(kBase64)) return from_base64(text.substr(kBase64.size()));
    if (text.starts_with(',')) return from_hex(text.substr(1));
    return malformed("a data URL [expected ',' and hex digits or ';base64,']");
  }
  if (text.starts_with("0x") || text.starts_with("0X")) text.remove_prefix(2);
  return from_hex(text);
}

std::string text_of_bytes(std::string_view bytes) {
  if (bytes.empty()) return {};
  std::string out = std::string(kData) + std::string(kBase64);
  out.reserve(out.size() + bytes.size() / 3 * 4 + 4);
  for (size_t i = 0; i < bytes.size(); i += 3) {
    uint32_t group = 0;
    for (size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? static_cast<uint8_t>(bytes[i + k]) : 0U);
    for (size_t k = 0; k < 4; ++k)
      out += i + k > bytes.size() ? '=' : kDigits64[group >> (18 - 6 * k) & 63];
  }
  return out;
}

}  // namespace afx::nodes
