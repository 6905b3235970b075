// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/viewer/panes.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace afx::tools {
namespace {

constexpr const char* kPictureVertex = R"(#version 330 core
uniform vec2 stretch;
out vec2 place;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  place = vec2(corner.x, 1.0 - corner.y);  // the top row is the first
  gl_Position = vec4((corner * 2.0 - 1.0) * stretch, 0.0, 1.0);
}
)";

constexpr const char* kPictureFragment = R"(#version 330 core
uniform sampler2D picture;
in vec2 place;
out vec4 colour;
void main() {
  vec4 seen = texture(picture, place);
  ivec2 field = ivec2(gl_FragCoord.xy) >> 4;
  float board = ((field.x + field.y) & 1) == 0 ? 0.32 : 0.40;
  colour = vec4(mix(vec3(board), seen.rgb, seen.a), 1.0);
}
)";

constexpr const char* kLineVertex = R"(#version 330 core
layout(location = 0) in vec2 position;
layout(location = 1) in float depth_in;
layout(location = 2) in float across_in;
layout(location = 3) in vec4 colour_in;
out float depth;
out float across;
out vec4 line_colour;
void main() {
  depth = depth_in;
  across = across_in;
  line_colour = colour_in;
  gl_Position = vec4(position, 0.0, 1.0);
}
)";

constexpr const char* kLineFragment = R"(#version 330 core
uniform sampler2D depths;
uniform vec2 window;
uniform bool perspective;
uniform float half_width;
in float depth;
in float across;
in vec4 line_colour;
out vec4 colour;
void main() {
  float distance = perspective ? 1.0 / depth : depth;
  float nearest = texture(depths, vec2(gl_FragCoord.x, window.y - gl_FragCoord.y) / window).r;
  float seen = distance <= nearest * 1.002 ? 1.0 : 0.2;
  colour = line_colour;
  colour.a *= seen * clamp(half_width + 0.5 - abs(across), 0.0, 1.0);
}
)";

/// Whatever another renderer in this context has left.
void plain_state() {
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_BLEND);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glBindSampler(0, 0);
}

unsigned make_texture(int filter) {
  unsigned texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return texture;
}

const void* at(size_t offset) { return reinterpret_cast<const void*>(offset); }

}  // namespace

ShaderProgram::ShaderProgram(const char* vertex, const char* fragment) : id_(glCreateProgram()) {
  const unsigned shaders[] = {attach(GL_VERTEX_SHADER, vertex),
                              attach(GL_FRAGMENT_SHADER, fragment)};
  glLinkProgram(id_);
  for (const unsigned shader : shaders) glDeleteShader(shader);
  int linked = 0;
  glGetProgramiv(id_, GL_LINK_STATUS, &linked);
  if (linked == 0 && problem_.empty()) problem_ = "a shader cannot be linked";
}

ShaderProgram::~ShaderProgram() { glDeleteProgram(id_); }

unsigned ShaderProgram::attach(unsigned kind, const char* source) {
  const unsigned shader = glCreateShader(kind);
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  int compiled = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (compiled == 0) {
    std::array<char, 512> log{};
    glGetShaderInfoLog(shader, static_cast<int>(log.size()), nullptr, log.data());
    problem_ = log.data();
  }
  glAttachShader(id_, shader);
  return shader;
}

void ShaderProgram::use() const { glUseProgram(id_); }
int ShaderProgram::place(const char* uniform) const { return glGetUniformLocation(id_, uniform); }

PicturePane::PicturePane()
    : program_(kPictureVertex, kPictureFragment),
      picture_(make_texture(GL_LINEAR)),
      depths_(make_texture(GL_NEAREST)),
      no_depths_(make_texture(GL_NEAREST)) {
  const float infinite = std::numeric_limits<float>::infinity();
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, 1, 1, 0, GL_RED, GL_FLOAT, &infinite);
  glGenVertexArrays(1, &array_);
  render::RenderedImage nothing;
  nothing.picture = Picture(1, 1, 4);
  upload(nothing);
}

PicturePane::~PicturePane() {
  glDeleteTextures(1, &picture_);
  glDeleteTextures(1, &depths_);
  glDeleteTextures(1, &no_depths_);
  glDeleteVertexArrays(1, &array_);
}

void PicturePane::upload(const render::RenderedImage& image) {
  const int width = static_cast<int>(image.picture.width);
  const int height = static_cast<int>(image.picture.height);
  size_ = {width, height};
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glBindTexture(GL_TEXTURE_2D, picture_);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               image.picture.samples.data());
  glBindTexture(GL_TEXTURE_2D, depths_);
  if (!image.depth.empty())
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, width, height, 0, GL_RED, GL_FLOAT, image.depth.data());
}

void PicturePane::draw(const glm::ivec2& window) const {
  const double shape = size_.x / size_.y * window.y / window.x;
  program_.use();
  glUniform1i(program_.place("picture"), 0);
  glUniform2f(program_.place("stretch"), static_cast<float>(shape), 1);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, picture_);
  glBindVertexArray(array_);
  plain_state();
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

LinePane::LinePane() : program_(kLineVertex, kLineFragment) {
  glGenVertexArrays(1, &array_);
  glGenBuffers(1, &buffer_);
  glBindVertexArray(array_);
  glBindBuffer(GL_ARRAY_BUFFER, buffer_);
  constexpr int kStride = sizeof(LineVertex);
  glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, kStride, at(offsetof(LineVertex, x)));
  glVertexAttribPointer(1, 1, GL_FLOAT, GL_FALSE, kStride, at(offsetof(LineVertex, depth)));
  glVertexAttribPointer(2, 1, GL_FLOAT, GL_FALSE, kStride, at(offsetof(LineVertex, across)));
  glVertexAttribPointer(3, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride, at(offsetof(LineVertex, colour)));
  for (unsigned k = 0; k < 4; ++k) glEnableVertexAttribArray(k);
}

LinePane::~LinePane() {
  glDeleteBuffers(1, &buffer_);
  glDeleteVertexArrays(1, &array_);
}

void LinePane::draw(std::span<const LineVertex> vertices, bool perspective, double width,
                    unsigned depths, const glm::ivec2& window) const {
  if (vertices.empty()) return;
  program_.use();
  glUniform1i(program_.place("depths"), 0);
  glUniform2f(program_.place("window"), static_cast<float>(window.x), static_cast<float>(window.y));
  glUniform1i(program_.place("perspective"), perspective ? 1 : 0);
  glUniform1f(program_.place("half_width"), static_cast<float>(width / 2));
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, depths);
  glBindVertexArray(array_);
  glBindBuffer(GL_ARRAY_BUFFER, buffer_);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size_bytes()), vertices.data(),
               GL_STREAM_DRAW);
  plain_state();
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glDrawArrays(GL_TRIANGLES, 0, static_cast<int>(vertices.size()));
  glDisable(GL_BLEND);
}

Picture read_window(const glm::ivec2& window) {
  Picture picture(static_cast<uint32_t>(window.x), static_cast<uint32_t>(window.y), 3);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, window.x, window.y, GL_RGB, GL_UNSIGNED_BYTE, picture.samples.data());
  const size_t row = size_t{picture.width} * 3;
  for (uint32_t y = 0; y < picture.height / 2; ++y)  // the bottom row came first
    std::swap_ranges(picture.pixel(0, y), picture.pixel(0, y) + row,
                     picture.pixel(0, picture.height - 1 - y));
  return picture;
}

}  // namespace afx::tools
