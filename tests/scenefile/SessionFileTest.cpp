// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/scenefile/SessionFile.h"
#include "io/scenefile/SettingsFile.h"
#include "scene/basics/Error.h"
#include "support/FileBytes.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

// Every field off its default; numbers without a short decimal form.
SessionDocument unusual() {
  SessionDocument session;
  session.scene.volume = "heads/ct";
  session.scene.orientation = "RAS";
  session.scene.hasCamera = true;
  session.scene.hasTransferFunction = true;
  Scene& scene = session.scene.scene;
  scene.camera.position = {1.0 / 3.0, -250.1, 1e-7};
  scene.camera.projection = Camera::Projection::orthographic;
  scene.transferFunction.points = {{-1000.1, {0.1, 0.2, 0.3}, 0.0}, {2.0 / 7.0, {1, 1, 1}, 0.7}};
  scene.shading.model = ShadingModel::robust;
  scene.shading.exponentRange = {1.5, 63.25};
  scene.gradientOpacity = GradientOpacity{{{0.0, 0.0}, {12.5, 1.0}}};
  scene.fog.mode = Fog::Mode::exp2;
  scene.crop.lower = {0.1, 0.2, 0.3};
  scene.projection = Projection::compositeIsosurface;
  scene.isovalue = -77.7;
  scene.quality.toleranceLevels = 0.5;
  scene.quality.fineness = 3;
  session.scene.views = {{"from the ear", scene.camera}, {"a\tb", Camera{}}};
  session.series = 2;
  session.spacingMm = glm::dvec3(0.5, 0.25, 1.1);
  session.layout = CompareLayout::wipe;
  session.layoutIsAsked = false;
  session.leftModel = ShadingModel::none;
  session.rightModel = ShadingModel::robust;
  session.wipe = 0.3;
  session.snapshot = presetOf(scene, "before");
  session.comparedLook = session.snapshot;
  session.comparedLook->isovalue.reset();
  session.comparedLook->shading.reset();
  session.comparedLook->note = "a note";
  session.comparedFrom = presetOf(scene, "CT bone");
  session.changedPreset = presetOf(scene, "CT skin");
  session.planes = {.layout = PlaneLayout::oneLarge,
                    .large = PatientPlane::sagittal,
                    .crosshairMm = glm::dvec3(1.0 / 3.0, -1e5, 0.1),
                    .window = GreyWindow{-600.1, 1.0 / 7.0},
                    .interpolation = PlaneInterpolation::nearest,
                    .slab = {Slab::Mode::maximum, 12.3},
                    .isTinted = true,
                    .outlinesRegion = false};
  session.panel = SessionDocument::Panel::accuracy;
  session.preset = "Mine \"ä\"";
  session.scene.keep = {Region::Kind::labels, "seg.nrrd", {{2, 0.5}}};
  session.cropBoxIsShown = true;
  session.gradientCurveIsShown = true;
  session.labelInHand = 2;
  session.label = "CT 3×2×4";
  session.savedAs = "/somewhere/else.json";
  session.savedDigest = digestOf("its text");
  session.isUnsaved = true;
  return session;
}

std::string sessionRefusal(const std::string& text) {
  try {
    parseSession(text, "my.json");
    return {};
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::input);
    return error.what();
  }
}

TEST(SessionFile, keepsHowTheVolumeIsCutOpen) {
  SessionDocument session;
  session.scene.volume = "head.nrrd";
  CropBox before;
  before.lower = {0.1, 0.2, 0.3};
  session.opening = CutOpening{1, true, before, {}};
  EXPECT_EQ(parseSession(sessionToJson(session), "t").opening, session.opening);
  session.opening = CutOpening{0, false, {}, std::array<bool, 3>{true, false, true}};
  EXPECT_EQ(parseSession(sessionToJson(session), "t").opening, session.opening);
  std::string text = sessionToJson(session);
  const std::size_t at = text.find("\"x_upper\"");
  ASSERT_NE(at, std::string::npos);
  text.replace(at, 9, "\"w_upper\"");
  EXPECT_THROW(parseSession(text, "t"), Error);
}

TEST(SessionFile, whatIsWrittenIsReadToTheBit) {
  EXPECT_EQ(parseSession(sessionToJson(unusual()), "session"), unusual());
  SessionDocument plain;
  plain.scene.volume = "phantom:2";
  plain.scene.hasCamera = true;
  plain.scene.hasTransferFunction = true;
  EXPECT_EQ(parseSession(sessionToJson(plain), "session"), plain);
}

TEST(SessionFile, whatIsMissingTakesItsDefault) {
  const std::string text = R"({"limn_session": 1, "scene": {"limn_scene": 1, "volume": "a.nii"}})";
  SessionDocument expected;
  expected.scene.volume = "a.nii";
  EXPECT_EQ(parseSession(text, "my.json"), expected);
}

TEST(SessionFile, unknownKeysAreRefusedByNameOnEveryLevel) {
  const auto with = [](const std::string& scene, const std::string& rest) {
    return R"({"limn_session": 1, "scene": {"limn_scene": 1, "volume": "a.nii")" + scene + "}" + rest + "}";
  };
  EXPECT_EQ(sessionRefusal(with("", "")), "");
  EXPECT_NE(sessionRefusal(with("", R"(, "sceen": 1)")).find("\"sceen\""), std::string::npos);
  EXPECT_NE(sessionRefusal(with(R"(, "fogg": 1)", "")).find("\"scene.fogg\""), std::string::npos);
  EXPECT_NE(sessionRefusal(with("", R"(, "compare": {"middle": "none"})")).find("\"compare.middle\""),
            std::string::npos);
  EXPECT_NE(sessionRefusal(with("", R"(, "window": {"size": 3})")).find("\"window.size\""),
            std::string::npos);
}

TEST(SessionFile, valuesOutsideTheirRangeAreRefusedWithTheRange) {
  const std::string head = R"({"limn_session": 1, "scene": {"limn_scene": 1, "volume": "a.nii"}, )";
  EXPECT_NE(sessionRefusal(head + R"("compare": {"wipe": 1.5}})").find("from 0 to 1"), std::string::npos);
  EXPECT_NE(sessionRefusal(head + R"("window": {"label_in_hand": -1}})").find("from 0 to 65535"),
            std::string::npos);
  EXPECT_NE(sessionRefusal(head + R"("series": 0})").find("from 1 to 100000"), std::string::npos);
  EXPECT_NE(sessionRefusal(head + R"("spacing_mm": [1, 0, 1]})").find("above 0"), std::string::npos);
  EXPECT_NE(sessionRefusal(head + R"("compare": {"layout": "four"}})").find("side_by_side"),
            std::string::npos);
  EXPECT_NE(sessionRefusal(head + R"("slices": {"layout": "four"}})").find("picture_and_three"),
            std::string::npos);
  EXPECT_NE(sessionRefusal(head + R"("slices": {"slab": {"thickness_mm": 101}}})").find("from 0 to 100"),
            std::string::npos);
  EXPECT_NE(sessionRefusal(head + R"("slices": {"window": {"width": 0}}})").find("above 0"),
            std::string::npos);
}

TEST(SessionFile, isToldFromASceneByItsKey) {
  EXPECT_TRUE(looksLikeSession(sessionToJson(unusual())));
  EXPECT_FALSE(looksLikeSession(sceneToJson(unusual().scene.scene, "a.nii")));
  EXPECT_FALSE(looksLikeSession("[1, 2]"));
  EXPECT_FALSE(looksLikeSession("{\"limn_session\": "));
}

TEST(SessionFile, pathsAreRelativeToTheFile) {
  const test::TemporaryFolder folder;
  test::writeBytes(folder.path() / "s.json", sessionToJson(unusual()));
  EXPECT_EQ(readSessionFile(folder.path() / "s.json").scene.volume, (folder.path() / "heads/ct").string());
}

TEST(SettingsFile, keepsTextsByKey) {
  const SettingsDocument settings{{"theme", "dark"}, {"recent/ä/path", "C:\\\"x\"\n"}, {"empty", ""}};
  EXPECT_EQ(parseSettings(settingsToJson(settings), "settings"), settings);
  EXPECT_EQ(parseSettings(settingsToJson({}), "settings"), SettingsDocument());
  EXPECT_THROW(parseSettings(R"({"limn_settings": 1, "values": {"theme": 3}})", "settings"), Error);
  EXPECT_THROW(parseSettings(R"({"limn_settings": 1, "values": [1]})", "settings"), Error);
}

} // namespace
} // namespace limn
