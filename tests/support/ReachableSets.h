// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/effects/EffectSet.h"

#include <set>

namespace limn::test {

/// The canonical sets that scenes can reach: every combination of what belongs together, the groups that do
/// not touch each other's code (fog, knee, cut faces, …) varied one against all.
std::set<EffectSet> reachableSets();

/// Those of slices: each effect that they have alone, on a lit and on an unlit sample.
std::set<EffectSet> sliceSets();

} // namespace limn::test
