// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// One interface for all ways of drawing a scene.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "afx/picture.h"
#include "codec/error.h"
#include "codec/limits.h"
#include "render/camera.h"
#include "render/scene.h"

namespace afx::render {

inline constexpr uint32_t kMaxSide = 16384;

/// How voxels and surfels are drawn.
enum class SplatKind : uint8_t {
  smooth,  ///< as wide as they are, mixed where they overlap
  flat,    ///< the same, but the nearest alone counts: one sees each
  points   ///< the smallest that leaves no sample between neighbours of a sample's size: one sees
           ///< between them from near
};

/// How a scene becomes a picture.
struct RenderOptions {
  uint32_t width = 1024;         ///< 1..kMaxSide
  uint32_t height = 1024;        ///< 1..kMaxSide
  Rgba8 background{0, 0, 0, 0};  ///< sRGB, not premultiplied; a = 0 is a transparent background
  bool backdrop = true;          ///< draw the scene's, if it has one, instead of `background`
  SplatKind splats = SplatKind::smooth;
  /// Multiplies all splats: of a disc that faces the viewer the diameter is so many times the
  /// longest projected space diagonal of its voxel (the paper has 1.3); of one on the surface the
  /// radius is 0.75 voxel sides times this; the sides of a surfel are longer by this and a tenth.
  /// At 1 or more closed surfaces have no holes. 1..8
  double splat_scale = 1;
  /// Octrees are not drawn finer than this level.
  unsigned finest_level = 32;
  /// Nodes of an octree are drawn as wholes where their side is not more than so many samples: by
  /// default those of the level whose side is nearest to one sample, on a scale of doublings. 0..8;
  /// 0: always the finest level
  double coarseness = 1.41421356;
  unsigned samples = 3;  ///< n x n samples in each pixel, 1..8: smoothness of the edges
  bool depth = false;    ///< fill RenderedImage::depth
  unsigned threads = 0;  ///< 0 = all cores; the picture is the same for any number
};

/// A picture of a scene.
struct RenderedImage {
  Picture picture;           ///< RGBA, sRGB, straight alpha, top row first
  std::vector<float> depth;  ///< where asked for: height * width distances to the plane through the
                             ///< camera, the nearest in the pixel; infinite where nothing is
};

/// Makes room for a picture of that size, and for depths where they are asked for.
void resize(RenderedImage& image, const RenderOptions& options);

/// Checks what came from elsewhere. Errors  bad_argument, naming the option
[[nodiscard]] Status check_options(const RenderOptions& options);

/// Draws scenes. All renderers draw the same picture, but for rounding:
///
/// Each voxel is a disc that lies on the surface which the voxels stand for (VoxelTree::Facet): so
/// outlines are not fatter than the surface, and as smooth. Where no surface is known it is a disc
/// that faces the viewer, large enough to hold the projection of its cube, that bulges towards the
/// viewer: its centre has the depth of the voxel's, its rim lies half a voxel side deeper; so
/// neighbours part evenly instead of covering each other like scales. The colour of a sample is the
/// mean, in linear light, of the splats not more than a quarter of a voxel side behind the nearest
/// one there, weighted towards their centres: enough to soften the border between neighbours, too
/// little for the next layer of voxels to show. A pixel is the mean of its samples. Where voxels
/// are smaller than a sample the nodes above them are drawn, with mean colours as they are seen
/// from the viewer's side, each part of an octree by its own distance.
///
/// Each surfel is the parallelogram that it is, with its own depth at every sample, a little longer
/// than it is so that neighbours overlap, and not narrower than a sample. It is mixed in where it
/// lies not more than 0.4 of its shorter side behind the nearest splat, of whatever kind. The more
/// it is stretched the less it counts: then it comes from a picture that saw the surface from
/// aside.
///
/// Shapes hide and are hidden by depth alone; of those as deep as others the first in the scene is
/// seen. Light falls on them as VRML97 says (shading.h). Lines are one pixel wide, points a square
/// pixel. Transparent triangles are laid over what is behind them, the farthest first, by their
/// middle; so those that pass through each other are in part laid the wrong way round. Fog is mixed
/// in by the distance of a sample from the eye, in linear light, over all but background and
/// backdrop. The backdrop is opaque; parallel projections see it as perspective ones of 45 degrees
/// would.
///
/// Source  the paper, section VI (splat size); VRML97 (light, fog, background); bulge and mixing
/// are
///         ours, their constants found by trying (hole_test.cpp holds them to it)
///
/// The background shows through by the part of the pixel that nothing covers. Voxels and surfels
/// whose centre lies nearer than the near plane are left out. Towards the sides of very wide views
/// (beyond about 120 degrees) splats are larger than they should be.
///
/// A renderer is for one thread at a time.
class Renderer {
 public:
  Renderer() = default;
  virtual ~Renderer() = default;
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// What it is, for people: "software", "OpenGL 4.5 (llvmpipe ...)".
  [[nodiscard]] virtual std::string name() const = 0;
  /// Takes the scene that draw() draws; what it shares stays shared. After an error there is none.
  /// Errors  those of check_scene; limit_exceeded: more memory than the limits
  virtual Status set_scene(Scene scene) = 0;
  /// Draws into `image`, whose memory is used again if it is large enough.
  /// Errors  bad_argument: the camera or an option; limit_exceeded: more pixels or memory than the
  ///         limits; not_available: the graphics system refused
  virtual Status draw(const Camera& camera, const RenderOptions& options, RenderedImage& image) = 0;
};

/// Draws on the CPU: the reference for every other renderer. Needs nothing; the picture is the same
/// on every machine. Time grows with the pixels that are covered and with the surfels; of octrees
/// what is hidden or out of view is passed over in whole subtrees. Memory is at most 104 bytes a
/// surfel, 24 a position and 32 a triangle, line or point of a shape, 16 / 3 a pixel of a texture,
/// and some 16 a pixel.
[[nodiscard]] std::unique_ptr<Renderer> make_software_renderer(const Limits& limits = {});

/// Draws one picture with it.
[[nodiscard]] Result<RenderedImage> render(const Scene& scene, const Camera& camera,
                                           const RenderOptions& options, const Limits& limits = {});

}  // namespace afx::render
