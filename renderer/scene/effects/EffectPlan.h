// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "scene/basics/Message.h"
#include "scene/effects/EffectSet.h"

#include <vector>

namespace limn {

/// So many bits of a driver's weights between voxels are told apart; one that has as many weighs in floats.
inline constexpr int mostFilterBits = 12;

/// Facts about data and renderer on which effects depend beside the scene's own numbers.
struct SceneFacts {
  bool canSkipEmptySpace = false;  ///< the renderer knows where nothing can be seen
  double emptyShare = 1.0;         ///< of the blocks that the renderer can step over, 0..1
  bool hasDenseFunctions = false;  ///< control points so close that a table holds several in one bin
  double steepestPerMm = 0.0;      ///< what the field commonly changes by at most, value/mm (steepness)
  int filterBits = mostFilterBits; ///< of the weights by which the renderer's own filter mixes voxels
};

/// Why an effect is needed or not, a phrase for a reader.
struct EffectReason {
  Effect effect;
  bool isNeeded = false;
  Message reason;
  bool isDropped = false; ///< asked for by the scene, but without use in this picture
  bool operator==(const EffectReason&) const = default;
};

/// The effects that a scene calls for, canonical, with one reason per effect in the order of the enumeration.
/// Where nothing can be seen there are none.
struct EffectPlan {
  EffectSet effects;
  bool isVisible = true; ///< false: the picture is empty without drawing
  std::vector<EffectReason> reasons;
  bool operator==(const EffectPlan&) const = default;
};

/// A pure function of the scene and of facts about its data. A control point or the
/// camera can change the plan where they decide whether an effect shows at all: whether anything is opaque,
/// whether rays can end early, whether the step resolves the function, whether fog begins before the volume's
/// end. `canStandIn` lets a program go on drawing across such a change.
EffectPlan requiredEffects(const Scene& scene, const SceneFacts& facts);

/// Whether the step resolves the transfer function: over a sixteenth of the change of value in a step neither
/// opacity nor a visible colour changes by a fifth, and no band of opacity is narrower than a third of it.
/// Pre-integration pays where it does not.
bool stepResolvesFunction(const Scene& scene, double steepestPerMm);

/// Whether the plan depends on `steepestPerMm`: only then need it be measured.
bool readsSteepness(const Scene& scene);

/// Whether fog changes any colour: it has a density, and it begins before the volume ends.
bool fogShows(const Scene& scene);

/// Whether what stands between samples and their light counts (DEFINITION section 11): there is shadow or
/// occlusion, and the projection lights samples.
bool hasTravellingLight(const Scene& scene);

/// Whether light or boundaries follow the gradient of the smoothed field (DEFINITION section 2): smoothing
/// reaches beyond a voxel, and something of the picture reads the gradient.
bool smoothsNormals(const Scene& scene);

/// Whether the picture is one of physical light (DEFINITION section 12): the model asks for it, and the
/// projection shows tissue. MIP and the like show values without light, whatever the model.
bool isPhysical(const Scene& scene);

/// Whether anything of the volume could show: the transfer function is opaque somewhere in its range, or the
/// isovalue of a picture with a surface is reached.
bool isAnythingVisible(const Scene& scene);

/// Throws Error (usage) where there is no volume to draw.
void requireDrawable(const Scene& scene);

/// Scenes that a slider can reach from this one in one drag and that ask for effects which it may not ask
/// for: every slider off the value at which its effect vanishes (a density of 0, a range of width 0, …), with
/// and without pre-integration where the program chooses, and the gradient curve at both sides of its
/// straight line. Choices from lists are left as they are, but that classic counts as the enhanced model that
/// it is a case of.
std::vector<Scene> neighbours(const Scene& scene);

} // namespace limn
