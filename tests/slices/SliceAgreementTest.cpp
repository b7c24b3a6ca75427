// SPDX-License-Identifier: GPL-3.0-or-later
// Slices, ray caster and reference on heads: all approach one picture as the step shrinks, at order 2 where
// the integrand is smooth (DEFINITION section 7). It has jumps under classic light, whose normal is switched
// off in flat tissue, and in the shell of cut faces; there any fixed sampling is of order 1. Enhanced light
// makes flat tissue transparent. The ray caster cuts each ray's own chord into equal steps while slices share
// their planes, so the two agree in the limit only. SliceOrderTest holds smooth fields to the order alone.
#include "accuracy/ImageError.h"
#include "raycaster/RayCaster.h"
#include "reference/ReferenceIntegrator.h"
#include "scene/volume/Phantom.h"
#include "slices/SliceRenderer.h"
#include "stability/scenes/SimpleScenes.h"
#include "support/GlTest.h"
#include "support/Heads.h"
#include "support/TestData.h"

#include <cstdio>

namespace limn {
namespace {

constexpr glm::ivec2 agreementSize{48, 48};

struct AgreementRow {
  const char* what;
  double order; ///< at least, over all halvings together; the first, from a whole voxel, is not asymptotic
  void (*apply)(Scene&);
};

const AgreementRow agreementRows[] = {
    {"classic", 1.0, [](Scene& s) { s.shading.model = ShadingModel::classic; }},
    {"enhanced", 1.7, [](Scene&) {}},
    {"enhanced, orthographic", 1.7,
     [](Scene& s) {
       s.camera.projection = Camera::Projection::orthographic;
       s.camera.heightMm = 280.0;
       s.camera = orbited(s.camera, 0.5, 0.3);
     }},
    {"enhanced, kept region", 1.5,
     [](Scene& s) {
       s.keep = cubesRegion(s.volume->grid().dims, 9, {1.0, 0.0, 0.4});
     }},
    {"enhanced, looks of labels", 1.5,
     [](Scene& s) {
       s.keep = withVariedLooks(cubesRegion(s.volume->grid().dims, 9, {1.0, 0.0, 0.4}), s.transferFunction);
     }},
    {"classic, fog, cropped, gradient opacity", 1.0,
     [](Scene& s) {
       s.shading.model = ShadingModel::classic;
       s.fog = {Fog::Mode::exp, glm::dvec3(0.4, 0.5, 0.6), 0.002, 300.0, 0.0};
       s.crop = {{0.0, 0.3, 0.1}, {0.55, 1.0, 0.8}};
       s.gradientOpacity = GradientOpacity{{{0.0, 0.1}, {100.0, 1.0}}};
       s.camera = orbited(s.camera, 0.6, 0.4);
     }},
};

// The observed order between two steps.
double orderOf(double coarse, double fine) {
  return fine > 0.0 && coarse > 0.0 ? std::log2(coarse / fine) : 0.0;
}

class SliceAgreement : public test::GlTest {
protected:
  void compare(const std::shared_ptr<const Volume>& volume, const AgreementRow& row) {
    Scene scene = test::headScene(volume, ShadingModel::enhanced);
    row.apply(scene);
    scene.quality.preintegrated = Preintegration::never; // one method for all steps
    scene.quality.stepVoxels = 1.0 / 128.0;
    const ReferencePicture reference = renderReference(scene, agreementSize);
    SliceRenderer renderer;
    RayCaster caster;
    std::printf("%s\n  %8s | to the reference: mean, p99.9, order | to the ray caster: mean, p99.9, order\n",
                row.what, "step");
    std::vector<ImageError> toReference, toCaster;
    for (const double step : {1.0, 0.5, 0.25, 0.125, 0.0625}) {
      scene.quality.stepVoxels = step;
      const Image slices = renderer.render(scene, agreementSize);
      toReference.push_back(imageError(slices, reference.pixels));
      toCaster.push_back(imageError(slices, caster.render(scene, agreementSize)));
      print(step, toReference, toCaster);
    }
    expectShrinking(toReference, row);
    expectShrinking(toCaster, row);
  }

private:
  static void print(double step, const std::vector<ImageError>& toReference,
                    const std::vector<ImageError>& toCaster) {
    const auto last = [](const std::vector<ImageError>& all) {
      const double order = all.size() > 1 ? orderOf(all[all.size() - 2].mean, all.back().mean) : 0.0;
      std::printf(" | %8.4f %8.4f %6.2f", all.back().mean, all.back().p99_9, order);
    };
    std::printf("  %8.4f", step);
    last(toReference);
    last(toCaster);
    std::printf("\n");
  }

  static void expectShrinking(const std::vector<ImageError>& errors, const AgreementRow& row) {
    for (std::size_t i = 1; i < errors.size(); ++i) {
      EXPECT_LT(errors[i].mean, errors[i - 1].mean) << row.what << ", halving " << i;
      EXPECT_LT(errors[i].p99_9, errors[i - 1].p99_9) << row.what << ", halving " << i;
    }
    const double halvings = static_cast<double>(errors.size() - 1);
    EXPECT_GE(orderOf(errors.front().mean, errors.back().mean) / halvings, row.order) << row.what;
  }
};

TEST_F(SliceAgreement, slicesApproachReferenceAndRayCasterOnThePhantom) {
  const auto volume = phantomVolume({.spacingMm = 3.0});
  for (const AgreementRow& row : agreementRows)
    compare(volume, row);
}

TEST_F(SliceAgreement, slicesApproachReferenceAndRayCasterOnTheCtHead) {
  LIMN_NEEDS_SHARED(test::ctHeadFile);
  const auto volume = test::ctHead();
  for (const AgreementRow& row : agreementRows)
    compare(volume, row);
}

} // namespace
} // namespace limn
