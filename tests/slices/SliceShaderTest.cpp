// SPDX-License-Identifier: GPL-3.0-or-later
// The programs of slices: each effect alone on a lit and on an unlit sample links and is valid GLSL 1.30 for
// the reference compiler.
#include "glsl/programs/ShaderVariant.h"
#include "scene/effects/EffectSet.h"
#include "support/GlTest.h"
#include "support/Places.h"
#include "support/ReachableSets.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

namespace limn {
namespace {

using SliceShaders = test::GlTest;

TEST_F(SliceShaders, everyProgramLinks) {
  for (const EffectSet& effects : test::sliceSets())
    EXPECT_NO_THROW(ShaderProgram(sliceVertexSource(), sliceSource(effects)));
  EXPECT_GT(test::sliceSets().size(), 30u);
}

TEST(SliceShaderText, everyProgramIsValidGlsl130) {
  if (std::system("glslangValidator --version > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "needs glslangValidator (Debian package glslang-tools), which this machine does not have";
  const auto folder = test::buildFolder() / "slice_variants";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "slice.vert") << sliceVertexSource().text;
  int count = 0;
  for (const EffectSet& effects : test::sliceSets())
    std::ofstream(folder / (std::to_string(++count) + ".frag")) << sliceSource(effects).text;
  const std::string log = (folder / "log.txt").string();
  const std::string command =
      "cd '" + folder.string() + "' && glslangValidator slice.vert *.frag > '" + log + "' 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << "see " << log;
}

TEST(SliceShaderText, slicesAreLitByTheBlocksOfTheRayCaster) {
  // Both programs of a set differ in how they step alone.
  const EffectSet effects =
      canonical({Effect::lighting, Effect::diffuse, Effect::fogExp, Effect::cutFaces, Effect::opacityMap});
  const auto blocksOf = [](const ShaderSource& source) {
    std::set<std::string> blocks;
    for (const ShaderSource::Line& line : source.lines)
      blocks.insert(line.file);
    return blocks;
  };
  std::set<std::string> slices = blocksOf(sliceSource(effects));
  std::set<std::string> rays = blocksOf(fragmentSource(effects));
  EXPECT_EQ(slices.erase("slice.glsl"), 1u);
  EXPECT_EQ(rays.erase("composite.glsl") + rays.erase("fetched.glsl") + rays.erase("gather.glsl"), 3u);
  EXPECT_EQ(slices, rays);
}

} // namespace
} // namespace limn
