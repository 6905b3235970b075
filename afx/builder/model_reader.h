// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Files to meshes and point clouds.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <variant>

#include "afx/builder/mesh.h"
#include "codec/diagnostics.h"
#include "codec/error.h"
#include "codec/limits.h"

namespace afx {

using SourceModel = std::variant<Mesh, PointCloud>;

/// Reads whatever the builder can build from: PLY without faces by read_ply_points(), everything
/// else by read_mesh(). The content tells a PLY, whatever its name.
/// Errors  as the two
Result<SourceModel> read_source_model(const std::string& path, const Limits& limits,
                                      Diagnostics& diagnostics);

/// Reads a mesh by Assimp: OBJ, glTF/GLB, PLY, COLLADA, STL, FBX, 3DS, X3D and more. Node
/// transforms are applied, textures read from beside the file or out of it.
///
/// Alpha cuts holes (Material::alpha_cutoff): the material's opacity times the alpha of its colour
/// texture or its opacity texture. In glTF by alphaMode, where BLEND counts as MASK with a cutoff
/// of one half; in other formats with the same cutoff, and the alpha of colour textures only if it
/// is on both sides of that.
///
/// Warnings  texture_missing, texture_unreadable, skipped_primitives (lines and points), non_finite
///           (vertices whose triangles are left out), bad_index, transparent (triangles left out
///           that cannot be seen), alpha_blending (materials meant to shine through)
/// Errors    io: the file cannot be opened or is no regular file; unsupported: Assimp has no
///           reader for it; malformed: Assimp's own message, or no triangles; limit_exceeded: file
///           size, mesh beyond limits.memory, nested too deeply; truncated: shorter than its counts
///           (mesh_screen.h); no_memory; not_available (see picture_io.h)
Result<Mesh> read_mesh(const std::string& path, const Limits& limits, Diagnostics& diagnostics);

/// Whether `bytes` begin like a PLY file, and if so whether it has faces (or strips) to draw.
enum class PlyKind { not_ply, points, mesh };
PlyKind ply_kind(std::span<const uint8_t> bytes);

/// Reads the points of a PLY file (ascii or binary of either byte order; properties in any order
/// and of any type; other elements and lists are skipped). x y z; red green blue (also with the
/// prefix diffuse_; 8 or 16 bits, or floats 0..1; sRGB); nx ny nz.
///
/// Warnings  non_finite (points left out)
/// Errors    malformed: the header or a number (with line), no x y z, no vertices; truncated: with
///           the byte; limit_exceeded: points beyond limits.memory
Result<PointCloud> read_ply_points(std::span<const uint8_t> bytes, const Limits& limits,
                                   Diagnostics& diagnostics);

}  // namespace afx
