// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/shapes/field_reader.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "afx/node_error.h"

namespace afx {
namespace {

std::string text_of(const glm::vec2& v) { return number_text(v.x) + ' ' + number_text(v.y); }
std::string text_of(const glm::vec3& v) {
  return number_text(v.x) + ' ' + number_text(v.y) + ' ' + number_text(v.z);
}

bool is_finite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace

std::string number_text(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", number);
  return text;
}

void FieldReader::fail(std::string_view field, const std::string& value,
                       const std::string& expected) {
  if (ok())
    error_ = bad_node(
        node_, "field " + std::string(field) + " is " + value + " (expected " + expected + ")");
}

float FieldReader::at_least(std::string_view field, float least) {
  const auto value = node_.get<float>(field);
  if (std::isfinite(value) && value >= least) return value;
  fail(field, number_text(value), number_text(least) + " or more");
  return 0;
}

float FieldReader::clamped(std::string_view field, float low, float high) {
  const auto value = node_.get<float>(field);
  if (!std::isnan(value)) return std::clamp(value, low, high);
  fail(field, "nan", number_text(low) + " to " + number_text(high));
  return 0;
}

glm::vec3 FieldReader::colour(std::string_view field) {
  auto value = node_.get<glm::vec3>(field);
  for (int i = 0; i < 3; ++i) {
    if (std::isnan(value[i])) {
      fail(field, text_of(value), "0 to 1");
      return glm::vec3(0);
    }
    value[i] = std::clamp(value[i], 0.0F, 1.0F);
  }
  return value;
}

float FieldReader::finite(std::string_view field) {
  const auto value = node_.get<float>(field);
  if (std::isfinite(value)) return value;
  fail(field, number_text(value), "a finite number");
  return 0;
}

glm::vec2 FieldReader::finite2(std::string_view field) {
  const auto value = node_.get<glm::vec2>(field);
  if (std::isfinite(value.x) && std::isfinite(value.y)) return value;
  fail(field, text_of(value), "finite numbers");
  return glm::vec2(0);
}

glm::vec3 FieldReader::finite3(std::string_view field) {
  const auto value = node_.get<glm::vec3>(field);
  if (is_finite(value)) return value;
  fail(field, text_of(value), "finite numbers");
  return glm::vec3(0);
}

glm::vec3 FieldReader::sizes3(std::string_view field) {
  const auto value = node_.get<glm::vec3>(field);
  if (is_finite(value) && std::min({value.x, value.y, value.z}) >= 0) return value;
  fail(field, text_of(value), "finite numbers, 0 or more");
  return glm::vec3(0);
}

}  // namespace afx
