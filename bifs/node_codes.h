// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The numbers that BIFS gives to nodes and fields. They follow by rule from the definitions.
#pragma once

#include <cstdint>
#include <optional>

#include "nodes/definitions.h"

namespace afx::bifs {

/// BIFS versions whose code tables a node code walks through. Version 10 has only private nodes,
/// whose tables are not here; a code that escapes beyond version 9 is an error.
inline constexpr unsigned kVersions = 9;
/// Code 0: the node is in the table of a later version.
inline constexpr uint32_t kEscapeCode = 0;
/// Version 2, in every node data type: a PROTO instance.
inline constexpr uint32_t kProtoCode = 1;
inline constexpr unsigned kProtoVersion = 2;

/// Bits needed to write x: 0 for 0, else floor(log2 x) + 1.
unsigned bits_for(uint64_t x);

/// Width of the node codes of a node data type in a version (1..kVersions), 0..7 bits.
/// Source: ISO/IEC 14496-11 (clause not checked); spec/bifs.md 6.2.
unsigned node_code_bits(nodes::NodeDataType type, unsigned version);
/// The code of a node in its version's table of a node data type; none if it may not stand there.
std::optional<uint32_t> node_code(const nodes::NodeDefinition& node, nodes::NodeDataType type);
/// The node with a code; nullptr for kEscapeCode, kProtoCode in version 2, and codes not given.
const nodes::NodeDefinition* node_of_code(nodes::NodeDataType type, unsigned version,
                                          uint32_t code);

/// Number of fields in a mode.
uint32_t field_count(const nodes::NodeDefinition& node, nodes::IndexMode mode);
/// Width of a field index: bits_for(count - 1), 0 for one field. A mode without fields is never
/// coded.
unsigned field_index_bits(const nodes::NodeDefinition& node, nodes::IndexMode mode);

}  // namespace afx::bifs
