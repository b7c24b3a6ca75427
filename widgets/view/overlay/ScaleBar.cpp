// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/overlay/ScaleBar.h"

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

} // namespace limn
