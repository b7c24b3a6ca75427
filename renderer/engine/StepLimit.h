// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/steps/RayFrame.h"

#include <string>

namespace limn {

/// A sentence where the longest ray of a scene would need more than `most` samples, empty where not.
inline std::string stepLimitation(const Scene& scene, int most) {
  if (longestRaySamples(scene) <= most)
    return {};
  return std::string("The step is so small that long rays would need more than ")
      .append(std::to_string(most))
      .append(" samples; they are drawn with that number.");
}

} // namespace limn
