// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The numbers of scene text. The common forms go the fast way; what that does not take (signs +,
// hexadecimal, nan with bits, numbers out of range) goes the slow way, which also makes the
// messages.
#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>

#include "nodes/text_classes.h"
#include "nodes/text_cursor.h"

namespace afx::nodes {

namespace {

constexpr ptrdiff_t kSafeDigits = 9;

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string lower_case(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return out;
}

/// Removes a sign; whether it was a minus.
bool take_sign(std::string_view& token) {
  if (token.empty() || (token[0] != '-' && token[0] != '+')) return false;
  const bool minus = token[0] == '-';
  token.remove_prefix(1);
  return minus;
}

template <class T>
std::optional<T> parse_all(std::string_view token, int base) {
  T value{};
  const auto [stop, failure] =
      std::from_chars(token.data(), token.data() + token.size(), value, base);
  if (failure != std::errc{} || stop != token.data() + token.size()) return std::nullopt;
  return value;
}

bool has_hex_prefix(std::string_view token) {
  return token.size() > 2 && token[0] == '0' && (token[1] == 'x' || token[1] == 'X');
}

/// A decimal number that from_chars calls out of range: whether it is too small rather than too
/// large, by the place of its first digit that is not 0.
bool is_underflow(std::string_view digits) {
  int64_t power = 0;  // decimal exponent of the first significant digit
  bool point = false, significant = false;
  size_t i = 0;
  for (; i < digits.size() && digits[i] != 'e' && digits[i] != 'E'; ++i) {
    if (digits[i] == '.') {
      point = true;
      continue;
    }
    significant = significant || digits[i] != '0';
    if (significant && !point) ++power;
    if (!significant && point) --power;
  }
  if (i >= digits.size()) return power <= 0;
  std::string_view exponent = digits.substr(i + 1);
  const bool minus = take_sign(exponent);
  const auto magnitude = parse_all<int64_t>(exponent, 10);
  if (!magnitude) return minus;  // more digits than an int64 holds
  return power <= (minus ? *magnitude : -*magnitude);
}

/// nan(0xBITS), as value_text writes a NaN that is not the usual one.
template <class T>
std::optional<T> nan_with_bits(std::string_view token) {
  using Bits = std::conditional_t<sizeof(T) == 4, uint32_t, uint64_t>;
  if (!token.starts_with("nan(0x") || !token.ends_with(")")) return std::nullopt;
  const auto bits = parse_all<Bits>(token.substr(6, token.size() - 7), 16);
  if (!bits || !std::isnan(std::bit_cast<T>(*bits))) return std::nullopt;
  return std::bit_cast<T>(*bits);
}

template <class T>
std::optional<T> special_float(std::string_view token) {
  const std::string word = lower_case(token);
  if (word == "inf" || word == "infinity") return std::numeric_limits<T>::infinity();
  if (word == "nan") return std::numeric_limits<T>::quiet_NaN();
  return nan_with_bits<T>(word);
}

}  // namespace

int32_t TextCursor::int32() {
  skip_space();
  // Nine digits cannot overflow, so they need no test each: twice as fast as from_chars.
  const bool minus = at_ != end_ && *at_ == '-';
  const char* const digits = at_ + (minus ? 1 : 0);
  const char* const stop = digits + std::min<ptrdiff_t>(kSafeDigits, end_ - digits);
  const char* at = digits;
  int32_t value = 0;
  for (; at != stop && is_digit(*at); ++at) value = value * 10 + (*at - '0');
  if (at != digits && (at == end_ || is_delimiter(*at))) {
    at_ = at;
    return minus ? -value : value;
  }
  return static_cast<int32_t>(integer_slow(INT32_MIN, INT32_MAX, "SFInt32"));
}

uint32_t TextCursor::uint32() {
  return static_cast<uint32_t>(integer_slow(0, UINT32_MAX, "number"));
}

uint64_t TextCursor::uint64() {
  skip_space();
  const size_t begin = offset();
  const std::string_view token = take_token();
  if (const auto number = parse_all<uint64_t>(token, 10)) return *number;
  at_ = text_.data() + begin;
  fail_expected("a number of at most 64 bits");
  return 0;
}

int64_t TextCursor::integer_slow(int64_t low, int64_t high, std::string_view kind) {
  skip_space();
  const size_t begin = offset();
  std::string_view token = take_token();
  const std::string_view whole = token;
  const bool minus = take_sign(token);
  const bool hex = has_hex_prefix(token);
  const bool digits = !token.empty() && is_digit(token[0]);
  const auto magnitude =
      digits ? parse_all<uint64_t>(hex ? token.substr(2) : token, hex ? 16 : 10) : std::nullopt;
  const size_t plain = token.find_first_not_of("0123456789");
  if (!magnitude && !(digits && plain == std::string_view::npos)) {
    at_ = text_.data() + begin;
    fail_expected("an integer");
    return 0;
  }
  if (magnitude && hex && !minus && low < 0 && *magnitude <= UINT32_MAX)
    return std::bit_cast<int32_t>(static_cast<uint32_t>(*magnitude));
  const bool fits = magnitude && *magnitude <= uint64_t{1} << 32;
  const int64_t value = !fits   ? 0
                        : minus ? -static_cast<int64_t>(*magnitude)
                                : static_cast<int64_t>(*magnitude);
  if (!fits || value < low || value > high) {
    fail(Errc::malformed, begin,
         quoted(whole) + " is out of range [expected " +
             (kind == "number" ? "a number" : "an SFInt32") + ", " + std::to_string(low) + " to " +
             std::to_string(high) + "]");
    return 0;
  }
  return value;
}

template <class T>
T TextCursor::float_number() {
  skip_space();
  T value = 0;
  const auto [stop, failure] = std::from_chars(at_, end_, value);
  if (failure == std::errc{} && (stop == end_ || is_delimiter(*stop)) && std::isfinite(value)) {
    at_ = stop;
    return value;
  }
  return float_slow<T>();
}

template <class T>
T TextCursor::float_slow() {
  skip_space();
  const size_t begin = offset();
  std::string_view token = take_token();
  const std::string_view whole = token;
  const bool minus = take_sign(token);
  if (const auto special = special_float<T>(token)) return minus ? -*special : *special;
  T value = 0;
  const bool number = !token.empty() && (is_digit(token[0]) || token[0] == '.');
  const char* const end = token.data() + token.size();
  const auto [stop, failure] = std::from_chars(token.data(), end, value);
  if (!number || stop != end || failure == std::errc::invalid_argument) {
    at_ = text_.data() + begin;
    fail_expected("a number");
    return 0;
  }
  if (failure == std::errc{} && std::isfinite(value)) return minus ? -value : value;
  if (is_underflow(token)) return minus ? -T{0} : T{0};
  fail(Errc::malformed, begin,
       quoted(whole) + " is out of range [expected " +
           (sizeof(T) == 4 ? "an SFFloat, at most 3.4028235e38"
                           : "an SFTime, at most 1.7976931348623157e308") +
           " either way]");
  return 0;
}

float TextCursor::float32() { return float_number<float>(); }
double TextCursor::float64() { return float_number<double>(); }

}  // namespace afx::nodes
