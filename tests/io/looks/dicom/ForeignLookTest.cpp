// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/dicom/ForeignLook.h"
#include "io/dicom/SyntheticSeries.h"
#include "io/looks/dicom/Looks.h"

#include "io/VolumeReader.h"
#include "io/looks/Look.h"

#include <glm/trigonometric.hpp>

// Looks that others wrote, by a writer that shares nothing with ours.

namespace limn {
namespace {

using test::DicomBuilder;
using test::ForeignLook;

DicomLook parsed(const ForeignLook& look) {
  return parseDicomLook(look.bytes(), "look.dcm");
}

Grid gridOf(const glm::dvec3& originMm, const glm::dmat3& direction = glm::dmat3(1.0)) {
  return {{10, 20, 40}, {1.0, 1.0, 2.0}, originMm, direction};
}

TEST(ForeignLook, isReadAsItSays) {
  const DicomLook look = parsed(ForeignLook());
  EXPECT_TRUE(look.changes.empty());
  EXPECT_FALSE(look.own);
  EXPECT_EQ(look.camera.projection, Camera::Projection::orthographic);
  EXPECT_EQ(look.camera.position, glm::dvec3(0, -500, 0));
  EXPECT_DOUBLE_EQ(look.camera.heightMm, 100.0);
  EXPECT_DOUBLE_EQ(look.aspect, 2.0);
  EXPECT_EQ(look.shading.model, ShadingModel::none); // no shading module
  EXPECT_DOUBLE_EQ(look.transferFunction.unitDistanceMm, 0.5);
  ASSERT_EQ(look.transferFunction.points.size(), 3u);
  EXPECT_DOUBLE_EQ(look.transferFunction.points[1].value, 100.0);
  EXPECT_DOUBLE_EQ(look.transferFunction.points[1].color.r, 0x8000 / 65535.0);
  EXPECT_DOUBLE_EQ(look.transferFunction.points[1].opacity, 0x4000 / 65535.0);
  std::vector<Message> changes;
  const Scene scene = sceneOf(look, gridOf({0, 0, 0}), changes).scene;
  EXPECT_DOUBLE_EQ(scene.quality.stepVoxels, 0.5); // the drawing step is the sampling step
  EXPECT_EQ(scene.image.width, 2 * scene.image.height);
}

// The vertical angle is measured at the far distance: 2·atan(50/1000).
TEST(ForeignLook, measuresItsFieldOfViewAtTheFarDistance) {
  ForeignLook look;
  look.object.text(0x00701602, "CS", "PERSPECTIVE");
  EXPECT_NEAR(parsed(look).camera.fovYDeg, glm::degrees(2.0 * std::atan(0.05)), 1e-12);
}

TEST(ForeignLook, movesAParallelViewThatLiesBesideItsAxis) {
  ForeignLook look;
  look.object.fds(0x00701606, {-90, 110, 70, -30, 1, 1000});
  const Camera camera = parsed(look).camera;
  EXPECT_EQ(camera.position, glm::dvec3(10, -500, 20)); // seen from the front, right is +x
  EXPECT_EQ(camera.target, glm::dvec3(10, 0, 20));
}

// C.11.2.1.2: the lowest value of a LINEAR window is c - 1/2 - (w-1)/2.
TEST(ForeignLook, readsWindowsOfBothKinds) {
  ForeignLook look;
  look.input.text(0x00281056, "CS", "LINEAR");
  EXPECT_DOUBLE_EQ(parsed(look).transferFunction.points.front().value, 0.0);
  EXPECT_DOUBLE_EQ(parsed(look).transferFunction.points.back().value, 199.0);
  look.input.without(0x00281056);
  EXPECT_DOUBLE_EQ(parsed(look).transferFunction.points.back().value, 199.0);
}

TEST(ForeignLook, readsTablesWithoutAWindowFromANegativeValueOn) {
  ForeignLook look;
  look.input.without(0x00281050).without(0x00281051).without(0x00281056);
  look.tables(16, {{0, 0x8000, 0xFFFF}, {0, 0, 0xFFFF}, {0, 0, 0xFFFF}, {0, 0x4000, 0xFFFF}}, 3, 0xFB50,
              "SS");
  const auto& points = parsed(look).transferFunction.points;
  EXPECT_DOUBLE_EQ(points.front().value, -1200.0);
  EXPECT_DOUBLE_EQ(points.back().value, -1198.0);
}

// Two entries to a word, the first in the lower half, one byte of padding.
TEST(ForeignLook, readsTablesOfEightBits) {
  ForeignLook look;
  look.tables(8, {{0x8000, 0x00FF}, {0, 0x00FF}, {0, 0x00FF}, {0x4000, 0x00FF}});
  const auto& points = parsed(look).transferFunction.points;
  ASSERT_EQ(points.size(), 3u);
  EXPECT_DOUBLE_EQ(points[1].color.r, 0x80 / 255.0);
  EXPECT_DOUBLE_EQ(points[1].opacity, 0x40 / 255.0);
  EXPECT_DOUBLE_EQ(points[2].opacity, 1.0);
}

// C.7.9.2: a run of one value, then a straight line of four.
TEST(ForeignLook, readsSegmentedTables) {
  ForeignLook look;
  look.tables(16, {{0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}}, 5);
  look.component.without(0x00281204);
  look.component.words(0x00281224, "OW", {0, 1, 0, 1, 4, 40000});
  const auto& points = parsed(look).transferFunction.points;
  ASSERT_EQ(points.size(), 2u); // a straight line has no more
  EXPECT_DOUBLE_EQ(points.back().opacity, 40000 / 65535.0);
}

TEST(ForeignLook, readsGreyAndIdentity) {
  ForeignLook look;
  look.component.text(0x0028140F, "CS", "EQUAL_RGB").text(0x00281410, "CS", "IDENTITY");
  const auto& points = parsed(look).transferFunction.points;
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points.back().color, glm::dvec3(1.0));
  EXPECT_EQ(points.back().opacity, 1.0);
}

TEST(ForeignLook, withoutAStepHoldsOverAMillimetreAndSaysSo) {
  ForeignLook look;
  look.object.without(0x00701607);
  EXPECT_DOUBLE_EQ(parsed(look).transferFunction.unitDistanceMm, 1.0);
  EXPECT_TRUE(test::says(parsed(look).changes, "1 mm"));
}

TEST(ForeignLook, isLitAsClassicWithWhitePhongHighlights) {
  ForeignLook look;
  look.object.text(0x00701701, "CS", "DOUBLESIDED").fds(0x00701702, {0.5}).fds(0x00701703, {0, 0.6, -0.8});
  look.object.fds(0x00701704, {0.4}).fds(0x00701705, {0.3}).fds(0x00701706, {0.25});
  const Shading shading = parsed(look).shading;
  Shading expected;
  expected.model = ShadingModel::classic;
  expected.ambient = 0.5;
  expected.diffuse = 0.4;
  expected.specular = 0.3;
  expected.ambientIntensity = expected.lightIntensity = 1.0;
  expected.exponent = 256.0; // a quarter of 1024
  expected.reflection = Reflection::phong;
  expected.specularColor = SpecularColor::light;
  expected.twoSided = true;
  expected.lightDirection = glm::dvec3(0, 0.6, -0.8);
  EXPECT_EQ(shading, expected);
  look.object.without(0x00701703);
  EXPECT_TRUE(test::says(parsed(look).changes, "comes from the viewer"));
}

// Two corners in patient space; the box lies along the volume's axes, which here are turned by a right angle.
TEST(ForeignLook, isCroppedAlongTheAxesOfTheVolume) {
  ForeignLook look;
  DicomBuilder box;
  box.us(0x00701309, {4}).text(0x00701302, "CS", "BOUNDING_BOX");
  const glm::dmat3 turned(glm::dvec3(0, 1, 0), glm::dvec3(-1, 0, 0), glm::dvec3(0, 0, 1));
  const Grid grid = gridOf({100, 0, 0}, turned);
  const glm::dvec3 a = indexToWorld(grid, {9.5, 4.5, -0.5}), b = indexToWorld(grid, {4.5, 19.5, 19.5});
  box.fds(0x00701303, {a.x, a.y, a.z, b.x, b.y, b.z});
  look.input.text(0x00701204, "CS", "YES").us(0x00701205, {4});
  look.object.sequence(0x00701301, {box});
  std::vector<Message> changes;
  const CropBox crop = sceneOf(parsed(look), grid, changes).scene.crop;
  EXPECT_LT(glm::length(crop.lower - glm::dvec3(0.5, 0.25, 0.0)), 1e-12);
  EXPECT_LT(glm::length(crop.upper - glm::dvec3(1.0, 1.0, 0.5)), 1e-12);
}

TEST(ForeignLook, saysWhatItsPlanesCutAway) {
  ForeignLook look;
  look.object.fds(0x00701606, {-100, 100, 50, -50, 505, 510});
  std::vector<Message> changes;
  sceneOf(parsed(look), gridOf({0, 0, 0}), changes);
  EXPECT_TRUE(test::says(changes, "near plane"));
  EXPECT_TRUE(test::says(changes, "far plane"));
}

TEST(ForeignLook, saysWhatIsLeftOut) {
  ForeignLook look;
  DicomBuilder planes;
  planes.us(0x00701309, {1}).text(0x00701302, "CS", "OBLIQUE_PLANES");
  look.input.text(0x00701204, "CS", "YES").us(0x00701205, {1});
  look.object.sequence(0x00701301, {planes}).text(0x00701A01, "CS", "SWIVEL");
  look.object.sequence(0x00701901, {DicomBuilder()}).sequence(0x00700001, {DicomBuilder()});
  const std::vector<Message> changes = parsed(look).changes;
  for (const char* part : {"oblique planes", "SWIVEL", "in the volume", "on the picture"})
    EXPECT_TRUE(test::says(changes, part)) << part;
}

void expectRefused(const ForeignLook& look, const std::string& part) {
  const std::string refusal = test::lookRefusal(look.bytes());
  EXPECT_NE(refusal.find(part), std::string::npos) << "\"" << refusal << "\" should say " << part;
  EXPECT_NE(refusal.find("look.dcm"), std::string::npos) << refusal;
}

TEST(ForeignLookRefusal, namesWhatCannotBeDrawn) {
  ForeignLook look;
  look.object.text(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.11.10");
  expectRefused(look, "segmented");
  look.object.text(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.11.11");
  expectRefused(look, "several volumes");
  look.object.text(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.11.6");
  expectRefused(look, "slices");
  look.object.text(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.11.1");
  expectRefused(look, "no presentation state of a volume");
  look = {};
  look.component.text(0x00701802, "CS", "TWO_TO_RGBA");
  expectRefused(look, "TWO_TO_RGBA");
  look = {};
  DicomBuilder registration;
  registration.text(0x00081150, "UI", "1.2.840.10008.5.1.4.1.1.66.3");
  look.input.sequence(0x00700404, {registration});
  expectRefused(look, "non-linear registration");
  look = {};
  DicomBuilder segments;
  segments.us(0x00701309, {1}).text(0x00701302, "CS", "INCLUDE_SEG");
  look.input.text(0x00701204, "CS", "YES").us(0x00701205, {1});
  look.object.sequence(0x00701301, {segments});
  expectRefused(look, "INCLUDE_SEG");
  look = {};
  look.set.text(0x00701202, "CS", "TEMPORAL");
  expectRefused(look, "TEMPORAL");
}

TEST(ForeignLookRefusal, namesWhatIsWrong) {
  ForeignLook look;
  look.tables(16, {{0, 1}, {0, 1}, {0, 1}, {0, 1}});
  expectRefused(look, "has 2 entries, where its descriptor announces 3");
  look = {};
  look.component.words(0x00281104, "US", {2, 0, 16}).words(0x00281204, "OW", {0, 1});
  expectRefused(look, "differ in length");
  look = {};
  look.component.words(0x00281101, "US", {3, 0, 12});
  expectRefused(look, "8 or 16");
  look = {};
  look.object.fds(0x00701606, {100, -100, 50, -50, 1, 1000});
  expectRefused(look, "contradicts itself");
  look = {};
  look.object.fds(0x00701603, {0, 0, 0});
  expectRefused(look, "viewpoint");
  look = {};
  look.object.fds(0x00701603, {0, std::nan(""), 0});
  expectRefused(look, "Position");
  look = {};
  look.input.text(0x00281051, "DS", "0");
  expectRefused(look, "width");
  look = {};
  look.set.text(0x00701209, "UI", "6.6");
  expectRefused(look, "which images");
  look = {};
  look.object.text(0x00701701, "CS", "SINGLESIDED").fds(0x00701702, {1.5});
  expectRefused(look, "0 to 1");
}

// However short it is cut, one sentence.
TEST(ForeignLookRefusal, ofTruncatedFiles) {
  const std::string whole = ForeignLook().bytes();
  ASSERT_EQ(test::lookRefusal(whole), "");
  for (std::size_t length = 0; length < whole.size(); ++length)
    ASSERT_NE(test::lookRefusal(whole.substr(0, length)), "") << length;
}

TEST(ForeignLook, givesAPresetCurveAndLight) {
  const std::vector<ReadLook> looks = parseLooks(ForeignLook().bytes(), "bone.dcm");
  ASSERT_EQ(looks.size(), 1u);
  EXPECT_EQ(looks[0].preset.name, "bone");
  EXPECT_EQ(looks[0].preset.modality, "CT");
  EXPECT_EQ(looks[0].preset.transferFunction.points.size(), 3u);
  EXPECT_EQ(looks[0].preset.shading->model, ShadingModel::none);
  EXPECT_FALSE(looks[0].preset.projection);
}

// Written under the ending alone where the series is known that it is filed with.
TEST(DicomPreset, isWrittenForASeries) {
  Preset preset;
  preset.name = "veil";
  preset.modality = "CT";
  preset.transferFunction.points = {{-100.0, {1, 0, 0}, 0.0}, {300.0, {1, 1, 1}, 0.25}};
  EXPECT_THROW(lookAs("veil.dcm", preset), Error);
  test::TemporaryFolder folder;
  test::slice(1, 0.0).write(folder.path() / "1");
  test::slice(2, 1.0).write(folder.path() / "2");
  LookTarget target;
  target.series = {readVolume(folder.path()), folder.path(), 1};
  const WrittenLook written = lookAs("veil.dcm", preset, target);
  EXPECT_EQ(parseLooks(written.text, "veil.dcm").front().preset.transferFunction, preset.transferFunction);
  EXPECT_TRUE(test::says(written.changes, "table of"));
  EXPECT_EQ(parseDicomLook(written.text, "veil.dcm").images.size(), 2u);
}

TEST(LookSeries, isTheOneThatHoldsEveryImage) {
  DicomLook look;
  look.images = {{"a", "1"}, {"a", "2"}};
  const auto series = [](int number, std::vector<DicomReference> images) {
    return SeriesImages{number, "s", "t", std::move(images), {}};
  };
  const std::vector<SeriesImages> all{series(1, {{"a", "7"}}),
                                      series(2, {{"a", "2"}, {"a", "1"}, {"a", "3"}})};
  EXPECT_EQ(seriesOf(look, all, "look.dcm", "folder").number, 2);
  EXPECT_TRUE(belongsToOne(look, all));
  const auto refusal = [&](const std::vector<SeriesImages>& some) {
    try {
      seriesOf(look, some, "look.dcm", "folder");
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), Error::Kind::input);
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(refusal({all[0]}).find("another series"), std::string::npos) << refusal({all[0]});
  EXPECT_NE(refusal({}).find("another series"), std::string::npos);
  SeriesImages part = series(1, {{"a", "2"}});
  EXPECT_NE(refusal({part}).find("1 of the 2 images"), std::string::npos);
  part.leftOut = {"1"}; // another phase, which the volume is not made of
  EXPECT_EQ(seriesOf(look, {part}, "look.dcm", "folder").number, 1);
}

} // namespace
} // namespace limn
