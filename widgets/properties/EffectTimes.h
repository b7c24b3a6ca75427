// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/effects/EffectRows.h"

#include <QSize>
#include <QString>

#include <optional>
#include <vector>

namespace limn {

/// How far the measurement of what effects cost is, and what came out of it.
struct EffectTimes {
  bool isMeasuring = false;
  double fraction = 0.0;                               ///< 0..1, while measuring
  std::vector<std::optional<EffectCost>> costs;        ///< one per row; empty: not measured
  double wholeMs = 0.0;                                ///< of the picture with all its effects
  QString method;                                      ///< how the time was measured
  QSize size;                                          ///< of the picture measured, pixels
  std::vector<std::optional<EffectCost>> wouldCosts{}; ///< one per row: of what is off, where it could be on
  bool operator==(const EffectTimes&) const = default;
};

} // namespace limn
