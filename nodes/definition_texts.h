// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

namespace afx::nodes {

/// A file of nodes/definitions/, compiled in.
struct DefinitionText {
  const char* name;  ///< "v1.nodes" and so on, in order of version
  const char* text;
};
extern const DefinitionText kDefinitionTexts[];
extern const unsigned kDefinitionTextCount;

}  // namespace afx::nodes
