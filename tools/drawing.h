// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Models of any kind, made ready to be drawn.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <memory>
#include <vector>

#include "afx/builder/mesh.h"
#include "afx/builder/mesh_look.h"
#include "afx/surfels.h"
#include "codec/diagnostics.h"
#include "codec/error.h"
#include "render/renderer.h"
#include "tools/model_input.h"
#include "tools/scene_input.h"
#include "tools/session.h"

namespace afx::tools {

/// What is drawn: either a mesh, as it is, or splats.
class Drawing {
 public:
  Drawing(const Session& session, Diagnostics& diagnostics)
      : session_(session), diagnostics_(diagnostics), left_(session.limits) {}
  Drawing(const Drawing&) = delete;
  Drawing& operator=(const Drawing&) = delete;

  /// Octrees are drawn at this level, or at their finest.
  void set_level(unsigned level) { level_ = level; }

  /// Adds what a scene shows. Warnings   those of warn_of_left_out
  /// Errors  those of reading; malformed: there is nothing to draw
  Status add(const LoadedScene& scene);
  /// Adds an octree. to_world   from the cube of side 1 around the origin
  Status add(const OctreeModel& model, const glm::dmat4& to_world);
  /// Adds any model; a mesh must be the only one.
  /// shade   for a mesh
  Status add(ModelInput&& model, Shade shade);

  /// Whether it is a mesh; then scene() is empty.
  [[nodiscard]] bool is_mesh() const { return mesh_ != nullptr; }
  /// The splats, for a renderer of one's own.
  [[nodiscard]] const render::Scene& scene() const { return scene_; }

  /// Points that hold all of it, for render::fit_camera.
  [[nodiscard]] std::vector<glm::dvec3> outline() const;

  /// Draws it once. The depths of a mesh are those at the pixels' centres.
  [[nodiscard]] Result<render::RenderedImage> draw(const render::Camera& camera,
                                                   const render::RenderOptions& options) const;

  /// "1,234 voxels", "500 triangles".
  [[nodiscard]] std::string size() const;
  [[nodiscard]] uint64_t voxels() const;

 private:
  Result<std::shared_ptr<const render::VoxelTree>> colour(const OctreeModel& model);
  Status add(const std::vector<DibrModel>& models);
  /// The clouds of a shape, in its own coordinates.
  Result<render::Scene> make_ready(const DibrModel& model);
  std::shared_ptr<const Surfels> keep(Surfels&& surfels);
  [[nodiscard]] Result<render::RenderedImage> draw_mesh(const render::Camera& camera,
                                                        const render::RenderOptions& options) const;

  const Session& session_;
  Diagnostics& diagnostics_;
  unsigned level_ = 32;
  Limits left_;  // of the session's
  std::unique_ptr<Mesh> mesh_;
  std::unique_ptr<MeshLook> look_;
  std::vector<glm::dvec3> corners_;  // of the mesh
  render::Scene scene_;
};

}  // namespace afx::tools
