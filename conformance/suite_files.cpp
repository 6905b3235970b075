// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "conformance/suite_files.h"

#include <zlib.h>

#include <algorithm>
#include <filesystem>

#include "afx/builder/json_text.h"
#include "afx/file.h"
#include "conformance/sha256.h"

namespace afx::conformance {
namespace {

namespace fs = std::filesystem;
constexpr size_t kMostUnpacked = size_t{256} << 20;

Result<std::vector<uint8_t>> unpack(std::span<const uint8_t> packed) {
  std::vector<uint8_t> plain;
  for (size_t room = packed.size() * 16 + 1024; room <= kMostUnpacked; room *= 4) {
    plain.resize(room);
    uLongf size = room;
    const int done = uncompress(plain.data(), &size, packed.data(), packed.size());
    if (done == Z_BUF_ERROR) continue;
    if (done != Z_OK) break;
    plain.resize(size);
    return plain;
  }
  return Error{Errc::malformed, Place::none(),
               "it cannot be unpacked (expected zlib, at most 256 MiB)"};
}

Status add_suites(const std::string& folder, std::vector<std::string>& found) {
  std::error_code failure;
  if (!fs::is_directory(folder, failure))
    return Error{Errc::io, Place::none(), "is not a folder", {}, folder};
  const size_t before = found.size();
  if (fs::is_regular_file(fs::path(folder) / "suite.json", failure)) found.push_back(folder);
  for (fs::recursive_directory_iterator at(folder, failure), end; !failure && at != end;
       at.increment(failure)) {
    std::error_code unknown;
    if (at->path().filename() != "suite.json" || !at->is_regular_file(unknown)) continue;
    if (at.depth() > 0) found.push_back(at->path().parent_path().string());
  }
  if (failure) return Error{Errc::io, Place::none(), failure.message(), {}, folder};
  if (found.size() == before)
    return Error{Errc::malformed, Place::none(), "there is no suite.json in it", {}, folder};
  std::sort(found.begin() + static_cast<std::ptrdiff_t>(before), found.end());
  return {};
}

}  // namespace

Result<std::vector<std::string>> find_suites(const std::vector<std::string>& folders) {
  std::vector<std::string> found;
  for (const std::string& folder : folders)
    if (Status added = add_suites(folder, found); !added.ok()) return added.error();
  return found;
}

Result<std::vector<uint8_t>> read_suite_file(const Suite& suite, const SuiteFile& file) {
  const auto opened = MappedFile::open_regular(suite.folder + "/" + file.path);
  if (!opened.ok()) return opened.error();
  const std::span<const uint8_t> bytes = opened.value().bytes();
  if (const std::string digest = sha256(bytes); digest != file.sha256)
    return Error{Errc::malformed, Place::none(),
                 "the SHA-256 is " + digest + " (expected " + file.sha256 + ")"};
  return std::vector<uint8_t>(bytes.begin(), bytes.end());
}

Result<nlohmann::json> read_suite_json(const Suite& suite, const SuiteFile& file) {
  auto bytes = read_suite_file(suite, file);
  if (bytes.ok() && file.path.ends_with(".z")) bytes = unpack(bytes.value());
  if (!bytes.ok()) return bytes.error();
  return parse_json(bytes.value(), {.memory = kMostUnpacked * 64});
}

}  // namespace afx::conformance
