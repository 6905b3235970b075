// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The two passes over all voxels and surfels of a scene.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <vector>

#include "render/gl/gl_surfels.h"
#include "render/gl/gl_target.h"
#include "render/gl/gl_voxels.h"

namespace afx::render {

/// The splats of a scene in the memory of the graphics system.
class GlSplats {
 public:
  /// Errors  as GlProgram::make
  static Result<GlSplats> make(const GlFeatures& features);

  /// Takes the splats of a scene and keeps what it shares with the one before.
  void set_scene(const Scene& scene);

  /// The clouds of the scene as one camera sees them.
  struct Frame {
    std::vector<GlVoxelCloud> voxels;
    std::vector<GlSurfelCloud> surfels;
    double farthest = 0;  ///< nothing is farther, about
  };
  /// scene   the same again; lens, options   must outlive the frame
  [[nodiscard]] Frame frame(const Scene& scene, const Lens& lens,
                            const RenderOptions& options) const;
  /// Draws into the target's samples.
  /// walls   the target has walls: splats must lie before them
  void draw(Frame& frame, const GlView& view, const GlTarget& target, bool walls) const;

 private:
  /// A program for each combination of these.
  enum Variant : unsigned { quads = 1, colour = 2, sides = 4, surfels = 8 };
  void draw_voxels(Frame& frame, const GlView& view, unsigned variant, bool walls) const;
  void draw_surfels(Frame& frame, const GlView& view, unsigned variant, bool walls) const;
  const GlProgram& begin(const GlView& view, unsigned variant, bool walls) const;

  GlFeatures features_;
  std::array<GlProgram, 16> programs_;
  std::map<const VoxelTree*, std::unique_ptr<GlTree>> trees_;
  std::map<const Surfels*, std::unique_ptr<GlSurfels>> surfels_;
};

}  // namespace afx::render
