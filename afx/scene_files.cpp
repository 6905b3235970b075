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
  return UrlFile{path, std::move(file).value(), name};
}

Result<UrlFile> open_stream(int32_t object_descriptor, const ObjectStreams* streams) {
  const std::string path = "od:" + std::to_string(object_descriptor);
  if (streams == nullptr) {
    return Error{Errc::unsupported, Place::none(),
                 "url " + path + " names an object descriptor (expected a file)"};
  }
  const auto found = streams->find(static_cast<uint16_t>(object_descriptor));
  if (found == streams->end())
    return Error{Errc::unsupported, Place::none(),
                 "url " + path + " names no stream that is there"};
  const bifs::Media& stream = found->second;
  if (stream.track.samples.empty())
    return Error{Errc::malformed, Place::none(), "the stream has no samples", {}, path};
  auto sample = stream.bytes(0);
  if (!sample.ok()) {
    sample.error().file = path;
    return std::move(sample).error();
  }
  return UrlFile{path, MappedFile::in_memory(std::move(sample).value()), {}, &stream};
}

Result<UrlFile> open_one(const nodes::Url& url, const UrlBase& base, const Limits& limits) {
  if (url.is_descriptor()) return open_stream(url.object_descriptor, base.streams);
  const std::string name = file_name_of_url(url.text);
  if (name.find("://") != std::string::npos) {
    return Error{Errc::unsupported, Place::none(), "url \"" + name + "\" is not a file name"};
  }
  auto file = open_path(name, base.folder, limits);
  const std::string decoded = percent_decoded(name);
  if (file.ok() || decoded == name) return file;
  auto second = open_path(decoded, base.folder, limits);
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

std::string file_name_of_url(const std::string& text) {
  std::string name = text;
  for (const char* scheme : {"file://", "file:"}) {
    if (name.starts_with(scheme)) name.erase(0, std::string(scheme).size());
  }
  return name;
}

Result<UrlFile> open_url(std::span<const nodes::Url> urls, const UrlBase& base,
                         const Limits& limits) {
  Result<UrlFile> last = Error{Errc::bad_argument, Place::none(), "there is no url"};
  for (const nodes::Url& url : urls) {
    last = open_one(url, base, limits);
    if (last.ok()) break;
  }
  return last;
}

}  // namespace afx
