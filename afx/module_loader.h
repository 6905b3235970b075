// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Parts of the program that are loaded when they are first needed, for the libraries that they link
// cost every process time and memory: pictures (OpenImageIO), meshes (Assimp).
#pragma once

#include <string>

namespace afx {

/// What was found in a module.
struct ModuleSymbol {
  void* symbol = nullptr;  ///< nullptr: nothing
  std::string problem;     ///< then: why
};

/// Loads NAME.so and finds a symbol of it. Looked for in the folder that AFX_MODULE_DIR names, then
/// in ../lib/afx beside the folder of the program, in afx beside this library, and where it was
/// installed. It stays loaded.
/// what   for messages, "the module for pictures"
ModuleSymbol find_in_module(const std::string& name, const char* symbol, const std::string& what);

}  // namespace afx
