// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <glm/vec2.hpp>
#include <map>
#include <string>
#include <string_view>

#include "codec/limits.h"

namespace afx {

/// The picture on a material of an .mtl file, with what its options do to texture coordinates: u' =
/// scale * u + offset.
struct MtlTexture {
  std::string file;
  glm::vec2 scale{1, 1};
  glm::vec2 offset{0, 0};
};

/// By the name of the material.
using MtlTextures = std::map<std::string, MtlTexture>;

/// The pictures that an .mtl file names by map_Kd with options that have up to three values: -o
/// (offset), -s (scale) and -t (turbulence, which changes nothing here). Assimp skips these, and
/// takes a file name for a value where there are fewer than three. Lines that make no sense are
/// passed over.
/// Source: the Wavefront MTL format, "Options for texture map statements"
MtlTextures mtl_textures(std::string_view mtl);

/// The same of all .mtl files that an .obj file names; those that cannot be read have none.
MtlTextures mtl_textures_of_obj(const std::string& obj_path, const Limits& limits);

}  // namespace afx
