// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace afx {

/// What kind of failure it is, for programs. Few and stable.
enum class Errc {
  truncated,       ///< the data end before the structure does
  malformed,       ///< the data break a rule of the format
  unsupported,     ///< legal, but not done here
  limit_exceeded,  ///< our own refusal: a size beyond `Limits`
  bad_argument,    ///< the caller asked for something that cannot be (also: fields that do not fit
                   ///< each other)
  no_memory,       ///< memory could not be had
  io,              ///< a file could not be opened, read or written
  not_available    ///< a feature that this build or installation lacks
};

/// The name of a code as it is printed, e.g. "limit_exceeded".
const char* to_string(Errc code);

/// Where in its input something was found. Text places count lines and columns from 1 (columns in
/// characters, a tab is one), binary places count bits from 0 at the start of the caller's buffer.
struct Place {
  enum class Kind : uint8_t { none, bit, text };
  Kind kind = Kind::none;
  uint64_t bit = 0;     ///< kind == bit
  uint32_t line = 0;    ///< kind == text
  uint32_t column = 0;  ///< kind == text

  static Place none() { return {}; }
  static Place at_bit(uint64_t bit) { return {Kind::bit, bit, 0, 0}; }
  static Place at_byte(uint64_t byte) { return at_bit(byte * 8); }
  static Place at_line(uint32_t line, uint32_t column) { return {Kind::text, 0, line, column}; }
  bool operator==(const Place&) const = default;
};

/// "12:7" for text, "34" for a byte, "34.5" for bit 5 of byte 34, "" for no place.
std::string to_string(const Place& place);

/// A failure: code for programs, place and sentence for people.
struct Error {
  Errc code = Errc::malformed;
  Place place;
  std::string text;          ///< what is wrong, and in brackets what was expected; no full stop
  std::string excerpt = {};  ///< text formats: the line and below it a caret; otherwise empty
  std::string file = {};     ///< the file it is about, where whoever composed the error knew it
};

/// "FILE:WHERE: text", leaving out what is not known; `file` stands in where the error names none.
std::string to_string(const Error& error, const std::string& file = {});

/// A value or an Error. Ask with ok() before taking the value; taking what is not there is a bug of
/// the caller and asserts.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value)
      : state_(std::in_place_index<0>, std::move(value)) {}  // NOLINT: implicit on purpose
  Result(Error error)
      : state_(std::in_place_index<1>, std::move(error)) {}  // NOLINT: implicit on purpose

  [[nodiscard]] bool ok() const { return state_.index() == 0; }
  [[nodiscard]] T& value() & { return *std::get_if<0>(&state_); }
  [[nodiscard]] const T& value() const& { return *std::get_if<0>(&state_); }
  [[nodiscard]] T&& value() && { return std::move(*std::get_if<0>(&state_)); }
  [[nodiscard]] Error& error() & { return *std::get_if<1>(&state_); }
  [[nodiscard]] const Error& error() const& { return *std::get_if<1>(&state_); }
  [[nodiscard]] Error&& error() && { return std::move(*std::get_if<1>(&state_)); }

 private:
  std::variant<T, Error> state_;
};

/// Success or an Error.
template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : error_(std::move(error)) {}  // NOLINT: implicit on purpose

  [[nodiscard]] bool ok() const { return !error_.has_value(); }
  [[nodiscard]] const Error& error() const& { return *error_; }
  [[nodiscard]] Error& error() & { return *error_; }
  [[nodiscard]] Error&& error() && { return std::move(*error_); }

 private:
  std::optional<Error> error_;
};

using Status = Result<void>;

}  // namespace afx
