// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include "bifs/command.h"
#include "codec/error.h"

namespace afx::bifs {

/// Does to a scene what a command says. PROTO insertions and the PROTOs of a scene replacement are
/// taken as declared in the scene already; GlobalQuantizer changes nothing here.
///
/// An insertion behind the end of a list appends; values given to an eventIn of a node that has an
/// exposedField of its stem (set_coordIndex, coordIndex) go there, others are dropped.
///
/// Errors: bad_argument, and nothing is changed (of a command with several values those before the
/// one that is refused are set): an index behind the end in a replacement or deletion, no such
/// ROUTE, a node that would come to stand inside itself, a value of another type.
Status apply_command(nodes::Scene& scene, const Command& command);

}  // namespace afx::bifs
