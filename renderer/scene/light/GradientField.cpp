// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/light/GradientField.h"

namespace limn {

double GradientField::more(const std::shared_ptr<const Volume>& volume, double sigmaMm,
                           const Effort& effort) {
  m_volume = volume;
  m_plain.setVolume(m_volume);
  m_isAskedFor = false;
  const bool isOther = m_smoothing && sigmaMm > 0.0 && m_smoothing->sigmaMm() != sigmaMm;
  if (m_smoothing && (isOther || m_smoothing->volume() != m_volume)) {
    m_smoothing.reset();
    m_ofSmoothed.setVolume(nullptr);
  }
  if (!m_volume || !(sigmaMm > 0.0))
    return 1.0;
  if (!m_smoothing)
    m_smoothing.emplace(m_volume, sigmaMm);
  const double done = m_smoothing->more(effort);
  m_isAskedFor = done == 1.0;
  if (m_isAskedFor)
    m_ofSmoothed.setVolume(m_smoothing->smoothed());
  return done;
}

GradientScale GradientField::scale(const Shading& shading, bool usesRatio, const Effort& effort) {
  GradientScale scale = (m_isAskedFor ? m_ofSmoothed : m_plain).of(shading, usesRatio, effort);
  scale.smoothed = smoothed();
  return scale;
}

std::size_t GradientField::ownBytes() const {
  return m_smoothing ? m_volume->voxelCount() * sizeof(float) : 0;
}

glm::dvec3 followedGradientAt(const Volume& volume, const GradientScale& scale, const glm::dvec3& index) {
  const bool isThere = scale.smoothed && scale.smoothed->grid() == volume.grid();
  return glm::transpose(volume.grid().direction) * gradientAt(isThere ? *scale.smoothed : volume, index);
}

} // namespace limn
