// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "conformance/temporary_folder.h"

#include <cstdlib>
#include <filesystem>
#include <utility>

#include "afx/file.h"

namespace afx::conformance {

namespace fs = std::filesystem;

Result<TemporaryFolder> TemporaryFolder::make() {
  std::error_code failure;
  std::string name = (fs::temp_directory_path(failure) / "afx-XXXXXX").string();
  if (failure || mkdtemp(name.data()) == nullptr)
    return Error{Errc::io, Place::none(), "a temporary folder cannot be made"};
  return TemporaryFolder(std::move(name));
}

TemporaryFolder::TemporaryFolder(TemporaryFolder&& other) noexcept
    : path_(std::exchange(other.path_, {})) {}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
}

Status write_whole_file(const std::string& path, std::span<const uint8_t> bytes) {
  return write_file_atomically(path, bytes, true);
}

std::optional<std::vector<uint8_t>> read_whole_file(const std::string& path, size_t most) {
  const auto file = MappedFile::open_regular(path, {.file_bytes = most});
  if (!file.ok()) return {};
  const std::span<const uint8_t> bytes = file.value().bytes();
  return std::vector<uint8_t>(bytes.begin(), bytes.end());
}

}  // namespace afx::conformance
