// SPDX-License-Identifier: GPL-3.0-or-later
// Rules that every picture made of slices keeps.
#include "accuracy/ImageError.h"
#include "raycaster/RayCaster.h"
#include "scene/steps/RayFrame.h"
#include "slices/ProxySlabs.h"
#include "slices/SliceRenderer.h"
#include "support/AnalyticScenes.h"
#include "support/GlTest.h"
#include "support/RendererRules.h"

#include <epoxy/gl.h>

#include <random>

namespace limn {
namespace {

constexpr glm::ivec2 rulesSize{96, 80};

Scene phantomScene(ShadingModel model) {
  Scene scene = test::noisyPhantom(model);
  scene.quality.earlyTermination = 1.0;
  return scene;
}

// A layer rounds 1 - a (at most 2⁻²⁵ of values below 1), a product and a sum: 3·2⁻²⁵ in one channel, which
// later layers only shrink. Front to back, the error of alpha weighs the layers behind and counts once more.
// Both pictures together: 9·2⁻²⁵ per layer.
double roundingOfTwo(const Scene& scene) {
  return 9.0 * 0x1p-25 * static_cast<double>(proxySlabs(scene, rulesSize).size());
}

using SliceRules = test::GlTest;

TEST_F(SliceRules, backToFrontAndFrontToBackAreThePictureButForRounding) {
  SliceRenderer backwards(BlendOrder::backToFront), forwards(BlendOrder::frontToBack);
  for (const ShadingModel model :
       {ShadingModel::none, ShadingModel::classic, ShadingModel::enhanced, ShadingModel::robust})
    for (const double step : {2.0, 0.5, 0.05}) {
      Scene scene = phantomScene(model);
      scene.quality.stepVoxels = step;
      const Image image = backwards.render(scene, rulesSize);
      const double difference = test::largestDifference(image, forwards.render(scene, rulesSize));
      std::printf("step %g: largest difference %.3g of %.3g\n", step, difference, roundingOfTwo(scene));
      EXPECT_LE(difference, roundingOfTwo(scene));
      EXPECT_NE(image, Image(rulesSize));
    }
}

struct RuleRow {
  const char* what;
  void (*apply)(Scene&);
};

const RuleRow alongAxes[] = {
    {"enhanced, fog",
     [](Scene& s) {
       s.fog = {Fog::Mode::exp, glm::dvec3(0.4, 0.5, 0.6), 0.002, 300.0, 0.0};
     }},
    {"cropped",
     [](Scene& s) {
       s.crop = {{0.1, 0.3, 0.1}, {0.6, 1.0, 0.8}};
     }},
    {"pre-integrated", [](Scene& s) { s.quality.preintegrated = Preintegration::always; }},
    {"jittered", [](Scene& s) { s.quality.jitter = true; }},
    {"X-ray", [](Scene& s) { s.projection = Projection::xray; }},
};

TEST_F(SliceRules, slicesTakeTheRayCastersSamplesWhereChordsAreTheBoxsDepth) {
  // Along an axis every chord is as deep as the box, so both renderers cut it into the same steps.
  SliceRenderer slices;
  RayCaster caster;
  for (const RuleRow& row : alongAxes)
    for (const StandardView view : {StandardView::anterior, StandardView::left, StandardView::inferior}) {
      Scene scene = phantomScene(ShadingModel::enhanced);
      scene.camera = standardView(scene.camera, scene.volume->grid(), view);
      scene.camera.projection = Camera::Projection::orthographic;
      scene.camera.heightMm = 290.0;
      scene.quality.preintegrated = Preintegration::never;
      row.apply(scene);
      const Image image = slices.render(scene, rulesSize);
      const ImageError levels = imageError(image, caster.render(scene, rulesSize));
      std::printf("%s: largest %.4f levels, mean %.6f\n", row.what, levels.largest, levels.mean);
      // The bounds of the ray caster against the reference under the same samples (AgainstReferenceTest).
      EXPECT_LE(levels.largest, 0.5) << row.what;
      EXPECT_LE(levels.mean, 0.01) << row.what;
      EXPECT_NE(image, Image(rulesSize));
    }
}

// The largest error of alpha in a picture of a homogeneous box with `opacity` over the unit
// distance, against its closed form; `hits` counts the pixels that show it.
double homogeneousError(SliceRenderer& slices, const Scene& scene, double opacity, int& hits) {
  const Image image = slices.render(scene, rulesSize);
  const RayFrame frame = rayFrame(scene.camera, scene.volume->grid(), rulesSize);
  const IndexBox box = croppedBox(scene.volume->grid(), scene.crop);
  double worst = 0.0;
  for (int y = 0; y < rulesSize.y; ++y)
    for (int x = 0; x < rulesSize.x; ++x) {
      const RaySpan span = spanInBox(framedRay(frame, x, y, rulesSize), box);
      const double units =
          span.isEmpty() ? 0.0 : (span.end - span.begin) / scene.transferFunction.unitDistanceMm;
      worst = std::max(worst, std::abs(image.at(x, y).a - (1.0 - std::pow(1.0 - opacity, units))));
      hits += !span.isEmpty();
    }
  return worst;
}

TEST_F(SliceRules, aHomogeneousBoxIsExactAtEveryAngleAndForEveryStep) {
  SliceRenderer slices;
  Scene scene;
  scene.volume = test::boxOf({30.0, 20.0, 25.0});
  scene.shading.model = ShadingModel::none;
  scene.transferFunction = test::constantFunction(0.05, glm::dvec3(1.0));
  scene.camera = orbited(defaultCamera(scene.volume->grid()), 0.6, 0.4);
  scene.camera.fovYDeg = 60.0;
  scene.camera.position *= 0.7;
  // Steps in voxels, which are 20 mm at the smallest.
  for (const double step : {3.0, 0.1, 0.03, 0.004}) {
    scene.quality.stepVoxels = step;
    int hits = 0;
    const double worst = homogeneousError(slices, scene, 0.05, hits);
    std::printf("%zu slabs: largest error %.3g over %d pixels\n", proxySlabs(scene, rulesSize).size(), worst,
                hits);
    EXPECT_LE(worst, 2e-6); // the tolerance of A7
    EXPECT_GT(hits, 1000);
  }
}

TEST_F(SliceRules, everyPixelIsBlendedOncePerSlabFromWhereverOneLooks) {
  // A pixel of a polygon's seam drawn twice or not at all would miss the closed form by a layer.
  SliceRenderer forwards(BlendOrder::frontToBack), backwards(BlendOrder::backToFront);
  std::mt19937 random(7); // fixed seed
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto anywhere = [&] { return glm::dvec3(unit(random), unit(random), unit(random)); };
  const glm::dvec3 shapes[] = {{3.0, 2.0, 4.0}, {5.0, 0.01, 3.0}, {0.05, 0.05, 6.0}};
  int hits = 0;
  double worst = 0.0;
  for (int i = 0; i < 90; ++i) {
    const double scale = i % 3 == 0 ? 1e-4 : i % 3 == 1 ? 1.0 : 1e4;
    const glm::dvec3& shape = shapes[i / 3 % 3];
    Scene scene = test::rayThrough(test::boxOf(scale * shape));
    scene.camera.projection = i % 2 == 0 ? Camera::Projection::perspective : Camera::Projection::orthographic;
    // One in five stands in the box or close to it.
    scene.camera.position = scale * (i % 5 == 0 ? 1.0 : 6.0) * anywhere();
    scene.camera.target = scale * 0.3 * anywhere();
    scene.camera.up = anywhere();
    scene.camera.heightMm = scale * 5.0;
    scene.camera.fovYDeg = i % 4 == 0 ? 100.0 : 40.0;
    scene.transferFunction = test::constantFunction(0.3, glm::dvec3(1.0), scale);
    scene.quality.stepVoxels = 0.07 * scale / smallestSpacingMm(scene.volume->grid());
    for (SliceRenderer* slices : {&forwards, &backwards})
      worst = std::max(worst, homogeneousError(*slices, scene, 0.3, hits));
    EXPECT_LE(worst, 1e-5) << "camera " << i; // a layer has an opacity of 0.02
  }
  std::printf("largest error %.3g over %d pixels\n", worst, hits);
  EXPECT_GT(hits, 100000);
}

test::DrawPicture with(SliceRenderer& slices) {
  return [&slices](const Scene& scene, const glm::ivec2& size) { return slices.render(scene, size); };
}

TEST_F(SliceRules, theCameraMovesThroughTheBoxWithoutAJump) {
  SliceRenderer slices;
  test::expectNoJumpThroughTheBox(with(slices));
}

TEST_F(SliceRules, aRayInAFaceIsLitOnceOfTwoFaces) {
  SliceRenderer slices;
  test::expectFacesLitOnce(with(slices));
}

TEST_F(SliceRules, picturesAreSoundAndNothingOutsideTheBox) {
  SliceRenderer slices;
  RayCaster caster;
  for (const ShadingModel model : {ShadingModel::none, ShadingModel::enhanced, ShadingModel::robust}) {
    const Scene scene = phantomScene(model);
    const Image image = slices.render(scene, rulesSize);
    const std::vector<int> counts = caster.sampleCounts(scene, rulesSize);
    const double rounding = roundingOfTwo(scene);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
      const glm::vec4& pixel = image.pixels[i];
      if (counts[i] == 0) {
        EXPECT_EQ(pixel, glm::vec4(0.0f));
      }
      EXPECT_TRUE(pixel.a >= 0.0f && pixel.a <= 1.0f + rounding);
      EXPECT_LE(std::max({pixel.r, pixel.g, pixel.b}), pixel.a + rounding);
    }
    EXPECT_EQ(slices.render(scene, rulesSize), image) << "the second time";
  }
}

TEST_F(SliceRules, drawingLeavesTheStateOfTheContextAsItWas) {
  SliceRenderer slices;
  glEnable(GL_DEPTH_TEST);
  glBlendFuncSeparate(GL_DST_COLOR, GL_ZERO, GL_SRC_ALPHA, GL_ONE);
  glBlendEquation(GL_MAX);
  glViewport(1, 2, 3, 4);
  slices.render(phantomScene(ShadingModel::classic), {20, 16});
  GLint viewport[4], source = 0, equation = 0, framebuffer = -1, program = -1;
  glGetIntegerv(GL_VIEWPORT, viewport);
  glGetIntegerv(GL_BLEND_SRC_RGB, &source);
  glGetIntegerv(GL_BLEND_EQUATION_ALPHA, &equation);
  glGetIntegerv(GL_FRAMEBUFFER_BINDING, &framebuffer);
  glGetIntegerv(GL_CURRENT_PROGRAM, &program);
  EXPECT_TRUE(glIsEnabled(GL_DEPTH_TEST));
  EXPECT_FALSE(glIsEnabled(GL_BLEND));
  EXPECT_TRUE(viewport[0] == 1 && viewport[3] == 4);
  EXPECT_EQ(source, GL_DST_COLOR);
  EXPECT_EQ(equation, GL_MAX);
  EXPECT_EQ(framebuffer, 0);
  EXPECT_EQ(program, 0);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(SliceRules, aStepTooSmallIsLimitedAndReported) {
  SliceRenderer slices;
  Scene scene = test::rayThrough(test::boxOf(glm::dvec3(1.0)));
  scene.transferFunction = test::constantFunction(0.5, glm::dvec3(1.0));
  slices.render(scene, {1, 1});
  EXPECT_EQ(slices.limitation().english(), "");
  scene.quality.stepVoxels = 1e-5;
  slices.render(scene, {1, 1});
  EXPECT_NE(slices.limitation().english().find("60000 slices"), std::string::npos)
      << slices.limitation().english();
}

TEST(SlicePlan, whatBelongsToTheMarchIsDroppedWithAReason) {
  Scene scene;
  scene.volume = test::boxOf(glm::dvec3(1.0));
  scene.transferFunction = test::constantFunction(0.9999, glm::dvec3(1.0));
  scene.quality.earlyTermination = 0.98;
  const EffectPlan march = requiredEffects(scene, {.canSkipEmptySpace = true});
  const EffectPlan plan = sliceEffects(scene, {.canSkipEmptySpace = true});
  EXPECT_TRUE(march.effects.has(Effect::earlyTermination));
  ASSERT_EQ(plan.reasons.size(), march.reasons.size());
  for (std::size_t i = 0; i < plan.reasons.size(); ++i) {
    const EffectReason& reason = plan.reasons[i];
    EXPECT_EQ(reason.effect, march.reasons[i].effect);
    EXPECT_EQ(reason.isNeeded, plan.effects.has(reason.effect));
    EXPECT_FALSE(reason.reason.empty());
    if (reason.effect == Effect::earlyTermination || reason.effect == Effect::emptySpaceSkipping ||
        reason.effect == Effect::longRays) {
      EXPECT_FALSE(reason.isNeeded);
      EXPECT_NE(reason.reason.english().find("slice"), std::string::npos) << reason.reason.english();
    } else {
      EXPECT_EQ(reason.isNeeded, march.reasons[i].isNeeded);
      EXPECT_EQ(reason.reason, march.reasons[i].reason);
    }
  }
}

TEST(SlicePlan, everyProjectionButCompositeAndXrayIsRefusedByName) {
  Scene scene;
  scene.volume = test::boxOf(glm::dvec3(1.0));
  for (const Projection projection : {Projection::composite, Projection::xray}) {
    scene.projection = projection;
    EXPECT_NO_THROW(requireSliceable(scene));
  }
  for (const auto& [projection, name] : {std::pair{Projection::mip, "\"mip\""},
                                         {Projection::minip, "\"minip\""},
                                         {Projection::average, "\"average\""},
                                         {Projection::isosurface, "\"isosurface\""},
                                         {Projection::compositeIsosurface, "\"composite_isosurface\""}}) {
    scene.projection = projection;
    try {
      requireSliceable(scene);
      ADD_FAILURE() << name << " was not refused";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), Error::Kind::usage);
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
    }
  }
}

} // namespace
} // namespace limn
