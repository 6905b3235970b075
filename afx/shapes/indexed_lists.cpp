// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/shapes/indexed_lists.h"

#include <algorithm>
#include <glm/common.hpp>

namespace afx {
namespace {

using nodes::NodeView;

std::string range_text(size_t values) {
  return values == 0 ? "no index: there are no values" : "0 to " + std::to_string(values - 1);
}

Error bad_index(const NodeView& node, std::string_view field, size_t place, int32_t index,
                const std::string& expected) {
  return bad_node(node, "field " + std::string(field) + ": value " + std::to_string(place) +
                            " is " + std::to_string(index) + " (expected " + expected + ")");
}

Error too_few(const NodeView& node, std::string_view field, size_t count, size_t least) {
  return bad_node(node, "field " + std::string(field) + " has " + std::to_string(count) +
                            " values (expected at least " + std::to_string(least) + ")");
}

bool in_range(int32_t index, size_t values) {
  return index >= 0 && static_cast<size_t>(index) < values;
}

/// The numbers of corners of which each has a place in a list of indices.
Result<std::vector<uint32_t>> look_up(const NodeView& node, std::string_view field,
                                      const std::vector<int32_t>& list, size_t values,
                                      std::vector<uint32_t> places) {
  for (uint32_t& place : places) {
    if (place >= list.size()) return too_few(node, field, list.size(), size_t{place} + 1);
    if (!in_range(list[place], values))
      return bad_index(node, field, place, list[place], range_text(values));
    place = static_cast<uint32_t>(list[place]);
  }
  return places;
}

}  // namespace

Status check_size(const NodeView& node, uint64_t count, uint64_t bytes, const Limits& limits) {
  if (count <= limits.memory / bytes && count < (uint64_t{1} << 31)) return {};
  return bad_node(node, "has " + std::to_string(count) + " corners, more than the limit",
                  Errc::limit_exceeded);
}

void clamp_colours(std::vector<glm::vec3>& colours) {
  for (glm::vec3& colour : colours) colour = glm::clamp(colour, 0.0F, 1.0F);
}

Result<IndexedCorners> read_corners(const NodeView& node, size_t points, uint64_t corner_bytes,
                                    const Limits& limits) {
  const auto& list = node.get<std::vector<int32_t>>("coordIndex");
  if (Status status = check_size(node, list.size(), corner_bytes, limits); !status.ok())
    return status.error();
  IndexedCorners out;
  const auto end_face = [&] {
    if (out.points.size() > out.starts.back())
      out.starts.push_back(static_cast<uint32_t>(out.points.size()));
  };
  for (size_t place = 0; place < list.size(); ++place) {
    if (list[place] == -1) {
      end_face();
    } else if (in_range(list[place], points)) {
      out.points.push_back(static_cast<uint32_t>(list[place]));
      out.places.push_back(static_cast<uint32_t>(place));
    } else {
      return bad_index(node, "coordIndex", place, list[place],
                       points == 0 ? "-1: there are no points" : "-1 or " + range_text(points));
    }
  }
  end_face();
  return out;
}

Result<std::vector<uint32_t>> corner_numbers(const NodeView& node,
                                             const IndexedAttribute& attribute, size_t values,
                                             const IndexedCorners& corners) {
  std::vector<uint32_t> places = attribute.per_corner ? corners.places : corners.points;
  if (!attribute.per_corner)
    for (uint32_t face = 0; face + 1 < corners.starts.size(); ++face)
      std::fill(places.begin() + corners.starts[face], places.begin() + corners.starts[face + 1],
                face);
  const auto* list = node.find<std::vector<int32_t>>(attribute.index_field);
  if (list != nullptr && !list->empty())
    return look_up(node, attribute.index_field, *list, values, std::move(places));
  if (attribute.per_corner) places = corners.points;
  const auto most = std::max_element(places.begin(), places.end());
  if (most != places.end() && *most >= values)
    return too_few(node, attribute.field, values, size_t{*most} + 1);
  return places;
}

}  // namespace afx
