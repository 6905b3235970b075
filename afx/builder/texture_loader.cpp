// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/texture_loader.h"

#include <assimp/scene.h>

#include <algorithm>
#include <filesystem>
#include <span>
#include <system_error>
#include <utility>

#include "afx/file.h"
#include "afx/picture_io.h"
#include "afx/scene_files.h"

namespace afx {
namespace {

namespace fs = std::filesystem;

bool is_file(const fs::path& path) {
  std::error_code problem;
  return fs::is_regular_file(path, problem);
}

std::string lower(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

// The file of a folder whose name is the same but for capitals; the first in the order of names.
std::string find_ignoring_case(const fs::path& folder, const std::string& name) {
  std::error_code problem;
  std::string found;
  for (fs::directory_iterator entry(folder, problem), end; !problem && entry != end;
       entry.increment(problem)) {
    const std::string candidate = entry->path().filename().string();
    if (lower(candidate) == lower(name) && (found.empty() || candidate < found)) found = candidate;
  }
  return found.empty() ? found : (folder / found).string();
}

// Where links and ".." are taken out, so that a file has one name.
std::string canonical(const std::string& path) {
  std::error_code problem;
  const fs::path result = fs::weakly_canonical(path, problem);
  return problem ? path : result.string();
}

// A picture and its copies of half, quarter, ... the side, with 16-bit samples of three colours and
// of alpha if it has that.
uint64_t bytes_of(const Picture& picture) {
  uint64_t bytes = picture.samples.size();
  for (uint32_t w = picture.width, h = picture.height; w > 1 || h > 1;) {
    w = std::max(1U, w / 2);
    h = std::max(1U, h / 2);
    bytes += uint64_t{w} * h * (picture.components % 2 == 0 ? 4 : 3) * sizeof(uint16_t);
  }
  return bytes;
}

}  // namespace

TextureLoader::TextureLoader(const aiScene& scene, const std::string& model_path,
                             const Limits& limits, Diagnostics& diagnostics)
    : scene_(scene),
      folder_(fs::path(model_path).parent_path().string()),
      limits_(limits),
      diagnostics_(diagnostics) {}

Result<std::optional<uint32_t>> TextureLoader::load(const TextureNames& names) {
  if (const auto at = known_.find(names); at != known_.end()) return at->second;
  // The same pictures by other names are not read again.
  const TextureNames sources{source_of(names.colour), source_of(names.opacity), names.alpha};
  const bool all_found = sources.colour.empty() == names.colour.empty() &&
                         sources.opacity.empty() == names.opacity.empty();
  if (const auto at = known_.find(sources); all_found && at != known_.end()) return at->second;
  const Result<std::optional<uint32_t>> number = load_new(names);
  if (!number.ok()) return number;
  known_[names] = number.value();
  if (all_found) known_[sources] = number.value();
  return number;
}

Result<std::optional<uint32_t>> TextureLoader::load_new(const TextureNames& names) {
  Result<Picture> colour = picture_of(names.colour), opacity = picture_of(names.opacity);
  for (const Result<Picture>* picture : {&colour, &opacity})
    if (!picture->ok()) return picture->error();
  if (colour.value().empty() && opacity.value().empty()) return std::optional<uint32_t>();
  const bool has_opacity = !opacity.value().empty();
  Picture texture =
      has_opacity ? with_opacity(colour.value(), opacity.value()) : std::move(colour).value();
  texture = with_alpha_by_rule(std::move(texture), has_opacity ? AlphaRule::as_is : names.alpha);
  const std::string key = source_of(names.colour) + '\n' +
                          (has_opacity ? source_of(names.opacity) : "") + '\n' +
                          std::to_string(texture.components);
  if (const auto at = stored_.find(key); at != stored_.end()) return std::optional(at->second);
  if (bytes_of(texture) > limits_.memory) {
    const std::string& name = names.colour.empty() ? names.opacity : names.colour;
    warn(name, Error{Errc::limit_exceeded,
                     {},
                     "with it the textures take more memory than the limit",
                     {},
                     {}});
    return std::optional<uint32_t>();
  }
  limits_.memory -= bytes_of(texture);
  const auto number = static_cast<uint32_t>(textures_.size());
  textures_.push_back(std::move(texture));
  stored_[key] = number;
  return std::optional(number);
}

// The picture of that name; an empty one for no name and where it cannot be had.
Result<Picture> TextureLoader::picture_of(const std::string& name) {
  if (name.empty() || failed_.count(name) != 0) return Picture();
  Result<Picture> picture = read(name, source_of(name));
  if (picture.ok() || picture.error().code == Errc::not_available) return picture;
  warn(name, picture.error());
  return Picture();
}

void TextureLoader::warn(const std::string& name, const Error& error) {
  failed_.insert(name);
  diagnostics_.warn(error.code == Errc::io ? "texture_missing" : "texture_unreadable", {},
                    "texture " + name + ": " + error.text + "; its material's colour stands in");
}

// What tells pictures apart: the file without links, or "*" and the number of an embedded one;
// empty if there is none.
std::string TextureLoader::source_of(const std::string& name) const {
  if (name.empty()) return {};
  const auto embedded = scene_.GetEmbeddedTextureAndIndex(name.c_str());
  if (embedded.first != nullptr) return "*" + std::to_string(embedded.second);
  const std::string path = find_file(name);
  return path.empty() ? path : canonical(path);
}

Result<Picture> TextureLoader::read(const std::string& name, const std::string& source) const {
  if (const aiTexture* embedded = scene_.GetEmbeddedTexture(name.c_str()); embedded != nullptr)
    return read_embedded(*embedded, name);
  if (source.empty()) return Error{Errc::io, {}, "there is no such file", {}, name};
  const Result<MappedFile> file = MappedFile::open_regular(source, limits_);
  if (!file.ok()) return file.error();
  return decode_picture(file.value().bytes(), source, limits_);
}

Result<Picture> TextureLoader::read_embedded(const aiTexture& texture,
                                             const std::string& name) const {
  if (texture.pcData == nullptr)
    return Error{Errc::malformed, {}, "the embedded picture is empty", {}, name};
  if (texture.mHeight == 0)  // a whole picture file of mWidth bytes
    return decode_picture({reinterpret_cast<const uint8_t*>(texture.pcData), texture.mWidth},
                          name + "." + texture.achFormatHint, limits_);
  const uint64_t pixels = uint64_t{texture.mWidth} * texture.mHeight;
  if (pixels == 0 || pixels > std::min(limits_.picture_pixels, limits_.memory / 4))
    return Error{Errc::limit_exceeded, {}, "the embedded picture is too large", {}, name};
  Picture picture(texture.mWidth, texture.mHeight, 4);
  for (size_t i = 0; i < pixels; ++i) {
    const aiTexel& texel = texture.pcData[i];
    const uint8_t rgba[4] = {texel.r, texel.g, texel.b, texel.a};
    std::copy(rgba, rgba + 4, picture.samples.begin() + static_cast<std::ptrdiff_t>(4 * i));
  }
  return picture;
}

// As named; with slashes for backslashes; as a url; by its last part beside the model, whatever its
// capitals.
std::string TextureLoader::find_file(std::string name) const {
  std::replace(name.begin(), name.end(), '\\', '/');
  for (const std::string& candidate : {name, percent_decoded(name)}) {
    const fs::path path = fs::path(folder_) / candidate;  // an absolute name stays as it is
    if (is_file(path)) return path.string();
  }
  const std::string last = fs::path(percent_decoded(name)).filename().string();
  if (last.empty()) return {};
  const fs::path folder = folder_.empty() ? fs::path(".") : fs::path(folder_);
  return find_ignoring_case(folder, last);
}

}  // namespace afx
