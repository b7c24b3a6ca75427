// SPDX-License-Identifier: GPL-3.0-or-later
#include "slices/SlicePlan.h"

#include "scene/ProjectionName.h"
#include "scene/basics/Error.h"

#include <vector>

namespace limn {
namespace {

struct Dropped {
  Effect effect;
  Message reason;
};

// What slices leave out, and why.
std::vector<Dropped> droppedBySlices() {
  return {{Effect::earlyTermination,
           Message::tr("slices are blended one after the other and none knows which pixels are done")},
          {Effect::emptySpaceSkipping, Message::tr("a slice is one sample: there is nothing to step over")},
          {Effect::longRays, Message::tr("slices do not march along rays, so no ray is too long")}};
}

} // namespace

void requireSliceable(const Scene& scene) {
  requireDrawable(scene);
  if (scene.projection != Projection::composite && scene.projection != Projection::xray)
    throw Error(Error::Kind::usage, Message::tr("Slices cannot draw the projection \"%1\", only composite "
                                                "and xray; use --engine gl or reference for it.")
                                        .arg(nameOf(scene.projection)));
}

EffectPlan sliceEffects(const Scene& scene, const SceneFacts& facts) {
  EffectPlan plan = requiredEffects(scene, facts);
  for (const Dropped& dropped : droppedBySlices()) {
    plan.effects = plan.effects.without(dropped.effect);
    for (EffectReason& reason : plan.reasons)
      if (reason.effect == dropped.effect)
        reason = {dropped.effect, false, dropped.reason};
  }
  plan.effects = canonical(plan.effects);
  return plan;
}

} // namespace limn
