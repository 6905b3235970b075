// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <optional>
#include <vector>

#include "render/lens.h"
#include "render/mip_picture.h"
#include "render/octree_view.h"
#include "render/renderer.h"
#include "render/scene.h"
#include "render/software/backdrop_painter.h"
#include "render/software/shape_tiles.h"
#include "render/software/splat_tiles.h"
#include "render/software/tile_samples.h"

namespace afx::render {

/// What all tiles of one picture share.
struct Frame {
  /// All checked; they must outlive it.
  /// pictures   of the scene's textures and backdrop
  Frame(const Scene& the_scene, const MipPictures& pictures, const Camera& camera,
        const RenderOptions& the_options);
  Frame(const Frame&) = delete;
  Frame& operator=(const Frame&) = delete;

  const Scene& scene;
  const RenderOptions& options;
  Lens lens;
  TileGrid grid;
  std::vector<OctreeView> octrees;
  SplatTiles surfels;
  ShapeTiles shapes;
  std::optional<BackdropPainter> backdrop;  ///< to be drawn instead of RenderOptions::background
};

}  // namespace afx::render
