// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Owners of what OpenGL keeps under a number. Their context must be current when they are made and
// when they go.
#pragma once

#include <epoxy/gl.h>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <utility>
#include <vector>

#include "codec/error.h"

namespace afx::render {

/// Owns one number; 0 is none. `Kind` makes and deletes.
template <class Kind>
class GlObject {
 public:
  GlObject() = default;
  explicit GlObject(GLuint id) : id_(id) {}
  GlObject(GlObject&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  GlObject(const GlObject&) = delete;
  GlObject& operator=(const GlObject&) = delete;
  ~GlObject() {
    if (id_ != 0) Kind::remove(id_);
  }

  static GlObject make() { return GlObject(Kind::make()); }
  [[nodiscard]] GLuint id() const { return id_; }
  explicit operator bool() const { return id_ != 0; }

 private:
  GLuint id_ = 0;
};

struct GlBufferKind {
  static GLuint make();
  static void remove(GLuint id);
};
struct GlTextureKind {
  static GLuint make();
  static void remove(GLuint id);
};
struct GlArrayKind {
  static GLuint make();
  static void remove(GLuint id);
};
struct GlFramebufferKind {
  static GLuint make();
  static void remove(GLuint id);
};
struct GlProgramKind {
  static GLuint make();
  static void remove(GLuint id);
};
using GlBuffer = GlObject<GlBufferKind>;
using GlTexture = GlObject<GlTextureKind>;
using GlArray = GlObject<GlArrayKind>;  ///< a vertex array
using GlFramebuffer = GlObject<GlFramebufferKind>;

/// What the current context is and can.
struct GlFeatures {
  bool es = false;       ///< OpenGL ES
  int version = 0;       ///< 10 times major, and minor
  float most_point = 1;  ///< the largest size of a point, in samples
  bool conservative_depth = false;
  std::string name;  ///< "OpenGL 4.5 (llvmpipe ...)"

  /// Of the current context.
  /// Errors  not_available: it is older than OpenGL 3.3 or ES 3.0, or cannot blend into textures of
  ///         floats
  static Result<GlFeatures> find();
};

/// Two shaders linked into a program.
class GlProgram {
 public:
  GlProgram() = default;
  /// defines   lines of the preprocessor, put before both after the version
  /// Errors    not_available, with the compiler's log
  static Result<GlProgram> make(const GlFeatures& features, const std::string& defines,
                                const std::string& vertex, const std::string& fragment);

  void use() const;
  // Uniforms, of the program in use; names that it does not have are passed over.
  void set(const char* name, int value) const;
  void set(const char* name, float value) const;
  void set(const char* name, const glm::vec2& value) const;
  void set(const char* name, const glm::vec3& value) const;
  void set(const char* name, const glm::vec4& value) const;
  void set(const char* name, const glm::ivec2& value) const;
  void set(const char* name, const glm::ivec3& value) const;
  void set(const char* name, const glm::mat3& value) const;
  void set(const char* name, const std::vector<int>& values) const;  // of an array

  explicit operator bool() const { return static_cast<bool>(id_); }

 private:
  [[nodiscard]] GLint place(const char* name) const;

  GlObject<GlProgramKind> id_;
};

/// Whether OpenGL has noted an error since the last call.
/// Errors  not_available, with what was done and the error's name
[[nodiscard]] Status check_gl(const std::string& doing);

}  // namespace afx::render
