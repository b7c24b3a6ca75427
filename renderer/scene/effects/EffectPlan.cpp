// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/effects/EffectPlan.h"

#include "scene/LabelLooks.h"
#include "scene/ProjectionFacts.h"
#include "scene/basics/Error.h"
#include "scene/basics/StableMath.h"
#include "scene/function/FunctionDetail.h"
#include "scene/light/GradientSmoothing.h"
#include "scene/light/LightingTerms.h"
#include "scene/steps/LocalSteps.h"
#include "scene/steps/RayFrame.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

// Below this share of empty blocks a look at their map costs more than it saves.
constexpr double leastEmptyShare = 0.05;

// Collects one clause per effect.
struct Plan {
  EffectPlan plan;

  void clause(Effect effect, bool isNeeded, const Message& because, const Message& becauseNot) {
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
    terms.shadow = {};
    terms.significance.reset();
    terms.opacity.atBoundary = terms.opacity.atFlat;
  }
  return terms;
}

Message whyUnlit(const Scene& scene) {
  return scene.shading.model == ShadingModel::physical
             ? Message::tr("physical light stands in its place")
             : Message::tr("the chosen model shows plain colours without light");
}

void lightClauses(Plan& plan, const Scene& scene, const LightingTerms& terms, bool hasGradientOpacity) {
  const bool readsGradient =
      hasGradientOpacity || terms.usesNormal() || terms.usesRatio() || isPhysical(scene);
  const Message unlit = whyUnlit(scene);
  const Message flat = isConstant(*scene.volume)
                           ? Message::tr("every voxel has the same value, so there are no boundaries")
                           : Message();
  plan.clause(Effect::lighting, terms.isLit, Message::tr("the chosen model lights the volume"), unlit);
  plan.clause(Effect::gradient, readsGradient,
              Message::tr("light or boundary settings need to know where boundaries lie"),
              !flat.empty() ? flat : Message::tr("nothing in this picture depends on boundaries"));
  plan.clause(Effect::diffuse, terms.diffuse != 0.0,
              Message::tr("surfaces are brighter where they face the light"),
              !flat.empty() ? flat : Message::tr("the diffuse light is set to 0"));
  plan.clause(Effect::specular, terms.specular != 0.0,
              Message::tr("surfaces shine where they mirror the light"),
              !terms.isLit    ? unlit
              : !flat.empty() ? flat
                              : Message::tr("the strength of the highlights is set to 0"));
  plan.clause(Effect::phong, terms.reflection == Reflection::phong, Message::tr("their shape is Phong's"),
              Message::tr("their shape is Blinn's, or there are none"));
  plan.clause(Effect::twoSided, terms.twoSided, Message::tr("the inner sides of surfaces are lit as well"),
              terms.usesNormal() ? Message::tr("surfaces are lit on their outer side only")
                                 : Message::tr("no light falls on surfaces"));
  plan.clause(Effect::fixedLight, terms.lightDirection.has_value(),
              terms.lightAxes == LightAxes::camera
                  ? Message::tr("the light comes from a direction of its own and turns with the viewer")
                  : Message::tr("the light comes from a direction of its own"),
              Message::tr("the light comes from the viewer"));
  plan.clause(Effect::specularOfLight, terms.specularColor == SpecularColor::light,
              Message::tr("they take the light's colour"), Message::tr("they take the tissue's colour"));
}

void gradientClauses(Plan& plan, const LightingTerms& terms, bool hasGradientOpacity) {
  plan.clause(Effect::exponentMap, terms.mapsExponent(),
              Message::tr("strong boundaries shine more sharply than weak ones"),
              terms.specular == 0.0 ? Message::tr("there are no highlights")
                                    : Message::tr("highlights are equally sharp everywhere"));
  plan.clause(Effect::opacityMap, terms.mapsOpacity(),
              Message::tr("strong boundaries are made more opaque than weak ones"),
              Message::tr("boundaries are as opaque as the curve says"));
  plan.clause(Effect::opacityFactor, !terms.mapsOpacity() && terms.opacity.atFlat != 1.0,
              Message::tr("every opacity is multiplied by the same factor"),
              Message::tr("opacities are not changed by a constant factor"));
  const Message noCurve = terms.usesRatio()
                              ? Message::tr("the strength of boundaries counts as measured (linear)")
                              : Message::tr("nothing depends on the strength of boundaries");
  plan.clause(Effect::gammaCurve, terms.curve.type == GradientCurve::Type::gamma,
              Message::tr("weak and strong boundaries are weighed by a power (gamma)"), noCurve);
  plan.clause(Effect::logCurve, terms.curve.type == GradientCurve::Type::log,
              Message::tr("weak and strong boundaries are weighed by a logarithm"), noCurve);
  plan.clause(Effect::gradientOpacity, hasGradientOpacity,
              Message::tr("a curve says how opaque boundaries are by their strength"),
              Message::tr("no curve of opacity over the strength of boundaries is set"));
}

void robustClauses(Plan& plan, const Scene& scene, const LightingTerms& terms) {
  const bool isRobust = scene.shading.model == ShadingModel::robust;
  plan.clause(Effect::energyFactor, terms.energyFactor,
              Message::tr("broad highlights carry no more light than sharp ones"),
              isRobust ? Message::tr("highlights are equally sharp, or their light is not evened out")
                       : Message::tr("the robust model is not chosen"));
  plan.clause(Effect::significance, terms.significance.has_value(),
              Message::tr("highlights are faded out where boundaries are insignificant"),
              isRobust ? Message::tr("fading out insignificant highlights is off, or there are none")
                       : Message::tr("the robust model is not chosen"));
  plan.clause(Effect::knee, terms.knee.has_value(),
              Message::tr("light could add up to more than full brightness and would be cut off"),
              isRobust ? Message::tr("the light never adds up to that much, or the limit is off")
                       : Message::tr("the robust model is not chosen"));
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

bool isThin(const Fog& fog) {
  const bool isExponential = fog.mode == Fog::Mode::exp || fog.mode == Fog::Mode::exp2;
  return isExponential && !(fog.densityPerMm > 0.0);
}

// By a hair beyond the corner: the shaders' distances are floats.
bool beginsBehindVolume(const Scene& scene) {
  return scene.fog.startMm >= farthestDepthMm(scene) * (1.0 + 1e-5);
}

void fogClauses(Plan& plan, const Scene& scene) {
  const Fog& fog = scene.fog;
  const bool shows = fogShows(scene);
  const Message why = fog.mode == Fog::Mode::none ? Message::tr("fog is off")
                      : isThin(fog)               ? Message::tr("the density of the fog is 0")
                      : beginsBehindVolume(scene) ? Message::tr("the fog begins behind the volume")
                                                  : Message::tr("another fog is chosen");
  plan.clause(Effect::fogLinear, shows && fog.mode == Fog::Mode::linear, Message::tr("linear fog is on"),
              why);
  plan.clause(Effect::fogExp, shows && fog.mode == Fog::Mode::exp, Message::tr("exponential fog is on"), why);
  plan.clause(Effect::fogExp2, shows && fog.mode == Fog::Mode::exp2,
              Message::tr("squared exponential fog is on"), why);
}

void travelClauses(Plan& plan, const Scene& scene, const LightingTerms& terms) {
  const Message unlit = whyUnlit(scene);
  plan.clause(Effect::shadow, terms.shadow.strength > 0.0,
              Message::tr("what stands between tissue and the light casts a shadow"),
              !terms.isLit                             ? unlit
              : !(scene.shading.shadow.strength > 0.0) ? Message::tr("the strength of shadows is set to 0")
              : terms.reflects() ? Message::tr("a light that comes from the viewer casts no shadow")
                                 : Message::tr("no light falls on surfaces"));
  plan.clause(Effect::occlusion, terms.occlusion.strength > 0.0,
              Message::tr("less ambient light reaches hollows and what lies close together"),
              !terms.isLit ? unlit
              : !(scene.shading.occlusion.strength > 0.0)
                  ? Message::tr("the strength of occlusion is set to 0")
                  : Message::tr("there is no ambient light"));
  plan.clause(Effect::physical, isPhysical(scene),
              Message::tr("light goes random ways through tissue, which scatters and absorbs it"),
              scene.shading.model == ShadingModel::physical
                  ? Message::tr("this kind of picture shows values without light")
                  : Message::tr("the physical model is not chosen"));
}

void smoothingClause(Plan& plan, const Scene& scene) {
  const double sigma = scene.shading.gradientSmoothing;
  plan.clause(
      Effect::smoothNormals, smoothsNormals(scene),
      Message::tr("terraces of thick slices are taken out of the light"),
      !(sigma > 0.0)                                  ? Message::tr("the smoothing is set to 0 mm")
      : !smoothsAnything(sigma, scene.volume->grid()) ? Message::tr("the smoothing is finer than the voxels")
      : isConstant(*scene.volume) ? Message::tr("every voxel has the same value, so there are no boundaries")
                                  : Message::tr("nothing in this picture depends on boundaries"));
}

void looksClause(Plan& plan, const Scene& scene) {
  const Message whyNot = scene.keep.looks.empty() ? Message::tr("no label has a look of its own")
                         : integrates(scene.projection)
                             ? Message::tr("no label that shows has another look than the picture")
                             : Message::tr("this kind of picture takes one value of a ray, not of a label");
  plan.clause(Effect::labelLooks, hasLabelLooks(scene), Message::tr("some labels have looks of their own"),
              whyNot);
}

void projectionClauses(Plan& plan, const Scene& scene) {
  const auto choice = [&](Effect effect, Projection projection, const Message& because) {
    plan.clause(effect, scene.projection == projection, because,
                Message::tr("another kind of picture is chosen"));
  };
  choice(Effect::mip, Projection::mip, Message::tr("each ray shows its largest value"));
  choice(Effect::minip, Projection::minip, Message::tr("each ray shows its smallest value"));
  choice(Effect::average, Projection::average, Message::tr("each ray shows its mean value"));
  choice(Effect::xray, Projection::xray, Message::tr("each ray shows how much it absorbs"));
  choice(Effect::isosurface, Projection::isosurface,
         Message::tr("the picture shows the first surface of the chosen value"));
  choice(Effect::hybrid, Projection::compositeIsosurface,
         Message::tr("the surface of the chosen value stands behind what lies before it"));
}

// The largest depth that a ray can gather in the volume.
double largestDepth(const Scene& scene, const LightingTerms& terms) {
  const ValueRange& range = scene.volume->range();
  double perMm = 0.0;
  for (const TransferFunction& function : labelLooks(scene).functions) {
    const double opacity = largestOpacityWithin(function, range.lowest, range.highest) *
                           std::max(terms.opacity.atFlat, terms.opacity.atBoundary);
    perMm = std::max(perMm, minusLog1mOpacity(opacity) / function.unitDistanceMm);
  }
  return perMm * boxDiagonalMm(scene.volume->grid());
}

void marchClauses(Plan& plan, const Scene& scene, const SceneFacts& facts, const LightingTerms& terms) {
  const Preintegration chosen = scene.quality.preintegrated;
  const bool isResolved = chosen != Preintegration::automatic || isConstant(*scene.volume) ||
                          stepResolvesFunction(scene, facts.steepestPerMm);
  plan.clause(
      Effect::preintegration, chosen == Preintegration::always || !isResolved,
      chosen == Preintegration::always ? Message::tr("it is set to \"always\"")
      : hasLabelLooks(scene)
          ? Message::tr("curves of labels may change faster than one step can follow; where looks of labels "
                        "meet, samples stand for steps")
          : Message::tr("the curve changes faster than one step can follow"),
      chosen == Preintegration::never ? Message::tr("it is set to \"never\"")
                                      : Message::tr("the steps are fine enough for this curve"));
  plan.clause(Effect::jitter, scene.quality.jitter,
              Message::tr("it is switched on: neighbouring pixels sample at other depths"),
              Message::tr("it is switched off"));
  const double e = scene.quality.earlyTermination;
  // A hundredth of margin for the rounding of the shaders' sums.
  const bool canEnd = e < 1.0 && oneMinusExpNeg(1.01 * largestDepth(scene, terms)) >= e;
  plan.clause(Effect::earlyTermination, canEnd,
              Message::tr("what lies behind opaque tissue cannot be seen and is not drawn"),
              e < 1.0 ? Message::tr("nothing in this picture is opaque enough to hide what lies behind")
                      : Message::tr("rays are set to run to their end"));
  const bool skips = facts.canSkipEmptySpace && facts.emptyShare >= leastEmptyShare;
  plan.clause(Effect::emptySpaceSkipping, skips,
              Message::tr("transparent parts of the volume are stepped over"),
              facts.canSkipEmptySpace ? Message::tr("hardly any part of the volume is transparent")
                                      : Message::tr("it is switched off"));
  // Per sample at most three iterations of nested loops, and rays that run together wait for one another.
  const double loops =
      (scene.projection == Projection::compositeIsosurface ? 6.0 : 5.0) + (hasLabelLooks(scene) ? 6.0 : 0.0);
  plan.clause(Effect::longRays, loops * longestRaySamples(scene) > mostSamples,
              Message::tr("the longest ray has too many samples for nested loops"),
              Message::tr("every ray is short enough"));
  plan.clause(Effect::denseFunctions, facts.hasDenseFunctions,
              Message::tr("control points lie very close together"),
              Message::tr("control points lie far enough apart"));
}

// What scenes may ask for that physical light does not know.
const EffectSet ofOtherLight{Effect::fogLinear, Effect::fogExp, Effect::fogExp2, Effect::isosurface,
                             Effect::hybrid};

// What is left out because of the projection says so.
void explainDropped(EffectPlan& plan, Projection projection) {
  for (EffectReason& reason : plan.reasons) {
    const bool isKept = plan.effects.has(reason.effect);
    if (reason.isNeeded && !isKept)
      reason.reason = !plan.isVisible ? Message::tr("nothing of the volume can be seen")
                      : plan.effects.has(Effect::physical) && ofOtherLight.has(reason.effect)
                          ? Message::tr("physical light knows tissue, its key light and its sky alone")
                      : reason.effect == Effect::preintegration && plan.effects.has(Effect::localSteps)
                          ? Message::tr("error-controlled steps follow the curve themselves")
                      : reason.effect == Effect::jitter && plan.effects.has(Effect::localSteps)
                          ? Message::tr("error-controlled steps leave no sample to shift")
                      : reason.effect == Effect::jitter
                          ? Message::tr("exact steps (pre-integration) leave no sample to shift")
                      : reason.effect == Effect::emptySpaceSkipping && projection == Projection::composite
                          ? Message::tr("the steps are so small that rays take too many of them")
                      : projection == Projection::composite
                          ? Message::tr("nothing that can be seen depends on it")
                          : Message::tr("this kind of picture has no use for it");
    reason.isDropped = reason.isNeeded && !isKept;
    reason.isNeeded = isKept;
  }
}

double offZero(double value) {
  return value > 0.0 ? value : 1.0;
}

CoefficientRange widened(CoefficientRange range, double highest) {
  if (range.atFlat != range.atBoundary)
    return range;
  return range.atBoundary < highest
             ? CoefficientRange{range.atFlat, std::min(highest, range.atBoundary + 1.0)}
             : CoefficientRange{0.5 * range.atFlat, range.atBoundary};
}

Shading offNeutral(Shading shading) {
  if (shading.model == ShadingModel::classic) {
    shading.model = ShadingModel::enhanced;
    shading.exponentRange = {shading.exponent, shading.exponent};
    shading.opacityRange = {1.0, 1.0};
    shading.gradientCurve = {};
  }
  shading.diffuse = offZero(shading.diffuse);
  shading.specular = offZero(shading.specular);
  shading.lightIntensity = offZero(shading.lightIntensity);
  shading.exponentRange = widened(shading.exponentRange, 1024.0);
  shading.opacityRange = widened(shading.opacityRange, 8.0);
  if (shading.gradientCurve.type == GradientCurve::Type::gamma && shading.gradientCurve.parameter == 1.0)
    shading.gradientCurve.parameter = 2.0;
  return shading;
}

Scene offNeutral(Scene scene) {
  scene.shading = offNeutral(scene.shading);
  scene.fog.densityPerMm = scene.fog.densityPerMm > 0.0 ? scene.fog.densityPerMm : 1e-3;
  scene.fog.startMm = 0.0;
  return scene;
}

} // namespace

bool stepResolvesFunction(const Scene& scene, double steepestPerMm) {
  // Measured on the CT head against 1/64 voxel (tests/benchmarks/PreintegrationGain.cpp), mean error of
  // pre-integrated steps to that of samples: bands of 20 to 200 HU 0.09 to 0.33; edges of 60 % opacity within
  // 50 HU 0.36 (lit 0.63) at half a voxel, where the value commonly changes by up to 340 HU a step, within
  // 100 HU 0.59 (0.79), within 200 HU 1.8 (1.06). It takes 1.3 to 2 times as long.
  const double perStep = steepestPerMm * stepMm(scene);
  const ValueRange& range = scene.volume->range();
  const std::vector<TransferFunction> functions = labelLooks(scene).functions;
  return std::all_of(functions.begin(), functions.end(), [&](const TransferFunction& one) {
    const TransferFunction function = overVoxelAtLeast(one, smallestSpacingMm(scene.volume->grid()));
    return largestChangeOver(function, perStep / 16.0, range) < 0.2 &&
           narrowestBand(function, 0.1, range) >= perStep / 3.0;
  });
}

bool readsSteepness(const Scene& scene) {
  // Along no axis can the value change by more than the whole range from voxel to voxel: √3 for all three.
  const ValueRange& range = scene.volume->range();
  const double most =
      std::sqrt(3.0) * (range.highest - range.lowest) / smallestSpacingMm(scene.volume->grid());
  return scene.quality.preintegrated == Preintegration::automatic && !stepResolvesFunction(scene, most);
}

bool fogShows(const Scene& scene) {
  return scene.fog.mode != Fog::Mode::none && !isThin(scene.fog) && !beginsBehindVolume(scene);
}

bool hasTravellingLight(const Scene& scene) {
  const LightingTerms terms = lightingTerms(scene.shading);
  const bool isLocal = classifiesOnce(scene.projection) || scene.projection == Projection::xray;
  return !isLocal && (terms.shadow.strength > 0.0 || terms.occlusion.strength > 0.0);
}

bool smoothsNormals(const Scene& scene) {
  const LightingTerms terms = lightingTerms(scene.shading);
  const bool hasGradientOpacity = scene.gradientOpacity && !scene.gradientOpacity->points.empty();
  const bool marches = !classifiesOnce(scene.projection) && scene.projection != Projection::xray;
  return scene.shading.gradientSmoothing > 0.0 && marches && !isConstant(*scene.volume) &&
         (hasGradientOpacity || terms.usesNormal() || terms.usesRatio() || isPhysical(scene)) &&
         smoothsAnything(scene.shading.gradientSmoothing, scene.volume->grid());
}

bool isPhysical(const Scene& scene) {
  return scene.shading.model == ShadingModel::physical && !classifiesOnce(scene.projection) &&
         scene.projection != Projection::xray;
}

bool isAnythingVisible(const Scene& scene) {
  const ValueRange& range = scene.volume->range();
  const std::vector<TransferFunction> functions = labelLooks(scene).functions;
  const bool isOpaque =
      std::any_of(functions.begin(), functions.end(), [&](const TransferFunction& function) {
        return largestOpacityWithin(function, range.lowest, range.highest) > 0.0;
      });
  const bool hasSurface = scene.isovalue <= range.highest;
  if (isPhysical(scene)) // knows no surface of one value
    return isOpaque;
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
  plan.clause(Effect::cutFaces, scene.crop != CropBox{} && (terms.usesNormal() || isPhysical(scene)),
              Message::tr("the cuts of the crop box are lit as surfaces"),
              scene.crop == CropBox{} ? Message::tr("the crop box keeps the whole volume")
                                      : Message::tr("no light falls on the cuts"));
  travelClauses(plan, scene, terms);
  smoothingClause(plan, scene);
  plan.clause(Effect::region, isRestricting(scene.keep),
              isCutAway(scene.keep)                   ? Message::tr("what was cut away is hidden")
              : scene.keep.kind == Region::Kind::body ? Message::tr("what is not body is hidden")
                                                      : Message::tr("some labels are hidden or faded"),
              scene.keep.kind == Region::Kind::labels ? Message::tr("every label is shown")
                                                      : Message::tr("all of the volume is kept"));
  looksClause(plan, scene);
  projectionClauses(plan, scene);
  marchClauses(plan, scene, facts, terms);
  plan.clause(Effect::localSteps, finenessOf(scene.quality).has_value(),
              Message::tr("samples are spent where the picture needs them to keep to the tolerance"),
              Message::tr("no tolerance is set, so every step is equally long"));
  // On what weighs in floats a picture is the same without it, and a program less.
  const bool isCoarse = facts.filterBits < mostFilterBits;
  plan.clause(Effect::ownWeights, scene.quality.ownWeights && isCoarse,
              Message::tr("the graphics card weighs voxels too coarsely for the tolerance"),
              isCoarse ? Message::tr("the weights of the graphics card are fine enough for what is asked")
                       : Message::tr("voxels are weighed finely enough without it"));
  plan.clause(Effect::unlimited, false, "", Message::tr("only the measure of overflow draws it"));
  plan.clause(Effect::sampleCounts, false, "", Message::tr("only tests draw it"));
  plan.plan.isVisible = isAnythingVisible(scene);
  plan.plan.effects = plan.plan.isVisible ? canonical(plan.plan.effects) : EffectSet();
  explainDropped(plan.plan, scene.projection);
  return plan.plan;
}

void requireDrawable(const Scene& scene) {
  if (!scene.volume)
    throw Error(Error::Kind::usage, Message::tr("There is no volume to draw; open one first."));
}

std::vector<Scene> neighbours(const Scene& scene) {
  std::vector<Scene> found{offNeutral(scene)};
  if (found.front().shading.gradientCurve.type == GradientCurve::Type::gamma) {
    found.push_back(found.front());
    found.back().shading.gradientCurve.parameter = 1.0;
  }
  if (scene.quality.preintegrated == Preintegration::automatic) {
    const std::vector<Scene> planned = found;
    found.clear();
    for (const Preintegration choice : {Preintegration::never, Preintegration::always})
      for (Scene one : planned) {
        one.quality.preintegrated = choice;
        found.push_back(one);
      }
  }
  return found;
}

} // namespace limn
