// SPDX-License-Identifier: GPL-3.0-or-later
// Looks of labels drawn by the ray caster (DEFINITION section 10): as the reference draws them, and without a
// trace where there are none.
#include "accuracy/ImageError.h"
#include "accuracy/Tolerance.h"
#include "raycaster/RayCaster.h"
#include "reference/ReferenceIntegrator.h"
#include "scene/ProjectionFacts.h"
#include "scene/light/Shading.h"
#include "support/GlTest.h"
#include "support/JudgedTime.h"
#include "support/LookScenes.h"

#include <algorithm>
#include <iostream>

namespace limn {
namespace {

using test::cubesOfLooks;
using test::depthOfFourSteps;
using test::exactRamp;
using test::lookMsOf;
using test::medianLookMs;
using test::rampOfFourSteps;
using test::rampOfTwoLooks;
using test::sceneToTime;
using test::withEightLooks;

constexpr glm::ivec2 looksSize{96, 80};

class CasterLooks : public test::GlTest {
protected:
  // The ray caster's bound of the mean without looks.
  static constexpr double usualMean = 0.01;
  // Where a float decides otherwise on which side of a cell's face a place lies, a step is within one look in
  // one picture and its sample stands for it in the other: one ray of some thousand, by tens of levels.
  static constexpr double meanOfPreintegrated = 0.05;

  void expectAsTheReference(const Scene& scene, const std::string& what, double mostMean = usualMean) {
    RayCaster caster;
    const ReferencePicture exact =
        renderReference(scene, looksSize, 0, {}, Limiting::clampOrKnee, {}, ToTolerance::byLocalSteps);
    const ImageError error = imageError(caster.render(scene, looksSize), toImage(exact));
    std::cout << what << ": 99.9th percentile " << error.p99_9 << ", mean " << error.mean << " levels\n";
    EXPECT_LE(error.p99_9, 1.0) << what;
    EXPECT_LE(error.mean, mostMean) << what;
  }
};

TEST_F(CasterLooks, allModelsAndCamerasAgreeWithTheReference) {
  for (const ShadingModel model : {ShadingModel::classic, ShadingModel::enhanced, ShadingModel::robust})
    for (const auto projection : {Camera::Projection::perspective, Camera::Projection::orthographic})
      for (const int looks : {2, 8})
        expectAsTheReference(cubesOfLooks(model, looks, projection),
                             std::string(nameOf(model)) + ", " + std::to_string(looks) + " looks");
}

TEST_F(CasterLooks, preintegratedStepsAgreeWithTheReference) {
  for (const ShadingModel model : {ShadingModel::classic, ShadingModel::robust})
    for (const double step : {0.5, 2.0})
      for (const Projection projection : {Projection::composite, Projection::xray}) {
        Scene scene = cubesOfLooks(model, 8, Camera::Projection::perspective);
        scene.projection = projection;
        scene.quality.preintegrated = Preintegration::always;
        scene.quality.stepVoxels = step;
        expectAsTheReference(scene,
                             std::string(nameOf(model)) + ", " + nameOf(projection) +
                                 ", pre-integrated, step " + std::to_string(step),
                             meanOfPreintegrated);
      }
}

TEST_F(CasterLooks, aStepIsPreintegratedWithinOneLook) {
  RayCaster caster;
  for (const double weight : {1.0, 0.5})
    for (const double factor : {1.0, 0.7})
      for (const Projection projection : {Projection::composite, Projection::xray}) {
        Scene scene = rampOfFourSteps(weight);
        scene.projection = projection;
        scene.shading.model = ShadingModel::enhanced;
        scene.shading.opacityRange = {factor, factor};
        const double counts = projection == Projection::xray ? 1.0 : factor;
        // What exp2 and log of a software driver, which are polynomials, leave of a float.
        EXPECT_NEAR(caster.render(scene, {1, 1}).pixels[0].a, -std::expm1(-depthOfFourSteps(weight, counts)),
                    1e-5);
      }
}

TEST_F(CasterLooks, coarseStepsWithinOneLookLeaveNoBands) {
  const Image exact = exactRamp(looksSize);
  Scene scene = rampOfTwoLooks();
  RayCaster caster;
  scene.quality.preintegrated = Preintegration::never;
  const double sampled = imageError(caster.render(scene, looksSize), exact).largest;
  scene.quality.preintegrated = Preintegration::always;
  const double integrated = imageError(caster.render(scene, looksSize), exact).largest;
  std::cout << "largest of a step of 4 voxels: " << sampled << " levels by samples, " << integrated
            << " pre-integrated\n";
  EXPECT_GT(sampled, 50.0 * integrated);
  EXPECT_LE(integrated, 0.5); // not to be seen
}

TEST_F(CasterLooks, whatElseAPictureMayHaveAgreesWithTheReference) {
  for (const Projection projection :
       {Projection::composite, Projection::xray, Projection::compositeIsosurface, Projection::mip}) {
    Scene scene = cubesOfLooks(ShadingModel::robust, 8, Camera::Projection::perspective);
    scene.projection = projection;
    scene.crop = {{0.1, 0.2, 0.0}, {0.9, 1.0, 0.8}};
    scene.fog = distanceFog(200.0, 900.0);
    scene.gradientOpacity = GradientOpacity{{{0.0, 0.2}, {60.0, 1.0}}};
    scene.shading.opacityRange = {0.0, 3.0};
    for (const Preintegration choice : {Preintegration::always, Preintegration::never}) {
      scene.quality.preintegrated = choice;
      expectAsTheReference(scene, std::string("fog, crop, gradient opacity, ") + nameOf(projection),
                           choice == Preintegration::always ? meanOfPreintegrated : usualMean);
    }
  }
}

TEST_F(CasterLooks, stepsThatAnErrorControlsKeepToTheTolerance) {
  for (const Projection projection : {Projection::composite, Projection::xray}) {
    Scene scene = cubesOfLooks(ShadingModel::classic, 8, Camera::Projection::perspective);
    scene.projection = projection;
    // Smaller, so that no ray reaches the most samples that a driver's loops may take.
    scene.volume = phantomVolume({.spacingMm = 6.0});
    scene.keep = withVariedLooks(cubesRegion(scene.volume->grid().dims, 5, scene.keep.weights),
                                 scene.transferFunction);
    Scene fine = scene;
    fine.quality.stepVoxels = 1.0 / 32.0;
    scene.quality.toleranceLevels = 1.0;
    RayCaster caster;
    const WithinTolerance found =
        withinTolerance(scene, looksSize, [&caster](const Scene& candidate, const glm::ivec2& size) {
          return caster.render(candidate, size);
        });
    EXPECT_TRUE(found.holds) << found.sentence.english();
    const ImageError error =
        imageError(caster.render(found.scene, looksSize), toImage(renderReference(fine, looksSize)));
    std::cout << nameOf(projection) << ": 99.9th percentile " << error.p99_9 << " levels, fineness "
              << found.scene.quality.fineness.value_or(0.0) << "\n";
    EXPECT_LE(error.p99_9, 1.0);
  }
}

TEST_F(CasterLooks, eightOfThemTakeLittleMoreTimeThanNone) {
  const glm::ivec2 size(test::isTimeJudged() ? 256 : 64);
  const int runs = test::isTimeJudged() ? 5 : 1;
  for (const Preintegration choice : {Preintegration::never, Preintegration::always}) {
    Scene without = sceneToTime();
    without.quality.preintegrated = choice;
    const Scene with = withEightLooks(without);
    RayCaster one, other;
    std::vector<double> msWithout, msWith;
    one.render(without, size);
    other.render(with, size);
    for (int run = 0; run < runs; ++run) { // in turns: a machine that slows slows both
      msWithout.push_back(lookMsOf([&] { one.render(without, size); }));
      msWith.push_back(lookMsOf([&] { other.render(with, size); }));
    }
    test::judgeMs(choice == Preintegration::never ? "8 looks" : "8 looks, pre-integrated",
                  medianLookMs(msWith), 1.6 * medianLookMs(msWithout));
  }
}

TEST_F(CasterLooks, equalLooksInAllLabelsAreOneLook) {
  Scene scene = cubesOfLooks(ShadingModel::robust, 2, Camera::Projection::perspective);
  const TransferFunction look = shifted(scene.transferFunction, 40.0);
  scene.keep = withLooks(scene.keep, {{0, look}, {1, look}, {2, look}});
  ASSERT_TRUE(hasLabelLooks(scene));
  Scene one = scene;
  one.keep = withLooks(scene.keep, {});
  one.transferFunction = look;
  RayCaster caster;
  for (const Preintegration choice : {Preintegration::never, Preintegration::always}) {
    one.quality.preintegrated = scene.quality.preintegrated = choice;
    const ImageError error = imageError(caster.render(scene, looksSize), caster.render(one, looksSize));
    EXPECT_LE(error.largest, 0.05);
  }
}

TEST_F(CasterLooks, emptySpaceChangesNoBit) {
  Scene scene = cubesOfLooks(ShadingModel::enhanced, 8, Camera::Projection::perspective);
  RayCaster skipping, sampling(RayCaster::EmptySpace::sampled);
  for (const Projection projection : {Projection::composite, Projection::xray})
    for (const Preintegration choice : {Preintegration::never, Preintegration::always}) {
      scene.projection = projection;
      scene.quality.preintegrated = choice;
      EXPECT_EQ(skipping.render(scene, looksSize).pixels, sampling.render(scene, looksSize).pixels);
    }
}

TEST_F(CasterLooks, aUsedCasterDrawsAsAFreshOneWhateverChanged) {
  RayCaster used;
  Scene scene = cubesOfLooks(ShadingModel::classic, 2, Camera::Projection::perspective);
  std::vector<Scene> scenes{scene};
  scene.keep = withLooks(scene.keep, {});
  scenes.push_back(scene);
  scene = cubesOfLooks(ShadingModel::classic, 8, Camera::Projection::perspective);
  scene.volume = scenes.front().volume;
  scenes.push_back(scene);
  scene.keep.weights[1] = 0.0;
  scenes.push_back(scene);
  scene.quality.toleranceLevels = 1.0;
  scene.projection = Projection::mip;
  scenes.push_back(scene);
  scene.projection = Projection::composite;
  scenes.push_back(scene);
  scene.transferFunction = shifted(scene.transferFunction, 30.0);
  scenes.push_back(scene);
  scene.quality.toleranceLevels.reset();
  scene.quality.preintegrated = Preintegration::always;
  scene.quality.stepVoxels = 2.0;
  scenes.push_back(scene);
  for (const Scene& each : scenes) {
    RayCaster fresh;
    EXPECT_EQ(used.render(each, looksSize).pixels, fresh.render(each, looksSize).pixels);
  }
}

TEST_F(CasterLooks, withoutLooksTheProgramKnowsNothingOfThem) {
  Scene scene = cubesOfLooks(ShadingModel::robust, 2, Camera::Projection::perspective);
  RayCaster caster;
  EXPECT_NE(caster.fragmentShader(scene).find("u_labels"), std::string::npos);
  scene.keep = withLooks(scene.keep, {});
  const std::string text = caster.fragmentShader(scene);
  for (const char* word : {"LABEL_LOOKS\n", "u_labels", "u_cellLooks", "u_lookUnits"})
    EXPECT_EQ(text.find(std::string("#define EFFECT_") + word), std::string::npos);
  for (const char* name : {"u_labels", "u_cellLooks", "u_lookUnits"})
    EXPECT_EQ(text.find(name), std::string::npos) << name;
}

} // namespace
} // namespace limn
