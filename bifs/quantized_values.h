// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Which values of a presentation a quantizer reaches.
#pragma once

#include <string>
#include <vector>

#include "bifs/presentation.h"

namespace afx::bifs {

/// A value that has a quantization category, and is no integer of category 13 or 14. The pointers
/// are good as long as the presentation's nodes and commands stay as they are.
struct QuantizedValue {
  const nodes::NodeDefinition* node;
  const nodes::FieldDefinition* field;
  const nodes::FieldValue* value;
};

/// A scene of a presentation, and the commands up to the next one.
struct SceneValues {
  size_t unit = 0, command = 0;       ///< where its SceneReplacement stands; its root is not NULL
  bool has_inner_quantizer = false;   ///< the quantizer is to be the first child of the root
  std::vector<QuantizedValue> scene;  ///< in the scene; without those of a root that is outside
  std::vector<QuantizedValue> later;  ///< in the commands that follow
  std::string later_misfit;           ///< an integer there that does not fit; empty if all do
};

/// Errors: bad_argument (the presentation has quantizers; an integer of a scene does not
/// fit; a node comes with two scenes).
Result<std::vector<SceneValues>> find_quantized_values(const Presentation& presentation);

}  // namespace afx::bifs
