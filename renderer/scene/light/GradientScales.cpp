// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/light/GradientScales.h"

namespace limn {
namespace {

// Of a slider that is dragged; what is asked for again is found again.
constexpr std::size_t mostPercentiles = 64;

} // namespace

void GradientScales::setVolume(const std::shared_ptr<const Volume>& volume) {
  if (volume == m_volume)
    return;
  m_volume = volume;
  m_largest.reset();
  m_percentiles.clear();
}

GradientScale GradientScales::of(const Shading& shading, bool usesRatio, const Effort& effort) {
  const GradientReference reference = resolvedReference(shading);
  const auto* percentile = std::get_if<PercentileReference>(&reference);
  if (percentile && usesRatio && !m_percentiles.contains(percentile->percent)) {
    // One pass finds both.
    const FoundModuli found = findModuli(*m_volume, percentile->percent, effort);
    m_largest = found.largest;
    if (m_percentiles.size() >= mostPercentiles)
      m_percentiles.clear();
    m_percentiles.emplace(percentile->percent, found.percentile);
  }
  if (!m_largest)
    m_largest = largestGradient(*m_volume, effort);
  GradientScale scale{*m_largest, *m_largest};
  if (const auto* fixed = std::get_if<FixedReference>(&reference))
    scale.reference = fixed->valuePerMm;
  if (percentile && usesRatio)
    scale.reference = m_percentiles.at(percentile->percent);
  return scale;
}

void GradientScales::know(const FoundModuli& found, std::optional<double> percent) {
  m_largest = found.largest;
  if (percent)
    m_percentiles.emplace(*percent, found.percentile);
}

} // namespace limn
