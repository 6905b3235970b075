// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The inside of xmt_writer.h: descriptors and the commands of their stream.
#pragma once

#include "bifs/descriptor.h"
#include "bifs/od_command.h"
#include "bifs/xmt_output.h"

namespace afx::bifs {

void write_xmt_initial(XmtOutput& out, const InitialObjectDescriptor& initial);
void write_xmt_od_command(XmtOutput& out, const OdCommand& command);

}  // namespace afx::bifs
