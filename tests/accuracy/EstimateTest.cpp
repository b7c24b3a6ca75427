// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/ErrorEstimate.h"
#include "raycaster/RayCaster.h"
#include "support/GlTest.h"
#include "support/Heads.h"
#include "support/TestData.h"

#include <cmath>
#include <cstdio>

namespace limn {
namespace {
using Estimate = test::GlTest;

TEST_F(Estimate, experiment) {
  RayCaster caster;
  const auto volume = test::ctHead();
  for (int tf = 0; tf < 2; ++tf)
    for (const double et : {1.0, 0.998})
      for (const ShadingModel model : {ShadingModel::none, ShadingModel::classic, ShadingModel::enhanced}) {
        Scene scene = test::headScene(volume, model);
        scene.transferFunction = tf ? test::boneOnly() : test::skinMuscleBone();
        scene.quality.earlyTermination = 1.0;
        scene.quality.stepVoxels = 1.0 / 256;
        const glm::ivec2 size(96, 96);
        const Image truth = caster.render(scene, size);
        scene.quality.earlyTermination = et;
        std::vector<Image> images, probes;
        std::printf("%s model %d et %g\n", tf ? "bone" : "skin", (int)model, et);
        std::optional<ImageError> before, probeBefore;
        for (int k = 0; k <= 7; ++k) {
          scene.quality.stepVoxels = 1.0 / (1 << k);
          images.push_back(caster.render(scene, size));
          probes.push_back(caster.render(scene, {48, 48}));
          const ImageError real = imageError(images.back(), truth);
          double end = 0;
          {
            Image zero = images.back(), endp = images.back();
            for (auto& p : endp.pixels) { float d = p.a >= et ? 1 - p.a : 0; p += glm::vec4(0,0,0,d); }
            end = imageError(zero, endp).p99_9;
          }
          if (k == 0) continue;
          const ImageError halving = imageError(images[k], images[k - 1]);
          const ImageError probe = imageError(probes[k], probes[k - 1]);
          const ErrorEstimate e = errorAfterHalving(halving, before);
          const double pm = before ? std::log2(before->mean / halving.mean) : 1;
          const double p9 = before ? std::log2(before->p99_9 / halving.p99_9) : 1;
          std::printf("  1/%-4d true p99.9 %8.3f mean %7.4f | halving %8.3f est %8.3f ratio %5.2f (p=1: %5.2f) orders p99.9 %5.2f mean %5.2f end %.3f probe est %.3f ratio %.2f\n", 1 << k, real.p99_9,
                      real.mean, halving.p99_9, e.p99_9, e.p99_9 / real.p99_9, halving.p99_9 / real.p99_9, p9, pm, end,
                      errorAfterHalving(probe, probeBefore).p99_9, errorAfterHalving(probe, probeBefore).p99_9 / real.p99_9);
          before = halving;
          probeBefore = probe;
        }
      }
}
} // namespace
} // namespace limn
