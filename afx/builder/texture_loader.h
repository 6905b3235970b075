// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "afx/picture.h"
#include "codec/diagnostics.h"
#include "codec/error.h"
#include "codec/limits.h"

struct aiScene;
struct aiTexture;

namespace afx {

/// Finds the pictures that the materials of an imported scene name, each once, under however many
/// names. All of them together, with the smaller copies that sampling makes (texture_sampler.h),
/// keep to limits.memory.
class TextureLoader {
 public:
  /// model_path   the file that the scene came from: pictures are looked for relative to its folder
  TextureLoader(const aiScene& scene, const std::string& model_path, const Limits& limits,
                Diagnostics& diagnostics);

  /// The number of the picture among textures(), or nothing where it cannot be had (a warning says
  /// why, once for each name).
  /// name     as the material has it: "*0" and names of embedded pictures, or a path, also of
  /// another system Errors   only not_available: no picture can be read at all
  Result<std::optional<uint32_t>> load(const std::string& name);

  std::vector<Picture>& textures() { return textures_; }

 private:
  Result<std::optional<uint32_t>> load_source(const std::string& name, const std::string& source);
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
  std::map<std::string, std::optional<uint32_t>> known_;    // by name
  std::map<std::string, std::optional<uint32_t>> sources_;  // by what is behind the name
};

}  // namespace afx
