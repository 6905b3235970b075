// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What a scene shows by depth images and octrees, resolved.
#pragma once

#include <glm/mat4x4.hpp>
#include <map>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include "afx/depth_image.h"
#include "afx/octree_model.h"
#include "afx/scene_files.h"
#include "codec/diagnostics.h"
#include "codec/error.h"
#include "codec/limits.h"
#include "nodes/scene.h"
#include "nodes/traversal.h"

namespace afx {

/// DepthImages that belong together, or an OctreeImage.
using DibrShape = std::variant<std::vector<DepthImage>, OctreeModel>;

/// One object: a shape and where it stands. Objects that show the same nodes share one shape.
struct DibrModel {
  glm::dmat4 to_world{1};                  ///< from the coordinates of its nodes
  std::shared_ptr<const DibrShape> shape;  ///< not null in what is handed out

  DibrModel() = default;
  DibrModel(const glm::dmat4& matrix, std::shared_ptr<const DibrShape> shared)
      : to_world(matrix), shape(std::move(shared)) {}
  /// A shape of its own.
  DibrModel(const glm::dmat4& matrix, DibrShape own)
      : DibrModel(matrix, std::make_shared<DibrShape>(std::move(own))) {}

  /// The one that it is; the other is null.
  [[nodiscard]] const std::vector<DepthImage>* depth_images() const {
    return std::get_if<std::vector<DepthImage>>(shape.get());
  }
  [[nodiscard]] const OctreeModel* octree() const { return std::get_if<OctreeModel>(shape.get()); }
};

/// Reads objects of one scene and keeps what they show: nodes that are met again, in another place
/// or at another time, are not read again. (Instances of a PROTO are different nodes each.) The
/// scene must not change meanwhile.
class DibrModelReader {
 public:
  /// left   what all together may take; its memory becomes less by what is read. Must outlive this
  DibrModelReader(UrlBase base, Limits& left) : base_(std::move(base)), left_(left) {}

  /// Errors and warnings as read_dibr_models, the warnings of a node once.
  Result<DibrModel> read(const nodes::DibrObject& object, Diagnostics& diagnostics);

 private:
  using Shared = std::shared_ptr<const DibrShape>;
  Result<Shared> read_octree(const nodes::DibrObject& object, Diagnostics& diagnostics);
  Result<Shared> read_images(const nodes::DibrObject& object, Diagnostics& diagnostics);
  void take(uint64_t bytes);

  UrlBase base_;
  Limits& left_;
  std::map<std::vector<uint32_t>, Shared> known_;  // by the paths of the nodes
};

/// Reads all objects of a scene, in its order (nodes/traversal.h), with their pictures. Nodes that
/// USE shows in several places are read once.
/// Errors    those of find_dibr_objects, read_depth_image, read_octree_model; limit_exceeded: all
///           together take more than limits.memory
/// Warnings  those of the readers
Result<std::vector<DibrModel>> read_dibr_models(const nodes::Scene& scene, const UrlBase& base,
                                                const Limits& limits, Diagnostics& diagnostics);

}  // namespace afx
