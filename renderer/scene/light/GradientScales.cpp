// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/light/GradientScales.h"

namespace limn {

void GradientScales::setVolume(const std::shared_ptr<const Volume>& volume) {
  if (volume == m_volume)
    return;
  m_volume = volume;
  m_largest.reset();
  m_percentiles.clear();
}

GradientScale GradientScales::of(const Shading& shading, bool usesRatio) {
  if (!m_largest)
    m_largest = largestGradient(*m_volume);
  GradientScale scale{*m_largest, *m_largest};
  const GradientReference reference = resolvedReference(shading);
  if (const auto* fixed = std::get_if<FixedReference>(&reference))
    scale.reference = fixed->valuePerMm;
  if (const auto* percentile = std::get_if<PercentileReference>(&reference); percentile && usesRatio) {
    auto known = m_percentiles.find(percentile->percent);
    if (known == m_percentiles.end())
      known = m_percentiles.emplace(percentile->percent, gradientPercentile(*m_volume, percentile->percent))
                  .first;
    scale.reference = known->second;
  }
  return scale;
}

} // namespace limn
