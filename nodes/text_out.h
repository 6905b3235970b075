// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>

#include "codec/error.h"

namespace afx::nodes {

/// Takes text piece by piece. Its errors are handed on.
using TextSink = std::function<Status(std::string_view piece)>;

/// Text that is made bit by bit and handed on in pieces, so that it need not be held as a whole.
/// The first error of the sink sticks; what is written after it is dropped.
class TextOut {
 public:
  /// Without a sink the whole text stays in text().
  explicit TextOut(TextSink sink = {}) : sink_(std::move(sink)) {}

  /// What has not been handed on yet: append to it, and call piece() from time to time.
  [[nodiscard]] std::string& text() { return text_; }

  /// Hands the text on if there is enough of it.
  void piece() {
    if (text_.size() >= kPiece && sink_) hand_on();
  }
  /// Hands the rest on. Errors: the first one of the sink.
  Status finish() {
    if (sink_ && !text_.empty()) hand_on();
    return status_;
  }

  /// Whether the line at work is empty, as after a line end or where nothing has been written.
  [[nodiscard]] bool at_line_begin() const {
    return text_.empty() ? last_ == '\n' : text_.back() == '\n';
  }

 private:
  static constexpr size_t kPiece = size_t{1} << 16;

  void hand_on() {
    if (status_.ok()) status_ = sink_(text_);
    last_ = text_.back();
    text_.clear();
  }

  TextSink sink_;
  std::string text_;
  char last_ = '\n';  ///< of what has been handed on
  Status status_;
};

}  // namespace afx::nodes
