// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Numbers of a node's fields, held against their ranges.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "codec/error.h"
#include "nodes/node_view.h"

namespace afx {

/// Reads fields one after another; the first error stays, and what is read after it is 0. A field
/// that the node does not have is an error of the caller.
class FieldReader {
 public:
  explicit FieldReader(const nodes::NodeView& node) : node_(node) {}

  /// A finite number that is at least so much; else an error.
  float at_least(std::string_view field, float least);
  /// A number drawn into a range. Error: NaN.
  float clamped(std::string_view field, float low, float high);
  /// A colour, its parts drawn into 0..1. Error: NaN.
  glm::vec3 colour(std::string_view field);
  /// Finite numbers; else an error.
  float finite(std::string_view field);
  glm::vec2 finite2(std::string_view field);
  glm::vec3 finite3(std::string_view field);
  /// Finite numbers that are 0 or more.
  glm::vec3 sizes3(std::string_view field);

  [[nodiscard]] bool ok() const { return !error_.has_value(); }
  [[nodiscard]] const Error& error() const { return *error_; }
  /// Notes an error of the node, unless there is one: "field size is ... (expected ...)".
  void fail(std::string_view field, const std::string& value, const std::string& expected);

 private:
  const nodes::NodeView& node_;
  std::optional<Error> error_;
};

/// A number as messages have it: "0.5", "nan".
std::string number_text(double number);

}  // namespace afx
