// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <span>

#include "codec/error.h"
#include "nodes/scene.h"

namespace afx::bifs {

/// The data type of the node that a scene replacement brings: SFTopNode.
/// Source: ISO/IEC 14496-11, SceneReplace (clause not checked); spec/bifs.md 4
nodes::NodeDataType top_node_type();

/// Whether the node may be the top node of a scene. NULL may.
bool may_be_top_node(const nodes::Scene& scene, nodes::NodeId id);

/// A new Group over the nodes, to be the top node of texts whose nodes may not be that or are many.
/// Error: malformed, for the first that may not stand under a Group; `refused` is its number.
Result<nodes::NodeId> put_in_group(nodes::Scene& scene, std::span<const nodes::NodeId> roots,
                                   size_t& refused);

/// The nodes of MPEG-4 that may, for messages.
inline constexpr const char* kTopNodes = "Group, OrderedGroup, Layer2D, Layer3D";

}  // namespace afx::bifs
