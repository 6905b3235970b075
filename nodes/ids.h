// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <compare>
#include <cstdint>

namespace afx::nodes {

/// A number that names one thing of one kind: a node's number cannot be given where a field's is
/// meant. Default: names nothing (valid() is false).
template <class Tag>
struct Index {
  static constexpr uint32_t kNone = 0xFFFFFFFF;
  uint32_t value = kNone;

  constexpr Index() = default;
  constexpr explicit Index(uint32_t v) : value(v) {}
  constexpr explicit Index(size_t v) : value(static_cast<uint32_t>(v)) {}
  [[nodiscard]] constexpr bool valid() const { return value != kNone; }
  constexpr auto operator<=>(const Index&) const = default;
};

using NodeId = Index<struct NodeTag>;  ///< a node of a Scene; not valid: the NULL node
using ScopeId =
    Index<struct ScopeTag>;  ///< a name scope of a Scene: the scene's own or a PROTO body
using ProtoId = Index<struct ProtoTag>;  ///< a PROTO or EXTERNPROTO declaration of a Scene
using FieldIndex =
    Index<struct FieldTag>;  ///< a field of a NodeDefinition, in declared order ("ALL")

}  // namespace afx::nodes
