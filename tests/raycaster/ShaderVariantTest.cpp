// SPDX-License-Identifier: GPL-3.0-or-later
// Every program that a scene can ask for links, and is valid GLSL 1.30 for the reference compiler.
#include "glsl/programs/ShaderVariant.h"
#include "gl/DriverHealth.h"
#include "scene/effects/EffectSet.h"
#include "support/GlTest.h"
#include "support/Places.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <regex>
#include <set>

namespace limn {
namespace {

using Groups = std::vector<std::vector<Effect>>;

const Groups lights{
    {},
    {Effect::lighting},
    {Effect::lighting, Effect::diffuse},
    {Effect::lighting, Effect::specular},
    {Effect::lighting, Effect::diffuse, Effect::specular},
    {Effect::lighting, Effect::diffuse, Effect::specular, Effect::phong},
    {Effect::lighting, Effect::diffuse, Effect::specular, Effect::fixedLight},
    {Effect::lighting, Effect::diffuse, Effect::specular, Effect::phong, Effect::fixedLight},
};

const Groups maps{
    {},
    {Effect::exponentMap, Effect::opacityMap},
    {Effect::exponentMap},
    {Effect::opacityMap},
    {Effect::exponentMap, Effect::opacityMap, Effect::gammaCurve},
    {Effect::exponentMap, Effect::opacityMap, Effect::logCurve},
    {Effect::exponentMap, Effect::opacityMap, Effect::energyFactor, Effect::significance, Effect::knee},
    {Effect::opacityFactor},
    {Effect::significance},
};

const Groups others{
    {},
    {Effect::emptySpaceSkipping, Effect::earlyTermination},
    {Effect::emptySpaceSkipping, Effect::earlyTermination, Effect::fogLinear},
    {Effect::emptySpaceSkipping, Effect::earlyTermination, Effect::fogExp},
    {Effect::emptySpaceSkipping, Effect::earlyTermination, Effect::fogExp2},
    {Effect::emptySpaceSkipping, Effect::earlyTermination, Effect::cutFaces},
    {Effect::emptySpaceSkipping, Effect::earlyTermination, Effect::twoSided, Effect::specularOfLight},
    {Effect::emptySpaceSkipping, Effect::gradientOpacity, Effect::knee},
    {Effect::emptySpaceSkipping, Effect::longRays, Effect::denseFunctions},
    {Effect::emptySpaceSkipping, Effect::preintegration},
    {Effect::emptySpaceSkipping, Effect::preintegration, Effect::gradientOpacity, Effect::earlyTermination},
    {Effect::preintegration, Effect::longRays, Effect::denseFunctions},
    {Effect::emptySpaceSkipping, Effect::jitter, Effect::knee},
    {Effect::emptySpaceSkipping, Effect::unlimited},
    {Effect::emptySpaceSkipping, Effect::isosurface, Effect::cutFaces},
    {Effect::emptySpaceSkipping, Effect::isosurface, Effect::jitter, Effect::fogExp, Effect::knee},
    {Effect::emptySpaceSkipping, Effect::hybrid, Effect::earlyTermination},
    {Effect::emptySpaceSkipping, Effect::hybrid, Effect::preintegration, Effect::cutFaces},
    {Effect::hybrid, Effect::longRays, Effect::fogLinear},
    {Effect::emptySpaceSkipping, Effect::xray},
    {Effect::emptySpaceSkipping, Effect::xray, Effect::preintegration},
    {Effect::xray, Effect::jitter, Effect::longRays},
    {Effect::emptySpaceSkipping, Effect::localSteps, Effect::earlyTermination},
    {Effect::localSteps, Effect::gradientOpacity, Effect::fogLinear},
    {Effect::emptySpaceSkipping, Effect::localSteps, Effect::cutFaces, Effect::knee, Effect::unlimited},
    {Effect::emptySpaceSkipping, Effect::localSteps, Effect::hybrid, Effect::longRays},
    {Effect::emptySpaceSkipping, Effect::localSteps, Effect::xray, Effect::denseFunctions},
    {Effect::emptySpaceSkipping, Effect::localSteps, Effect::earlyTermination, Effect::sampleCounts},
    {Effect::localSteps, Effect::xray, Effect::sampleCounts},
    {Effect::mip},
    {Effect::minip, Effect::jitter},
    {Effect::average, Effect::denseFunctions},
    {Effect::emptySpaceSkipping, Effect::region, Effect::earlyTermination},
    {Effect::emptySpaceSkipping, Effect::region, Effect::preintegration, Effect::gradientOpacity},
    {Effect::emptySpaceSkipping, Effect::region, Effect::hybrid, Effect::longRays},
    {Effect::region, Effect::isosurface},
    {Effect::region, Effect::xray},
    {Effect::region, Effect::localSteps, Effect::earlyTermination},
    {Effect::region, Effect::localSteps, Effect::xray},
    {Effect::region, Effect::mip},
    {Effect::region, Effect::minip},
    {Effect::region, Effect::average},
    {Effect::sampleCounts},
};

// The canonical sets that scenes can reach: every combination of what belongs together, the groups that do
// not touch each other's code (fog, knee, cut faces, …) varied one against all.
std::set<EffectSet> reachableSets() {
  std::set<EffectSet> sets;
  for (const auto& light : lights)
    for (const auto& map : maps)
      for (const auto& other : others) {
        EffectSet effects;
        for (const auto* group : {&light, &map, &other})
          for (const Effect effect : *group)
            effects = effects.with(effect);
        sets.insert(canonical(effects));
      }
  return sets;
}

using ShaderVariants = test::GlTest;

TEST_F(ShaderVariants, everyReachableProgramLinks) {
  int count = 0;
  for (const EffectSet& effects : reachableSets()) {
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
  for (const EffectSet& effects : reachableSets())
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
