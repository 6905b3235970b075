// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/software/backdrop_painter.h"

#include <glm/common.hpp>

#include "render/shading.h"

namespace afx::render {

BackdropPainter::BackdropPainter(const Backdrop& backdrop, const Lens& lens,
                                 const RenderOptions& options, const MipPictures& pictures)
    : backdrop_(backdrop), rays_(backdrop, lens), samples_(options.samples), pictures_{} {
  for (size_t k = 0; k < pictures_.size(); ++k)
    pictures_[k] = pictures.find(backdrop.pictures[k].get());
}

glm::vec3 BackdropPainter::light(uint32_t x, uint32_t y) const {
  const glm::dvec2 at(samples_ * (x + 0.5), samples_ * (y + 0.5));
  const glm::dvec3 ray = rays_.at(at);
  const CubePlace cube = cube_place(ray);
  const MipPicture* picture = pictures_[cube.face];
  glm::vec4 texel(0);
  if (picture != nullptr) {
    const auto change = [&](double right, double down) {
      return place_on_face(cube.face, rays_.at(at + glm::dvec2(right, down))) - cube.place;
    };
    texel = picture->at(cube.place, picture->level_for(change(samples_, 0), change(0, samples_)),
                        false, false);
  }
  const glm::vec3 over = linear_light(glm::vec3(texel));
  if (texel.w == 1) return over;
  return glm::mix(linear_light(sky_colour(backdrop_, ray)), over, texel.w);
}

}  // namespace afx::render
