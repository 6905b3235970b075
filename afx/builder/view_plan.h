// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// From where pictures of a model are taken: box texture, generalized box texture, or as many views
// as it takes to see everything. Source: the paper, sections III and VII.A.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <vector>

#include "afx/builder/view_source.h"
#include "codec/error.h"

namespace afx {

/// The most views that are taken of one model.
inline constexpr unsigned kMostViews = 255;

struct ViewOptions {
  uint32_t resolution = 256;  ///< pixels along the model's longest side
  bool orthographic = true;
};

/// The longest side of the upright box around a model; 1 for one without extent.
double longest_side(const ViewSource& source);

/// Directions from the model to the camera, evenly spread: 6 are those of a box (reference_name());
/// any other number lies on a spiral from top to bottom (Fibonacci lattice).
///
/// count   1..kMostViews
std::vector<glm::dvec3> even_directions(unsigned count);

/// The view from a direction that just holds the model. Pixels are squares whose side is the
/// model's longest side / resolution (in perspective: at the model's middle). A camera from the
/// side holds +y up, one from above or below -z or +z.
Shot view_from(const ViewSource& source, const glm::dvec3& direction, const ViewOptions& options);

/// How much of what can be seen at all a set of views shows.
struct Coverage {
  uint64_t visible = 0;  ///< points of the surface that some of many directions see
  uint64_t covered = 0;  ///< of those, the ones that the views show

  [[nodiscard]] double part() const {
    return visible == 0 ? 1 : static_cast<double>(covered) / static_cast<double>(visible);
  }
};

/// Sees which points of a surface views show: those whose pixel has them in front, and not from the
/// side by less than 10 degrees.
class CoverageMeter {
 public:
  /// Looks at the model from 128 directions first.
  /// progress   called with 0..1; may be empty
  /// Errors     those of the source
  static Result<CoverageMeter> of(const ViewSource& source,
                                  const std::function<void(double)>& progress = {});

  /// What the views show all together. Errors   those of the source
  [[nodiscard]] Result<Coverage> measure(const std::vector<Shot>& views) const;

  /// Directions of views that show nearly all that can be seen: the six of a box, then each time
  /// the one of 128 that shows the most that none before did, until that is less than 1 in 2000
  /// of all. At most `most`.
  [[nodiscard]] std::vector<glm::dvec3> choose(unsigned most = kMostViews) const;

 private:
  explicit CoverageMeter(const ViewSource& source) : source_(&source) {}
  [[nodiscard]] Result<std::vector<bool>> shown(const Shot& shot) const;

  const ViewSource* source_;
  PointCloud points_;
  std::vector<glm::dvec3> directions_;
  std::vector<std::vector<bool>> shown_;  // for each direction, which points
  std::vector<bool> visible_;             // the points that any of them shows
};

}  // namespace afx
