// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Message.h"
#include "scene/steps/RayFrame.h"

namespace limn {

/// A sentence where the longest ray of a scene would need more than `most` samples, empty where not.
inline Message stepLimitation(const Scene& scene, int most) {
  if (longestRaySamples(scene) <= most)
    return {};
  return Message::tr(
             "The step is so small that long rays would need more than %1 samples; they are drawn with that "
             "number.")
      .arg(most);
}

} // namespace limn
