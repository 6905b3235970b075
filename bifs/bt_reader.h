// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <string_view>

#include "bifs/presentation.h"
#include "codec/diagnostics.h"
#include "codec/error.h"
#include "codec/limits.h"
#include "nodes/scene_reader.h"

namespace afx::bifs {

/// Reads a presentation from BT: object descriptors, a scene (as read_scene_text reads it; a VRML
/// file is one too) and timed commands.
///
///     InitialObjectDescriptor { ... }    first, or not at all
///     the scene: PROTOs, one node, ROUTEs (`DEF name ROUTE` has an ID)
///     [RAP] AT time { commands }         D before the time: after the access unit before
///     commands outside of AT             are of time 0
///
///     REPLACE SCENE BY scene             REPLACE n BY node                DELETE n
///     INSERT AT n.field[i] value         APPEND TO n.field value          XDELETE n
///     REPLACE n.field BY value           REPLACE n.field[i] BY value      DELETE n.field[i]
///     DELETE n.nodefield                 DELETE LAST n.field (FIRST)      GLOBALQP node or NULL
///     INSERT ROUTE [DEF r] a.b TO c.d    REPLACE ROUTE r BY a.b TO c.d    DELETE ROUTE r
///     MULTIPLEREPLACE n { field value }  MULTIPLEINDREPLACE n.field [ i BY value ]
///     XREPLACE n.field BY value          also n.field[i], n.field[m.index], n.field[i].child and
///                                        BY m.field
///     INSERTPROTO [ PROTOs ]             DELETEPROTO [ names ] or ALL
///     UPDATE OD [ ObjectDescriptors ]    REMOVE OD [ IDs ]
///     UPDATE ESD IN id esDescr [ ... ]   REMOVE ESD FROM id [ ES_IDs ]
///
/// [-1] and [LAST] are the last element, [0] and [FIRST] the first. A node whose DEF name is N<k>
/// has the ID k + 1 if that is free, other nodes with names the smallest free one; ROUTEs likewise
/// by R<k> (bifs/id_assignment.h). Access units of one time are one; within a stream times do not
/// go back. Beyond the peer:
///
///     UnknownDescriptor { tag n data "..." }    in otherDescr [ ], and where descriptors stand
///     UnknownCommand { tag n data "..." }       bytes as in nodes/byte_text.h
///
/// Errors    those of read_scene_text; unsupported: AT ... IN another scene stream
/// Warnings  those of read_scene_text; top_nodes: several top nodes, or one that may not stand
///           there, are put under a Group; mux_info: a field of MuxInfo that is left out;
///           no_route: R<k> means the ID of a ROUTE that is not there
/// Source    the dialect of the peer (spec/bifs.md 17)
Result<Presentation> read_bt(std::string_view text, const Limits& limits, Diagnostics& diagnostics,
                             const nodes::SceneReadOptions& options = {});

}  // namespace afx::bifs
