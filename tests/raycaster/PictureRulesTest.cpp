// SPDX-License-Identifier: GPL-3.0-or-later
// Rules that every picture of the ray caster keeps, to the bit where the rule is an equality.
#include "raycaster/RayCaster.h"
#include "scene/light/LightingTerms.h"
#include "support/AnalyticScenes.h"
#include "support/GlTest.h"
#include "support/Heads.h"
#include "support/RendererRules.h"

#include <cmath>

namespace limn {
namespace {

constexpr glm::ivec2 rulesSize{96, 80};

bool isSound(const Image& image) {
  for (const glm::vec4& pixel : image.pixels) {
    for (int channel = 0; channel < 4; ++channel)
      if (!std::isfinite(pixel[channel]) || pixel[channel] < 0.0f)
        return false;
    // Colours are limited to 1 before compositing, so none exceeds alpha but for rounding.
    if (pixel.a > 1.0f || std::max({pixel.r, pixel.g, pixel.b}) > pixel.a + 1e-6f)
      return false;
  }
  return true;
}

bool isEmpty(const Image& image) {
  return image == Image(image.size);
}

using PictureRules = test::GlTest;

TEST_F(PictureRules, enhancedWithEqualRangesIsClassicToTheBitAndTheSameProgram) {
  RayCaster caster;
  Scene classic = test::noisyPhantom(ShadingModel::classic);
  classic.shading.exponent = 20.0;
  const Image expected = caster.render(classic, rulesSize);
  Scene enhanced = classic;
  enhanced.shading.model = ShadingModel::enhanced;
  enhanced.shading.exponentRange = {20.0, 20.0};
  enhanced.shading.opacityRange = {1.0, 1.0};
  EXPECT_EQ(caster.render(enhanced, rulesSize), expected);
  EXPECT_EQ(caster.compiledPrograms(), 1);
  EXPECT_EQ(lightingTerms(enhanced.shading), lightingTerms(classic.shading));
  EXPECT_FALSE(isEmpty(expected));
}

TEST_F(PictureRules, robustWithEveryExtraNeutralIsEnhancedToTheBit) {
  RayCaster caster;
  Scene enhanced = test::noisyPhantom(ShadingModel::enhanced);
  enhanced.shading.gradientReference = LargestReference{};
  const Image expected = caster.render(enhanced, rulesSize);
  Scene robust = enhanced;
  robust.shading.model = ShadingModel::robust;
  robust.shading.energyFactor = false;
  robust.shading.significance.reset();
  robust.shading.knee.reset();
  EXPECT_EQ(caster.render(robust, rulesSize), expected);
  EXPECT_EQ(caster.compiledPrograms(), 1);
}

TEST_F(PictureRules, everyExtraOfRobustChangesThePicture) {
  RayCaster caster;
  Scene scene = test::noisyPhantom(ShadingModel::robust);
  scene.shading.specular = 2.0;
  const Image all = caster.render(scene, rulesSize);
  Scene without = scene;
  without.shading.energyFactor = false;
  EXPECT_NE(caster.render(without, rulesSize), all) << "energy factor";
  without = scene;
  without.shading.significance.reset();
  EXPECT_NE(caster.render(without, rulesSize), all) << "significance";
  without = scene;
  without.shading.knee.reset();
  EXPECT_NE(caster.render(without, rulesSize), all) << "knee";
}

TEST_F(PictureRules, editingAControlPointCompilesNoProgram) {
  RayCaster caster;
  Scene scene = test::noisyPhantom(ShadingModel::enhanced);
  Image before = caster.render(scene, rulesSize);
  // Points that close up on each other ask for pre-integrated steps: a resting view has that program at hand.
  while (caster.warmUp(scene, rulesSize)) {
  }
  const int programs = caster.compiledPrograms();
  for (int i = 0; i < 12; ++i) {
    scene.transferFunction = withPointMoved(scene.transferFunction, 3, -20.0 + 10.0 * i, 0.1 + 0.05 * i);
    const Image after = caster.render(scene, rulesSize);
    EXPECT_NE(after, before) << "the edit did not show";
    before = after;
  }
  scene.transferFunction = withPointAdded(scene.transferFunction, 700.0, 0.1);
  caster.render(scene, rulesSize);
  scene.transferFunction = withoutPoints(scene.transferFunction, {0, 2});
  caster.render(scene, rulesSize);
  scene.camera = orbited(scene.camera, 0.3, 0.2);
  caster.render(scene, rulesSize);
  EXPECT_EQ(caster.compiledPrograms(), programs);
}

TEST_F(PictureRules, allPicturesAreFiniteAndOutsideTheBoxIsExactlyNothing) {
  RayCaster caster;
  for (const ShadingModel model :
       {ShadingModel::none, ShadingModel::classic, ShadingModel::enhanced, ShadingModel::robust}) {
    const Scene scene = test::noisyPhantom(model);
    const Image image = caster.render(scene, rulesSize);
    const std::vector<int> counts = caster.sampleCounts(scene, rulesSize);
    EXPECT_TRUE(isSound(image));
    int missed = 0;
    for (std::size_t i = 0; i < counts.size(); ++i)
      if (counts[i] == 0) {
        EXPECT_EQ(image.pixels[i], glm::vec4(0.0f));
        ++missed;
      }
    EXPECT_GT(missed, 100);
  }
}

test::DrawPicture with(RayCaster& caster) {
  return [&caster](const Scene& scene, const glm::ivec2& size) { return caster.render(scene, size); };
}

TEST_F(PictureRules, theCameraMovesThroughTheBoxWithoutAJump) {
  RayCaster caster;
  test::expectNoJumpThroughTheBox(with(caster));
}

TEST_F(PictureRules, aRayInAFaceIsLitOnceOfTwoFaces) {
  RayCaster caster;
  test::expectFacesLitOnce(with(caster));
}

TEST_F(PictureRules, degenerateVolumesAreDrawnSoundly) {
  RayCaster caster;
  const glm::ivec3 sizes[] = {{1, 1, 1}, {1, 5, 7}, {5, 1, 7}, {5, 7, 1}, {1, 1, 9}, {2, 2, 2}};
  for (const glm::ivec3& dims : sizes)
    for (const bool isConstant : {true, false})
      for (const ShadingModel model : {ShadingModel::classic, ShadingModel::robust}) {
        Grid grid;
        grid.dims = dims;
        std::vector<float> voxels(static_cast<std::size_t>(dims.x) * dims.y * dims.z, 50.0f);
        for (std::size_t i = 0; !isConstant && i < voxels.size(); ++i)
          voxels[i] = static_cast<float>(i * 37 % 101);
        Scene scene = test::headScene(
            std::make_shared<const Volume>(grid, voxels, Rescale{}, std::nullopt, VolumeInfo{}), model);
        scene.transferFunction = {1.0, {{0.0, glm::dvec3(1.0), 0.0}, {100.0, glm::dvec3(1.0), 0.9}}};
        const Image image = caster.render(scene, {32, 32});
        EXPECT_TRUE(isSound(image));
        // The single voxel of a varying volume has the transparent value 0; without a gradient the robust
        // model's opacity coefficient is its smallest, 0.
        const bool shows = isConstant ? model == ShadingModel::classic : dims != glm::ivec3(1);
        EXPECT_NE(isEmpty(image), shows) << dims.x << dims.y << dims.z;
      }
}

TEST_F(PictureRules, valuesNearTheEndOfFloatGiveThePictureOfTheirScaledCopy) {
  // H16: normalising in double makes a volume scaled by a power of two the same to the bit.
  RayCaster caster;
  const auto render = [&caster](double scale) {
    std::vector<double> voxels;
    for (int i = 0; i < 125; ++i)
      voxels.push_back(scale * (i * 37 % 101));
    Grid grid;
    grid.dims = glm::ivec3(5);
    Scene scene =
        test::headScene(std::make_shared<const Volume>(grid, voxels, Rescale{}, std::nullopt, VolumeInfo{}),
                        ShadingModel::enhanced);
    scene.transferFunction = {1.0, {{0.0, glm::dvec3(1.0), 0.0}, {100.0 * scale, glm::dvec3(1.0), 0.9}}};
    return caster.render(scene, {32, 32});
  };
  const Image expected = render(1.0);
  EXPECT_FALSE(isEmpty(expected));
  EXPECT_EQ(render(0x1p100), expected);
  EXPECT_EQ(render(0x1p-100), expected);
}

TEST_F(PictureRules, aFarCameraWithATinyFieldOfViewSeesTheOrthographicPicture) {
  // H12: from 1000 box diagonals the rays are parallel to 1/2000 over the box; one level is the bound.
  RayCaster caster;
  Scene scene = test::noisyPhantom(ShadingModel::classic);
  scene.quality.stepVoxels = 0.25;
  const double diagonal = boxDiagonalMm(scene.volume->grid());
  scene.camera.projection = Camera::Projection::orthographic;
  scene.camera.heightMm = diagonal;
  const Image orthographic = caster.render(scene, rulesSize);
  scene.camera.projection = Camera::Projection::perspective;
  scene.camera.position.y = -1e6 * diagonal;
  scene.camera.fovYDeg = 2.0 * std::atan(0.5e-6) * 180.0 / 3.14159265358979323846;
  const Image far = caster.render(scene, rulesSize);
  EXPECT_LE(test::largestDifference(far, orthographic) * 255.0, 1.0);
}

TEST_F(PictureRules, aStepBelowTheLimitIsReported) {
  RayCaster caster;
  Scene scene = test::noisyPhantom(ShadingModel::none);
  caster.render(scene, {4, 4});
  EXPECT_EQ(caster.limitation().english(), "");
  scene.quality.stepVoxels = 1e-4;
  scene.transferFunction = {};
  caster.render(scene, {1, 1});
  EXPECT_NE(caster.limitation().english().find("60000"), std::string::npos);
  EXPECT_FALSE(caster.facts(scene).takesAllSamples);
  scene.quality.stepVoxels = 0.5;
  EXPECT_TRUE(caster.facts(scene).takesAllSamples);
}

TEST_F(PictureRules, aSceneIsReadyOnceAProgramCanDrawIt) {
  RayCaster caster;
  Scene scene = test::noisyPhantom(ShadingModel::enhanced);
  EXPECT_FALSE(caster.facts(scene).isReady);
  caster.render(scene, {4, 4});
  const int programs = caster.compiledPrograms();
  EXPECT_TRUE(caster.facts(scene).isReady);
  scene.quality.preintegrated = Preintegration::always;
  EXPECT_FALSE(caster.facts(scene).isReady) << "steps of another kind";
  EXPECT_EQ(caster.compiledPrograms(), programs) << "to ask compiles nothing";
  scene.transferFunction = {};
  EXPECT_TRUE(caster.facts(scene).isReady) << "nothing can be seen";
}

} // namespace
} // namespace limn
