// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/making/Turntable.h"
#include "app/core/sources/SceneSource.h"
#include "scene/volume/Phantom.h"
#include "support/FileBytes.h"
#include "support/ProgramRun.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

// `limn turntable`, and the turn itself.

namespace limn {
namespace {

using test::Outcome;

TEST(Turntable, turnsAboutThePatientsUprightAxisAndKeepsItsDistance) {
  Camera camera;
  camera.target = {10.0, 20.0, 30.0};
  camera.position = camera.target + glm::dvec3(0.0, -400.0, 100.0); // from the front, a little above
  const Camera quarter = turned(camera, std::numbers::pi / 2.0);
  // Anticlockwise from above (LPS: x left, y back, z up) the front (0,-1) becomes the left (1,0).
  EXPECT_NEAR(quarter.position.x, camera.target.x + 400.0, 1e-9);
  EXPECT_NEAR(quarter.position.y, camera.target.y, 1e-9);
  EXPECT_NEAR(quarter.position.z, camera.position.z, 1e-9) << "it stays at its height";
  const Camera whole = turned(camera, 2.0 * std::numbers::pi);
  EXPECT_NEAR(glm::length(whole.position - camera.position), 0.0, 1e-9);
}

TEST(Turntable, beginsWithTheSceneItself) {
  Turntable turntable;
  turntable.frames = 4;
  turntable.scene.image = {512, 512, {0.0, 0.0, 0.0}};
  const std::vector<Scene> frames = framesOf(turntable);
  ASSERT_EQ(frames.size(), 4u);
  EXPECT_EQ(frames[0], turntable.scene);
  EXPECT_EQ(frames[2].camera, turned(turntable.scene.camera, std::numbers::pi));
}

TEST(Turntable, ofAFramedViewFramesAllWithOneDistance) {
  Turntable turntable;
  turntable.frames = 5;
  turntable.size = {60, 40};
  Scene& scene = turntable.scene;
  scene.volume = phantomVolume({8.0, 0.0, 1});
  scene.transferFunction.points = {{-300.0, glm::dvec3(1.0), 0.0}, {0.0, glm::dvec3(1.0), 0.5}};
  scene.camera = defaultCamera(scene.volume->grid());
  scene.camera = framedCamera(scene, 1.5);
  const Grid& grid = scene.volume->grid();
  const VisibleVoxels visible = visibleVoxels(scene);
  double largest = 0.0;
  for (int view = 0; view < 5; ++view) {
    const Camera alone = framed(turned(scene.camera, 0.4 * std::numbers::pi * view), grid, visible, 1.5);
    largest = std::max(largest, glm::distance(alone.target, alone.position));
  }
  const std::vector<Scene> frames = framesOf(turntable);
  ASSERT_EQ(frames.size(), 5u);
  for (int view = 0; view < 5; ++view) {
    const Camera& camera = frames[static_cast<std::size_t>(view)].camera;
    EXPECT_NEAR(glm::distance(camera.target, camera.position), largest, 1e-9) << view;
    const Camera expected =
        framedFrom(turned(scene.camera, 0.4 * std::numbers::pi * view), grid, visible, 1.5, largest);
    EXPECT_NEAR(glm::distance(camera.position, expected.position), 0.0, 1e-9) << view;
  }
  // Framed in pictures of another shape, too.
  scene.camera = framedCamera(scene, 0.8);
  turntable.cameraAspect = 0.8;
  EXPECT_NEAR(glm::distance(framesOf(turntable)[2].camera.position, frames[2].camera.position), 0.0, 1e-9);
  // Who came nearer turns as the camera stands.
  scene.camera = zoomed(scene.camera, 1.2);
  EXPECT_EQ(framesOf(turntable)[2].camera, turned(scene.camera, 0.8 * std::numbers::pi));
}

TEST(Turntable, tellsHowManyFramesAreDrawnBesideWhatElseIsWork) {
  EXPECT_EQ(shareDrawn(0.0, false), 0.0);
  EXPECT_EQ(shareDrawn(0.01, false), 0.0) << "cameras are looked for";
  EXPECT_GT(shareDrawn(0.5, true), shareDrawn(0.5, false)) << "a video follows on its frames";
  for (const bool isVideo : {false, true})
    EXPECT_EQ(shareDrawn(1.0, isVideo), 1.0);
}

class TurntableCommand : public testing::Test {
protected:
  Outcome run(const std::string& arguments, const std::string& before = {}) {
    return test::runProgram(folder.path(), arguments, before);
  }
  std::string file(const std::string& name) const { return (folder.path() / name).string(); }

  test::TemporaryFolder folder;
};

TEST_F(TurntableCommand, framesArePicturesOfRenderAndCarryTheirScenes) {
  const Outcome outcome =
      run("turntable phantom:16 --frames 3 --size 64x48 --engine cpu --quiet -o " + file("turn"));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(test::entriesOf(folder.path() / "turn"), 3u);
  for (const char* frame : {"frame-0001.png", "frame-0002.png", "frame-0003.png"}) {
    // Rendered again from the scene inside, the file is the same to the last byte.
    ASSERT_EQ(run("render " + file("turn/") + frame + " --engine cpu --quiet -o " + file("again.png")).status,
              0);
    EXPECT_EQ(test::bytesOfFile(file("again.png")), test::bytesOfFile(file("turn/") + frame)) << frame;
  }
  EXPECT_NE(test::bytesOfFile(file("turn/frame-0001.png")), test::bytesOfFile(file("turn/frame-0002.png")));
}

TEST_F(TurntableCommand, saysWhereItIsAlsoWithoutATerminal) {
  const std::string command = "turntable phantom:16 --frames 3 --size 64x48 --engine cpu -o ";
  const Outcome told = run(command + file("told"));
  ASSERT_EQ(told.status, 0) << told.err;
  EXPECT_NE(told.err.find("limn: Drawing frame 1 of 3."), std::string::npos) << told.err;
  const Outcome quiet = run(command + file("quiet") + " --quiet");
  EXPECT_EQ(quiet.err.find("Drawing"), std::string::npos) << quiet.err;
}

TEST_F(TurntableCommand, saysOnceWhatItsFramesHide) {
  const std::string words = "turntable phantom:8 --frames 2 --size 32x32 --engine cpu -o ";
  const std::string sentence = "The frames do not say what they show: ";
  EXPECT_EQ(run(words + file("all")).err.find(sentence), std::string::npos) << "they show everything";
  const std::string told = run(words + file("body") + " --keep body --model classic").err;
  const auto at = told.find(sentence + "Classic · Body only: table hidden.");
  ASSERT_NE(at, std::string::npos) << told;
  EXPECT_EQ(told.find(sentence, at + 1), std::string::npos);
  EXPECT_EQ(run(words + file("quiet") + " --keep body --quiet").err.find(sentence), std::string::npos);
}

TEST_F(TurntableCommand, aPartOfATurnIsAFrameOfIt) {
  ASSERT_EQ(
      run("turntable phantom:16 --frames 3 --size 64x48 --engine cpu --quiet -o " + file("turn")).status, 0);
  ASSERT_EQ(
      run("render phantom:16 --turn 2/3 --size 64x48 --engine cpu --quiet -o " + file("third.png")).status,
      0);
  const auto cameraIn = [&](const std::string& picture) {
    return loadScene(file(picture), {}, {}).scene.camera;
  };
  EXPECT_NEAR(glm::distance(cameraIn("third.png").position, cameraIn("turn/frame-0003.png").position), 0.0,
              1e-9);
}

TEST_F(TurntableCommand, framesOfALongerTurnAreNotMixedWithThese) {
  const std::string words = " --size 32x32 --engine cpu --quiet -o " + file("turn");
  ASSERT_EQ(run("turntable phantom:16 --frames 3" + words).status, 0);
  const Outcome shorter = run("turntable phantom:16 --frames 2" + words);
  EXPECT_EQ(shorter.status, 2);
  EXPECT_NE(shorter.err.find("frame-0003.png of a longer turntable"), std::string::npos) << shorter.err;
  EXPECT_EQ(run("turntable phantom:16 --frames 3" + words).status, 0) << "all of the old ones go";
}

TEST_F(TurntableCommand, aVideoIsMadeWhereFfmpegIsInstalled) {
  if (videoProgram().empty())
    GTEST_SKIP() << "ffmpeg is not installed";
  // An odd size, which most players cannot show, gets a pixel more.
  const Outcome outcome =
      run("turntable phantom:16 --frames 4 --size 63x47 --engine cpu --quiet -o " + file("turn.mp4"));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::string video = test::bytesOfFile(file("turn.mp4"));
  EXPECT_EQ(video.substr(4, 4), "ftyp") << "an MP4 begins with its kind";
  EXPECT_GT(video.size(), 1000u);
}

TEST_F(TurntableCommand, withoutFfmpegSaysWhatToDo) {
  // A path on which there is nothing but what starts the program.
  std::filesystem::create_directory(file("bin"));
  std::filesystem::create_symlink("/usr/bin/env", file("bin/env"));
  const Outcome outcome =
      run("turntable phantom:16 --frames 2 --size 32x32 --engine cpu --quiet -o " + file("turn.mp4"),
          "PATH='" + file("bin") + "'; export PATH;");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(
      outcome.err.find("ffmpeg is not installed; install the package ffmpeg or save frames into a folder."),
      std::string::npos)
      << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(file("turn.mp4")));
}

TEST_F(TurntableCommand, aFailureOfTheVideoIsSaidAndLeavesTheOldFile) {
  if (videoProgram().empty())
    GTEST_SKIP() << "ffmpeg is not installed";
  test::writeBytes(file("turn.mp4"), "old");
  // Frames of 32 × 32 are smaller than 4 blocks of 512 bytes; the video is not.
  const Outcome outcome =
      run("turntable phantom:16 --frames 30 --size 32x32 --engine cpu --quiet -o " + file("turn.mp4"),
          "trap '' XFSZ; ulimit -f 4;");
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_EQ(test::bytesOfFile(file("turn.mp4")), "old");
}

} // namespace
} // namespace limn
