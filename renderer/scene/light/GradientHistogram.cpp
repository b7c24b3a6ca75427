// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/light/GradientHistogram.h"

namespace limn {

GradientOpacity boundaryRamp(const Histogram& gradients) {
  if (!(gradients.range.highest > 0.0))
    return {{{0.0, 1.0}}};
  const double fades = quantile(gradients, 0.60);
  const double stays = quantile(gradients, 0.97);
  if (!(stays > fades)) // nearly all voxels have no gradient, as in a volume of labels
    return {{{0.0, 0.0}, {gradients.range.highest / 2.0, 1.0}}};
  return {{{fades, 0.0}, {stays, 1.0}}};
}

} // namespace limn
