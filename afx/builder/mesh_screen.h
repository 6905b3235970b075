// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "codec/error.h"
#include "codec/limits.h"

namespace afx {

/// How deep brackets, elements and blocks of a mesh file may nest: Assimp recurses into them.
inline constexpr unsigned kMostMeshNesting = 1000;

/// Looks, before Assimp reads a file, for what makes it take gigabytes or overflow its stack:
/// counts beyond what the file has bytes for (PLY, OFF, text .x) and deep nesting (JSON, XML, text
/// .x and .fbx). One pass over the bytes, no memory. What it lets pass may still be wrong.
///
/// path    for its ending
/// Errors  truncated: the file is too short for its counts; limit_exceeded: nested deeper than
/// 1000,
///         or counts beyond limits.memory; malformed: a PLY header is
Status screen_mesh_file(const std::string& path, std::span<const uint8_t> bytes,
                        const Limits& limits);

}  // namespace afx
