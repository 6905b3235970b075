// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Object descriptors and their commands as BT. Part of bt_writer, not for others.
#pragma once

#include <string>

#include "bifs/descriptor.h"
#include "bifs/od_command.h"

namespace afx::bifs {

/// `InitialObjectDescriptor { ... }`, in lines that end.
std::string bt_text(const InitialObjectDescriptor& initial);
/// A command, in lines that begin with `indent` levels.
std::string bt_text(const OdCommand& command, size_t indent);

}  // namespace afx::bifs
