// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "codec/error.h"

namespace afx::conformance {

/// A folder of one's own below the system's temporary folder; it goes with this object.
class TemporaryFolder {
 public:
  static Result<TemporaryFolder> make();  ///< Errors  io
  TemporaryFolder(TemporaryFolder&& other) noexcept;
  TemporaryFolder& operator=(TemporaryFolder&&) = delete;
  ~TemporaryFolder();

  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  explicit TemporaryFolder(std::string path) : path_(std::move(path)) {}
  std::string path_;
};

/// Errors  io
Status write_whole_file(const std::string& path, std::span<const uint8_t> bytes);
/// A file that another program may have written; nothing where it is not there, is no regular file
/// or has more than `most` bytes.
std::optional<std::vector<uint8_t>> read_whole_file(const std::string& path, size_t most);

}  // namespace afx::conformance
