// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/shapes/face_nodes.h"

#include <cmath>
#include <utility>

#include "afx/node_error.h"
#include "afx/shapes/face_mesh.h"
#include "afx/shapes/field_reader.h"
#include "afx/shapes/indexed_lists.h"

namespace afx {
namespace {

using nodes::NodeView;

/// The fields that both nodes have.
Status read_attributes(const NodeView& node, const IndexedCorners& corners, FaceMesh& mesh) {
  FieldReader fields(node);
  mesh.crease_angle = fields.at_least("creaseAngle", 0);
  if (!fields.ok()) return fields.error();
  mesh.ccw = node.get<bool>("ccw");
  mesh.solid = node.get<bool>("solid");
  auto colours = corner_values<glm::vec3>(
      node, {"color", "color", "colorIndex", node.get<bool>("colorPerVertex")}, corners);
  if (!colours.ok()) return colours.error();
  mesh.colours = std::move(colours).value();
  clamp_colours(mesh.colours);
  auto normals = corner_values<glm::vec3>(
      node, {"normal", "vector", "normalIndex", node.get<bool>("normalPerVertex")}, corners);
  if (!normals.ok()) return normals.error();
  mesh.normals = std::move(normals).value();
  auto texture =
      corner_values<glm::vec2>(node, {"texCoord", "point", "texCoordIndex", true}, corners);
  if (!texture.ok()) return texture.error();
  mesh.texture_coordinates = std::move(texture).value();
  return {};
}

Result<Geometry> triangles_of(const NodeView& node, FaceMesh& mesh, IndexedCorners corners) {
  mesh.corners = std::move(corners.points);
  mesh.starts = std::move(corners.starts);
  auto geometry = geometry_of(mesh);
  if (!geometry.ok()) return bad_node(node, geometry.error().text, geometry.error().code);
  return geometry;
}

/// An ElevationGrid with more than one row and column.
struct Grid {
  uint32_t columns = 0, rows = 0;  // of points
  float x_spacing = 1, z_spacing = 1;

  [[nodiscard]] bool empty() const { return columns < 2 || rows < 2; }
};

Result<Grid> read_grid(const NodeView& node) {
  Grid grid;
  FieldReader fields(node);
  for (const char* field : {"xDimension", "zDimension"}) {
    const auto points = node.get<int32_t>(field);
    if (points < 0) fields.fail(field, std::to_string(points), "0 or more");
    (field[0] == 'x' ? grid.columns : grid.rows) = static_cast<uint32_t>(points);
  }
  grid.x_spacing = fields.at_least("xSpacing", 0);
  grid.z_spacing = fields.at_least("zSpacing", 0);
  if (!fields.ok()) return fields.error();
  return grid;
}

Result<std::vector<glm::vec3>> grid_points(const NodeView& node, const Grid& grid) {
  const auto& heights = node.get<std::vector<float>>("height");
  const uint64_t count = uint64_t{grid.columns} * grid.rows;
  if (heights.size() < count)
    return bad_node(node, "field height has " + std::to_string(heights.size()) +
                              " values (expected " + std::to_string(count) + ")");
  std::vector<glm::vec3> points;
  points.reserve(count);
  for (uint32_t j = 0; j < grid.rows; ++j)
    for (uint32_t i = 0; i < grid.columns; ++i) {
      const glm::vec3 point(grid.x_spacing * static_cast<float>(i), heights[points.size()],
                            grid.z_spacing * static_cast<float>(j));
      if (!lists::is_finite(point))
        return bad_node(node, "field height: point (" + std::to_string(i) + ", " +
                                  std::to_string(j) + ") is not finite (expected finite numbers)");
      points.push_back(point);
    }
  return points;
}

/// Counter-clockwise as one looks down (z to the lower edge).
IndexedCorners grid_corners(const Grid& grid) {
  IndexedCorners out;
  for (uint32_t j = 0; j + 1 < grid.rows; ++j)
    for (uint32_t i = 0; i + 1 < grid.columns; ++i) {
      const uint32_t at = j * grid.columns + i, below = at + grid.columns;
      out.points.insert(out.points.end(), {at, below, below + 1, at + 1});
      out.starts.push_back(static_cast<uint32_t>(out.points.size()));
    }
  out.places = out.points;
  return out;
}

/// (0, 0) at the first point, (1, 1) at the last.
std::vector<glm::vec2> grid_texture(const Grid& grid, const IndexedCorners& corners) {
  std::vector<glm::vec2> out;
  out.reserve(corners.points.size());
  for (const uint32_t point : corners.points)
    out.emplace_back(static_cast<double>(point % grid.columns) / (grid.columns - 1),
                     static_cast<double>(point / grid.columns) / (grid.rows - 1));
  return out;
}

}  // namespace

Result<Geometry> read_indexed_face_set(const NodeView& node, const Limits& limits) {
  const auto points = finite_list<glm::vec3>(node, "coord", "point");
  if (!points.ok()) return points.error();
  auto corners = read_corners(node, points.value().size(), kFaceCornerBytes, limits);
  if (!corners.ok()) return std::move(corners).error();
  if (Status status = check_size(node, points.value().size(), sizeof(glm::vec3) * 2, limits);
      !status.ok())
    return status.error();
  FaceMesh mesh;
  mesh.points.assign(points.value().begin(), points.value().end());
  mesh.convex = node.get<bool>("convex");
  if (Status status = read_attributes(node, corners.value(), mesh); !status.ok())
    return status.error();
  return triangles_of(node, mesh, std::move(corners).value());
}

Result<Geometry> read_elevation_grid(const NodeView& node, const Limits& limits) {
  const auto grid = read_grid(node);
  if (!grid.ok()) return grid.error();
  if (grid.value().empty()) return Geometry{};
  const uint64_t count = uint64_t{grid.value().columns} * grid.value().rows;
  if (Status status = check_size(node, count, 4 * kFaceCornerBytes, limits); !status.ok())
    return status.error();
  auto points = grid_points(node, grid.value());
  if (!points.ok()) return std::move(points).error();
  FaceMesh mesh;
  mesh.points = std::move(points).value();
  IndexedCorners corners = grid_corners(grid.value());
  if (Status status = read_attributes(node, corners, mesh); !status.ok()) return status.error();
  if (mesh.texture_coordinates.empty())
    mesh.texture_coordinates = grid_texture(grid.value(), corners);
  return triangles_of(node, mesh, std::move(corners));
}

}  // namespace afx
