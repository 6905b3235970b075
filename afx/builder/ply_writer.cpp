// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/ply_writer.h"

#include <bit>
#include <initializer_list>
#include <string>

namespace afx {
namespace {

std::string header_of(const PointCloud& cloud, bool doubles) {
  std::string text = "ply\nformat binary_little_endian 1.0\nelement vertex " +
                     std::to_string(cloud.positions.size()) + "\n";
  const auto add = [&](const char* type, std::initializer_list<const char*> names) {
    for (const char* name : names) text += std::string("property ") + type + " " + name + "\n";
  };
  add(doubles ? "double" : "float", {"x", "y", "z"});
  if (!cloud.normals.empty()) add("float", {"nx", "ny", "nz"});
  if (!cloud.colours.empty()) add("uchar", {"red", "green", "blue"});
  return text + "end_header\n";
}

template <class Bits>
void put(Bits bits, std::vector<uint8_t>& to) {
  for (size_t byte = 0; byte < sizeof(Bits); ++byte)
    to.push_back(static_cast<uint8_t>(bits >> (8 * byte)));
}

}  // namespace

std::vector<uint8_t> write_ply_points(const PointCloud& cloud) {
  const bool doubles = cloud.origin != glm::dvec3(0);
  const std::string header = header_of(cloud, doubles);
  std::vector<uint8_t> bytes(header.begin(), header.end());
  const size_t point_bytes = (doubles ? 24U : 12U) + (cloud.normals.empty() ? 0U : 12U) +
                             (cloud.colours.empty() ? 0U : 3U);
  bytes.reserve(bytes.size() + cloud.positions.size() * point_bytes);
  for (size_t n = 0; n < cloud.positions.size(); ++n) {
    for (int axis = 0; axis < 3; ++axis) {
      const float part = cloud.positions[n][axis];
      if (doubles)
        put(std::bit_cast<uint64_t>(cloud.origin[axis] + static_cast<double>(part)), bytes);
      else
        put(std::bit_cast<uint32_t>(part), bytes);
    }
    for (int axis = 0; axis < 3 && !cloud.normals.empty(); ++axis)
      put(std::bit_cast<uint32_t>(cloud.normals[n][axis]), bytes);
    if (cloud.colours.empty()) continue;
    const Rgba8 c = cloud.colours[n];
    bytes.insert(bytes.end(), {c.r, c.g, c.b});
  }
  return bytes;
}

}  // namespace afx
