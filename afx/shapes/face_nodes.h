// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The nodes that are built of faces. Source: ISO/IEC 14772-1:1997 (VRML97), IndexedFaceSet,
// ElevationGrid (clauses not checked).
#pragma once

#include "afx/shape.h"
#include "codec/error.h"
#include "codec/limits.h"
#include "nodes/node_view.h"

namespace afx {

/// The triangles of an IndexedFaceSet. Faces of less than 3 corners or without area show nothing.
/// Errors  bad_argument: an index that names nothing, values that are not finite, too few values;
///         limit_exceeded: limits.memory; concave faces with too many corners
Result<Geometry> read_indexed_face_set(const nodes::NodeView& node, const Limits& limits);

/// The triangles of an ElevationGrid: rows along x, row after row along z; ccw TRUE: the outside is
/// above (+y). Heights that are left over are not looked at. Errors as above.
Result<Geometry> read_elevation_grid(const nodes::NodeView& node, const Limits& limits);

}  // namespace afx
