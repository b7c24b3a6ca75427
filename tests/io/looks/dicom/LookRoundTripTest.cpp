// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/dicom/Looks.h"

#include "io/VolumeReader.h"
#include "reference/ReferenceIntegrator.h"
#include "stability/scenes/RandomScene.h"
#include "support/ImageCompare.h"
#include "support/TestData.h"

#include <glm/gtc/matrix_transform.hpp>

namespace limn {
namespace {

Scene readBack(const std::string& look, const Scene& scene, std::vector<Message>* changes = nullptr) {
  std::vector<Message> said;
  const DicomLook read = parseDicomLook(look, "look.dcm");
  Scene back = sceneOf(read, scene.volume->grid(), said).scene;
  said.insert(said.end(), read.changes.begin(), read.changes.end());
  if (changes)
    *changes = said;
  back.volume = scene.volume;
  return back;
}

TEST(DicomLook, readsBackEveryNumberOfAScene) {
  int compared = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    Scene scene;
    try {
      scene = randomScene(seed).scene;
    } catch (const Error&) {
      continue; // a volume without a valid voxel
    }
    const DicomLook look = parseDicomLook(test::objectsOf(scene).look, "look.dcm");
    ASSERT_TRUE(look.own) << seed;
    scene.keep = {}; // a body is found anew, labels are another file
    if (scene.shading.gradientCurve.type == GradientCurve::Type::linear)
      scene.shading.gradientCurve = {}; // a straight line has no parameter
    SceneDocument expected = documentOf(scene, "");
    ASSERT_EQ(sceneToJson(look.own->scene, "volume"), sceneToJson(scene, "volume")) << seed;
    ASSERT_EQ(*look.own, expected) << seed;
    ++compared;
  }
  EXPECT_GT(compared, 300);
}

TEST(DicomLook, remembersThatTheBodyAloneIsKept) {
  Scene scene = test::phantomScene();
  scene.keep.kind = Region::Kind::body;
  EXPECT_EQ(parseDicomLook(test::objectsOf(scene).look, "look.dcm").own->keep.kind, Region::Kind::body);
}

// What another program gets, drawn by the definition itself: 1.5 levels is what the issue allows.
class StrippedLook : public testing::Test {
protected:
  static void expectSamePicture(const Scene& scene, double mostMean) {
    std::vector<Message> changes;
    const Scene back = readBack(test::stripped(test::objectsOf(scene).look), scene, &changes);
    const glm::ivec2 size(scene.image.width, scene.image.height);
    const ReferencePicture expected = renderReference(scene, size);
    const test::Difference difference =
        test::differenceOf(toImage(renderReference(back, size)), expected, [](std::size_t) { return true; });
    EXPECT_GT(difference.pixels, 100u);
    EXPECT_LE(difference.mean, mostMean) << difference;
    EXPECT_TRUE(changes.empty()) << changes.front().english();
    std::cout << difference << ", " << back.transferFunction.points.size() << " points\n";
  }
};

TEST_F(StrippedLook, drawsAsTheUnlitOriginal) {
  expectSamePicture(test::phantomScene(), 0.1);
}

TEST_F(StrippedLook, drawsStepsOfTheCurve) {
  Scene scene = test::phantomScene();
  scene.transferFunction.points = {{-200.0, {1, 0, 0}, 0.0},   {-200.0, {1, 0, 0}, 0.02},
                                   {60.0, {1, 0.5, 0}, 0.001}, {300.0, {1, 1, 0}, 0.001},
                                   {300.0, {1, 1, 1}, 1.0},    {301.5, {0, 1, 1}, 0.2}};
  expectSamePicture(scene, 0.5);
}

TEST_F(StrippedLook, drawsAnyUnitDistanceAndStep) {
  Scene scene = test::phantomScene();
  scene.transferFunction.unitDistanceMm = 7.5;
  scene.quality.stepVoxels = 0.21;
  expectSamePicture(scene, 0.3);
}

TEST_F(StrippedLook, drawsAParallelViewOfATurnedCroppedVolume) {
  Scene scene = test::phantomScene();
  Grid grid = scene.volume->grid();
  const glm::dvec3 axis = glm::normalize(glm::dvec3(1.0, 2.0, -0.5));
  grid.direction = glm::dmat3(glm::rotate(glm::dmat4(1.0), 0.7, axis));
  grid.direction[1] = -grid.direction[1]; // left-handed
  grid.spacingMm = {5.0, 6.0, 9.0};
  scene.volume = std::make_shared<const Volume>(scene.volume->placed(grid, scene.volume->info()));
  scene.camera = rolled(orbited(defaultCamera(grid), 0.4, 0.3), 0.2);
  scene.camera.projection = Camera::Projection::orthographic;
  scene.camera.heightMm = 260.0;
  scene.crop = {{0.1, 0.0, 0.25}, {0.9, 0.6, 1.0}};
  scene.image.width = 64;
  expectSamePicture(scene, 0.1);
}

TEST_F(StrippedLook, drawsFromWithinTheVolume) {
  Scene scene = test::phantomScene();
  scene.camera.position = boxCentreMm(scene.volume->grid());
  scene.camera.fovYDeg = 70.0;
  expectSamePicture(scene, 0.1);
}

TEST_F(StrippedLook, drawsProjections) {
  for (const Projection projection : {Projection::mip, Projection::minip}) {
    Scene scene = test::phantomScene();
    scene.projection = projection;
    scene.transferFunction.points.front().opacity = 0.3; // the lowest value of most rays is air's
    expectSamePicture(scene, 0.1);
  }
}

TEST_F(StrippedLook, drawsARealHead) {
  LIMN_NEEDS_SHARED("data/ct_head_cranium/dicom_explicit_le");
  Scene scene = test::phantomScene(); // its curve
  scene.volume = readVolume(test::sharedFolder() / "data/ct_head_cranium/dicom_explicit_le");
  scene.camera = defaultCamera(scene.volume->grid());
  expectSamePicture(scene, 0.2);
}

TEST(DicomLook, aStrippedLookHasTheNearestLight) {
  Scene scene = test::phantomScene();
  scene.shading = Shading{};
  scene.shading.model = ShadingModel::enhanced;
  scene.shading.ambient = 0.5;
  scene.shading.exponent = 64.0;
  scene.shading.twoSided = true;
  const Shading read = readBack(test::stripped(test::objectsOf(scene).look), scene).shading;
  EXPECT_EQ(read.model, ShadingModel::classic);
  EXPECT_EQ(read.reflection, Reflection::phong);
  EXPECT_EQ(read.specularColor, SpecularColor::light);
  EXPECT_TRUE(read.twoSided);
  // Coefficient times intensity; a quarter of Blinn's exponent; a headlight along the view.
  EXPECT_DOUBLE_EQ(read.ambient * read.ambientIntensity, 0.5 * 0.25);
  EXPECT_DOUBLE_EQ(read.diffuse * read.lightIntensity, 0.75);
  EXPECT_DOUBLE_EQ(read.specular * read.lightIntensity, 0.75);
  EXPECT_DOUBLE_EQ(read.exponent, 16.0);
  ASSERT_TRUE(read.lightDirection);
  EXPECT_LT(glm::length(*read.lightDirection - basisOf(scene.camera).forward), 1e-12);
}

TEST(DicomLook, smoothNormalsAreLostWhereThereAreSome) {
  Scene scene = test::phantomScene();
  scene.shading.model = ShadingModel::classic;
  EXPECT_FALSE(test::says(test::objectsOf(scene).losses, "Smooth normals"));
  scene.shading.gradientSmoothing = 15.0;
  EXPECT_TRUE(test::says(test::objectsOf(scene).losses, "Smooth normals"));
}

TEST(DicomLook, everyLossIsASentence) {
  Scene scene = test::phantomScene();
  scene.shading.model = ShadingModel::robust;
  scene.shading.ambient = 9.0;
  scene.gradientOpacity = GradientOpacity{{{0.0, 0.0}, {100.0, 1.0}}};
  scene.fog.mode = Fog::Mode::exp;
  scene.projection = Projection::xray;
  scene.keep.kind = Region::Kind::labels;
  scene.quality.preintegrated = Preintegration::always;
  scene.quality.jitter = true;
  scene.quality.toleranceLevels = 1.0;
  scene.camera.position = boxCentreMm(scene.volume->grid());
  const std::vector<Message> losses = test::objectsOf(scene).losses;
  for (const char* part : {"exponents by gradient",
                           "(O)",
                           "robust adds",
                           "Phong",
                           "white",
                           "headlight",
                           "limited to 1",
                           "table of",
                           "unit distance",
                           "gradient opacity",
                           "X-ray",
                           "fog",
                           "kept labels",
                           "error wished for",
                           "jitter",
                           "pre-integrated",
                           "end early",
                           "background",
                           "shape",
                           "near plane"})
    EXPECT_TRUE(test::says(losses, part)) << part;
  for (const Message& loss : losses)
    EXPECT_TRUE(loss.english().ends_with(".")) << loss.english();
  EXPECT_FALSE(test::says(test::objectsOf(test::phantomScene()).losses, "fog"));
}

// A look that another program wrote anew, with its private attributes copied, is what its standard ones say.
TEST(DicomLook, aCopiedPrivateBlockOfAnotherObjectIsLeftAside) {
  std::string look = test::objectsOf(test::phantomScene()).look;
  const std::size_t first = look.find("2.25."); // in the meta information
  const std::size_t instance = look.find(look.substr(first, 20), first + 20);
  ASSERT_NE(instance, std::string::npos);
  look[instance + 6] = look[instance + 6] == '1' ? '2' : '1';
  const DicomLook read = parseDicomLook(look, "look.dcm");
  EXPECT_FALSE(read.own);
  EXPECT_TRUE(test::says(read.changes, "changed by another program"));
}

TEST(DicomLook, everyWritingHasNewUids) {
  const Scene scene = test::phantomScene();
  const DicomObjects first = test::objectsOf(scene), second = test::objectsOf(scene);
  std::set<std::string> uids;
  std::size_t count = 0;
  for (const std::string* bytes : {&first.look, &first.picture, &second.look, &second.picture})
    for (const char* tag : {"\x20\x00\x0E\x00UI", "\x08\x00\x18\x00UI"}) {
      const std::size_t at = bytes->rfind(std::string(tag, 6));
      ASSERT_NE(at, std::string::npos);
      uids.insert(bytes->substr(at + 8, 24));
      ++count;
    }
  EXPECT_EQ(uids.size(), count);
}

} // namespace
} // namespace limn
