// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "codec/error.h"
#include "codec/limits.h"
#include "nodes/field_value.h"
#include "nodes/text_cursor.h"

namespace afx::nodes {

/// What one call of a reader may still use.
class Budget {
 public:
  explicit Budget(const Limits& limits) : values_(limits.scene_values), memory_(limits.memory) {}
  /// Takes `count` values of `bytes_each`. False, and a failure of `in`, if that is beyond the
  /// limits.
  bool take(TextCursor& in, uint64_t count, uint64_t bytes_each);

 private:
  uint64_t values_;
  uint64_t memory_;
};

using LoadFile = std::function<Result<std::string>(std::string_view name)>;

/// Reads field values of all types but nodes. Failures stick in the cursor.
class ValueReader {
 public:
  ValueReader(TextCursor& in, const Limits& limits, LoadFile load_file = {})
      : in_(in), limits_(limits), budget_(limits), load_file_(std::move(load_file)) {}

  /// A value of that type. The zero value after a failure.
  FieldValue read(FieldType type);
  /// An SFString that stands for bytes: data:application/octet-string, then hex, or ";base64,"; 0x
  /// and hex; hex; file:name.
  std::string read_bytes();
  [[nodiscard]] Budget& budget() { return budget_; }

 private:
  template <class T>
  FieldValue read_as();
  template <class T>
  std::vector<T> read_list();

  void read_one(bool& value) { value = in_.boolean(); }
  void read_one(uint8_t& value) { value = in_.boolean() ? 1 : 0; }
  void read_one(int32_t& value) { value = in_.int32(); }
  void read_one(float& value) { value = in_.float32(); }
  void read_one(double& value) { value = in_.float64(); }
  void read_one(std::string& value);
  void read_one(Url& value);
  void read_one(glm::vec2& value) { read_floats(&value.x, 2); }
  void read_one(glm::vec3& value) { read_floats(&value.x, 3); }
  void read_one(glm::vec4& value) { read_floats(&value.x, 4); }
  void read_one(Rotation& value) { read_floats(&value.x, 4); }
  void read_one(Image& value);
  void read_one(CommandBuffer& value) { value.text = std::string(in_.braces()); }
  void read_floats(float* out, unsigned count);
  void read_pixels(Image& image);

  TextCursor& in_;
  const Limits& limits_;
  Budget budget_;
  LoadFile load_file_;
};

}  // namespace afx::nodes
