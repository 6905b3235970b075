// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/gl/gl_splats.h"

#include <algorithm>
#include <utility>

#include "render/gl/splat_shaders.h"

namespace afx::render {

Result<GlSplats> GlSplats::make(const GlFeatures& features) {
  GlSplats splats;
  splats.features_ = features;
  for (unsigned variant = 0; variant < splats.programs_.size(); ++variant) {
    const bool has_sides = (variant & sides) != 0;
    const bool is_surfel = (variant & surfels) != 0;
    if (has_sides && (is_surfel || (variant & colour) == 0)) continue;
    std::string defines = features.conservative_depth ? "#define DEPTH_IS_GREATER\n" : "";
    if ((variant & quads) != 0) defines += "#define QUADS\n";
    if ((variant & colour) != 0) defines += "#define COLOUR\n";
    if (has_sides) defines += "#define SIDES\n";
    auto program = GlProgram::make(features, defines,
                                   is_surfel ? surfel_vertex_shader() : voxel_vertex_shader(),
                                   is_surfel ? surfel_fragment_shader() : voxel_fragment_shader());
    if (!program.ok()) return program.error();
    splats.programs_[variant] = std::move(program).value();
  }
  return splats;
}

void GlSplats::set_scene(const Scene& scene) {
  std::map<const VoxelTree*, std::unique_ptr<GlTree>> trees;
  for (const VoxelCloud& cloud : scene.voxels) {
    std::unique_ptr<GlTree>& tree = trees[cloud.tree.get()];
    if (tree == nullptr) tree = std::move(trees_[cloud.tree.get()]);
    if (tree == nullptr) tree = std::make_unique<GlTree>(cloud.tree);
  }
  trees_ = std::move(trees);
  std::map<const Surfels*, std::unique_ptr<GlSurfels>> lists;
  for (const SurfelCloud& cloud : scene.surfels) {
    std::unique_ptr<GlSurfels>& list = lists[cloud.surfels.get()];
    if (list == nullptr) list = std::move(surfels_[cloud.surfels.get()]);
    if (list == nullptr) list = std::make_unique<GlSurfels>(cloud.surfels);
  }
  surfels_ = std::move(lists);
}

GlSplats::Frame GlSplats::frame(const Scene& scene, const Lens& lens,
                                const RenderOptions& options) const {
  Frame frame;
  for (const VoxelCloud& cloud : scene.voxels) {
    frame.voxels.emplace_back(cloud, *trees_.at(cloud.tree.get()), lens, options);
    frame.farthest = std::max(frame.farthest, frame.voxels.back().farthest());
  }
  for (const SurfelCloud& cloud : scene.surfels) {
    frame.surfels.emplace_back(cloud, *surfels_.at(cloud.surfels.get()), lens, options);
    frame.farthest = std::max(frame.farthest, frame.surfels.back().farthest());
  }
  return frame;
}

const GlProgram& GlSplats::begin(const GlView& view, unsigned variant, bool walls) const {
  const GlProgram& program = programs_[variant];
  program.use();
  view.set_uniforms(program);
  program.set("has_walls", walls ? 1 : 0);
  program.set("walls", 2);
  return program;
}

void GlSplats::draw_voxels(Frame& frame, const GlView& view, unsigned variant, bool walls) const {
  const GlProgram* program = nullptr;
  for (GlVoxelCloud& cloud : frame.voxels) {
    for (unsigned level = 0; level < cloud.levels(); ++level) {
      // Only colours are different for the levels above the last.
      if ((variant & colour) != 0 && cloud.has_sides(level) != ((variant & sides) != 0)) continue;
      if (!cloud.has_any(level, (variant & quads) != 0)) continue;
      if (program == nullptr) program = &begin(view, variant, walls);
      if ((variant & quads) != 0) {
        cloud.draw_quads(*program, level);
      } else {
        cloud.draw_points(*program, level, features_.es);
      }
    }
  }
}

void GlSplats::draw_surfels(Frame& frame, const GlView& view, unsigned variant, bool walls) const {
  if (frame.surfels.empty()) return;
  const GlProgram& program = begin(view, variant | surfels, walls);
  for (const GlSurfelCloud& cloud : frame.surfels) {
    if ((variant & quads) != 0) {
      cloud.draw_quads(program);
    } else {
      cloud.draw_points(program);
    }
  }
}

void GlSplats::draw(Frame& frame, const GlView& view, const GlTarget& target, bool walls) const {
  for (GlVoxelCloud& cloud : frame.voxels) cloud.look(view);
  for (GlSurfelCloud& cloud : frame.surfels) cloud.look(view);
  if (!features_.es) glEnable(GL_PROGRAM_POINT_SIZE);
  target.begin_depths(walls);
  if (walls) target.bind_walls();
  for (const unsigned variant : {0U, static_cast<unsigned>(quads)}) {
    draw_voxels(frame, view, variant, walls);
    draw_surfels(frame, view, variant, walls);
  }
  target.begin_colours();
  for (const unsigned variant : {0U, static_cast<unsigned>(quads)}) {
    draw_voxels(frame, view, variant | colour, walls);
    draw_voxels(frame, view, variant | colour | sides, walls);
    draw_surfels(frame, view, variant | colour, walls);
  }
}

}  // namespace afx::render
