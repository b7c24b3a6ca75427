// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/light/GradientField.h"

#include "scene/effects/EffectPlan.h"

namespace limn {

double GradientField::more(const Scene& scene, const Effort& effort) {
  m_volume = scene.volume;
  m_plain.setVolume(m_volume);
  m_isAskedFor = false;
  const double sigma = scene.shading.gradientSmoothing;
  const bool isOther = m_smoothing && sigma > 0.0 && m_smoothing->sigmaMm() != sigma;
  if (m_smoothing && (isOther || m_smoothing->volume() != m_volume)) {
    m_smoothing.reset();
    m_ofSmoothed.setVolume(nullptr);
  }
  if (!m_volume || !smoothsNormals(scene))
    return 1.0;
  if (!m_smoothing)
    m_smoothing.emplace(m_volume, sigma);
  const double done = m_smoothing->more(effort);
  m_isAskedFor = done == 1.0;
  if (m_isAskedFor)
    m_ofSmoothed.setVolume(m_smoothing->smoothed());
  return done;
}

GradientScale GradientField::scale(const Scene& scene, bool usesRatio, const Effort& effort) {
  GradientScale scale = (m_isAskedFor ? m_ofSmoothed : m_plain).of(scene.shading, usesRatio, effort);
  scale.smoothed = smoothed();
  return scale;
}

std::size_t GradientField::ownBytes() const {
  return m_smoothing ? m_volume->voxelCount() * sizeof(float) : 0;
}

glm::dvec3 followedGradientAt(const Scene& scene, const GradientScale& scale, const glm::dvec3& index) {
  const Grid& grid = scene.volume->grid();
  const bool isThere = scale.smoothed && scale.smoothed->grid() == grid && smoothsNormals(scene);
  return glm::transpose(grid.direction) * gradientAt(isThere ? *scale.smoothed : *scene.volume, index);
}

} // namespace limn
