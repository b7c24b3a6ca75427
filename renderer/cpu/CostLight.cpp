// SPDX-License-Identifier: GPL-3.0-or-later
#include "cpu/CostLight.h"

namespace limn {

std::optional<LightVolumes> CostLight::found(const Scene& scene) {
  if (!m_finder)
    m_finder = std::make_unique<LightInBackground>();
  LightVolumes light = m_finder->known(scene);
  if (m_finder->isFinding(scene))
    return std::nullopt;
  // What was found between the two questions is told by a third.
  light = m_finder->known(scene);
  return light;
}

} // namespace limn
