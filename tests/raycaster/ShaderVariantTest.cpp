// SPDX-License-Identifier: GPL-3.0-or-later
// Every program that a scene can ask for links, and is valid GLSL 1.30 for the reference compiler.
#include "glsl/programs/ShaderVariant.h"
#include "gl/DriverHealth.h"
#include "support/GlTest.h"
#include "support/Places.h"
#include "support/ReachableSets.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <regex>

namespace limn {
namespace {

using ShaderVariants = test::GlTest;

TEST_F(ShaderVariants, everyReachableProgramLinks) {
  int count = 0;
  for (const EffectSet& effects : test::reachableSets()) {
    EXPECT_NO_THROW(ShaderProgram(vertexSource(), fragmentSource(effects)));
    ++count;
  }
  std::cout << count << " programs\n";
}

TEST(ShaderVariantText, everyReachableProgramIsValidGlsl130) {
  if (std::system("glslangValidator --version > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "needs glslangValidator (Debian package glslang-tools), which this machine does not have";
  const auto folder = test::buildFolder() / "shader_variants";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "full_screen.vert") << vertexSource().text;
  int count = 0;
  for (const EffectSet& effects : test::reachableSets())
    std::ofstream(folder / (std::to_string(++count) + ".frag")) << fragmentSource(effects).text;
  const std::string log = (folder / "log.txt").string();
  const std::string command =
      "cd '" + folder.string() + "' && glslangValidator full_screen.vert *.frag > '" + log + "' 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << "see " << log;
  std::cout << count << " programs validated\n";
}

TEST(ShaderVariantText, everyBlockIsAscii) {
  // GLSL 1.30 allows nothing else, even in comments.
  for (const EmbeddedShader& shader : embeddedShaders())
    for (const char character : shader.text)
      EXPECT_TRUE(character == '\n' || (character >= ' ' && character <= '~')) << shader.name;
}

TEST(ShaderVariantText, noBlockAsksWhetherANumberIsOneOrRaisesItUnguarded) {
  // Drivers differ in all of these (HARD_CASES section 1): numbers are sound before they reach a shader, and
  // the guarded forms stand in stable_math.glsl.
  const std::regex unguarded(R"(\b(isnan|isinf|pow|normalize)\s*\()");
  for (const EmbeddedShader& shader : embeddedShaders())
    EXPECT_FALSE(std::regex_search(std::string(shader.text), unguarded)) << shader.name;
}

TEST_F(ShaderVariants, anErrorNamesTheFileAndLineOfItsBlock) {
  ShaderSource broken;
  broken.append("prelude", "#version 130\n");
  broken.append("first.glsl", "float one() {\n  return 1.0;\n}\n");
  broken.append("second.glsl", "out vec4 fragColor;\nvoid main() {\n  fragColor = missing;\n}\n");
  try {
    const ShaderProgram program(vertexSource(), broken);
    FAIL() << "a broken shader compiled";
  } catch (const DriverError& error) {
    EXPECT_NE(error.details().find("second.glsl:3"), std::string::npos) << error.details();
  }
}

} // namespace
} // namespace limn
