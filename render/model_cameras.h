// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The cameras of the pictures that models are made of, for viewers that show where they stand.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <span>
#include <vector>

#include "afx/depth_camera.h"
#include "afx/dibr_model.h"

namespace afx::render {

/// The camera of one picture of one model.
struct ModelCamera {
  enum class Kind : uint8_t {
    depth_image,     ///< of a DepthImage: what lies between its planes is in the picture
    reference_image  ///< of an image of an OctreeImage: its planes are those that touch the cube.
                     ///< The near one may have a distance below 0: nothing is cut off there
  };
  Kind kind = Kind::depth_image;
  size_t model = 0;        ///< number of the model
  size_t image = 0;        ///< number of the image in it
  DepthCamera camera;      ///< in the coordinates of the model
  glm::dmat4 to_world{1};  ///< from there; it may stretch and mirror
};

/// The cameras of all models, in their order.
/// models   each with a shape
std::vector<ModelCamera> model_cameras(std::span<const DibrModel> models);

}  // namespace afx::render
