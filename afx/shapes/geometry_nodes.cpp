// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/shapes/geometry_nodes.h"

#include <algorithm>
#include <string>
#include <utility>

#include "afx/node_error.h"
#include "afx/shapes/face_nodes.h"
#include "afx/shapes/field_reader.h"
#include "afx/shapes/indexed_lists.h"
#include "afx/shapes/solids.h"

namespace afx {
namespace {

using nodes::NodeView;

constexpr uint64_t kSolidBytes = 65536;  // a sphere has 561 corners, the most
constexpr uint64_t kLineCornerBytes = 64;

Result<Geometry> read_box(const NodeView& node, const Limits& /*limits*/) {
  FieldReader fields(node);
  const glm::vec3 size = fields.sizes3("size");
  if (!fields.ok()) return fields.error();
  return box_geometry(size);
}

Result<Geometry> read_sphere(const NodeView& node, const Limits& /*limits*/) {
  FieldReader fields(node);
  const float radius = fields.at_least("radius", 0);
  if (!fields.ok()) return fields.error();
  return sphere_geometry(radius);
}

Result<Geometry> read_round(const NodeView& node, const Limits& /*limits*/) {
  const bool cone = node.type() == "Cone";
  FieldReader fields(node);
  RoundSolid solid;
  solid.radius = fields.at_least(cone ? "bottomRadius" : "radius", 0);
  solid.height = fields.at_least("height", 0);
  solid.side = node.get<bool>("side");
  solid.bottom = node.get<bool>("bottom");
  solid.top = !cone && node.get<bool>("top");
  if (!fields.ok()) return fields.error();
  return cone ? cone_geometry(solid) : cylinder_geometry(solid);
}

Result<Geometry> read_point_set(const NodeView& node, const Limits& limits) {
  const auto points = finite_list<glm::vec3>(node, "coord", "point");
  if (!points.ok()) return points.error();
  const size_t count = points.value().size();
  if (Status status = check_size(node, count, kLineCornerBytes, limits); !status.ok())
    return status.error();
  Geometry out;
  out.kind = Geometry::Kind::points;
  out.positions.assign(points.value().begin(), points.value().end());
  IndexedCorners corners;
  for (uint32_t i = 0; i < count; ++i) corners.points.push_back(i);
  corners.places = corners.points;
  auto colours = corner_values<glm::vec3>(node, {"color", "color", "", true}, corners);
  if (!colours.ok()) return std::move(colours).error();
  out.colours = std::move(colours).value();
  clamp_colours(out.colours);
  out.indices = std::move(corners.points);
  return out;
}

Result<Geometry> read_line_set(const NodeView& node, const Limits& limits) {
  const auto points = finite_list<glm::vec3>(node, "coord", "point");
  if (!points.ok()) return points.error();
  const auto corners = read_corners(node, points.value().size(), kLineCornerBytes, limits);
  if (!corners.ok()) return corners.error();
  auto colours = corner_values<glm::vec3>(
      node, {"color", "color", "colorIndex", node.get<bool>("colorPerVertex")}, corners.value());
  if (!colours.ok()) return std::move(colours).error();
  Geometry out;
  out.kind = Geometry::Kind::lines;
  for (const uint32_t point : corners.value().points)
    out.positions.push_back(points.value()[point]);
  out.colours = std::move(colours).value();
  clamp_colours(out.colours);
  const std::vector<uint32_t>& starts = corners.value().starts;
  for (size_t line = 0; line + 1 < starts.size(); ++line)
    for (uint32_t c = starts[line]; c + 1 < starts[line + 1]; ++c)
      out.indices.insert(out.indices.end(), {c, c + 1});
  return out;
}

struct GeometryRule {
  std::string_view type;
  Result<Geometry> (*read)(const NodeView&, const Limits&);
  uint64_t bytes;  // what it takes whatever its fields are
};
constexpr GeometryRule kRules[] = {
    {"Box", read_box, kSolidBytes},
    {"Cone", read_round, kSolidBytes},
    {"Cylinder", read_round, kSolidBytes},
    {"ElevationGrid", read_elevation_grid, 0},
    {"IndexedFaceSet", read_indexed_face_set, 0},
    {"IndexedLineSet", read_line_set, 0},
    {"PointSet", read_point_set, 0},
    {"Sphere", read_sphere, kSolidBytes},
};

const GeometryRule* find_rule(std::string_view type) {
  const auto* rule = std::find_if(std::begin(kRules), std::end(kRules),
                                  [&](const GeometryRule& r) { return r.type == type; });
  return rule == std::end(kRules) ? nullptr : rule;
}

}  // namespace

bool is_known_geometry(std::string_view type) { return find_rule(type) != nullptr; }

Result<Geometry> read_geometry(const NodeView& node, const Limits& limits) {
  const GeometryRule* rule = find_rule(node.type());
  if (rule == nullptr)
    return bad_node(node, "is not a geometry that can be shown", Errc::unsupported);
  if (rule->bytes > limits.memory)
    return bad_node(node, "does not fit into the memory that is left", Errc::limit_exceeded);
  return rule->read(node, limits);
}

uint64_t bytes_of(const Geometry& geometry) {
  return (geometry.positions.size() + geometry.normals.size() + geometry.colours.size()) *
             sizeof(glm::vec3) +
         geometry.texture_coordinates.size() * sizeof(glm::vec2) +
         geometry.indices.size() * sizeof(uint32_t);
}

}  // namespace afx
