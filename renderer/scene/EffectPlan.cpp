// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/EffectPlan.h"

#include "scene/Error.h"
#include "scene/FunctionDetail.h"
#include "scene/LightingTerms.h"
#include "scene/RayFrame.h"
#include "scene/StableMath.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

// Below this share of empty blocks a look at their map costs more than it saves.
constexpr double leastEmptyShare = 0.05;

// Collects one clause per effect.
struct Plan {
  EffectPlan plan;

  void clause(Effect effect, bool isNeeded, const char* because, const char* becauseNot) {
    if (isNeeded)
      plan.effects = plan.effects.with(effect);
    plan.reasons.push_back({effect, isNeeded, isNeeded ? because : becauseNot});
  }
};

bool isConstant(const Volume& volume) {
  return !(volume.range().highest > volume.range().lowest);
}

// The terms with what a volume without any gradient leaves of them: no normal but on a cut face, and r = 0.
LightingTerms termsFor(const Scene& scene) {
  LightingTerms terms = lightingTerms(scene.shading);
  if (isConstant(*scene.volume) && scene.crop == CropBox{}) {
    terms.diffuse = 0.0;
    terms.specular = 0.0;
    terms.significance.reset();
    terms.opacity.atBoundary = terms.opacity.atFlat;
  }
  return terms;
}

void lightClauses(Plan& plan, const Scene& scene, const LightingTerms& terms, bool hasGradientOpacity) {
  const bool readsGradient = hasGradientOpacity || terms.usesNormal() || terms.usesRatio();
  const char* flat = isConstant(*scene.volume) ? "the volume is constant and has no gradient" : nullptr;
  plan.clause(Effect::lighting, terms.isLit, "the model lights samples", "the model is unlit");
  plan.clause(Effect::gradient, readsGradient, "light or a map of opacity or highlights reads it",
              flat ? flat : "nothing reads it");
  plan.clause(Effect::diffuse, terms.diffuse != 0.0, "the diffuse term is not 0",
              flat ? flat : "the diffuse term is 0");
  plan.clause(Effect::specular, terms.specular != 0.0, "the specular term is not 0",
              !terms.isLit ? "the model is unlit"
              : flat       ? flat
                           : "the specular term is 0");
  plan.clause(Effect::phong, terms.reflection == Reflection::phong, "Phong reflection is chosen",
              "Blinn reflection is chosen, or there are no highlights");
  plan.clause(Effect::twoSided, terms.twoSided, "surfaces are lit from both sides",
              "surfaces are lit from outside only, or no light falls on them");
  plan.clause(Effect::fixedLight, terms.lightDirection.has_value(), "the light has its own direction",
              "the light is a headlight");
  plan.clause(Effect::specularOfLight, terms.specularColor == SpecularColor::light,
              "highlights take the light's colour", "highlights take the material's colour");
}

void gradientClauses(Plan& plan, const LightingTerms& terms, bool hasGradientOpacity) {
  plan.clause(Effect::exponentMap, terms.mapsExponent(), "the highlight sharpness follows the gradient",
              terms.specular == 0.0 ? "there are no highlights" : "the highlight sharpness is constant");
  plan.clause(Effect::opacityMap, terms.mapsOpacity(), "the opacity coefficient follows the gradient",
              "the opacity coefficient is constant");
  plan.clause(Effect::opacityFactor, !terms.mapsOpacity() && terms.opacity.atFlat != 1.0,
              "the constant opacity coefficient is not 1", "the coefficient is 1 or follows the gradient");
  const char* noCurve = terms.usesRatio() ? "the curve is linear" : "nothing uses the gradient ratio";
  plan.clause(Effect::gammaCurve, terms.curve.type == GradientCurve::Type::gamma, "the curve is a power",
              noCurve);
  plan.clause(Effect::logCurve, terms.curve.type == GradientCurve::Type::log, "the curve is logarithmic",
              noCurve);
  plan.clause(Effect::gradientOpacity, hasGradientOpacity, "a curve of opacity over the gradient is set",
              "no curve of opacity over the gradient is set");
}

void robustClauses(Plan& plan, const Scene& scene, const LightingTerms& terms) {
  const bool isRobust = scene.shading.model == ShadingModel::robust;
  plan.clause(Effect::energyFactor, terms.energyFactor,
              "broad highlights are held to the energy of narrow ones",
              isRobust ? "the energy factor is off or 1" : "the model is not robust");
  plan.clause(Effect::significance, terms.significance.has_value(), "highlights are weighed by significance",
              isRobust ? "highlights are not weighed, or there are none" : "the model is not robust");
  plan.clause(Effect::knee, terms.knee.has_value(), "the sum of the light terms can pass the knee",
              isRobust ? "no sum of the light terms reaches the knee" : "the model is not robust");
}

// The eye's distance to the farthest corner of what the crop leaves, mm, or the camera plane's.
double farthestDepthMm(const Scene& scene) {
  const Grid& grid = scene.volume->grid();
  const IndexBox box = croppedBox(grid, scene.crop);
  const CameraBasis basis = basisOf(scene.camera);
  double farthest = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 at((corner & 1) != 0 ? box.upper.x : box.lower.x,
                        (corner & 2) != 0 ? box.upper.y : box.lower.y,
                        (corner & 4) != 0 ? box.upper.z : box.lower.z);
    const glm::dvec3 fromEye = indexToWorld(grid, at + centreIndex(grid)) - scene.camera.position;
    const bool isPerspective = scene.camera.projection == Camera::Projection::perspective;
    farthest = std::max(farthest, isPerspective ? glm::length(fromEye) : glm::dot(fromEye, basis.forward));
  }
  return farthest;
}

void fogClauses(Plan& plan, const Scene& scene) {
  const Fog& fog = scene.fog;
  const bool isExponential = fog.mode == Fog::Mode::exp || fog.mode == Fog::Mode::exp2;
  const bool isThin = isExponential && !(fog.densityPerMm > 0.0);
  // A hair beyond the corner: the shaders' distances are floats.
  const bool isBehind = fog.startMm >= farthestDepthMm(scene) * (1.0 + 1e-5);
  const bool shows = fog.mode != Fog::Mode::none && !isThin && !isBehind;
  const char* why = fog.mode == Fog::Mode::none ? "fog is off"
                    : isThin                    ? "the fog's density is 0"
                    : isBehind                  ? "the fog begins behind the volume"
                                                : "another fog is chosen";
  plan.clause(Effect::fogLinear, shows && fog.mode == Fog::Mode::linear, "linear fog is on", why);
  plan.clause(Effect::fogExp, shows && fog.mode == Fog::Mode::exp, "exponential fog is on", why);
  plan.clause(Effect::fogExp2, shows && fog.mode == Fog::Mode::exp2, "squared exponential fog is on", why);
}

void projectionClauses(Plan& plan, const Scene& scene) {
  const auto choice = [&](Effect effect, Projection projection, const char* because) {
    plan.clause(effect, scene.projection == projection, because, "another projection is chosen");
  };
  choice(Effect::mip, Projection::mip, "each ray shows its largest value");
  choice(Effect::minip, Projection::minip, "each ray shows its smallest value");
  choice(Effect::average, Projection::average, "each ray shows its mean value");
  choice(Effect::xray, Projection::xray, "each ray shows how much it absorbs");
  choice(Effect::isosurface, Projection::isosurface, "each ray shows the first surface");
  choice(Effect::hybrid, Projection::compositeIsosurface, "a surface stands behind what lies before it");
}

// The largest depth that a ray can gather in the volume.
double largestDepth(const Scene& scene, const LightingTerms& terms) {
  const ValueRange& range = scene.volume->range();
  const double opacity = largestOpacityWithin(scene.transferFunction, range.lowest, range.highest) *
                         std::max(terms.opacity.atFlat, terms.opacity.atBoundary);
  return minusLog1mOpacity(opacity) / scene.transferFunction.unitDistanceMm *
         boxDiagonalMm(scene.volume->grid());
}

void marchClauses(Plan& plan, const Scene& scene, const SceneFacts& facts, const LightingTerms& terms) {
  const Preintegration chosen = scene.quality.preintegrated;
  const bool isResolved = chosen != Preintegration::automatic || isConstant(*scene.volume) ||
                          stepResolvesFunction(scene, facts.steepestPerMm);
  plan.clause(Effect::preintegration, chosen == Preintegration::always || !isResolved,
              chosen == Preintegration::always ? "it is set to always"
                                               : "the transfer function changes within less than a step",
              chosen == Preintegration::never ? "it is set to never"
                                              : "the step resolves the transfer function");
  plan.clause(Effect::jitter, scene.quality.jitter, "jitter is on", "jitter is off");
  const double e = scene.quality.earlyTermination;
  // A hundredth of margin for the rounding of the shaders' sums.
  const bool canEnd = e < 1.0 && oneMinusExpNeg(1.01 * largestDepth(scene, terms)) >= e;
  plan.clause(Effect::earlyTermination, canEnd, "rays end at the opacity set",
              e < 1.0 ? "no ray can reach the opacity at which it would end" : "it is set to never");
  const bool skips = facts.canSkipEmptySpace && facts.emptyShare >= leastEmptyShare;
  plan.clause(Effect::emptySpaceSkipping, skips, "parts of the volume cannot show",
              facts.canSkipEmptySpace ? "hardly any part of the volume is empty" : "it is switched off");
  const double loops = scene.projection == Projection::compositeIsosurface ? 3.0 : 2.0;
  plan.clause(Effect::longRays, loops * longestRaySamples(scene) > mostSamples,
              "the longest ray has too many samples for nested loops", "every ray is short enough");
  plan.clause(Effect::denseFunctions, facts.hasDenseFunctions, "control points lie very close together",
              "control points lie far enough apart");
}

// What is left out because of the projection says so.
void explainDropped(EffectPlan& plan, Projection projection) {
  for (EffectReason& reason : plan.reasons) {
    const bool isKept = plan.effects.has(reason.effect);
    if (reason.isNeeded && !isKept)
      reason.reason = !plan.isVisible                   ? "nothing of the volume can be seen"
                      : reason.effect == Effect::jitter ? "a pre-integrated step has no sample to shift"
                      : reason.effect == Effect::emptySpaceSkipping && projection == Projection::composite
                          ? "the rays have too many samples for nested loops"
                      : projection == Projection::composite ? "nothing that shows depends on it"
                                                            : "this projection does not use it";
    reason.isNeeded = isKept;
  }
}

} // namespace

bool stepResolvesFunction(const Scene& scene, double steepestPerMm) {
  // Measured on the CT head against 1/64 voxel, mean error of pre-integrated steps to that of samples: bands
  // of 20 to 200 HU 0.09 to 0.33; ramps of 60 % opacity over 50 HU 0.36 (lit 0.63) at half a voxel, where the
  // value commonly changes by up to 340 HU a step, over 100 HU 0.59 (0.79), over 200 HU 1.8 (1.06). It
  // takes 1.4 times as long, which a smaller step would turn into half the error.
  const double perStep = steepestPerMm * stepMm(scene);
  const ValueRange& range = scene.volume->range();
  return largestChangeOver(scene.transferFunction, perStep / 16.0, range) < 0.2 &&
         narrowestBand(scene.transferFunction, 0.1, range) >= perStep / 3.0;
}

bool readsSteepness(const Scene& scene) {
  // Along no axis can the value change by more than the whole range from voxel to voxel: √3 for all three.
  const ValueRange& range = scene.volume->range();
  const double most =
      std::sqrt(3.0) * (range.highest - range.lowest) / smallestSpacingMm(scene.volume->grid());
  return scene.quality.preintegrated == Preintegration::automatic && !stepResolvesFunction(scene, most);
}

bool isAnythingVisible(const Scene& scene) {
  const ValueRange& range = scene.volume->range();
  const bool isOpaque = largestOpacityWithin(scene.transferFunction, range.lowest, range.highest) > 0.0;
  const bool hasSurface = scene.isovalue <= range.highest;
  switch (scene.projection) {
  case Projection::isosurface:
    return hasSurface;
  case Projection::compositeIsosurface:
    return hasSurface || isOpaque;
  default:
    return isOpaque;
  }
}

EffectPlan requiredEffects(const Scene& scene, const SceneFacts& facts) {
  const LightingTerms terms = termsFor(scene);
  const bool hasGradientOpacity = scene.gradientOpacity && !scene.gradientOpacity->points.empty();
  Plan plan;
  lightClauses(plan, scene, terms, hasGradientOpacity);
  gradientClauses(plan, terms, hasGradientOpacity);
  robustClauses(plan, scene, terms);
  fogClauses(plan, scene);
  plan.clause(Effect::cutFaces, scene.crop != CropBox{} && terms.usesNormal(),
              "the crop box cuts the volume and the cut faces are lit",
              scene.crop == CropBox{} ? "the crop box cuts nothing" : "the cut faces are not lit");
  projectionClauses(plan, scene);
  marchClauses(plan, scene, facts, terms);
  plan.clause(Effect::unlimited, false, "", "only the measure of overflow draws it");
  plan.clause(Effect::sampleCounts, false, "", "only tests draw it");
  plan.plan.isVisible = isAnythingVisible(scene);
  plan.plan.effects = plan.plan.isVisible ? canonical(plan.plan.effects) : EffectSet();
  explainDropped(plan.plan, scene.projection);
  return plan.plan;
}

void requireDrawable(const Scene& scene) {
  if (!scene.volume)
    throw Error(Error::Kind::usage, "There is no volume to draw; open one first.");
}

} // namespace limn
