// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glsl/decisions/Decisions.h"
#include "scene/Scene.h"
#include "scene/effects/EffectSet.h"

#include <optional>
#include <string>
#include <vector>

namespace limn {

/// One decision about accuracy taken in one way, all others being the program's own.
struct DecisionVariant {
  std::string group; ///< "look-up table"
  std::string name;  ///< "8 bits, 256 entries"
  bool isDefault = false;
  Decisions decisions;
  std::optional<double> earlyTermination; ///< takes the place of the scene's
};

/// Every way in which this program can take each decision, group by group, its own first.
std::vector<DecisionVariant> decisionVariants();

/// Those that can show in a picture of the scene, which calls for `effects`: a maximum (MIP) has no opacity
/// to correct, an unlit picture no gradient.
std::vector<DecisionVariant> decisionVariants(const Scene& scene, EffectSet effects);

} // namespace limn
