// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Which nodes a command brings along. Writers need to know: a node is written whole at its first
// place, and by its ID at the others.
#pragma once

#include <unordered_set>

#include "bifs/command.h"

namespace afx::bifs {

/// The nodes that have been written, or will be by the command at work.
using NodeSet = std::unordered_set<uint32_t>;

/// The nodes that stand in a command's values, in their fields and in its PROTOs and not in
/// `known`; they are added to `known`. Command buffers are left out: they are written when all else
/// is known.
NodeSet new_nodes(const nodes::Scene& scene, const Command& command, NodeSet& known);

}  // namespace afx::bifs
