// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/light/Gradient.h"
#include "scene/light/ModulusSearch.h"

#include <map>
#include <memory>
#include <optional>

namespace limn {

/// The gradient scales of one volume under any shading, each measured when first asked for.
class GradientScales {
public:
  /// Forgets what was measured of another volume.
  void setVolume(const std::shared_ptr<const Volume>& volume);

  /// As limn::gradientScale; where nothing reads the ratio of moduli, a percentile is not measured for it.
  GradientScale of(const Shading& shading, bool usesRatio, const Effort& effort = {});

  /// What is known of the volume already: with a percent, that percentile, too.
  void know(const FoundModuli& found, std::optional<double> percent);

private:
  std::shared_ptr<const Volume> m_volume;
  std::optional<double> m_largest;
  std::map<double, double> m_percentiles;
};

} // namespace limn
