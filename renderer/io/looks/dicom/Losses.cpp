// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/dicom/Losses.h"

#include "io/looks/dicom/ColourTable.h"
#include "io/looks/dicom/GeometryModule.h"
#include "scene/effects/EffectPlan.h"
#include "scene/light/LightingTerms.h"

namespace limn {
namespace {

using Sentences = std::vector<Message>;

bool isByGradient(ShadingModel model) {
  return model == ShadingModel::enhanced || model == ShadingModel::robust;
}

void addModel(const Shading& shading, Sentences& losses) {
  if (shading.model == ShadingModel::physical)
    losses.push_back(Message::tr("Physical light is not kept: the model is written as classic."));
  if (!isByGradient(shading.model))
    return;
  losses.push_back(Message::tr("The model is written as classic: exponents by gradient are not kept."));
  losses.push_back(Message::tr("Opacity by gradient (O) is not kept: the curve's own opacity is written."));
  if (shading.model == ShadingModel::robust)
    losses.push_back(
        Message::tr("What robust adds (energy factor, significance, knee) is not kept: sums are clamped."));
}

void addLight(const Scene& scene, Sentences& losses) {
  const Shading& shading = scene.shading;
  if (shading.model == ShadingModel::none)
    return;
  if (shading.reflection == Reflection::blinn && shading.specular > 0.0)
    losses.push_back(Message::tr(
        "Highlights are written as Phong's, with a quarter of the exponent of Blinn-Phong, as wide."));
  if (shading.specularColor == SpecularColor::material && shading.specular > 0.0)
    losses.push_back(Message::tr("Highlights in the material's colour are not kept: they are white."));
  if (!shading.lightDirection)
    losses.push_back(
        scene.camera.projection == Camera::Projection::perspective
            ? Message::tr(
                  "The headlight is written as parallel light along the view, so it no longer follows "
                  "the camera, and towards the edges of the picture it differs.")
            : Message::tr(
                  "The headlight is written as light along the view, so it no longer follows the camera."));
  if (shading.lightDirection && shading.lightAxes == LightAxes::camera)
    losses.push_back(Message::tr("The light no longer turns with the camera: it stays where it is now."));
  const LightingTerms terms = lightingTerms(shading);
  if (terms.shadow.strength > 0.0)
    losses.push_back(Message::tr("Shadows are not kept."));
  if (terms.occlusion.strength > 0.0)
    losses.push_back(Message::tr("Occlusion is not kept: ambient light reaches everything alike."));
  if (smoothsNormals(scene))
    losses.push_back(Message::tr("Smooth normals are not kept: terraces of thick slices show in the light."));
  const double light = shading.lightIntensity;
  if (shading.ambient * shading.ambientIntensity > 1.0 || shading.diffuse * light > 1.0 ||
      shading.specular * light > 1.0)
    losses.push_back(Message::tr("Coefficients times intensity above 1 are limited to 1."));
}

void addCurve(const Scene& scene, Sentences& losses) {
  const double stepMm = scene.quality.stepVoxels * smallestSpacingMm(scene.volume->grid());
  const int entries = entriesFor(scene.volume->range());
  losses.push_back(Message::tr("The curve is written as a table of %1 entries over the values of the volume.")
                       .arg(entries));
  if (scene.transferFunction.unitDistanceMm != stepMm)
    losses.push_back(
        Message::tr("The unit distance of %1 mm is not kept: opacities are written over the step of %2 mm.")
            .arg(Message::rounded(scene.transferFunction.unitDistanceMm, 4), Message::rounded(stepMm, 4)));
  if (scene.gradientOpacity)
    losses.push_back(Message::tr("The gradient opacity is not kept."));
}

void addRays(const Scene& scene, Sentences& losses) {
  if (scene.projection == Projection::average)
    losses.push_back(Message::tr("The average is not kept: the look is a composite."));
  if (scene.projection == Projection::xray)
    losses.push_back(Message::tr("The X-ray is not kept: the look is a composite."));
  if (scene.projection == Projection::isosurface || scene.projection == Projection::compositeIsosurface)
    losses.push_back(Message::tr("The isosurface is not kept: the look is a composite."));
  if (scene.fog.mode != Fog::Mode::none)
    losses.push_back(Message::tr("The fog is not kept."));
  if (scene.keep.kind == Region::Kind::body)
    losses.push_back(Message::tr("That the body alone is kept is lost: table and holder are shown."));
  if (scene.keep.kind == Region::Kind::labels)
    losses.push_back(Message::tr(
        "The kept labels are lost, for Limn as well: a look names no label map; save the scene beside it."));
}

void addLooks(const Region& keep, Sentences& losses) {
  if (!keep.looks.empty())
    losses.push_back(Message::tr("The looks of labels are not kept: one curve is written for all of them."));
}

void addCuts(const Region& keep, Sentences& losses) {
  if (isCutAway(keep))
    losses.push_back(Message::tr("What was cut away by hand is shown by other programs."));
}

void addQuality(const Scene& scene, Sentences& losses) {
  const Quality& quality = scene.quality;
  if (quality.toleranceLevels)
    losses.push_back(Message::tr("The error wished for is not kept: steps are equal."));
  if (quality.jitter)
    losses.push_back(Message::tr("The jitter is not kept."));
  if (quality.preintegrated == Preintegration::always)
    losses.push_back(Message::tr("That the curve is pre-integrated is not kept."));
  if (quality.earlyTermination < 1.0)
    losses.push_back(Message::tr("Where rays end early is left to the program that draws."));
  losses.push_back(Message::tr("The background is not kept."));
  losses.push_back(Message::tr("Of the picture's size only the shape is kept, not its pixels."));
}

void addCamera(const Scene& scene, Sentences& losses) {
  const ValueRange depths = dicom::depthsOf(scene.camera, scene.volume->grid());
  if (depths.lowest <= 0.0)
    losses.push_back(
        Message::tr("The near plane lies just before the eye, which is within the volume or beside it."));
}

} // namespace

std::vector<Message> lossesOf(const Scene& scene) {
  Sentences losses;
  addModel(scene.shading, losses);
  addLight(scene, losses);
  addCurve(scene, losses);
  addRays(scene, losses);
  addLooks(scene.keep, losses);
  addCuts(scene.keep, losses);
  addQuality(scene, losses);
  addCamera(scene, losses);
  return losses;
}

} // namespace limn
