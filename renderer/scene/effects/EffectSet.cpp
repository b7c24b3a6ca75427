// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/effects/EffectSet.h"

#include <array>

namespace limn {
namespace {

constexpr std::array<EffectDescription, effectCount> descriptions{{
    {"lighting", "EFFECT_LIGHTING", "samples are lit"},
    {"gradient", "EFFECT_GRADIENT", "the gradient is measured at visible samples"},
    {"diffuse", "EFFECT_DIFFUSE", "diffuse reflection"},
    {"specular", "EFFECT_SPECULAR", "highlights"},
    {"phong", "EFFECT_PHONG", "highlights after Phong instead of Blinn"},
    {"two_sided", "EFFECT_TWO_SIDED", "surfaces are lit from both sides"},
    {"fixed_light", "EFFECT_FIXED_LIGHT", "a light that does not follow the viewer"},
    {"light_coloured_highlights", "EFFECT_SPECULAR_OF_LIGHT", "highlights have the light's colour"},
    {"exponent_map", "EFFECT_EXPONENT_MAP", "the specular exponent follows the gradient"},
    {"opacity_map", "EFFECT_OPACITY_MAP", "the opacity follows the gradient"},
    {"opacity_factor", "EFFECT_OPACITY_FACTOR", "one factor on every opacity"},
    {"gamma_curve", "EFFECT_GAMMA_CURVE", "a power curve on the gradient ratio"},
    {"log_curve", "EFFECT_LOG_CURVE", "a logarithmic curve on the gradient ratio"},
    {"gradient_opacity", "EFFECT_GRADIENT_OPACITY", "a curve of opacity over the gradient modulus"},
    {"energy_factor", "EFFECT_ENERGY_FACTOR", "broad highlights are as strong as narrow ones"},
    {"significance", "EFFECT_SIGNIFICANCE", "no highlights where the gradient is insignificant"},
    {"knee", "EFFECT_KNEE", "bright colours are compressed and keep their hue"},
    {"fog_linear", "EFFECT_FOG_LINEAR", "linear fog"},
    {"fog_exp", "EFFECT_FOG_EXP", "exponential fog"},
    {"fog_exp2", "EFFECT_FOG_EXP2", "squared exponential fog"},
    {"cut_faces", "EFFECT_CUT_FACES", "faces cut by the crop box are lit as faces"},
    {"shadow", "EFFECT_SHADOW", "what stands between a sample and its light dims it"},
    {"occlusion", "EFFECT_OCCLUSION", "what stands around a sample dims its ambient light"},
    {"smooth_normals", "EFFECT_SMOOTH_NORMALS", "the gradient is that of the smoothed field"},
    {"physical", "EFFECT_PHYSICAL", "light goes random ways through the volume"},
    {"region", "EFFECT_REGION", "a kept region takes opacity from what lies outside it"},
    {"label_looks", "EFFECT_LABEL_LOOKS", "labels have transfer functions of their own"},
    {"mip", "EFFECT_MIP", "the largest value of each ray"},
    {"minip", "EFFECT_MINIP", "the smallest value of each ray"},
    {"average", "EFFECT_AVERAGE", "the mean value of each ray"},
    {"xray", "EFFECT_XRAY", "absorption without colour"},
    {"isosurface", "EFFECT_ISOSURFACE", "the first surface of one value"},
    {"hybrid", "EFFECT_HYBRID", "the composite up to the first surface of one value"},
    {"preintegration", "EFFECT_PREINTEGRATION", "the transfer function is integrated within each step"},
    {"jitter", "EFFECT_JITTER", "samples are shifted from pixel to pixel"},
    {"early_termination", "EFFECT_EARLY_TERMINATION", "rays end where nothing behind can be seen"},
    {"empty_space_skipping", "EFFECT_EMPTY_SPACE_SKIPPING", "rays step over blocks that cannot show"},
    {"long_rays", "EFFECT_LONG_RAYS", "one loop over the samples, for very many of them"},
    {"dense_functions", "EFFECT_DENSE_FUNCTIONS", "a search among control points that lie very close"},
    {"local_steps", "EFFECT_LOCAL_STEPS", "samples are spent where the picture needs them"},
    {"own_weights", "EFFECT_OWN_WEIGHTS", "voxels are weighed in floats, not by the driver's filter"},
    {"unlimited", "EFFECT_UNLIMITED", "the sum of the light terms before it is limited"},
    {"sample_counts", "EFFECT_SAMPLE_COUNTS", "the number of samples instead of the picture"},
}};

// Effects that draw nothing by themselves at the values which scenes without them have. (A curve has none, a
// power of 1 rounds; two-sided, Phong and the light's own direction or colour are choices.)
const EffectSet neutralEffects{Effect::lighting,
                               Effect::gradient,
                               Effect::diffuse,
                               Effect::specular,
                               Effect::exponentMap,
                               Effect::opacityMap,
                               Effect::opacityFactor,
                               Effect::gradientOpacity,
                               Effect::energyFactor,
                               Effect::significance,
                               Effect::knee,
                               Effect::fogLinear,
                               Effect::fogExp,
                               Effect::fogExp2,
                               Effect::cutFaces,
                               Effect::jitter,
                               Effect::earlyTermination,
                               Effect::emptySpaceSkipping,
                               Effect::denseFunctions};

const EffectSet highlightChoices{Effect::phong, Effect::specularOfLight};
const EffectSet lightChoices{Effect::twoSided, Effect::fixedLight};
const EffectSet curves{Effect::gammaCurve, Effect::logCurve};

// What lights samples one by one.
const EffectSet ofSamplesLight{
    Effect::lighting,     Effect::diffuse,     Effect::specular,   Effect::shadow,
    Effect::occlusion,    Effect::knee,        Effect::opacityMap, Effect::opacityFactor,
    Effect::significance, Effect::exponentMap, Effect::fogLinear,  Effect::fogExp,
    Effect::fogExp2,      Effect::isosurface,  Effect::hybrid,     Effect::unlimited};

// What a projection cannot use.
EffectSet withinProjection(EffectSet effects) {
  const EffectSet marching{Effect::xray,      Effect::preintegration, Effect::jitter,
                           Effect::longRays,  Effect::denseFunctions, Effect::emptySpaceSkipping,
                           Effect::region,    Effect::labelLooks,     Effect::localSteps,
                           Effect::ownWeights};
  if (effects.hasAny(scalarProjections)) {
    const EffectSet kept =
        scalarProjections.with({Effect::jitter, Effect::denseFunctions, Effect::region, Effect::ownWeights});
    return effects.without(effects.without(kept));
  }
  if (effects.has(Effect::xray))
    return effects.without(effects.without(marching));
  if (effects.has(Effect::isosurface))
    return effects.without({Effect::opacityMap, Effect::opacityFactor, Effect::gradientOpacity,
                            Effect::labelLooks, Effect::preintegration, Effect::earlyTermination,
                            Effect::longRays, Effect::denseFunctions, Effect::localSteps});
  return effects;
}

} // namespace

const EffectDescription& describe(Effect effect) {
  return descriptions[static_cast<std::size_t>(effect)];
}

bool usesRatio(EffectSet effects) {
  return effects.hasAny({Effect::exponentMap, Effect::opacityMap, Effect::significance});
}

EffectSet canonical(EffectSet effects) {
  const bool counts = effects.has(Effect::sampleCounts);
  // Light on random ways asks for boundaries, and for nothing that lights samples.
  if (effects.has(Effect::physical) && !effects.hasAny(scalarProjections) && !effects.has(Effect::xray))
    effects = effects.without(ofSamplesLight);
  effects = withinProjection(effects);
  // Equal steps are counted without taking them; how many error-controlled ones there are shows in the march.
  if (counts && !effects.has(Effect::localSteps))
    return {Effect::sampleCounts};
  if (counts)
    effects = effects.with(Effect::sampleCounts).without(Effect::unlimited);
  const auto drop = [&effects](bool condition, EffectSet useless) {
    if (condition)
      effects = effects.without(useless);
  };
  const auto has = [&effects](Effect effect) { return effects.has(effect); };
  drop(has(Effect::localSteps), {Effect::preintegration, Effect::jitter});
  drop(has(Effect::localSteps) && !has(Effect::hybrid), {Effect::longRays});
  drop(has(Effect::preintegration), {Effect::jitter});
  drop(!has(Effect::lighting),
       {Effect::diffuse, Effect::specular, Effect::occlusion, Effect::knee, Effect::unlimited});
  drop(has(Effect::unlimited), {Effect::knee});
  drop(!has(Effect::specular), highlightChoices.with({Effect::exponentMap, Effect::significance}));
  drop(!has(Effect::exponentMap), {Effect::energyFactor});
  drop(!has(Effect::diffuse) && !has(Effect::specular), lightChoices);
  drop(!has(Effect::fixedLight), {Effect::shadow});
  drop(!effects.hasAny({Effect::diffuse, Effect::specular, Effect::occlusion, Effect::physical}),
       {Effect::cutFaces});
  drop(has(Effect::opacityMap), {Effect::opacityFactor});
  drop(!usesRatio(effects), curves);
  const bool readsGradient =
      usesRatio(effects) || effects.hasAny({Effect::diffuse, Effect::specular, Effect::occlusion,
                                            Effect::gradientOpacity, Effect::physical});
  drop(!readsGradient, {Effect::smoothNormals});
  return readsGradient ? effects.with(Effect::gradient) : effects.without(Effect::gradient);
}

EffectSet leavingOut(EffectSet effects, EffectSet leftOut) {
  effects = effects.without(leftOut);
  if (leftOut.has(Effect::gradient))
    effects =
        effects.without({Effect::diffuse, Effect::specular, Effect::exponentMap, Effect::opacityMap,
                         Effect::significance, Effect::gradientOpacity, Effect::occlusion, Effect::physical});
  return canonical(effects);
}

bool canStandIn(EffectSet effects, EffectSet needed) {
  EffectSet missing = needed.without(effects);
  if (effects.has(Effect::opacityMap))
    missing = missing.without(Effect::opacityFactor);
  // Stepping over empty space changes no bit, present or absent.
  missing = missing.without(Effect::emptySpaceSkipping);
  if (!missing.isEmpty())
    return false;
  // A choice is free where what it concerns is not needed.
  EffectSet free = neutralEffects;
  if (!needed.has(Effect::specular))
    free = free.with(highlightChoices);
  if (!needed.hasAny({Effect::diffuse, Effect::specular}))
    free = free.with(lightChoices);
  if (!usesRatio(needed))
    free = free.with(curves);
  if (needed.hasAny(fogs))
    free = free.without(fogs);
  return effects.without(needed).without(free).isEmpty();
}

EffectSet withAllNeutral(EffectSet needed) {
  EffectSet all = needed.with(neutralEffects);
  // Two fogs exclude each other.
  all = all.without(fogs.without(needed.hasAny(fogs) ? needed : EffectSet{Effect::fogExp}));
  return canonical(all);
}

} // namespace limn
