// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/shading.h"

namespace afx {

Colouring colouring_of(const Mesh& mesh) {
  if (!mesh.colours.empty()) return Colouring::painted;
  for (const uint32_t material : mesh.material_of)
    if (mesh.materials[material].texture != Material::kNoTexture && !mesh.texture_coords.empty())
      return Colouring::painted;
  return mesh.has_colours ? Colouring::plain : Colouring::none;
}

Colouring colouring_of(const PointCloud& cloud) {
  return cloud.colours.empty() ? Colouring::none : Colouring::painted;
}

bool is_to_be_shaded(Colouring colouring, Shade shade) {
  return shade == Shade::always || (shade == Shade::automatic && colouring != Colouring::painted);
}

}  // namespace afx
