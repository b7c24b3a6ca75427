// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/PictureFigures.h"
#include "scene/effects/EffectPlan.h"

#include <optional>
#include <string>
#include <vector>

namespace limn {

/// One line of what a picture simulates, as people and scripts are told: a group of effects that belong
/// together for a reader.
struct EffectRow {
  std::string name;  ///< for scripts, e.g. "exponent_map"; the names of the scene format
  Message title;     ///< for people
  bool isOn = false; ///< whether the picture simulates it
  Message reason;    ///< why or why not, a phrase in plain words
  EffectSet effects; ///< what the row stands for: without these the picture does not simulate it
  bool operator==(const EffectRow&) const = default;
};

/// The plan of a scene as rows, always the same ones in the same order.
std::vector<EffectRow> effectRows(const Scene& scene, const EffectPlan& plan);

/// What a row's effect costs: the time of a picture with it less the time without it. Below 0 where it saves
/// time.
struct EffectCost {
  double ms = 0.0;                        ///< of medians
  double spreadMs = 0.0;                  ///< half the range in which the middle half of the differences lies
  std::optional<PictureChange> brought{}; ///< to the picture; told of light on its way alone
  double withoutMs = 0.0;                 ///< the median time without it; 0 where it is not told
  bool operator==(const EffectCost&) const = default;
};

/// Whether a cost is lost in its spread, or too small to be told: where it is less than two spreads, which is
/// three times what the median of seven pairs scatters by.
bool isLostInSpread(const EffectCost& cost);

/// A cost in words: "12 ms", "saves 210 of 270 ms" (all that the picture would take without it, so that
/// nobody looks for it in what it takes now), or "≈ 0 ms" where it is lost.
Message costText(const EffectCost& cost);

/// The same with its spread: "12 ± 1.0 ms", "saves 210 ± 3.0 of 270 ms", "≈ 0 ms".
Message costWithSpreadText(const EffectCost& cost);

/// What an effect that is off would cost, in words: "would take 12 ms more", "would save 210 of 270 ms", or
/// "would take hardly any time" where it is lost.
Message wouldCostText(const EffectCost& cost);

/// What an effect that is off would bring to a picture, in words as below.
Message wouldBringText(const PictureChange& change);

/// What an effect brought to a picture in words: "changes this picture by up to 85 of 255 levels, by 4.2 on
/// average", or that it changes nothing that could be seen (less than half a level).
Message broughtText(const PictureChange& change);

} // namespace limn
