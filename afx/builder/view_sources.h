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

/// Views of pieces of surface (surfel_drawing.h). They must stay as they are.
class SurfelViews : public ViewSource {
 public:
  SurfelViews(const Surfels& surfels, unsigned threads, const Limits& limits)
      : surfels_(surfels), threads_(threads), limits_(limits) {}

  [[nodiscard]] Bounds bounds_along(const glm::dmat3& axes) const override;
  Result<DepthImage> take(const Shot& shot, unsigned depth_bits) const override;
  /// To a step of 16 bits of depth.
  Result<std::vector<float>> distances(const Shot& shot) const override;
  /// Errors  bad_argument: there are no pieces
  Result<PointCloud> samples(size_t count) const override;

 private:
  const Surfels& surfels_;
  unsigned threads_;
  Limits limits_;
};

}  // namespace afx
