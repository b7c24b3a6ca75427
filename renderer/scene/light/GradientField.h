// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "scene/light/GradientScales.h"
#include "scene/light/GradientSmoothing.h"

#include <optional>

namespace limn {

/// The field whose gradient light and boundaries of a scene follow: that of the volume, or a smoothed one
/// (DEFINITION section 2), and the gradient scales of either. What was made is kept until another volume, or
/// another σ, takes its place: pictures with and without it may take turns.
class GradientField {
public:
  /// Goes on smoothing for a scene, where it asks for that (smoothsNormals), for some ten ms; the share that
  /// is done, 1 once nothing is missing. Throws Cancelled, and then goes on from there.
  double more(const Scene& scene, const Effort& effort = {});

  /// The same to its end.
  void update(const Scene& scene, const Effort& effort = {}) {
    while (more(scene, effort) < 1.0) {
    }
  }

  /// Null where the last scene asks for none.
  std::shared_ptr<const Volume> smoothed() const {
    return m_isAskedFor ? m_smoothing->smoothed() : std::shared_ptr<const Volume>();
  }

  /// Of the gradients of the last scene, whose smoothing is done: as limn::gradientScale of them, with the
  /// smoothed field; where nothing reads the ratio of moduli, a percentile is not measured for it.
  GradientScale scale(const Scene& scene, bool usesRatio, const Effort& effort = {});

  /// Of the volume's own gradients, as GradientScales::know.
  void know(const FoundModuli& found, std::optional<double> percent) { m_plain.know(found, percent); }

  /// What the smoothed field takes in memory, bytes.
  std::size_t ownBytes() const;

private:
  std::shared_ptr<const Volume> m_volume;
  GradientScales m_plain, m_ofSmoothed;
  std::optional<Smoothing> m_smoothing;
  bool m_isAskedFor = false;
};

/// The gradient that light and boundaries of a scene follow at a continuous index, along the grid's axes,
/// value/mm. Where normals are smooth it is that of the field in `scale`, which is an engine's; before an
/// engine has one for this volume, the volume's own.
glm::dvec3 followedGradientAt(const Scene& scene, const GradientScale& scale, const glm::dvec3& index);

} // namespace limn
