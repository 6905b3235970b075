// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Models of any kind, made ready to be drawn.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "afx/builder/mesh.h"
#include "afx/builder/mesh_look.h"
#include "codec/diagnostics.h"
#include "codec/error.h"
#include "render/model_cameras.h"
#include "render/renderer.h"
#include "render/scene_maker.h"
#include "tools/model_input.h"
#include "tools/session.h"
#include "tools/shown_scene.h"

namespace afx::tools {

/// Who looks through a camera.
inline nodes::Viewer viewer_of(const render::Camera& camera) {
  return {camera.position, camera.orientation * glm::dvec3(0, 1, 0)};
}

/// What is drawn: a mesh, as it is, or what a scene shows.
class Drawing {
 public:
  Drawing(const Session& session, Diagnostics& diagnostics)
      : session_(session), diagnostics_(diagnostics) {}
  Drawing(const Drawing&) = delete;
  Drawing& operator=(const Drawing&) = delete;

  /// Octrees are drawn at this level, or at their finest. To be said before anything is added.
  void set_level(unsigned level) { level_ = level; }

  /// Adds what a scene of any kind shows, as it is without a viewer; nothing else may be added.
  /// Errors and warnings: those of ShownScene and of SceneMaker; malformed: there is nothing to
  /// draw
  Status add_scene(Input input);
  /// Adds any model; a mesh must be the only one.
  /// shade   for a mesh
  Status add(ModelInput&& model, Shade shade);

  /// Whether the scene changes with the viewer (LOD, Billboard).
  [[nodiscard]] bool depends_on_viewer() const { return depends_on_viewer_; }
  /// Reads such a scene for another viewer; for others this does nothing. After an error it is as
  /// it was before. Errors and warnings: as add_scene
  Status set_viewer(const nodes::Viewer& viewer, Diagnostics& diagnostics);
  /// Whom it was last read for; none: as it is without one.
  [[nodiscard]] const std::optional<nodes::Viewer>& viewer() const { return viewer_; }
  /// Those that the scene names.
  [[nodiscard]] const std::vector<Viewpoint>& viewpoints() const { return viewpoints_; }
  /// Of the pictures of its models.
  [[nodiscard]] const std::vector<render::ModelCamera>& cameras() const { return cameras_; }

  [[nodiscard]] bool is_mesh() const { return mesh_ != nullptr; }
  /// All of it, for a renderer of one's own; of a mesh shapes that are made anew each time. Errors:
  /// those of shapes_of(Mesh)
  [[nodiscard]] Result<render::Scene> scene() const;

  /// Points that hold all of it, for render::fit_camera.
  [[nodiscard]] std::vector<glm::dvec3> outline() const;

  /// Draws it once, in software. The depths of a mesh are those at the pixels' centres.
  [[nodiscard]] Result<render::RenderedImage> draw(const render::Camera& camera,
                                                   const render::RenderOptions& options) const;

  /// "1,234 voxels, 17 points and 500 triangles".
  [[nodiscard]] std::string size() const;
  [[nodiscard]] uint64_t voxels() const;

 private:
  render::SceneMaker& maker();
  Status add(const std::vector<DibrModel>& models);
  Status read_scene_for(const std::optional<nodes::Viewer>& viewer, Diagnostics& diagnostics);
  [[nodiscard]] Result<render::RenderedImage> draw_mesh(const render::Camera& camera,
                                                        const render::RenderOptions& options) const;

  const Session& session_;
  Diagnostics& diagnostics_;
  unsigned level_ = 32;
  Shade shade_ = Shade::automatic;
  std::shared_ptr<const Mesh> mesh_;
  std::unique_ptr<MeshLook> look_;
  std::vector<glm::dvec3> corners_;  // of the mesh
  std::unique_ptr<ShownScene> shown_;
  std::optional<render::SceneMaker> maker_;
  bool depends_on_viewer_ = false;
  std::optional<nodes::Viewer> viewer_;
  std::vector<Viewpoint> viewpoints_;
  std::vector<render::ModelCamera> cameras_;
  render::Scene scene_;  // what is not a mesh
};

}  // namespace afx::tools
