// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/mtl_textures.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include "afx/file.h"

namespace afx {
namespace {

constexpr std::string_view kBlank = " \t\r\f\v";

std::string_view trimmed(std::string_view text) {
  const size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

// Takes the first line off a text.
std::string_view take_line(std::string_view& text) {
  const size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = trimmed(text.substr(0, end));
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

// Takes the first word off a line.
std::string_view take_word(std::string_view& line) {
  const size_t end = std::min(line.find_first_of(kBlank), line.size());
  const std::string_view word = line.substr(0, end);
  line = trimmed(line.substr(end));
  return word;
}

std::optional<float> number(std::string_view word) {
  float value = 0;
  const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
  const bool whole = problem == std::errc() && end == word.data() + word.size();
  return whole ? std::optional(value) : std::nullopt;
}

// Takes up to three numbers, but not the last word: that is the file. The third is for depth.
void take_numbers(std::string_view& line, glm::vec2& values) {
  for (int k = 0; k < 3; ++k) {
    std::string_view rest = line;
    const std::optional<float> value = number(take_word(rest));
    if (!value || rest.empty()) return;
    if (k < 2) values[k] = *value;
    line = rest;
  }
}

// What follows "map_Kd": options, each with its values, and the file. Nothing without an option
// that matters here.
std::optional<MtlTexture> map_of(std::string_view line) {
  MtlTexture texture;
  glm::vec2 turbulence(0);
  bool moved = false;
  while (line.size() > 1 && line[0] == '-') {
    const std::string_view option = take_word(line);
    if (option == "-o" || option == "-s" || option == "-t") {
      moved = true;
      take_numbers(line,
                   option == "-o" ? texture.offset : (option == "-s" ? texture.scale : turbulence));
    } else {
      take_word(line);
      if (option == "-mm") take_word(line);
    }
  }
  texture.file = line;
  return moved && !line.empty() ? std::optional(texture) : std::nullopt;
}

}  // namespace

MtlTextures mtl_textures(std::string_view mtl) {
  MtlTextures textures;
  std::string material;
  while (!mtl.empty()) {
    std::string_view line = take_line(mtl);
    const std::string_view word = take_word(line);
    if (word == "newmtl") material = line;
    if (word != "map_Kd" && word != "map_kd") continue;
    if (std::optional<MtlTexture> texture = map_of(line)) textures[material] = *std::move(texture);
  }
  return textures;
}

MtlTextures mtl_textures_of_obj(const std::string& obj_path, const Limits& limits) {
  const auto text_of = [](const MappedFile& file) {
    return std::string_view(reinterpret_cast<const char*>(file.bytes().data()),
                            file.bytes().size());
  };
  MtlTextures textures;
  std::set<std::string> seen;
  const Result<MappedFile> obj = MappedFile::open_regular(obj_path, limits);
  if (!obj.ok()) return textures;
  for (std::string_view rest = text_of(obj.value()); !rest.empty();) {
    std::string_view line = take_line(rest);
    if (take_word(line) != "mtllib") continue;
    const std::string path = (std::filesystem::path(obj_path).parent_path() / line).string();
    if (!seen.insert(path).second) continue;
    const Result<MappedFile> mtl = MappedFile::open_regular(path, limits);
    if (mtl.ok()) textures.merge(mtl_textures(text_of(mtl.value())));
  }
  return textures;
}

}  // namespace afx
