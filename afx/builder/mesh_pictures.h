// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Textures of meshes changed to what a Look can say.
#pragma once

#include <glm/vec3.hpp>

#include "afx/picture.h"

namespace afx {

/// The picture times a colour, in linear light: RGB, or RGBA where it has alpha that is to be kept.
///
/// picture   not empty, 1 to 4 components
/// colour    linear light, 0..1
[[nodiscard]] Picture tinted(const Picture& picture, const glm::vec3& colour, bool keep_alpha);

/// Twice as wide (u), high (v) or both: beside and above the picture its mirror image. Repeated,
/// with texture coordinates of half the size, it shows what Wrap::mirror does.
[[nodiscard]] Picture with_mirror_image(const Picture& picture, bool u, bool v);

}  // namespace afx
