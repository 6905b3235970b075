// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The boundary between mesh_reader.cpp and the module afx_meshes.so, which links Assimp. Both come
// out of one build; no exception crosses.
#pragma once

#include <string>

#include "afx/builder/mesh.h"
#include "codec/diagnostics.h"
#include "codec/error.h"
#include "codec/limits.h"

extern "C" {

/// Imports the mesh of a file that has been screened (mesh_screen.h). The one symbol of the module,
/// by the name "afx_mesh_import".
typedef void (*afx_mesh_import_function)(const std::string* path, const afx::Limits* limits,
                                         afx::Diagnostics* diagnostics,
                                         afx::Result<afx::Mesh>* mesh);
}
