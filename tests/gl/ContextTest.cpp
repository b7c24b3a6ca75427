// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/GlObjects.h"
#include "gl/ShaderProgram.h"
#include "support/GlTest.h"

#include <epoxy/gl.h>

namespace limn {
namespace {

using Context = test::GlTest;

TEST_F(Context, namesItsRendererAndOffersOpenGl3) {
  EXPECT_NE(rendererName(), "unknown");
  EXPECT_GE(epoxy_gl_version(), 30);
}

TEST_F(Context, objectsDieWithTheirOwnerAndMove) {
  unsigned name = 0;
  {
    GlTexture first;
    name = first.name();
    glBindTexture(GL_TEXTURE_2D, name);
    GlTexture second(std::move(first));
    EXPECT_EQ(second.name(), name);
    EXPECT_EQ(first.name(), 0u); // NOLINT: what moving leaves behind is what is tested
    EXPECT_TRUE(glIsTexture(name));
  }
  EXPECT_FALSE(glIsTexture(name));
}

TEST(ContextOrder, aSecondContextWorksAfterTheFirstHasGone) {
  for (int i = 0; i < 3; ++i)
    try {
      const HeadlessContext context;
      EXPECT_NE(rendererName(), "unknown");
    } catch (const Error& error) {
      GTEST_SKIP() << error.what();
    }
}

TEST(ShaderLog, placesAreTranslatedWhateverTheDriverWrites) {
  ShaderSource source;
  source.append("a.glsl", "one\ntwo\n");
  source.append("b.glsl", "three\n");
  EXPECT_EQ(withFileLines("0:3(7): error: x", source), "b.glsl:1(7): error: x\n");          // Mesa
  EXPECT_EQ(withFileLines("0(2) : error C0000: x", source), "a.glsl:2 : error C0000: x\n"); // NVIDIA
  EXPECT_EQ(withFileLines("ERROR: 0:1: x", source), "ERROR: a.glsl:1: x\n");                // AMD, Apple
  EXPECT_EQ(withFileLines("no place", source), "no place\n");
}

} // namespace
} // namespace limn
