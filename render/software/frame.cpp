// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/software/frame.h"

namespace afx::render {

Frame::Frame(const Scene& the_scene, const MipPictures& pictures, const Camera& camera,
             const RenderOptions& the_options)
    : scene(the_scene),
      options(the_options),
      lens(camera, options),
      grid(options),
      surfels(scene.surfels, lens, options),
      shapes(scene, lens, options, pictures) {
  octrees.reserve(scene.voxels.size());
  for (const VoxelCloud& cloud : scene.voxels) octrees.emplace_back(cloud, lens, options);
  if (options.backdrop && scene.backdrop)
    backdrop.emplace(*scene.backdrop, lens, options, pictures);
}

}  // namespace afx::render
