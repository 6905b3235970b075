// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What `afx info` says of scenes. Both functions fill `out` as far as they come and return an exit
// code.
#pragma once

#include <nlohmann/json.hpp>

#include "tools/input.h"
#include "tools/session.h"

namespace afx::tools {

/// Nodes by type, ROUTEs, PROTOs, OctreeImages.
int info_of_text_scene(const Input& input, const Session& session, Diagnostics& diagnostics,
                       nlohmann::ordered_json& out);

/// Tracks with their streams and sizes, object descriptors, the configuration, what each type of
/// node takes, and the scene as it is at the end.
int info_of_coded_scene(const Input& input, const Session& session, Diagnostics& diagnostics,
                        nlohmann::ordered_json& out);

}  // namespace afx::tools
