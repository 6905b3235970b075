// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "afx/builder/texture_alpha.h"
#include "afx/picture.h"
#include "codec/diagnostics.h"
#include "codec/error.h"
#include "codec/limits.h"

struct aiScene;
struct aiTexture;

namespace afx {

/// The pictures that make one texture, by the names that a material has for them: "*0" and names of
/// embedded pictures, or paths, also of another system. Either may be empty.
struct TextureNames {
  std::string colour;
  std::string opacity;
  AlphaRule alpha = AlphaRule::if_mixed;  ///< of the colour picture, where there is no opacity
  bool operator<(const TextureNames& other) const {
    return std::tie(colour, opacity, alpha) < std::tie(other.colour, other.opacity, other.alpha);
  }
};

/// Finds the pictures that the materials of an imported scene name, each once, under however many
/// names. All of them together, with the smaller copies that sampling makes (texture_sampler.h),
/// keep to limits.memory.
class TextureLoader {
 public:
  /// model_path   the file that the scene came from: pictures are looked for relative to its folder
  TextureLoader(const aiScene& scene, const std::string& model_path, const Limits& limits,
                Diagnostics& diagnostics);

  /// The number of the texture among textures(), or nothing where no picture for it can be had (a
  /// warning says why, once for each name). It has alpha (2 or 4 components) where that counts.
  /// Errors   only not_available: no picture can be read at all
  Result<std::optional<uint32_t>> load(const TextureNames& names);

  std::vector<Picture>& textures() { return textures_; }

 private:
  Result<std::optional<uint32_t>> load_new(const TextureNames& names);
  Result<Picture> picture_of(const std::string& name);
  void warn(const std::string& name, const Error& error);
  [[nodiscard]] std::string source_of(const std::string& name) const;
  [[nodiscard]] Result<Picture> read(const std::string& name, const std::string& source) const;
  [[nodiscard]] Result<Picture> read_embedded(const aiTexture& texture,
                                              const std::string& name) const;
  [[nodiscard]] std::string find_file(std::string name) const;

  const aiScene& scene_;
  std::string folder_;
  Limits limits_;  // memory: what is left
  Diagnostics& diagnostics_;
  std::vector<Picture> textures_;
  std::map<TextureNames, std::optional<uint32_t>> known_;  // by names and by sources
  std::map<std::string, uint32_t> stored_;  // by the sources and whether there is alpha
  std::set<std::string> failed_;            // names that were warned of
};

}  // namespace afx
