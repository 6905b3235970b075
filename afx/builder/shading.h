// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>

#include "afx/builder/mesh.h"

namespace afx {

/// Whether a soft light from above and in front is painted into the model: nobody lights a DIBR
/// model later, and one colour all over shows nothing but an outline.
enum class Shade : uint8_t {
  automatic,  ///< meshes without textures and vertex colours, points without colours
  always,     ///< whatever the colours: they are darkened where they face away from the light
  never       ///< what has no colours at all is white
};

/// What a model says about the colours of its surface.
enum class Colouring : uint8_t {
  none,    ///< nothing
  plain,   ///< one colour for each material
  painted  ///< textures, or colours of vertices or points
};

Colouring colouring_of(const Mesh& mesh);
Colouring colouring_of(const PointCloud& cloud);

bool is_to_be_shaded(Colouring colouring, Shade shade);

}  // namespace afx
