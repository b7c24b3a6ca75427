// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/overlay/CameraMarks.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace limn {

double mmPerPixel(const Camera& camera, double heightPixels) {
  const double height = camera.projection == Camera::Projection::orthographic
                            ? camera.heightMm
                            : 2.0 * halfHeight(camera) * glm::length(camera.target - camera.position);
  return height / heightPixels;
}

ScaleBar scaleBar(double mmPerPixel, double mostPixels) {
  const double most = mmPerPixel * mostPixels;
  if (!(most > 0.0) || !std::isfinite(most))
    return {};
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  double length = power;
  for (double factor : {2.0, 5.0})
    if (factor * power <= most)
      length = factor * power;
  return {length, length / mmPerPixel};
}

std::string lettersOf(const glm::dvec3& direction) {
  constexpr double leastCosine = 0.2588; // cos 75°
  // LPS: +x is the patient's left, +y posterior, +z superior.
  constexpr std::array<const char*, 3> letters{"RL", "AP", "IS"};
  std::array<int, 3> order{0, 1, 2};
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return std::abs(direction[a]) > std::abs(direction[b]); });
  std::string text;
  for (int axis : order)
    if (std::abs(direction[axis]) > leastCosine)
      text += letters[axis][direction[axis] > 0.0 ? 1 : 0];
  return text;
}

OrientationLetters orientationLetters(const Camera& camera) {
  const CameraBasis basis = basisOf(camera);
  return {lettersOf(-basis.right), lettersOf(basis.right), lettersOf(basis.up), lettersOf(-basis.up)};
}

} // namespace limn
