// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/scene_files.h"

#include <charconv>
#include <filesystem>

namespace afx {
namespace {

Result<UrlFile> open_path(const std::string& name, const std::string& folder,
                          const Limits& limits) {
  const std::string path = (std::filesystem::path(folder) / name).string();
  auto file = MappedFile::open_regular(path, limits);
  if (!file.ok()) {
    Error error = std::move(file).error();
    error.file = path;
    return error;
  }
  return UrlFile{path, std::move(file).value()};
}

Result<UrlFile> open_one(const nodes::Url& url, const std::string& folder, const Limits& limits) {
  if (url.is_descriptor()) {
    return Error{Errc::unsupported, Place::none(),
                 "url od:" + std::to_string(url.object_descriptor) +
                     " names an object descriptor (expected a file)"};
  }
  std::string name = url.text;
  for (const char* scheme : {"file://", "file:"}) {
    if (name.starts_with(scheme)) name.erase(0, std::string(scheme).size());
  }
  if (name.find("://") != std::string::npos) {
    return Error{Errc::unsupported, Place::none(), "url \"" + name + "\" is not a file name"};
  }
  auto file = open_path(name, folder, limits);
  const std::string decoded = percent_decoded(name);
  if (file.ok() || decoded == name) return file;
  auto second = open_path(decoded, folder, limits);
  return second.ok() ? std::move(second) : std::move(file);
}

}  // namespace

std::string percent_decoded(const std::string& text) {
  std::string decoded;
  for (size_t i = 0; i < text.size(); ++i) {
    unsigned value = 0;
    const char* digits = text.data() + i + 1;
    const bool code = text[i] == '%' && i + 2 < text.size() &&
                      std::from_chars(digits, digits + 2, value, 16).ptr == digits + 2;
    decoded += code ? static_cast<char>(value) : text[i];
    i += code ? 2 : 0;
  }
  return decoded;
}

Result<UrlFile> open_url(std::span<const nodes::Url> urls, const std::string& folder,
                         const Limits& limits) {
  Result<UrlFile> last = Error{Errc::bad_argument, Place::none(), "there is no url"};
  for (const nodes::Url& url : urls) {
    last = open_one(url, folder, limits);
    if (last.ok()) break;
  }
  return last;
}

}  // namespace afx
