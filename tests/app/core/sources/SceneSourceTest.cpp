// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/sources/SceneSource.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

namespace limn {
namespace {

TEST(SceneSource, aSceneWithoutACurveTakesOnlyThatFromThePreset) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "scene.json";
  std::ofstream(path) << R"({"limn_scene": 1, "volume": "phantom:8", "projection": "xray",
      "gradient_opacity": {"points": [{"gradient": 5, "opacity": 0.5}]},
      "shading": {"model": "robust", "exponent": 77}})";
  const LoadedScene loaded = loadScene(path.string(), {}, {});
  EXPECT_FALSE(loaded.preset.empty());
  EXPECT_FALSE(loaded.scene.transferFunction.points.empty());
  EXPECT_EQ(loaded.scene.projection, Projection::xray);
  EXPECT_EQ(loaded.scene.gradientOpacity, (GradientOpacity{{{5.0, 0.5}}}));
  EXPECT_EQ(loaded.scene.shading.model, ShadingModel::robust);
  EXPECT_EQ(loaded.scene.shading.exponent, 77.0);
}

TEST(SceneSource, aVolumeAloneOpensAsItsPresetSays) {
  const LoadedScene loaded = loadScene("phantom:8", {}, {});
  EXPECT_EQ(loaded.preset, "CT bone and veil");
  EXPECT_EQ(loaded.scene.projection, Projection::composite);
  EXPECT_FALSE(loaded.hasOwnCamera);
}

// The file says nothing of its unit, and its values are those of a CT: a body would be found in it.
TEST(SceneSource, aSingleImageOpensUnlitAndWhole) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "image.nrrd";
  std::ofstream file(path);
  file << "NRRD0004\ntype: short\ndimension: 3\nsizes: 40 40 1\nspacings: 1 1 9\nencoding: ascii\n\n";
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 40; ++x)
      file << (std::hypot(x - 20, y - 20) < 12 ? 200 : -1000) << ' ';
  file.close();
  SourceOptions options;
  options.hidesTable = true;
  const LoadedScene loaded = loadScene(path.string(), options, {});
  EXPECT_EQ(loaded.preset, "Image");
  EXPECT_EQ(loaded.scene.shading.model, ShadingModel::none);
  EXPECT_EQ(loaded.scene.keep, Region());
  EXPECT_TRUE(loaded.notes.empty()) << "no other slice: no bands";
}

TEST(SceneSource, normalsOfThickSlicesAreSmoothWhereThatIsAskedFor) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "thick.nrrd";
  std::ofstream(path) << "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 2 2\nspacings: 1 1 5\n"
                         "encoding: ascii\n\n0 1 2 3 4 5 6 7\n";
  const LoadedScene plain = loadScene(path.string(), {}, {});
  EXPECT_EQ(plain.scene.shading.gradientSmoothing, 0.0);
  ASSERT_EQ(plain.notes.size(), 1u);
  EXPECT_EQ(plain.notes[0].english().find("smooth normals"), std::string::npos);
  SourceOptions options;
  options.smoothsSlices = true;
  const LoadedScene smooth = loadScene(path.string(), options, {});
  EXPECT_NEAR(smooth.scene.shading.gradientSmoothing, 3.5, 1e-12);
  ASSERT_EQ(smooth.notes.size(), 1u);
  EXPECT_NE(smooth.notes[0].english().find("smooth normals"), std::string::npos);
  options.read.spacingMm = glm::dvec3(1.0);
  EXPECT_EQ(loadScene(path.string(), options, {}).scene.shading.gradientSmoothing, 0.0);
}

TEST(SceneSource, theNumberOfASeriesIsNotIgnoredInSilence) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "small.nrrd";
  std::ofstream(path) << "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 2 2\nspacings: 1 1 1\n"
                         "encoding: ascii\n\n0 1 2 3 4 5 6 7\n";
  SourceOptions options;
  EXPECT_TRUE(loadScene(path.string(), options, {}).notes.empty());
  options.read.series = 3;
  const LoadedScene loaded = loadScene(path.string(), options, {});
  ASSERT_EQ(loaded.notes.size(), 1u);
  EXPECT_NE(loaded.notes.front().english().find("3 was ignored"), std::string::npos)
      << loaded.notes.front().english();
  EXPECT_EQ(loadScene("phantom:16", options, {}).notes.size(), 1u);
}

SessionDocument sessionOfPhantom() {
  SessionDocument session;
  session.scene.volume = "phantom:8";
  session.scene.hasCamera = session.scene.hasTransferFunction = true;
  session.scene.scene.camera.position = {1, 2, 3};
  session.scene.scene.transferFunction.points = {{0, {1, 1, 1}, 0}, {1, {1, 1, 1}, 1}};
  session.layout = CompareLayout::difference;
  return session;
}

TEST(SceneSource, whatWasMeasuredStaysWithItsVolumeAndItsSeries) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "session.json";
  SessionDocument session = sessionOfPhantom();
  session.scene.measurements = {{Measurement::Kind::mark, std::nullopt, {{1, 2, 3}}, "1"}};
  session.series = 2;
  std::ofstream(path) << sessionToJson(session);
  const auto leftOut = [](const LoadedScene& loaded) {
    return std::ranges::any_of(loaded.notes, [](const Message& note) {
      return note.english().starts_with("The measurements were left out");
    });
  };
  const LoadedScene own = loadScene(path.string(), {}, {});
  EXPECT_EQ(own.measurements, session.scene.measurements);
  EXPECT_FALSE(leftOut(own));
  SourceOptions options;
  options.volume = "phantom:10";
  const LoadedScene other = loadScene(path.string(), options, {});
  EXPECT_TRUE(other.measurements.empty());
  EXPECT_TRUE(leftOut(other)) << "and that is said";
  options = {};
  options.read.series = 3;
  const LoadedScene otherSeries = loadScene(path.string(), options, {});
  EXPECT_TRUE(otherSeries.measurements.empty());
  EXPECT_TRUE(leftOut(otherSeries));
  options.read.series = 2;
  EXPECT_EQ(loadScene(path.string(), options, {}).measurements, session.scene.measurements);
  // The same volume found under the name that stands for it.
  options = {};
  options.volume = "phantom:8";
  EXPECT_EQ(loadScene(path.string(), options, {}).measurements, session.scene.measurements);
}

TEST(SceneSource, anotherVolumeThanTheSessionsIsSaidFirstAndItsLabelsAreLeftOut) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "session.json";
  SessionDocument session = sessionOfPhantom();
  const LoadedScene own = loadScene("phantom:8", {}, {});
  session.traits = {own.scene.volume->grid().dims, true};
  session.scene.keep.kind = Region::Kind::labels;
  session.scene.keep.labels = "labels.nrrd";
  std::ofstream(path) << sessionToJson(session);
  EXPECT_EQ(readSessionFile(path).traits, session.traits);
  SourceOptions options;
  options.volume = "phantom:10";
  const LoadedScene other = loadScene(path.string(), options, {});
  EXPECT_TRUE(other.sparesSession());
  EXPECT_EQ(other.scene.keep.kind, Region::Kind::all);
  const glm::ivec3 now = other.scene.volume->grid().dims, then = session.traits->voxels;
  ASSERT_NE(now, then);
  const auto size = [](const glm::ivec3& dims) {
    return std::to_string(dims.x) + " × " + std::to_string(dims.y) + " × " + std::to_string(dims.z);
  };
  ASSERT_FALSE(other.notes.empty());
  EXPECT_EQ(other.notes.front().english(), "This is another volume than the session's: " + size(now) +
                                               " voxels in place of " + size(then) + ".");
  EXPECT_TRUE(std::ranges::any_of(other.notes, [](const Message& note) {
    return note.english() == "The labels were left out: they are of another volume.";
  }));
}

// As another scanner puts the patient's head a metre away.
TEST(SceneSource, aViewThatLooksPastTheVolumeOfAnotherPatientIsFittedToIt) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "session.json", volume = folder.path() / "other.nrrd";
  std::ofstream(volume)
      << "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 2 2\nspace: left-posterior-superior\n"
         "space directions: (9,0,0) (0,9,0) (0,0,9)\nspace origin: (1000,0,0)\n"
         "encoding: ascii\n\n0 1 1 1 1 1 1 1\n";
  SessionDocument session = sessionOfPhantom();
  Camera& camera = session.scene.scene.camera;
  camera.position = {300, 0, 0}; // from the patient's left
  camera.target = {0, 0, 0};
  std::ofstream(path) << sessionToJson(session);
  const auto saysThatItIsFitted = [](const LoadedScene& loaded) {
    return loaded.notes.size() > 1 && loaded.notes[0].english().starts_with("This may be another volume") &&
           loaded.notes[1].english().starts_with("The saved view looks past this volume");
  };
  SourceOptions options;
  options.volume = volume;
  const LoadedScene fitted = loadScene(path.string(), options, {});
  EXPECT_TRUE(saysThatItIsFitted(fitted));
  EXPECT_FALSE(fitted.hasOwnCamera) << "whoever shows it may fit it to the window";
  EXPECT_EQ(fitted.scene.transferFunction, session.scene.scene.transferFunction);
  EXPECT_NEAR(fitted.scene.camera.target.x, 1004.5, 9.0);
  EXPECT_NEAR(glm::distance(basisOf(fitted.scene.camera).forward, basisOf(camera).forward), 0.0, 1e-9);
  options.bringsView = true;
  const LoadedScene unasked = loadScene(path.string(), options, {});
  EXPECT_FALSE(saysThatItIsFitted(unasked)) << "whoever asks looks from elsewhere";
  EXPECT_EQ(unasked.scene.camera, camera);
  options.bringsView = false;
  options.volume = "phantom:10"; // another one, which lies where that lay
  const LoadedScene seen = loadScene(path.string(), options, {});
  EXPECT_FALSE(saysThatItIsFitted(seen));
  EXPECT_EQ(seen.scene.camera, camera);
}

TEST(SceneSource, aSessionIsASourceLikeAScene) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "session.json";
  const SessionDocument session = sessionOfPhantom();
  std::ofstream(path) << sessionToJson(session);
  const LoadedScene loaded = loadScene(path.string(), {}, {});
  EXPECT_EQ(loaded.volumePath, "phantom:8");
  EXPECT_TRUE(loaded.hasOwnCamera);
  EXPECT_EQ(loaded.scene.camera, session.scene.scene.camera);
  ASSERT_TRUE(loaded.session);
  EXPECT_EQ(loaded.session->layout, CompareLayout::difference);
}

TEST(SceneSource, scenesAndSessionsAreKnownByWhatTheyHoldWhateverTheirEnding) {
  const test::TemporaryFolder folder;
  for (const char* name : {"mine", "mine.v2", "mine.txt"}) {
    const std::string path = (folder.path() / name).string();
    std::ofstream(path) << sessionToJson(sessionOfPhantom());
    EXPECT_TRUE(loadScene(path, {}, {}).session) << name;
    std::ofstream(path) << "\n {\"limn_scene\": 1, \"volume\": \"phantom:8\", \"projection\": \"xray\"}";
    EXPECT_EQ(loadScene(path, {}, {}).scene.projection, Projection::xray) << name;
    std::ofstream(path) << "{\"other\": 1}";
    EXPECT_THROW(loadScene(path, {}, {}), Error) << name;
  }
}

TEST(SceneSource, aSceneOfTheSampleHeadOpensFromAnyFolder) {
  const auto head = installedSampleHead();
  if (!head)
    GTEST_SKIP() << "no sample head is installed (package invesalius-examples)";
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "scene.json"; // as a picture of it says, which names no folders
  std::ofstream(path) << R"({"limn_scene": 1, "volume": ")" << head->filename().string() << "\"}";
  EXPECT_EQ(loadScene(path.string(), {}, {}).volumePath, head->string());
}

TEST(SceneSource, aPathMeansTheSameFromEverywhereAndBuiltInNamesStay) {
  EXPECT_EQ(absoluteSource("sample"), "sample");
  EXPECT_EQ(absoluteSource("phantom:4"), "phantom:4");
  const std::filesystem::path here = std::filesystem::current_path();
  EXPECT_EQ(absoluteSource("data/../head.nii"), (here / "head.nii").string());
  EXPECT_EQ(absoluteSource("series/"), (here / "series").string());
}

TEST(SceneSource, aVolumeThatMayNotBeNamedIsFoundByWhatStandsForIt) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "session.json";
  SessionDocument session = sessionOfPhantom();
  session.scene.volume = "ct-64x64x64-abc";
  std::ofstream(path) << sessionToJson(session);
  EXPECT_THROW(loadScene(path.string(), {}, {}), VolumeMissing);
  SourceOptions options;
  options.references["ct-64x64x64-abc"] = folder.path() / "moved"; // nor there
  EXPECT_THROW(loadScene(path.string(), options, {}), VolumeMissing);
  std::ofstream(folder.path() / "moved") << "not a volume, but there";
  try {
    loadScene(path.string(), options, {});
    FAIL() << "nothing was thrown";
  } catch (const VolumeMissing&) {
    FAIL() << "it was not looked for";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("moved"), std::string::npos) << error.what();
  }
}

} // namespace
} // namespace limn
