// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// A whole MPEG-4 scene as it is to be seen: DIBR objects, ordinary geometry, lights, surroundings.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "afx/dibr_model.h"
#include "afx/shape.h"
#include "afx/surroundings.h"
#include "nodes/traversal.h"

namespace afx {

/// What a scene shows, in plain lists.
struct VisualScene {
  std::vector<DibrModel> models;
  std::vector<Shape> shapes;  ///< none without primitives
  std::vector<Light> lights;  ///< those that are on, without the headlight
  std::optional<Backdrop> backdrop;
  std::optional<Fog> fog;
  std::vector<Viewpoint> viewpoints;  ///< the first is the one to begin with
  Navigation navigation;
  bool depends_on_viewer = false;  ///< there are LOD or Billboard nodes: read anew as one moves
};

/// A scene that an Inline names, as it was loaded.
struct InlineScene {
  std::shared_ptr<const nodes::Scene> scene;  ///< may own more: what base refers to
  UrlBase base{""};                           ///< for the urls in it
  std::string file;  ///< tells files apart: the same name, the same scene. Also for messages
};

/// Loads what the urls of an Inline name, relative to the base of the scene that it stands in.
using InlineLoader =
    std::function<Result<InlineScene>(std::span<const nodes::Url> urls, const UrlBase& base)>;

struct VisualOptions {
  std::optional<nodes::Viewer> viewer;  ///< for LOD and Billboard, see nodes/traversal.h
  InlineLoader load_inline;             ///< empty: Inlines are not shown
  std::string file;  ///< the scene's own, as the loader names files; to find that it inlines itself
};

/// How deep Inlines may stand in each other, and how many files may be loaded in all.
constexpr uint32_t kMaxInlineDepth = 8;
constexpr uint32_t kMaxInlineFiles = 256;

/// Reads a scene for one viewer after another. Pictures and geometry, DIBR or not, and Inlines are
/// kept: they are read when they are first seen.
class VisualSceneReader {
 public:
  /// scene, and what base refers to, must outlive this and not change. limits.memory is for all
  /// that is kept. options.viewer is not looked at.
  VisualSceneReader(const nodes::Scene& scene, UrlBase base, VisualOptions options,
                    const Limits& limits);
  VisualSceneReader(VisualSceneReader&&) noexcept;
  VisualSceneReader& operator=(VisualSceneReader&&) noexcept;
  ~VisualSceneReader();

  /// Errors and warnings as read_visual_scene; what has been warned of is not said again.
  Result<VisualScene> read(const std::optional<nodes::Viewer>& viewer, Diagnostics& diagnostics);

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

/// Reads all that a scene shows. The first Background, Fog and NavigationInfo count; those of an
/// Inline, and its Viewpoints, do not. Its DirectionalLights light what it shows, other lights
/// everything. What USE shows in several places is read once and shared.
///
/// Errors    those of find_scene_objects, of the readers of DIBR objects (dibr_model.h) and of
/// those
///           in afx/shapes; bad_argument: a matrix with numbers beyond 1e60; limit_exceeded: all
///           together takes more than limits.memory. One of an inlined file names it
/// Warnings  unknown_geometry: shapes that are not shown, one for all; inline_not_shown: it cannot
///           be loaded (but limit_exceeded is an error), inlines itself, or stands too deep; those
///           of the readers
Result<VisualScene> read_visual_scene(const nodes::Scene& scene, const UrlBase& base,
                                      const VisualOptions& options, const Limits& limits,
                                      Diagnostics& diagnostics);

}  // namespace afx
