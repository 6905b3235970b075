// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <string>

#include "codec/error.h"
#include "nodes/node_view.h"

namespace afx {

/// An error of a scene that names a node: "PointTexture: ...".
inline Error bad_node(const nodes::NodeView& node, const std::string& text,
                      Errc code = Errc::bad_argument) {
  return {code, Place::none(), node.label() + ": " + text};
}

}  // namespace afx
