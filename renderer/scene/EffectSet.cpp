// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/EffectSet.h"

#include "scene/Error.h"
#include "scene/LightingTerms.h"
#include "scene/RayFrame.h"

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
    {"early_termination", "EFFECT_EARLY_TERMINATION", "rays end where nothing behind can be seen"},
    {"empty_space_skipping", "EFFECT_EMPTY_SPACE_SKIPPING", "rays step over blocks that cannot show"},
    {"long_rays", "EFFECT_LONG_RAYS", "one loop over the samples, for very many of them"},
    {"dense_functions", "EFFECT_DENSE_FUNCTIONS", "a search among control points that lie very close"},
    {"sample_counts", "EFFECT_SAMPLE_COUNTS", "draws the number of samples instead of the picture"},
}};

// Collects one clause per effect.
struct Plan {
  EffectPlan plan;

  void clause(Effect effect, bool isNeeded, const char* because, const char* becauseNot) {
    if (isNeeded)
      plan.effects = plan.effects.with(effect);
    plan.reasons.push_back({effect, isNeeded, isNeeded ? because : becauseNot});
  }
};

void lightClauses(Plan& plan, const LightingTerms& terms, bool hasGradientOpacity) {
  const bool readsGradient = hasGradientOpacity || terms.usesNormal() || terms.usesRatio();
  plan.clause(Effect::lighting, terms.isLit, "the model lights samples", "the model is unlit");
  plan.clause(Effect::gradient, readsGradient, "lighting or a map of opacity or exponent reads it",
              "no term reads it");
  plan.clause(Effect::diffuse, terms.diffuse != 0.0, "the diffuse term is not 0", "the diffuse term is 0");
  plan.clause(Effect::specular, terms.specular != 0.0, "the specular term is not 0",
              "the specular term is 0");
  plan.clause(Effect::phong, terms.reflection == Reflection::phong, "Phong reflection is chosen",
              "Blinn reflection is chosen, or there are no highlights");
  plan.clause(Effect::twoSided, terms.twoSided, "two-sided lighting is on", "two-sided lighting is off");
  plan.clause(Effect::fixedLight, terms.lightDirection.has_value(), "the light has its own direction",
              "the light is a headlight");
  plan.clause(Effect::specularOfLight, terms.specularColor == SpecularColor::light,
              "highlights take the light's colour", "highlights take the material's colour");
}

void gradientClauses(Plan& plan, const LightingTerms& terms, bool hasGradientOpacity) {
  plan.clause(Effect::exponentMap, terms.mapsExponent(), "the exponent range is not a single value",
              "the exponent is constant");
  plan.clause(Effect::opacityMap, terms.mapsOpacity(), "the opacity range is not a single value",
              "the opacity coefficient is constant");
  plan.clause(Effect::opacityFactor, !terms.mapsOpacity() && terms.opacity.atFlat != 1.0,
              "the constant opacity coefficient is not 1", "the coefficient is 1 or follows the gradient");
  plan.clause(Effect::gammaCurve, terms.curve.type == GradientCurve::Type::gamma, "the curve is a power",
              "the curve is not a power, or nothing uses the ratio");
  plan.clause(Effect::logCurve, terms.curve.type == GradientCurve::Type::log, "the curve is logarithmic",
              "the curve is not logarithmic, or nothing uses the ratio");
  plan.clause(Effect::gradientOpacity, hasGradientOpacity, "a gradient-opacity curve is given",
              "no gradient-opacity curve is given");
}

void robustClauses(Plan& plan, const LightingTerms& terms) {
  plan.clause(Effect::energyFactor, terms.energyFactor, "the energy factor is on and the exponent varies",
              "the energy factor is off or 1");
  plan.clause(Effect::significance, terms.significance.has_value(), "highlights are weighed by significance",
              "highlights are not weighed");
  plan.clause(Effect::knee, terms.knee.has_value(), "the sum of the light terms can pass the knee",
              "there is no knee, or no sum of terms reaches it");
}

void fogClauses(Plan& plan, const Fog& fog) {
  const bool isDense = fog.densityPerMm > 0.0;
  plan.clause(Effect::fogLinear, fog.mode == Fog::Mode::linear, "linear fog is on", "linear fog is off");
  plan.clause(Effect::fogExp, fog.mode == Fog::Mode::exp && isDense, "exponential fog is on",
              "exponential fog is off or has no density");
  plan.clause(Effect::fogExp2, fog.mode == Fog::Mode::exp2 && isDense, "squared exponential fog is on",
              "squared exponential fog is off or has no density");
}

} // namespace

const EffectDescription& describe(Effect effect) {
  return descriptions[static_cast<std::size_t>(effect)];
}

EffectSet canonical(EffectSet effects) {
  const auto drop = [&effects](bool condition, std::initializer_list<Effect> useless) {
    if (condition)
      for (const Effect effect : useless)
        effects = effects.without(effect);
  };
  const auto has = [&effects](Effect effect) { return effects.has(effect); };
  if (has(Effect::sampleCounts))
    return EffectSet().with(Effect::sampleCounts);
  drop(has(Effect::longRays), {Effect::emptySpaceSkipping});
  drop(!has(Effect::lighting), {Effect::diffuse, Effect::specular, Effect::knee});
  drop(!has(Effect::specular), {Effect::phong, Effect::specularOfLight, Effect::exponentMap,
                                Effect::energyFactor, Effect::significance});
  drop(!has(Effect::exponentMap), {Effect::energyFactor});
  drop(!has(Effect::diffuse) && !has(Effect::specular),
       {Effect::twoSided, Effect::fixedLight, Effect::cutFaces});
  drop(has(Effect::opacityMap), {Effect::opacityFactor});
  const bool usesRatio = has(Effect::exponentMap) || has(Effect::opacityMap) || has(Effect::significance);
  drop(!usesRatio, {Effect::gammaCurve, Effect::logCurve});
  const bool readsGradient =
      usesRatio || has(Effect::diffuse) || has(Effect::specular) || has(Effect::gradientOpacity);
  return readsGradient ? effects.with(Effect::gradient) : effects.without(Effect::gradient);
}

EffectPlan requiredEffects(const Scene& scene, const SceneFacts& facts) {
  const LightingTerms terms = lightingTerms(scene.shading);
  const bool hasGradientOpacity = scene.gradientOpacity && !scene.gradientOpacity->points.empty();
  Plan plan;
  lightClauses(plan, terms, hasGradientOpacity);
  gradientClauses(plan, terms, hasGradientOpacity);
  robustClauses(plan, terms);
  fogClauses(plan, scene.fog);
  plan.clause(Effect::cutFaces, scene.crop != CropBox{} && terms.usesNormal(),
              "the crop box cuts the volume and samples are lit", "nothing is cut, or nothing is lit");
  plan.clause(Effect::earlyTermination, scene.quality.earlyTermination < 1.0, "rays end at the opacity set",
              "early termination is set to never");
  plan.clause(Effect::emptySpaceSkipping, facts.canSkipEmptySpace, "blocks that cannot show are known",
              "it is switched off, or the rays have too many samples for nested loops");
  plan.clause(Effect::longRays, 2.0 * facts.longestRaySamples > mostSamples,
              "the longest ray has too many samples for nested loops", "every ray is short enough");
  plan.clause(Effect::denseFunctions, facts.hasDenseFunctions, "control points lie very close together",
              "control points lie far enough apart");
  plan.clause(Effect::sampleCounts, false, "", "only tests draw it");
  plan.plan.effects = canonical(plan.plan.effects);
  for (EffectReason& reason : plan.plan.reasons)
    reason.isNeeded = plan.plan.effects.has(reason.effect);
  return plan.plan;
}

void requireDrawable(const Scene& scene) {
  const auto refuse = [](const char* what) {
    throw Error(Error::Kind::usage,
                std::string(what) + " cannot be drawn yet; choose another setting for it.");
  };
  if (!scene.volume)
    throw Error(Error::Kind::usage, "There is no volume to draw; open one first.");
  switch (scene.projection) {
  case Projection::composite:
    break;
  case Projection::mip:
    refuse("The projection \"mip\"");
    break;
  case Projection::minip:
    refuse("The projection \"minip\"");
    break;
  case Projection::average:
    refuse("The projection \"average\"");
    break;
  case Projection::xray:
    refuse("The projection \"xray\"");
    break;
  case Projection::isosurface:
    refuse("The projection \"isosurface\"");
    break;
  case Projection::compositeIsosurface:
    refuse("The projection \"composite_isosurface\"");
    break;
  }
  if (scene.quality.preintegrated == Preintegration::always)
    refuse("A pre-integrated picture");
  if (scene.quality.jitter)
    refuse("A jittered picture");
}

} // namespace limn
