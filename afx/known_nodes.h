// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Adding nodes whose types and fields are known to be right: where it cannot fail.
#pragma once

#include "nodes/scene.h"

namespace afx {

/// A new node of a type that there is, not yet standing anywhere.
nodes::NodeId add_known(nodes::Scene& scene, const char* type);

/// Gives one of its fields a value of the field's type.
void set_known(nodes::Scene& scene, nodes::NodeId node, const char* field, nodes::FieldValue value);

}  // namespace afx
