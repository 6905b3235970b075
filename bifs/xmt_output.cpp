// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/xmt_output.h"

#include <utility>

#include "bifs/xmt_values.h"

namespace afx::bifs {

namespace {

constexpr size_t kPiece = size_t{1} << 16;  // bytes that are handed on together, about

}  // namespace

void XmtOutput::fail(Error error) {
  if (status_.ok()) status_ = std::move(error);
}

void XmtOutput::end_tag_begin() {
  if (std::exchange(in_tag_, false)) text_ += ">\n";
}

void XmtOutput::open(std::string_view name) {
  end_tag_begin();
  if (text_.size() >= kPiece) flush();
  indent();
  (text_ += '<') += name;
  open_.emplace_back(name);
  in_tag_ = true;
}

void XmtOutput::attribute(std::string_view name, std::string_view value) {
  if (value.find('\0') != std::string_view::npos)
    return fail(std::string(name) + ": a string with a byte of 0, which no XML text can hold");
  ((text_ += ' ') += name) += "=\"";
  append_escaped(text_, value);
  text_ += '"';
}

void XmtOutput::close() {
  const std::string name = std::move(open_.back());
  open_.pop_back();
  if (std::exchange(in_tag_, false)) {
    text_ += "/>\n";
    return;
  }
  indent();
  text_ += "</" + name + ">\n";
}

void XmtOutput::line(std::string_view text) {
  end_tag_begin();
  indent();
  (text_ += text) += '\n';
}

void XmtOutput::flush() {
  if (ok() && !text_.empty()) status_ = write_(text_);
  text_.clear();
}

}  // namespace afx::bifs
