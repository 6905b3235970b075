// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/exposure.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace afx {
namespace {

// A solid cube of voxels with its corner at `low`.
std::vector<Voxel> solid(uint32_t low, uint32_t side) {
  std::vector<Voxel> voxels;
  for (uint32_t x = 0; x < side; ++x)
    for (uint32_t y = 0; y < side; ++y)
      for (uint32_t z = 0; z < side; ++z) voxels.push_back({low + x, low + y, low + z});
  return voxels;
}

bool on_surface(const Voxel& v, uint32_t low, uint32_t side) {
  const auto end = [&](uint32_t c) { return c == low || c == low + side - 1; };
  return end(v.x) || end(v.y) || end(v.z);
}

TEST(ExposedVoxels, OfASolidCubeAreItsOutermostLayer) {
  for (const uint32_t low : {0U, 5U}) {
    const std::vector<Voxel> voxels = solid(low, 11);
    const std::vector<uint8_t> exposed = exposed_voxels(voxels, 4, 2);
    for (size_t i = 0; i < voxels.size(); ++i)
      EXPECT_EQ(exposed[i] != 0, on_surface(voxels[i], low, 11)) << i;
  }
}

TEST(ExposedVoxels, ExcludeWhatIsShutIn) {
  std::vector<Voxel> voxels;
  for (const Voxel& v : solid(2, 10))
    if (on_surface(v, 2, 10)) voxels.push_back(v);
  voxels.push_back({6, 6, 6});  // inside the hollow cube
  const std::vector<uint8_t> exposed = exposed_voxels(voxels, 4, 1);
  EXPECT_EQ(exposed.back(), 0);
  EXPECT_EQ(std::count(exposed.begin(), exposed.end(), 1),
            static_cast<std::ptrdiff_t>(voxels.size()) - 1);
}

TEST(ExposedVoxels, IncludeTheWallsOfADent) {
  // A cube with a pit one voxel wide from the top, three deep: no axis but y sees its walls, from
  // which only slanting lines and the way straight up lead out.
  std::vector<Voxel> voxels;
  for (const Voxel& v : solid(1, 9))
    if (!(v.x == 5 && v.z == 5 && v.y >= 7)) voxels.push_back(v);
  const std::vector<uint8_t> exposed = exposed_voxels(voxels, 4, 1);
  const auto at = [&](Voxel v) {
    return exposed[static_cast<size_t>(std::find(voxels.begin(), voxels.end(), v) -
                                       voxels.begin())];
  };
  EXPECT_EQ(at({4, 7, 5}), 1);
  EXPECT_EQ(at({5, 6, 5}), 1);
  EXPECT_EQ(at({4, 6, 5}), 0);
}

}  // namespace
}  // namespace afx
