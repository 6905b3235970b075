// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Checks of what a scene holds beside voxels and surfels; for check_scene. All errors are
// bad_argument, and the text names what is wrong.
#pragma once

#include <cstddef>
#include <glm/mat4x4.hpp>
#include <string>

#include "afx/shape.h"
#include "afx/surroundings.h"
#include "codec/error.h"

namespace afx::render {

/// Whether a matrix is affine and finite; the text says "the matrix of a `whose`".
[[nodiscard]] Status check_affine(const glm::dmat4& matrix, const std::string& whose);

/// lights   how many there are in the scene
[[nodiscard]] Status check_shape(const Shape& shape, size_t lights);
[[nodiscard]] Status check_light(const Light& light);
[[nodiscard]] Status check_fog(const Fog& fog);
[[nodiscard]] Status check_backdrop(const Backdrop& backdrop);

}  // namespace afx::render
