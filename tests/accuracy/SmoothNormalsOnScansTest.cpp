// SPDX-License-Identifier: GPL-3.0-or-later
// Smooth normals on scans (DEFINITION section 2): both engines against the reference, in the width that
// opening sets where slices are thick. The bounds are those of pictures without them (AgainstReferenceTest,
// CpuAgainstReferenceTest): half a level at most and 0.01 in the mean, where both take the same samples.
#include "cpu/CpuRenderer.h"
#include "io/VolumeReader.h"
#include "raycaster/RayCaster.h"
#include "scene/light/GradientSmoothing.h"
#include "scene/presets/PresetFit.h"
#include "scene/volume/Histogram.h"
#include "support/GlTest.h"
#include "support/ImageCompare.h"
#include "support/TestData.h"

#include <iostream>

namespace limn {
namespace {

constexpr glm::ivec2 scanPicture{128, 128};

struct Scan {
  const char* name;
  const char* path; // below the shared folder
};

constexpr Scan scans[] = {
    {"CT head", "data/ct_head_cranium/ct_head_cranium.nii.gz"},
    {"CT thorax", "data/ct_thorax_contrast/lidc2_uint8.vti"},
    {"MR PD head", "data/mr_pd_head_dicom"},
    {"MR brain", "data/mr_brain_nrrd/brain1_image.nrrd"},
};

Scene sceneOf(const std::shared_ptr<const Volume>& volume, ShadingModel model) {
  Scene scene;
  scene.volume = volume;
  scene.transferFunction = automaticRamp(histogramOf(*volume), volume->grid());
  scene.camera = orbited(defaultCamera(volume->grid()), 0.5, 0.3);
  scene.shading.model = model;
  scene.shading.gradientSmoothing = smoothingOfSlices(volume->grid());
  scene.quality.earlyTermination = 1.0;
  return scene;
}

using SmoothScans = test::GlTest;

TEST_F(SmoothScans, bothEnginesDrawThemAsTheReference) {
  for (const Scan& scan : scans)
    LIMN_NEEDS_SHARED(scan.path);
  for (const Scan& scan : scans) {
    SCOPED_TRACE(scan.name);
    const std::shared_ptr<const Volume> volume = readVolume(test::sharedFolder() / scan.path);
    RayCaster caster;
    CpuRenderer processor;
    for (const ShadingModel model : {ShadingModel::classic, ShadingModel::enhanced}) {
      const Scene scene = sceneOf(volume, model);
      ASSERT_GT(scene.shading.gradientSmoothing, 1.0);
      const ReferencePicture reference = renderReference(scene, scanPicture);
      const test::Difference cpu = test::differenceOf(processor.render(scene, scanPicture), reference,
                                                      [](std::size_t) { return true; });
      const Image image = caster.render(scene, scanPicture);
      const std::vector<int> counts = caster.sampleCounts(scene, scanPicture);
      const test::Difference gl = test::differenceOf(
          image, reference, [&](std::size_t i) { return counts[i] == reference.samples[i]; });
      std::cout << scan.name << ", " << nameOf(model) << ": CPU " << cpu << "; OpenGL " << gl << "\n";
      for (const test::Difference& difference : {cpu, gl}) {
        EXPECT_LE(difference.largest, 0.5);
        EXPECT_LE(difference.mean, 0.01);
        EXPECT_GT(difference.pixels, 1000u);
      }
    }
  }
}

} // namespace
} // namespace limn
