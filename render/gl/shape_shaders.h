// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The shaders of shapes. For the preprocessor:
//   BANDS   lines and points, as quadrilaterals that are one pixel wide; otherwise triangles
//   GLASS   transparent: with fog, the colour times the opacity
#pragma once

#include <string>

namespace afx::render {

/// Reckons how much fog leaves of a colour; uniforms: see GlShapes::set_fog.
std::string fog_part();
std::string shape_vertex_shader();
std::string shape_fragment_shader();

}  // namespace afx::render
