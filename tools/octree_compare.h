// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include "afx/octree_stream.h"
#include "codec/diagnostics.h"
#include "codec/error.h"
#include "codec/limits.h"
#include "tools/input.h"
#include "tools/session.h"
#include "tools/verdict.h"

namespace afx::tools {

/// Reads all frames of a stream, or the one OctreeImage of a scene or raw octree.
/// Errors  those of decode_octree_stream and read_octree
Result<OctreeStream> octrees_of(const Input& input, OctreeQuery& query, const Session& session,
                                Diagnostics& diagnostics);

/// Whether the fields of two octrees are the same, frame by frame, and if not, the first place
/// where they differ; where their voxels can be laid side by side (equal numbers of levels and
/// frames, within the limits) also how many of them do.
Verdict compare_octrees(const OctreeStream& a, const OctreeStream& b, const Limits& limits);

}  // namespace afx::tools
