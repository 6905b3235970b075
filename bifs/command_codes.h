// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Numbers and small rules of the command syntax, for decoder and encoder.
// Source: ISO/IEC 14496-11 (clauses not checked); spec/bifs.md 3, 5, 7, 8, 12.
#pragma once

#include <cstdint>

#include "nodes/definitions.h"

namespace afx::bifs {

inline constexpr uint32_t kInsertionCommand = 0;
inline constexpr uint32_t kDeletionCommand = 1;
inline constexpr uint32_t kReplacementCommand = 2;
inline constexpr uint32_t kSceneReplacementCommand = 3;

inline constexpr uint32_t kNodeSubtype = 0;
inline constexpr uint32_t kExtendedSubtype = 1;  ///< of insertions
inline constexpr uint32_t kFieldSubtype = 1;     ///< of replacements
inline constexpr uint32_t kValueSubtype = 2;
inline constexpr uint32_t kRouteSubtype = 3;

inline constexpr uint32_t kProtoListInsertion = 0;
inline constexpr uint32_t kProtoListDeletion = 1;
inline constexpr uint32_t kAllProtoDeletion = 2;
inline constexpr uint32_t kMultipleIndexedReplacement = 3;
inline constexpr uint32_t kMultipleFieldReplacement = 4;
inline constexpr uint32_t kGlobalQuantizer = 5;
inline constexpr uint32_t kNodeDeletionEx = 6;
inline constexpr uint32_t kXReplace = 7;

inline constexpr uint32_t kPositionIndex = 0;
inline constexpr uint32_t kPositionFirst = 2;
inline constexpr uint32_t kPositionLast = 3;
inline constexpr unsigned kNodePositionBits = 8;    ///< index of a node insertion
inline constexpr unsigned kValuePositionBits = 16;  ///< of the other indexed commands

/// The definition whose indices a node description uses: the fields that a Script declares are not
/// part of it.
inline const nodes::NodeDefinition& node_layout(const nodes::NodeDefinition& definition) {
  if (!definition.script) return definition;
  const nodes::NodeDefinition* standard = nodes::definitions().find(definition.name);
  return standard != nullptr ? *standard : definition;
}

}  // namespace afx::bifs
