// SPDX-License-Identifier: GPL-3.0-or-later
// The reference against closed forms, within the tolerances that the file of cases states.
#include "reference/ReferenceIntegrator.h"
#include "support/AnalyticCases.h"
#include "support/AnalyticScenes.h"

#include <gtest/gtest.h>

#include <iostream>
#include <set>

namespace limn {
namespace {

TEST(ReferenceAnalytic, everyCaseMeetsItsClosedForm) {
  LIMN_NEEDS_SHARED(test::analyticCasesFile);
  std::set<std::string> ids;
  for (const test::AnalyticRay& ray : test::analyticRays(test::analyticCases())) {
    const glm::dvec4 pixel = renderReference(ray.scene, {1, 1}, 1).pixels[0];
    ids.insert(ray.id);
    if (ray.alpha) {
      EXPECT_NEAR(pixel.a, *ray.alpha, ray.tolerance) << ray.id << " " << ray.what;
    }
    for (int channel = 0; ray.color && channel < 3; ++channel)
      EXPECT_NEAR(pixel[channel], (*ray.color)[channel], ray.tolerance)
          << ray.id << " " << ray.what << " channel " << channel;
  }
  std::cout << ids.size() << " cases:";
  for (const std::string& id : ids)
    std::cout << " " << id;
  std::cout << "\n";
  EXPECT_GE(ids.size(), 50u);
}

} // namespace
} // namespace limn
