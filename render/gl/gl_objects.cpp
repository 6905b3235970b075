// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/gl/gl_objects.h"

#include <algorithm>

namespace afx::render {
namespace {

Error refused(const std::string& text) { return {Errc::not_available, Place::none(), text}; }

std::string version_lines(const GlFeatures& features) {
  if (!features.es) return "#version 330 core\n";
  return "#version 300 es\nprecision highp float;\nprecision highp int;\n"
         "precision highp sampler2D;\n";
}

Result<GLuint> compile(GLenum kind, const std::string& source) {
  const GLuint shader = glCreateShader(kind);
  const char* const text = source.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint good = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (good == GL_TRUE) return shader;
  std::vector<char> log(4096);
  glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
  glDeleteShader(shader);
  return refused(std::string("OpenGL refused a shader: ") + log.data());
}

const char* error_name(GLenum error) {
  switch (error) {
    case GL_OUT_OF_MEMORY:
      return "out of memory";
    case GL_INVALID_ENUM:
      return "invalid enumerator";
    case GL_INVALID_VALUE:
      return "invalid value";
    case GL_INVALID_OPERATION:
      return "invalid operation";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
      return "invalid framebuffer";
    default:
      return "unknown error";
  }
}

}  // namespace

GLuint GlBufferKind::make() {
  GLuint id = 0;
  glGenBuffers(1, &id);
  return id;
}
void GlBufferKind::remove(GLuint id) { glDeleteBuffers(1, &id); }
GLuint GlTextureKind::make() {
  GLuint id = 0;
  glGenTextures(1, &id);
  return id;
}
void GlTextureKind::remove(GLuint id) { glDeleteTextures(1, &id); }
GLuint GlArrayKind::make() {
  GLuint id = 0;
  glGenVertexArrays(1, &id);
  return id;
}
void GlArrayKind::remove(GLuint id) { glDeleteVertexArrays(1, &id); }
GLuint GlFramebufferKind::make() {
  GLuint id = 0;
  glGenFramebuffers(1, &id);
  return id;
}
void GlFramebufferKind::remove(GLuint id) { glDeleteFramebuffers(1, &id); }
GLuint GlProgramKind::make() { return glCreateProgram(); }
void GlProgramKind::remove(GLuint id) { glDeleteProgram(id); }

Result<GlFeatures> GlFeatures::find() {
  GlFeatures found;
  found.es = !epoxy_is_desktop_gl();
  found.version = epoxy_gl_version();
  const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  found.name = std::string(found.es ? "OpenGL ES " : "OpenGL ") +
               std::to_string(found.version / 10) + "." + std::to_string(found.version % 10) +
               " (" + (renderer == nullptr ? "unknown" : renderer) + ")";
  if (found.version < (found.es ? 30 : 33))
    return refused(found.name + " is too old (expected OpenGL 3.3 or OpenGL ES 3.0)");
  if (found.es && !(epoxy_has_gl_extension("GL_EXT_color_buffer_float") &&
                    (found.version >= 32 || epoxy_has_gl_extension("GL_EXT_float_blend"))))
    return refused(found.name + " cannot add up colours in floats (expected GL_EXT_float_blend)");
  GLfloat range[2] = {1, 1};
  glGetFloatv(found.es ? GL_ALIASED_POINT_SIZE_RANGE : GL_POINT_SIZE_RANGE, range);
  found.most_point = std::clamp(range[1], 1.0F, 512.0F);
  found.conservative_depth =
      !found.es && (found.version >= 42 || epoxy_has_gl_extension("GL_ARB_conservative_depth"));
  return found;
}

Result<GlProgram> GlProgram::make(const GlFeatures& features, const std::string& defines,
                                  const std::string& vertex, const std::string& fragment) {
  const std::string head = version_lines(features) + defines;
  const auto first = compile(GL_VERTEX_SHADER, head + vertex);
  if (!first.ok()) return first.error();
  const auto second = compile(GL_FRAGMENT_SHADER, head + fragment);
  if (!second.ok()) {
    glDeleteShader(first.value());
    return second.error();
  }
  GlProgram program;
  program.id_ = GlObject<GlProgramKind>::make();
  for (const GLuint shader : {first.value(), second.value()}) {
    glAttachShader(program.id_.id(), shader);
    glDeleteShader(shader);  // goes with the program
  }
  glLinkProgram(program.id_.id());
  GLint good = GL_FALSE;
  glGetProgramiv(program.id_.id(), GL_LINK_STATUS, &good);
  if (good == GL_TRUE) return program;
  std::vector<char> log(4096);
  glGetProgramInfoLog(program.id_.id(), static_cast<GLsizei>(log.size()), nullptr, log.data());
  return refused(std::string("OpenGL did not link shaders: ") + log.data());
}

void GlProgram::use() const { glUseProgram(id_.id()); }
GLint GlProgram::place(const char* name) const { return glGetUniformLocation(id_.id(), name); }
void GlProgram::set(const char* name, int value) const { glUniform1i(place(name), value); }
void GlProgram::set(const char* name, float value) const { glUniform1f(place(name), value); }
void GlProgram::set(const char* name, const glm::vec2& value) const {
  glUniform2fv(place(name), 1, &value.x);
}
void GlProgram::set(const char* name, const glm::vec3& value) const {
  glUniform3fv(place(name), 1, &value.x);
}
void GlProgram::set(const char* name, const glm::vec4& value) const {
  glUniform4fv(place(name), 1, &value.x);
}
void GlProgram::set(const char* name, const glm::ivec2& value) const {
  glUniform2iv(place(name), 1, &value.x);
}
void GlProgram::set(const char* name, const glm::ivec3& value) const {
  glUniform3iv(place(name), 1, &value.x);
}
void GlProgram::set(const char* name, const glm::mat3& value) const {
  glUniformMatrix3fv(place(name), 1, GL_FALSE, &value[0].x);
}
void GlProgram::set(const char* name, const std::vector<int>& values) const {
  if (!values.empty())
    glUniform1iv(place(name), static_cast<GLsizei>(values.size()), values.data());
}

Status check_gl(const std::string& doing) {
  const GLenum error = glGetError();
  if (error == GL_NO_ERROR) return {};
  // Others may be noted too. A lost context notes them without end.
  for (int i = 0; i < 16 && glGetError() != GL_NO_ERROR; ++i) {
  }
  return refused("OpenGL failed while " + doing + ": " + error_name(error));
}

}  // namespace afx::render
