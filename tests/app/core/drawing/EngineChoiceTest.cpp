// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/drawing/EngineChoice.h"
#include "app/core/drawing/RealRenderers.h"
#include "app/document/Settings.h"
#include "cpu/CpuRenderer.h"
#include "scene/basics/Error.h"
#include "scene/view/FirstView.h"
#include "scene/volume/Phantom.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

EngineFacts onLlvmpipe(std::optional<Engine> setting) {
  return {setting, {}, "llvmpipe (LLVM 15.0.6, 256 bits)", std::nullopt};
}

TEST(EngineChoice, withoutOpenGlTheProcessorDrawsWhateverIsSet) {
  for (const std::optional<Engine> setting :
       {std::optional<Engine>(), std::optional(Engine::rayCaster), std::optional(Engine::cpu)}) {
    const EngineChoice choice = chosenEngine({setting, "There is no OpenGL.", {}, std::nullopt});
    EXPECT_EQ(choice.engine, Engine::cpu);
    EXPECT_FALSE(choice.isGuess) << "nothing is left to be tried";
    EXPECT_EQ(choice.reason.english(), "There is no OpenGL.");
  }
}

TEST(EngineChoice, whatIsSetIsTakenAgainstEveryTrial) {
  EngineFacts facts = onLlvmpipe(Engine::rayCaster);
  facts.times = {50.0, 10.0};
  EXPECT_EQ(chosenEngine(facts).engine, Engine::rayCaster);
  facts.setting = Engine::cpu;
  facts.times = {10.0, 50.0};
  EXPECT_EQ(chosenEngine(facts).engine, Engine::cpu);
}

TEST(EngineChoice, aTrialDecidesWhatIsLeftOpenAndIsTheReason) {
  EngineFacts facts = onLlvmpipe(std::nullopt);
  facts.times = {10.0, 50.0};
  EXPECT_EQ(chosenEngine(facts).engine, Engine::rayCaster);
  EXPECT_FALSE(chosenEngine(facts).isGuess);
  EXPECT_NE(chosenEngine(facts).reason.english().find("10.0 ms with OpenGL and 50.0 ms"), std::string::npos);
}

TEST(EngineChoice, beforeATrialADriverWithoutACardYieldsToTheProcessor) {
  EngineFacts facts = onLlvmpipe(std::nullopt);
  EXPECT_EQ(chosenEngine(facts).engine, Engine::cpu);
  EXPECT_TRUE(chosenEngine(facts).isGuess);
  facts.renderer = "NVIDIA GeForce RTX 3060/PCIe/SSE2";
  EXPECT_EQ(chosenEngine(facts).engine, Engine::rayCaster);
  EXPECT_TRUE(chosenEngine(facts).isGuess);
}

TEST(EngineMemory, keepsSettingAndTrialsForTheNextRunEachForItsMachine) {
  const test::TemporaryFolder folder;
  const UserFolders folders = UserFolders::below(folder.path());
  Settings first(folders.settings);
  EXPECT_EQ(first.engine(), std::nullopt);
  first.setEngine(Engine::cpu);
  first.engineMemory().remember("one", {12.25, 3.5});
  Settings next(folders.settings);
  EXPECT_EQ(next.engine(), Engine::cpu);
  EXPECT_EQ(next.engineMemory().recall("one"), (EngineTimes{12.25, 3.5}));
  EXPECT_EQ(next.engineMemory().recall("another"), std::nullopt);
}

TEST(EngineTrial, drawsWithBothAndEndsWhenItIsCancelled) {
  Scene scene;
  scene.volume = phantomVolume({8.0, 0.0, 1});
  scene.camera = defaultCamera(scene.volume->grid());
  scene.transferFunction.points = {{-300, {0.9, 0.6, 0.5}, 0.0}, {300, {1.0, 0.95, 0.85}, 0.5}};
  const EngineTrial trial = tryEngines(scene, {});
  EXPECT_GT(trial.times.openGlMs, 0.0);
  EXPECT_GT(trial.times.processorMs, 0.0);
  EXPECT_FALSE(trial.renderer.empty());
  EXPECT_THROW(tryEngines(scene, [] { return true; }), Cancelled);
}

TEST(RealRenderers, withoutOpenGlTheProcessorCastsTheRaysAndNothingElseIsOffered) {
  Scene scene;
  scene.volume = phantomVolume({16.0, 0.0, 1});
  scene.camera = defaultCamera(scene.volume->grid());
  scene.transferFunction.points = {{-300, {0.9, 0.6, 0.5}, 0.0}, {300, {1.0, 0.95, 0.85}, 0.5}};
  RealRenderers renderers(1, {}, Engine::cpu);
  EXPECT_EQ(renderers.render(scene, {40, 30}), CpuRenderer(1).render(scene, {40, 30}));
  EXPECT_TRUE(renderers.name().starts_with("CPU engine"));
  OperatingPoint point;
  EXPECT_TRUE(renderers.canDraw(point));
  point.gradients = GradientSource::precomputed;
  EXPECT_FALSE(renderers.canDraw(point));
  point = {};
  point.engine = Engine::slices;
  EXPECT_FALSE(renderers.canDraw(point));
}

} // namespace
} // namespace limn
