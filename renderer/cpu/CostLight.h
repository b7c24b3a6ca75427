// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cpu/LightFinder.h"

#include <memory>

namespace limn {

/// The light in which costs are measured: that of the picture itself, as whoever draws it knows it, and that
/// of scenes with other light, which is found on a thread beside.
class CostLight {
public:
  /// Takes the light of this scene from here on; `known` tells that of the first one. False while it is still
  /// being found. Throws what finding it threw.
  template <class Known>
  bool use(const Scene& scene, const Known& known) {
    if (!m_first) {
      m_ofFirst = known(scene);
      m_first = scene;
    }
    m_light = scene == *m_first ? std::optional(m_ofFirst) : found(scene);
    return m_light.has_value();
  }

  /// Takes none from here on: it is found along paths.
  void useNone() { m_light = LightVolumes(); }

  /// Only after one of these.
  const LightVolumes& light() const { return *m_light; }

private:
  std::optional<LightVolumes> found(const Scene& scene);

  std::optional<Scene> m_first;
  LightVolumes m_ofFirst;
  std::optional<LightVolumes> m_light;
  std::unique_ptr<LightInBackground> m_finder; ///< null until another light is asked for
};

} // namespace limn
