// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include "afx/builder/mesh_look.h"
#include "afx/builder/view_source.h"
#include "afx/surfels.h"
#include "codec/limits.h"

namespace afx {

/// Views of a mesh. The look must stay as it is.
class MeshViews : public ViewSource {
 public:
  MeshViews(const MeshLook& look, unsigned threads, const Limits& limits)
      : look_(look), threads_(threads), limits_(limits) {}

  [[nodiscard]] Bounds bounds_along(const glm::dmat3& axes) const override;
  Result<DepthImage> take(const Shot& shot, unsigned depth_bits) const override;
  Result<std::vector<float>> distances(const Shot& shot) const override;
  Result<PointCloud> samples(size_t count) const override;

 private:
  const MeshLook& look_;
  unsigned threads_;
  Limits limits_;
};

}  // namespace afx
