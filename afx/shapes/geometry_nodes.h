// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Geometry nodes as plain structs.
#pragma once

#include "afx/shape.h"
#include "codec/error.h"
#include "codec/limits.h"
#include "nodes/node_view.h"

namespace afx {

/// What a geometry node shows: Box, Cone, Cylinder, ElevationGrid, IndexedFaceSet, IndexedLineSet,
/// PointSet, Sphere. It may be nothing (no indices).
/// Errors  unsupported: another type of node; bad_argument: fields out of their range or that do
///         not fit each other; limit_exceeded: limits.memory
Result<Geometry> read_geometry(const nodes::NodeView& node, const Limits& limits);

/// Whether read_geometry knows this type of node.
bool is_known_geometry(std::string_view type);

/// How many bytes it holds.
uint64_t bytes_of(const Geometry& geometry);

}  // namespace afx
