// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include "conformance/generator/generator.h"

namespace afx::conformance {

/// Whose coders and texts are checked; each function gives bytes for bytes, unchanged where nothing
/// is the matter. For tests.
struct SceneFault {
  /// Damages what was decoded or read, as JSON text.
  std::function<void(std::string& commands)> told = {};
};

/// That a random presentation (random_scene.h) holds: encoded as a raw scene with every choice that
/// an encoder has, and as an MP4 file, it decodes to the same commands, and what was decoded
/// encodes to the same bytes again; written as BT and XMT-A it reads back as the same commands;
/// quantized it stays within the errors that are promised, and encodes to the same bytes again.
Property scene_property(const SceneFault& fault = {});

}  // namespace afx::conformance
