// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/scene_viewpoints.h"

#include <algorithm>

#include "nodes/nearest_name.h"

namespace afx::tools {
namespace {

/// "'front' and 'From the side'"; the first few.
std::string listed(const std::vector<Viewpoint>& viewpoints) {
  constexpr size_t kMost = 12;
  std::string list;
  for (size_t i = 0; i < std::min(viewpoints.size(), kMost); ++i) {
    const Viewpoint& one = viewpoints[i];
    const std::string& name = one.name.empty() ? one.description : one.name;
    list += (i == 0 ? "" : ", ") + (name.empty() ? std::to_string(i + 1) : "'" + name + "'");
  }
  return viewpoints.size() > kMost ? list + ", ..." : list;
}

}  // namespace

Result<size_t> pick_viewpoint(const std::vector<Viewpoint>& viewpoints, const std::string& name) {
  for (size_t i = 0; i < viewpoints.size(); ++i)
    if (!name.empty() && viewpoints[i].name == name) return i;
  for (size_t i = 0; i < viewpoints.size(); ++i)
    if (!name.empty() && viewpoints[i].description == name) return i;
  for (size_t i = 0; i < viewpoints.size(); ++i)
    if (std::to_string(i + 1) == name) return i;
  if (viewpoints.empty())
    return Error{Errc::bad_argument, Place::none(),
                 "there is no viewpoint '" + name + "' (the scene has none)"};
  nodes::NearestName nearest(name);
  for (const Viewpoint& one : viewpoints) {
    nearest.offer(one.name);
    nearest.offer(one.description);
  }
  return Error{Errc::bad_argument, Place::none(),
               "there is no viewpoint '" + name + "'" + nearest.hint() + " (expected " +
                   listed(viewpoints) + ", or a number from 1 to " +
                   std::to_string(viewpoints.size()) + ")"};
}

}  // namespace afx::tools
