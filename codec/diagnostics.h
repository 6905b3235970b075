// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "codec/error.h"

namespace afx {

/// Something that is not as it should be but does not stop the work.
struct Warning {
  std::string code;  ///< stable name for programs, e.g. "trailing_bytes"
  Place place;
  std::string text;
  std::string file = {};  ///< the file it is about, where that is another than the input itself
};

/// Collects warnings. The first kKept are kept with their text, all are counted: a hostile file
/// cannot fill memory with them. Not for use by several threads at once.
class Diagnostics {
 public:
  static constexpr size_t kKept = 100;

  void warn(std::string code, Place place, std::string text);
  /// Adds the warnings of another collection, in order; `file` is what those are about that name
  /// none.
  void append(const Diagnostics& other, const std::string& file = {});

  [[nodiscard]] const std::vector<Warning>& warnings() const { return warnings_; }
  [[nodiscard]] uint64_t count() const { return count_; }  ///< kept or not

 private:
  std::vector<Warning> warnings_;
  uint64_t count_ = 0;
};

}  // namespace afx
