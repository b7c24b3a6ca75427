// SPDX-License-Identifier: GPL-3.0-or-later
// Drivers that have too little memory or refuse a program.
#include "engine/VolumeTooLarge.h"
#include "gl/DriverHealth.h"
#include "glsl/programs/ShaderVariant.h"
#include "raycaster/ProgramCache.h"
#include "raycaster/RayCaster.h"
#include "scene/volume/Phantom.h"
#include "support/GlTest.h"
#include "support/Heads.h"
#include "support/MappedVolume.h"
#include "support/TemporaryFolder.h"

#include <epoxy/gl.h>

namespace limn {
namespace {

using GraphicsMemory = test::GlTest;

constexpr glm::ivec2 memorySize{48, 48};

TEST_F(GraphicsMemory, aVolumeThatMayTakeLessIsShownDownSampledAndSaysSo) {
  // 48 x 58 x 68 voxels with an apron, 4 bytes each: 0.84 MB.
  const Scene scene = test::headScene(phantomVolume({.spacingMm = 4.0}), ShadingModel::classic);
  RayCaster free;
  const Image whole = free.render(scene, memorySize);
  EXPECT_EQ(free.limitation().english(), "");
  RayCaster limited(RayCaster::EmptySpace::skipped, RayCaster::Programs::specialised, {}, {0.25, true});
  const Image reduced = limited.render(scene, memorySize);
  EXPECT_LE(limited.volumeMb(), 0.25);
  EXPECT_NE(limited.limitation().english().find("48×58×68"), std::string::npos)
      << limited.limitation().english();
  EXPECT_NE(limited.limitation().english().find("memory that it may take"), std::string::npos);
  // The same head with fewer voxels: the mean alpha agrees to a few parts in a hundred.
  double wholeAlpha = 0.0, reducedAlpha = 0.0;
  for (std::size_t i = 0; i < whole.pixels.size(); ++i) {
    wholeAlpha += whole.pixels[i].a;
    reducedAlpha += reduced.pixels[i].a;
  }
  EXPECT_GT(wholeAlpha, 100.0);
  EXPECT_NEAR(reducedAlpha, wholeAlpha, 0.1 * wholeAlpha);
}

TEST_F(GraphicsMemory, noRoomAtAllIsRefusedInASentence) {
  const Scene scene = test::headScene(phantomVolume({.spacingMm = 8.0}), ShadingModel::none);
  RayCaster caster(RayCaster::EmptySpace::skipped, RayCaster::Programs::specialised, {}, {1e-6, true});
  try {
    caster.render(scene, memorySize);
    FAIL() << "a volume fits into a byte";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::openGl);
  }
}

TEST_F(GraphicsMemory, whatMayNotBeReducedIsRefusedWholeAndTheNextVolumeIsDrawn) {
  Scene scene = test::headScene(phantomVolume({.spacingMm = 4.0}), ShadingModel::classic);
  RayCaster caster(RayCaster::EmptySpace::skipped, RayCaster::Programs::specialised, {}, {0.25, false});
  try {
    caster.render(scene, memorySize);
    FAIL() << "0.84 MB fit into a quarter of one";
  } catch (const VolumeTooLarge& error) {
    EXPECT_STREQ(error.what(),
                 "The volume of 48×58×68 voxels is too large for the graphics memory that it may take.");
  }
  scene.volume = phantomVolume({.spacingMm = 16.0});
  EXPECT_EQ(caster.render(scene, memorySize), RayCaster().render(scene, memorySize));
  EXPECT_EQ(caster.limitation().english(), "");
}

TEST_F(GraphicsMemory, aVolumeOnDiskIsLeftToOthers) {
  const test::TemporaryFolder folder;
  Scene scene = test::headScene(phantomVolume({.spacingMm = 8.0}), ShadingModel::classic);
  scene.volume = test::mapped(*scene.volume, folder.path() / "voxels");
  for (const bool mayReduce : {false, true}) {
    RayCaster caster(RayCaster::EmptySpace::skipped, RayCaster::Programs::specialised, {}, {1e3, mayReduce});
    try {
      caster.render(scene, memorySize);
      FAIL() << "all of it would be copied";
    } catch (const VolumeTooLarge& error) {
      EXPECT_STREQ(error.what(),
                   "The volume of 24×29×34 voxels does not lie in memory, from where the graphics "
                   "driver would copy it.");
    }
  }
}

// Sources that the driver refuses where they step over empty space.
ShaderSource brokenWithEmptySpace(EffectSet effects) {
  ShaderSource source = fragmentSource(effects, {});
  if (effects.has(Effect::emptySpaceSkipping))
    source.append("broken.glsl", "#error not on this driver\n");
  return source;
}

TEST_F(GraphicsMemory, aRefusedProgramIsReplacedByASimplerOneOfTheSamePicture) {
  ProgramCache programs({}, brokenWithEmptySpace);
  const EffectSet skipping{Effect::emptySpaceSkipping};
  const ShaderProgram& first = programs.programFor(skipping);
  EXPECT_TRUE(first.isLinked());
  EXPECT_EQ(&programs.programFor(skipping), &first);
  EXPECT_EQ(&programs.programFor({}), &first);
  EXPECT_EQ(programs.compiled(), 1);
}

// The program that is used all the time stays however many others are asked for.
TEST_F(GraphicsMemory, holdsNoMoreProgramsThanItMayAndLetsTheOldestGo) {
  ProgramCache programs({}, [](EffectSet) { return fragmentSource({Effect::sampleCounts}, {}); });
  const EffectSet always{Effect::phong};
  programs.exactly(always);
  const auto set = [](int bits) {
    EffectSet effects;
    for (int bit = 0; bit < 8; ++bit)
      if ((bits >> bit & 1) != 0)
        effects = effects.with(static_cast<Effect>(static_cast<int>(Effect::exponentMap) + bit));
    return effects;
  };
  for (int bits = 1; bits < 100; ++bits) {
    programs.start(set(bits));
    programs.exactly(always);
  }
  EXPECT_EQ(programs.held(), ProgramCache::most);
  EXPECT_TRUE(programs.has(always));
  EXPECT_TRUE(programs.has(set(99)));
  EXPECT_FALSE(programs.has(set(1)));
  EXPECT_EQ(programs.compiled(), 100);
}

TEST_F(GraphicsMemory, aRefusedProgramIsNotCompiledAgainAndKeepsTheDriversWords) {
  const auto broken = [](EffectSet effects) {
    ShaderSource source = fragmentSource(effects, {});
    source.append("broken.glsl", "#error not on this driver\n");
    return source;
  };
  int compiled = 0;
  ProgramCache programs({}, [&](EffectSet effects) {
    ++compiled;
    return broken(effects);
  });
  for (int i = 0; i < 2; ++i)
    try {
      programs.programFor({});
      FAIL() << "the driver takes an #error";
    } catch (const DriverError& error) {
      EXPECT_NE(error.details().find("broken.glsl:1"), std::string::npos) << error.details();
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
  EXPECT_EQ(compiled, 1);
}

TEST_F(GraphicsMemory, errorsOfTheDriverBecomeSentencesOnce) {
  forgetDriverErrors();
  EXPECT_NO_THROW(requireHealthyDriver("doing nothing"));
  glEnable(GL_NONE);
  EXPECT_THROW(requireHealthyDriver("asking for nothing"), DriverError);
  EXPECT_NO_THROW(requireHealthyDriver("doing nothing"));
  EXPECT_FALSE(contextIsLost());
}

} // namespace
} // namespace limn
