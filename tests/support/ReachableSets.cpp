// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/ReachableSets.h"

#include <vector>

namespace limn::test {
namespace {

using Groups = std::vector<std::vector<Effect>>;

const Groups lights{
    {},
    {Effect::lighting},
    {Effect::lighting, Effect::diffuse},
    {Effect::lighting, Effect::specular},
    {Effect::lighting, Effect::diffuse, Effect::specular},
    {Effect::lighting, Effect::diffuse, Effect::specular, Effect::phong},
    {Effect::lighting, Effect::diffuse, Effect::specular, Effect::fixedLight},
    {Effect::lighting, Effect::diffuse, Effect::specular, Effect::phong, Effect::fixedLight},
};

const Groups maps{
    {},
    {Effect::exponentMap, Effect::opacityMap},
    {Effect::exponentMap},
    {Effect::opacityMap},
    {Effect::exponentMap, Effect::opacityMap, Effect::gammaCurve},
    {Effect::exponentMap, Effect::opacityMap, Effect::logCurve},
    {Effect::exponentMap, Effect::opacityMap, Effect::energyFactor, Effect::significance, Effect::knee},
    {Effect::opacityFactor},
    {Effect::significance},
};

const Groups others{
    {},
    {Effect::emptySpaceSkipping, Effect::earlyTermination},
    {Effect::emptySpaceSkipping, Effect::earlyTermination, Effect::fogLinear},
    {Effect::emptySpaceSkipping, Effect::earlyTermination, Effect::fogExp},
    {Effect::emptySpaceSkipping, Effect::earlyTermination, Effect::fogExp2},
    {Effect::emptySpaceSkipping, Effect::earlyTermination, Effect::cutFaces},
    {Effect::emptySpaceSkipping, Effect::earlyTermination, Effect::twoSided, Effect::specularOfLight},
    {Effect::emptySpaceSkipping, Effect::gradientOpacity, Effect::knee},
    {Effect::emptySpaceSkipping, Effect::longRays, Effect::denseFunctions},
    {Effect::emptySpaceSkipping, Effect::preintegration},
    {Effect::emptySpaceSkipping, Effect::preintegration, Effect::gradientOpacity, Effect::earlyTermination},
    {Effect::preintegration, Effect::longRays, Effect::denseFunctions},
    {Effect::emptySpaceSkipping, Effect::smoothNormals, Effect::earlyTermination},
    {Effect::smoothNormals, Effect::localSteps, Effect::gradientOpacity},
    {Effect::smoothNormals, Effect::isosurface, Effect::ownWeights},
    {Effect::emptySpaceSkipping, Effect::jitter, Effect::knee},
    {Effect::emptySpaceSkipping, Effect::unlimited},
    {Effect::emptySpaceSkipping, Effect::isosurface, Effect::cutFaces},
    {Effect::emptySpaceSkipping, Effect::isosurface, Effect::jitter, Effect::fogExp, Effect::knee},
    {Effect::emptySpaceSkipping, Effect::hybrid, Effect::earlyTermination},
    {Effect::emptySpaceSkipping, Effect::hybrid, Effect::preintegration, Effect::cutFaces},
    {Effect::hybrid, Effect::longRays, Effect::fogLinear},
    {Effect::emptySpaceSkipping, Effect::xray},
    {Effect::emptySpaceSkipping, Effect::xray, Effect::preintegration},
    {Effect::xray, Effect::jitter, Effect::longRays},
    {Effect::emptySpaceSkipping, Effect::localSteps, Effect::earlyTermination},
    {Effect::localSteps, Effect::gradientOpacity, Effect::fogLinear},
    {Effect::emptySpaceSkipping, Effect::localSteps, Effect::cutFaces, Effect::knee, Effect::unlimited},
    {Effect::emptySpaceSkipping, Effect::localSteps, Effect::hybrid, Effect::longRays},
    {Effect::emptySpaceSkipping, Effect::localSteps, Effect::xray, Effect::denseFunctions},
    {Effect::emptySpaceSkipping, Effect::localSteps, Effect::earlyTermination, Effect::sampleCounts},
    {Effect::localSteps, Effect::xray, Effect::sampleCounts},
    {Effect::mip},
    {Effect::minip, Effect::jitter},
    {Effect::average, Effect::denseFunctions},
    {Effect::emptySpaceSkipping, Effect::region, Effect::earlyTermination},
    {Effect::emptySpaceSkipping, Effect::region, Effect::preintegration, Effect::gradientOpacity},
    {Effect::emptySpaceSkipping, Effect::region, Effect::hybrid, Effect::longRays},
    {Effect::region, Effect::isosurface},
    {Effect::region, Effect::xray},
    {Effect::region, Effect::localSteps, Effect::earlyTermination},
    {Effect::region, Effect::localSteps, Effect::xray},
    {Effect::region, Effect::mip},
    {Effect::region, Effect::minip},
    {Effect::region, Effect::average},
    {Effect::emptySpaceSkipping, Effect::labelLooks, Effect::region, Effect::earlyTermination},
    {Effect::emptySpaceSkipping, Effect::labelLooks, Effect::gradientOpacity, Effect::denseFunctions},
    {Effect::emptySpaceSkipping, Effect::labelLooks, Effect::hybrid, Effect::longRays},
    {Effect::labelLooks, Effect::jitter, Effect::ownWeights},
    {Effect::labelLooks, Effect::region, Effect::xray},
    {Effect::labelLooks, Effect::region, Effect::localSteps, Effect::earlyTermination},
    {Effect::labelLooks, Effect::localSteps, Effect::xray},
    {Effect::emptySpaceSkipping, Effect::labelLooks, Effect::preintegration},
    {Effect::emptySpaceSkipping, Effect::labelLooks, Effect::preintegration, Effect::region,
     Effect::gradientOpacity},
    {Effect::labelLooks, Effect::preintegration, Effect::longRays, Effect::denseFunctions},
    {Effect::labelLooks, Effect::preintegration, Effect::region, Effect::xray},
    {Effect::emptySpaceSkipping, Effect::ownWeights, Effect::preintegration, Effect::region},
    {Effect::emptySpaceSkipping, Effect::ownWeights, Effect::localSteps, Effect::gradientOpacity},
    {Effect::emptySpaceSkipping, Effect::ownWeights, Effect::localSteps, Effect::hybrid, Effect::region},
    {Effect::ownWeights, Effect::localSteps, Effect::xray},
    {Effect::ownWeights, Effect::isosurface},
    {Effect::ownWeights, Effect::mip, Effect::region},
    {Effect::ownWeights, Effect::average},
    {Effect::emptySpaceSkipping, Effect::shadow, Effect::occlusion, Effect::earlyTermination},
    {Effect::emptySpaceSkipping, Effect::shadow, Effect::gradientOpacity, Effect::region},
    {Effect::emptySpaceSkipping, Effect::occlusion, Effect::preintegration, Effect::cutFaces},
    {Effect::emptySpaceSkipping, Effect::shadow, Effect::occlusion, Effect::hybrid, Effect::ownWeights},
    {Effect::emptySpaceSkipping, Effect::shadow, Effect::occlusion, Effect::isosurface},
    {Effect::shadow, Effect::labelLooks, Effect::region, Effect::denseFunctions},
    {Effect::shadow, Effect::labelLooks, Effect::preintegration},
    {Effect::shadow, Effect::longRays, Effect::fogLinear},
    {Effect::sampleCounts},
};

// Refused or dropped by sliceEffects, or drawn by tests alone.
const EffectSet notOfSlices{Effect::labelLooks,
                            Effect::shadow,
                            Effect::occlusion,
                            Effect::physical,
                            Effect::mip,
                            Effect::minip,
                            Effect::average,
                            Effect::isosurface,
                            Effect::hybrid,
                            Effect::earlyTermination,
                            Effect::emptySpaceSkipping,
                            Effect::longRays,
                            Effect::unlimited,
                            Effect::sampleCounts};

} // namespace

std::set<EffectSet> reachableSets() {
  std::set<EffectSet> sets;
  for (const auto& light : lights)
    for (const auto& map : maps)
      for (const auto& other : others) {
        EffectSet effects;
        for (const auto* group : {&light, &map, &other})
          for (const Effect effect : *group)
            effects = effects.with(effect);
        sets.insert(canonical(effects));
      }
  return sets;
}

std::set<EffectSet> sliceSets() {
  const EffectSet lit{Effect::lighting, Effect::diffuse, Effect::specular};
  const EffectSet mapped = lit.with({Effect::exponentMap, Effect::opacityMap});
  std::set<EffectSet> sets;
  for (const EffectSet& base : {EffectSet(), lit, mapped})
    for (int i = 0; i < effectCount; ++i)
      if (const auto effect = static_cast<Effect>(i); !notOfSlices.has(effect))
        sets.insert(canonical(base.with(effect)));
  return sets;
}

} // namespace limn::test
