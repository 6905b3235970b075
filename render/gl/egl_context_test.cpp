// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "render/gl/egl_context.h"

#include <gtest/gtest.h>

#include "render/gl/gl_objects.h"
#include "render/gl/test_context.h"

namespace afx::render {
namespace {

// The first test of all that draw: it says why the others are skipped.
TEST(EglContext, IsMadeOrSaysWhatIsMissing) {
  const auto& context = test_context();
  if (context.ok()) {
    const auto features = GlFeatures::find();
    ASSERT_TRUE(features.ok()) << features.error().text;
    EXPECT_GE(features.value().version, 30);
    EXPECT_GE(features.value().most_point, 1);
    EXPECT_TRUE(check_gl("asking").ok());
    EXPECT_TRUE(features.value().name.starts_with("OpenGL ")) << features.value().name;
    return;
  }
  EXPECT_EQ(context.error().code, Errc::not_available);
  EXPECT_TRUE(context.error().text.starts_with("no OpenGL: ")) << context.error().text;
  GTEST_SKIP() << context.error().text;
}

TEST(GlObjects, AShaderThatIsWrongIsRefusedWithItsLog) {
  if (!test_context().ok()) GTEST_SKIP() << test_context().error().text;
  const auto features = GlFeatures::find();
  ASSERT_TRUE(features.ok());
  const auto program =
      GlProgram::make(features.value(), "", "void main() { gl_Position = nix; }", "void main() {}");
  ASSERT_FALSE(program.ok());
  EXPECT_EQ(program.error().code, Errc::not_available);
  EXPECT_NE(program.error().text.find("nix"), std::string::npos) << program.error().text;
}

TEST(GlObjects, WhatOpenGlRefusesIsReportedOnce) {
  if (!test_context().ok()) GTEST_SKIP() << test_context().error().text;
  glEnable(GL_TEXTURE_CUBE_MAP_POSITIVE_X);
  const Status status = check_gl("trying");
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().text, "OpenGL failed while trying: invalid enumerator");
  EXPECT_TRUE(check_gl("trying").ok());
}

}  // namespace
}  // namespace afx::render
