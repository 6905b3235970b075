// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <string_view>

#include "bifs/presentation.h"
#include "codec/diagnostics.h"
#include "codec/error.h"
#include "codec/limits.h"

namespace afx::bifs {

/// Reads a presentation from XMT-A, the XML form of MPEG-4 scenes, as GPAC writes it and as
/// XmtWriter does (bifs/xmt_writer.h says what stands for what).
///
/// `text` is UTF-8. Values are those of BT without brackets; a string is the attribute as it is,
/// strings of a list stand in quotes (a list of one needs none). Nodes get the IDs that their names
/// stand for (bifs/id_assignment.h), ROUTEs likewise; `binaryID` overrules that. Commands outside
/// `par` belong to time 0. Random access points are the first access unit of each stream and a
/// `par` that says isRAP="yes".
///
/// Errors carry line, column and an excerpt with a caret:
///   malformed       no well-formed XML; an entity beyond XML's five and numbers; an element,
///                   attribute or value that is not as the definitions want it: the nearest known
///                   name is offered
///   limit_exceeded  limits.scene_depth, scene_values, memory, picture_pixels
///   no_memory
///
/// Two PROTOs of one name in one scope are an error: GPAC writes such files, for it calls every
/// PROTO without a name Proto0, and which one an instance means cannot be known.
///
/// Warnings: invalid_utf8 (the bytes are kept), def_twice (the second node gets a name of its own;
/// the name means it from there on).
///
/// Source: ISO/IEC 14496-11, XMT-A (clauses not checked); the dialect as GPAC writes it.
Result<Presentation> read_xmt(std::string_view text, const Limits& limits,
                              Diagnostics& diagnostics);

}  // namespace afx::bifs
