// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// From where `afx render` looks: fitted to the model, by numbers, or from a Viewpoint of the scene.
#pragma once

#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "afx/surroundings.h"
#include "render/camera.h"
#include "tools/session.h"

namespace afx::tools {

/// What the command line says; angles in degrees.
struct CameraOptions {
  std::optional<double> azimuth, elevation, margin;  ///< fitted only
  std::optional<double> field_of_view, view_height, near_plane;
  bool orthographic = false;
  std::string position, look_at, up;  ///< "X,Y,Z"
  std::string orientation;            ///< "AX,AY,AZ,ANGLE", the angle in radians as in scenes
  std::string viewpoint;              ///< its name or number

  /// Whether it is fitted to the model.
  [[nodiscard]] bool is_fitted() const { return position.empty() && viewpoint.empty(); }
};

/// A sentence about options that are wrong or do not go together; empty: there is none.
std::string wrong_camera_option(const CameraOptions& options);

/// What is looked at.
struct Sight {
  std::vector<glm::dvec3> outline;  ///< points that hold it all
  std::vector<Viewpoint> viewpoints;
};

/// The camera for a picture of width/height `aspect`. Fitted with `ring`: so that nothing is cut
/// whichever way the camera is turned around the vertical axis through the model's middle.
/// options   that wrong_camera_option finds nothing wrong with
/// input     for messages
/// Returns   an exit code
int choose_camera(const CameraOptions& options, const Sight& sight, double aspect, bool ring,
                  const Session& session, const std::string& input, render::Camera& camera);

/// A point on the axis that a turntable turns around: that which the camera looks at by --look-at,
/// else the middle of the model.
glm::dvec3 turning_point(const CameraOptions& options, const Sight& sight);

/// The camera turned to the right by an angle in radians, around the vertical axis through a point.
render::Camera turned_camera(const render::Camera& camera, const glm::dvec3& around, double angle);

/// The numbers that give the camera again, by the names of the options.
nlohmann::ordered_json json_of(const render::Camera& camera);

}  // namespace afx::tools
