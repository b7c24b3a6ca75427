// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/scenefile/SceneFile.h"

#include "io/json/JsonFields.h"
#include "io/scenefile/SceneJson.h"
#include "scene/ProjectionFacts.h"
#include "scene/light/Shading.h"

#include <nlohmann/json.hpp>

namespace limn {
namespace {

using Json = nlohmann::ordered_json;

Json toJson(const glm::dvec3& v) {
  return Json::array({v.x, v.y, v.z});
}

Json toJson(const GradientReference& reference) {
  if (const auto* percentile = std::get_if<PercentileReference>(&reference))
    return {{"percentile", percentile->percent}};
  if (const auto* fixed = std::get_if<FixedReference>(&reference))
    return fixed->valuePerMm;
  return std::holds_alternative<LargestReference>(reference) ? "max" : "auto";
}

Json toJson(const GradientCurve& curve) {
  Json json = {{"type", gradientCurveWords.of(curve.type)}};
  if (curve.type == GradientCurve::Type::gamma)
    json["gamma"] = curve.parameter;
  if (curve.type == GradientCurve::Type::log)
    json["b"] = curve.parameter;
  return json;
}

Json toJson(const CoefficientRange& range) {
  return Json::array({range.atFlat, range.atBoundary});
}

Json lightJson(const Shading& shading) {
  if (!shading.lightDirection)
    return "headlight";
  const Json direction = toJson(*shading.lightDirection);
  return shading.lightAxes == LightAxes::camera ? Json{{"camera", direction}} : direction;
}

Json toJson(const Until& until) {
  if (const auto* paths = std::get_if<UntilPaths>(&until))
    return {{"paths", paths->paths}};
  if (const auto* levels = std::get_if<UntilLevels>(&until))
    return {{"levels", levels->levels}};
  return {{"seconds", std::get<UntilSeconds>(until).seconds}};
}

Json toJson(const PhysicalLight& light) {
  Json json{{"density", light.density},
            {"anisotropy", light.anisotropy},
            {"surface", light.surface},
            {"specular_share", light.specularShare},
            {"key_irradiance", light.keyIrradiance},
            {"key_radius_deg", light.keyRadiusDeg},
            {"sky", Json::array({light.sky.below, light.sky.above})},
            {"exposure_ev", light.exposureEv},
            {"seed", light.seed},
            {"until", toJson(light.until)}};
  if (light.filtersNoise)
    json["filter_noise"] = true;
  return json;
}

Json toJson(const Shading& shading) {
  Json json = {{"model", nameOf(shading.model)},
               {"ambient", shading.ambient},
               {"diffuse", shading.diffuse},
               {"specular", shading.specular},
               {"ambient_intensity", shading.ambientIntensity},
               {"light_intensity", shading.lightIntensity},
               {"exponent", shading.exponent},
               {"exponent_range", toJson(shading.exponentRange)},
               {"opacity_range", toJson(shading.opacityRange)},
               {"gradient_reference", toJson(shading.gradientReference)},
               {"gradient_curve", toJson(shading.gradientCurve)},
               {"energy_factor", shading.energyFactor}};
  json["significance"] =
      shading.significance ? Json::array({shading.significance->low, shading.significance->high}) : Json();
  json["knee"] = shading.knee ? Json(*shading.knee) : Json();
  json["specular_color"] = specularColorWords.of(shading.specularColor);
  json["reflection"] = reflectionWords.of(shading.reflection);
  json["two_sided"] = shading.twoSided;
  json["light_direction"] = lightJson(shading);
  if (shading.gradientSmoothing > 0.0)
    json["gradient_smoothing_mm"] = shading.gradientSmoothing;
  // Programs that know neither read what asks for neither.
  if (shading.shadow != Shadow{})
    json["shadow"] = {{"strength", shading.shadow.strength}, {"softness_deg", shading.shadow.softnessDeg}};
  if (shading.occlusion != Occlusion{})
    json["occlusion"] = {{"strength", shading.occlusion.strength}, {"reach_mm", shading.occlusion.reachMm}};
  if (shading.model == ShadingModel::physical || shading.physical != PhysicalLight{})
    json["physical"] = toJson(shading.physical);
  return json;
}

// A picture on its way has the paths that it has, and is drawn again with as many.
Shading shadingDrawn(const Scene& scene) {
  Shading shading = scene.shading;
  if (scene.quality.paths)
    shading.physical.until = UntilPaths{*scene.quality.paths};
  return shading;
}

Json toJson(const std::optional<GradientOpacity>& curve) {
  if (!curve)
    return nullptr;
  Json points = Json::array();
  for (const GradientOpacityPoint& point : curve->points)
    points.push_back({{"gradient", point.gradient}, {"opacity", point.opacity}});
  return {{"points", points}};
}

Json toJson(const ShownSides& sides) {
  Json json = {{"layout", nameOf(sides.layout)}};
  if (pictureCount(sides.layout) == 2)
    json.update({{"left", nameOf(sides.left)}, {"right", nameOf(sides.right)}, {"wipe", sides.wipe}});
  if (pictureCount(sides.layout) == 2 && sides.look)
    json["look"] = presetJson(*sides.look);
  return json;
}

Json toJson(const Fog& fog) {
  return {{"mode", fogWords.of(fog.mode)},
          {"color", toJson(fog.color)},
          {"density_per_mm", fog.densityPerMm},
          {"start_mm", fog.startMm},
          {"end_mm", fog.endMm}};
}

Json toJson(const Quality& quality) {
  Json json = {{"step_voxels", quality.stepVoxels},
               {"preintegrated", preintegrationWords.of(quality.preintegrated)},
               {"early_termination", quality.earlyTermination},
               {"jitter", quality.jitter}};
  if (quality.toleranceLevels)
    json["tolerance_levels"] = *quality.toleranceLevels;
  if (quality.fineness)
    json["fineness"] = *quality.fineness;
  if (quality.ownWeights)
    json["own_weights"] = true;
  return json;
}

} // namespace

nlohmann::ordered_json accuracyJson(const PictureAccuracy& accuracy) {
  Json json = {{"statement", accuracy.sentence}};
  const auto put = [&json](const char* key, const std::optional<double>& number) {
    if (number)
      json[key] = *number;
  };
  put("within_levels", accuracy.levels);
  if (const std::optional<AccuracyOfPaths>& paths = accuracy.paths) {
    json["paths"] = paths->count;
    put("rms_levels", paths->rmsLevels);
    put("filter_rms_levels", paths->filterRms);
    put("filter_largest_levels", paths->filterLargest);
  }
  return json;
}

nlohmann::ordered_json functionJson(const TransferFunction& function) {
  Json points = Json::array();
  for (const ControlPoint& point : function.points)
    points.push_back({{"value", point.value}, {"color", toJson(point.color)}, {"opacity", point.opacity}});
  return {{"unit_distance_mm", function.unitDistanceMm}, {"points", points}};
}

nlohmann::ordered_json sceneJson(const SceneDocument& document) {
  const Scene& scene = document.scene;
  Json json{{"limn_scene", 1}, {"volume", document.volume}};
  if (!document.orientation.empty())
    json["orientation"] = document.orientation;
  json.update(Json{{"camera", cameraJson(scene.camera)},
                   {"transfer_function", functionJson(scene.transferFunction)},
                   {"shading", toJson(shadingDrawn(scene))},
                   {"gradient_opacity", toJson(scene.gradientOpacity)},
                   {"fog", toJson(scene.fog)},
                   {"crop", {{"lower", toJson(scene.crop.lower)}, {"upper", toJson(scene.crop.upper)}}},
                   {"keep", keptPartJson(document.keep)},
                   {"projection", nameOf(scene.projection)},
                   {"isosurface", {{"value", scene.isovalue}}},
                   {"quality", toJson(scene.quality)},
                   {"image",
                    {{"width", scene.image.width},
                     {"height", scene.image.height},
                     {"background", toJson(scene.image.background)}}}});
  if (!document.measurements.empty())
    json["measurements"] = measurementsJson(document.measurements);
  if (!document.views.empty())
    json["views"] = viewsJson(document.views);
  if (document.sides)
    json["shown"] = toJson(*document.sides);
  return json;
}

SceneDocument documentOf(const Scene& scene, const std::string& volume) {
  SceneDocument document;
  document.volume = volume;
  document.scene = scene;
  document.scene.volume.reset();
  document.scene.keep = {};
  document.keep = keptPartOf(scene.keep);
  if (scene.volume)
    document.orientation = scene.volume->info().orientationByHand;
  document.hasCamera = true;
  document.hasTransferFunction = true;
  return document;
}

std::string sceneToJson(const Scene& scene, const std::string& volume,
                        const std::optional<PictureAccuracy>& accuracy) {
  return sceneToJson(documentOf(scene, volume), accuracy);
}

std::string sceneToJson(const SceneDocument& document, const std::optional<PictureAccuracy>& accuracy) {
  Json json = sceneJson(document);
  if (accuracy)
    json["accuracy"] = accuracyJson(*accuracy);
  return textOf(json);
}

std::string presetToJson(const Preset& preset) {
  Json json = {{"limn_preset", 1}};
  json.update(presetJson(preset));
  return textOf(json);
}

nlohmann::ordered_json presetJson(const Preset& preset) {
  Json json = {{"name", preset.name},
               {"modality", preset.modality},
               {"note", preset.note},
               {"transfer_function", functionJson(preset.transferFunction)}};
  if (!preset.folder.empty())
    json["folder"] = preset.folder;
  if (preset.gradientOpacity)
    json["gradient_opacity"] = toJson(preset.gradientOpacity);
  if (preset.shading)
    json["shading"] = toJson(*preset.shading);
  if (preset.projection)
    json["projection"] = nameOf(*preset.projection);
  if (preset.isovalue)
    json["isosurface"] = {{"value", *preset.isovalue}};
  if (preset.landmarks)
    json["landmarks"] = {{"background", preset.landmarks->background},
                         {"object", preset.landmarks->object},
                         {"brightest", preset.landmarks->brightest}};
  return json;
}

Json planesJson(const PlaneSettings& settings) {
  Json json = {{"layout", nameOf(settings.layout)}, {"large", nameOf(settings.large)}};
  if (settings.crosshairMm)
    json["crosshair_mm"] = toJson(*settings.crosshairMm);
  if (settings.window)
    json["window"] = {{"centre", settings.window->centre}, {"width", settings.window->width}};
  json["interpolation"] = nameOf(settings.interpolation);
  json["slab"] = {{"mode", nameOf(settings.slab.mode)}, {"thickness_mm", settings.slab.thicknessMm}};
  json["tinted"] = settings.isTinted;
  json["region_outlined"] = settings.outlinesRegion;
  return json;
}

} // namespace limn
