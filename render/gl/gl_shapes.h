// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Shapes in the memory of the graphics system, and how they are drawn.
#pragma once

#include <array>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <memory>
#include <vector>

#include "render/gl/gl_objects.h"
#include "render/gl/gl_pictures.h"
#include "render/gl/gl_view.h"
#include "render/scene.h"

namespace afx::render {

/// Lights that may fall on one shape.
inline constexpr size_t kMostLights = 64;

/// One geometry, uploaded: 44 bytes a position and 4 an index, or 48 a line or point.
class GlGeometry {
 public:
  explicit GlGeometry(std::shared_ptr<const Geometry> geometry);

  [[nodiscard]] const Geometry& geometry() const { return *geometry_; }
  /// A ball around it, in the local system.
  [[nodiscard]] const glm::dvec3& centre() const { return centre_; }
  [[nodiscard]] double radius() const { return radius_; }
  [[nodiscard]] bool is_bands() const { return geometry_->kind != Geometry::Kind::triangles; }
  /// Makes its vertex array current; of lines and points one whose instances are those from `first`
  /// on.
  void bind(size_t first = 0) const;
  [[nodiscard]] GLuint indices() const { return indices_.id(); }

 private:
  void upload_triangles();
  void upload_bands();

  std::shared_ptr<const Geometry> geometry_;
  glm::dvec3 centre_{0};
  double radius_ = 0;
  GlBuffer vertices_, indices_;
  GlArray array_;
};

/// The shapes of a scene.
class GlShapes {
 public:
  /// Errors  as GlProgram::make
  static Result<GlShapes> make(const GlFeatures& features);

  void set_scene(const Scene& scene);

  /// One shape as one camera sees it.
  struct Item {
    const Shape* shape;
    const GlGeometry* geometry;
    const GlPicture* picture;  // null: none
    bool transparent, mirrored;
    glm::dmat3 axes, normals;
    glm::dvec3 origin;
  };
  /// Primitives of one item that follow each other in the order of drawing.
  struct GlassRun {
    size_t item;
    size_t first, count;  // triangles: indices in the frame's list; else numbers of primitives
  };
  /// All of them.
  struct Frame {
    std::vector<Item> items;
    std::vector<GlassRun> glass;  // the farthest first
    GlBuffer glass_indices;
    GlTexture lights;
    double farthest = 0;
    bool has_walls = false;
  };
  [[nodiscard]] Frame frame(const Scene& scene, const GlPictures& pictures, const Lens& lens) const;
  /// Draw into the current framebuffer with its depth test.
  void draw_walls(const Frame& frame, const Scene& scene, const GlView& view) const;
  void draw_glass(const Frame& frame, const Scene& scene, const GlView& view) const;

  /// Sets the uniforms of fog_part().
  static void set_fog(const GlProgram& program, const Scene& scene, const GlView& view);

 private:
  const GlProgram& begin(const Frame& frame, const Scene& scene, const GlView& view, bool bands,
                         bool glass) const;
  void set_item(const GlProgram& program, const Item& item) const;
  static void sort_glass(Frame& frame, const Lens& lens);

  std::array<GlProgram, 4> programs_;
  std::map<const Geometry*, std::unique_ptr<GlGeometry>> geometries_;
};

}  // namespace afx::render
