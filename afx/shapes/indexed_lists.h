// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Lists of indices that are divided by -1, and values that corners have by them. Source: ISO/IEC
// 14772-1:1997 (VRML97), IndexedFaceSet, IndexedLineSet (clauses not checked).
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "afx/node_error.h"
#include "codec/error.h"
#include "codec/limits.h"
#include "nodes/node_view.h"

namespace afx {

/// Faces or lines by the numbers of their points. Empty ones are left out.
struct IndexedCorners {
  std::vector<uint32_t> points;     ///< of each corner
  std::vector<uint32_t> places;     ///< of each corner: where in coordIndex it stands
  std::vector<uint32_t> starts{0};  ///< the first corner of each face, then their number
};

/// Reads coordIndex. corner_bytes   what a corner will take in all, for the limit
/// Errors  bad_argument: an index that is not -1 or the number of one of so many points;
///         limit_exceeded: limits.memory
Result<IndexedCorners> read_corners(const nodes::NodeView& node, size_t points,
                                    uint64_t corner_bytes, const Limits& limits);

/// A kind of value, e.g. colours.
struct IndexedAttribute {
  std::string_view field;        ///< of the node that holds the values, e.g. "color"
  std::string_view list;         ///< of the values there, e.g. "color"
  std::string_view index_field;  ///< e.g. "colorIndex"; empty: there is none
  bool per_corner = true;        ///< false: one for each face
};

/// Which value each corner has. By corner: index_field as coordIndex is built, or if it is empty
/// coordIndex itself. By face: index_field one for each, or if it is empty in order.
/// Errors  bad_argument: an index that is not the number of one of so many values; too few of them
Result<std::vector<uint32_t>> corner_numbers(const nodes::NodeView& node,
                                             const IndexedAttribute& attribute, size_t values,
                                             const IndexedCorners& corners);

namespace lists {
inline bool is_finite(const glm::vec2& v) { return std::isfinite(v.x) && std::isfinite(v.y); }
inline bool is_finite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
}  // namespace lists

/// The values of a list in the node in a field, as they stand in the scene; none if there is no
/// node. Errors: bad_argument: NaN or infinity.
template <class V>
Result<std::span<const V>> finite_list(const nodes::NodeView& node, std::string_view field,
                                       std::string_view list) {
  const auto* values = node.child(field).find<std::vector<V>>(list);
  if (values == nullptr) return std::span<const V>();
  for (size_t i = 0; i < values->size(); ++i)
    if (!lists::is_finite((*values)[i]))
      return bad_node(node, "field " + std::string(field) + ": value " + std::to_string(i) +
                                " is not finite (expected finite numbers)");
  return std::span<const V>(*values);
}

/// One value for each corner; empty if the field holds no node. Errors of both above.
template <class V>
Result<std::vector<V>> corner_values(const nodes::NodeView& node, const IndexedAttribute& attribute,
                                     const IndexedCorners& corners) {
  std::vector<V> out;
  if (!node.child(attribute.field).valid()) return out;
  const auto values = finite_list<V>(node, attribute.field, attribute.list);
  if (!values.ok()) return values.error();
  const auto numbers = corner_numbers(node, attribute, values.value().size(), corners);
  if (!numbers.ok()) return numbers.error();
  out.reserve(numbers.value().size());
  for (const uint32_t number : numbers.value()) out.push_back(values.value()[number]);
  return out;
}

/// Colours drawn into 0..1.
void clamp_colours(std::vector<glm::vec3>& colours);

/// Errors  limit_exceeded: so many things of so many bytes are more than limits.memory
Status check_size(const nodes::NodeView& node, uint64_t count, uint64_t bytes,
                  const Limits& limits);

}  // namespace afx
