// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "codec/error.h"

namespace afx::bifs {

/// Writes XML element by element and hands the text on in pieces. The first failure sticks.
class XmtOutput {
 public:
  using Write = std::function<Status(std::string_view text)>;
  explicit XmtOutput(Write write) : write_(std::move(write)) {}

  /// An element inside the one at work, to be closed by close().
  void open(std::string_view name);
  /// An attribute of the element just opened.
  void attribute(std::string_view name, std::string_view value);
  void attribute(std::string_view name, uint64_t value) { attribute(name, std::to_string(value)); }
  void close();
  /// An element without content.
  void element(std::string_view name) { open(name), close(); }
  /// A line of text as it is.
  void line(std::string_view text);

  void fail(Error error);
  void fail(std::string text) { fail({Errc::bad_argument, {}, std::move(text)}); }
  [[nodiscard]] bool ok() const { return status_.ok(); }
  [[nodiscard]] const Status& status() const { return status_; }
  /// Hands on what is there.
  void flush();

 private:
  void end_tag_begin();
  void indent() { text_.append(open_.size(), ' '); }

  Write write_;
  Status status_;
  std::string text_;
  std::vector<std::string> open_;
  bool in_tag_ = false;
};

}  // namespace afx::bifs
