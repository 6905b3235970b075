// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "tools/input.h"
#include "tools/session.h"

namespace afx::tools {

/// What the parts of a model take: "file" (bytes of the file itself); of scenes also "pictures"
/// (bytes of all that ImageTextures name), "octree" and "imageIndices" (bytes of the fields, one a
/// node or symbol), "points" (samples of PointTextures). What a scene has none of is left out, and
/// so is what cannot be read: that is for others to say.
nlohmann::ordered_json model_sizes(const Input& input, const Session& session);

/// The same for people: "12,345 bytes, of pictures 6,789".
std::string size_text(const nlohmann::ordered_json& sizes);

}  // namespace afx::tools
