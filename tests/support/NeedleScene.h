// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/AnalyticScenes.h"

#include <cmath>

namespace limn::test {

/// A ray along a ramp whose function shows one needle, and what it absorbs.
struct NeedleScene {
  Scene scene;
  double alpha = 0.0;
};

/// The needle of opacity 0.9 is `width` mm wide on the ray either side of its tip. -log(1 - a) over a from 0
/// to 0.9 has the mean 1 + (0.1/0.9) log 0.1, and the unit distance makes each side half of one.
inline NeedleScene needleScene(double width) {
  std::vector<double> values;
  for (int i = 0; i <= 16; ++i)
    values.push_back(i);
  NeedleScene needle;
  needle.scene = rayThrough(columnOf(values, 1.0));
  const double tip = 5.3; // between voxels; a value a millimetre
  needle.scene.transferFunction = {2.0 * width,
                                   {{tip - width, glm::dvec3(1.0), 0.0},
                                    {tip, glm::dvec3(1.0), 0.9},
                                    {tip + width, glm::dvec3(1.0), 0.0}}};
  needle.alpha = -std::expm1(-(1.0 + 0.1 / 0.9 * std::log(0.1)));
  return needle;
}

/// A ray along a ramp over 16 mm, opaque from the value 1/3 on: colour by value tells where the ray stopped.
inline Scene edgeScene() {
  std::vector<double> values;
  for (int i = 0; i <= 16; ++i)
    values.push_back(i / 16.0);
  Scene scene = rayThrough(columnOf(values, 1.0));
  scene.transferFunction = {1e-3,
                            {{1.0 / 3.0, glm::dvec3(0.0), 0.0},
                             {1.0 / 3.0, glm::dvec3(0.0), 1.0},
                             {1.0 / 3.0 + 1.0 / 32.0, glm::dvec3(1.0), 1.0}}};
  return scene;
}

} // namespace limn::test
