// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// From what a scene shows to what renderers draw: octrees become trees of coloured voxels, depth
// images become surfels.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "afx/dibr_model.h"
#include "afx/visual_scene.h"
#include "codec/diagnostics.h"
#include "codec/error.h"
#include "codec/limits.h"
#include "render/scene.h"

namespace afx::render {

struct SceneMakerOptions {
  unsigned level = 32;   ///< octrees are made at this level, or at their finest
  unsigned threads = 0;  ///< 0 = all cores; the result is the same for any number
};

/// Makes scenes ready to be drawn. What it has made of a DibrShape is kept as long as that shape
/// lives, and shared by all models that show it, in one scene and in those that are made later: a
/// scene that is read anew for another viewer (VisualSceneReader) costs only what is new in it.
class SceneMaker {
 public:
  /// limits.memory is for all that is kept.
  explicit SceneMaker(const SceneMakerOptions& options = {}, const Limits& limits = {});

  /// Everything in a scene: its models, shapes, lights, headlight, fog, backdrop.
  ///
  /// Errors    those of colour_octree, surfels_of(DepthImage) and VoxelTree::make; bad_argument: a
  ///           model without shape; limit_exceeded: more than limits.memory
  /// Warnings  those of colour_octree, for each shape once
  Result<Scene> make(const VisualScene& scene, Diagnostics& diagnostics);
  /// Models alone. Errors and warnings as above.
  Result<Scene> make(std::span<const DibrModel> models, Diagnostics& diagnostics);

 private:
  /// What a shape has become: an octree a tree, depth images each their surfels.
  struct Ready {
    std::weak_ptr<const DibrShape> shape;
    std::shared_ptr<const VoxelTree> tree;
    std::vector<std::shared_ptr<const Surfels>> surfels;
    uint64_t bytes = 0;
  };
  Status make_ready(const DibrModel& model, Ready& ready, Diagnostics& diagnostics) const;
  Status add_octree(const OctreeModel& octree, const Limits& left, Ready& ready,
                    Diagnostics& diagnostics) const;
  Status add_images(const std::vector<DepthImage>& images, Limits left, Ready& ready) const;
  Result<const Ready*> find(const DibrModel& model, Diagnostics& diagnostics);
  void forget_what_is_gone();

  SceneMakerOptions options_;
  Limits left_;
  std::map<const DibrShape*, Ready> known_;
};

}  // namespace afx::render
