// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/scenefile/SceneFile.h"

#include "io/reading/ReadError.h"
#include "io/scenefile/SceneJson.h"
#include "scene/ProjectionFacts.h"
#include "scene/light/Shading.h"
#include "scene/steps/LocalSteps.h"
#include "scene/volume/Orientation.h"

#include <nlohmann/json.hpp>

#include <fstream>
#include <limits>

namespace limn {
namespace {

constexpr Limits exponentLimits{0.0, 1024.0, true};
constexpr Limits coefficientLimits{0.0, 8.0};

void readRange(JsonFields& fields, const std::string& key, CoefficientRange& range, const Limits& limits) {
  if (fields.pair(key, range.atFlat, range.atBoundary, limits) && range.atFlat > range.atBoundary)
    fields.fail(key, Message::tr("must name the smaller number first"));
}

GradientReference readGradientReference(JsonFields& shading) {
  const nlohmann::json& value = shading.child("gradient_reference");
  if (value == "auto")
    return AutomaticReference{};
  if (value == "max")
    return LargestReference{};
  if (value.is_object()) {
    PercentileReference reference;
    JsonFields fields = shading.object("gradient_reference");
    if (!fields.number("percentile", reference.percent, {0.0, 100.0, true}))
      fields.fail("percentile", Message::tr("is missing"));
    fields.finish();
    return reference;
  }
  FixedReference reference;
  if (!value.is_number())
    shading.fail("gradient_reference",
                 Message::tr("must be \"auto\", \"max\", {\"percentile\": p} or a number in value/mm"));
  shading.number("gradient_reference", reference.valuePerMm, positive);
  return reference;
}

GradientCurve readGradientCurve(JsonFields fields) {
  GradientCurve curve;
  fields.choice("type", curve.type, gradientCurveWords);
  if (curve.type == GradientCurve::Type::gamma)
    fields.number("gamma", curve.parameter, positive);
  if (curve.type == GradientCurve::Type::log)
    fields.number("b", curve.parameter, positive);
  fields.finish();
  return curve;
}

void readLightDirection(JsonFields& fields, Shading& shading) {
  if (!fields.has("light_direction"))
    return;
  shading.lightAxes = LightAxes::world;
  if (fields.child("light_direction") == "headlight") {
    shading.lightDirection.reset();
    return;
  }
  glm::dvec3 direction(0.0);
  if (fields.child("light_direction").is_object()) {
    JsonFields axes = fields.object("light_direction");
    axes.vector("camera", direction);
    axes.finish();
    shading.lightAxes = LightAxes::camera;
  } else {
    fields.vector("light_direction", direction);
  }
  // However short, a direction is one; the square of its length may be 0.
  if (direction == glm::dvec3(0.0))
    fields.fail("light_direction",
                Message::tr("must be \"headlight\", or a direction that is not zero, in world axes or as "
                            "{\"camera\": [right, up, forward]}"));
  shading.lightDirection = direction;
}

void readTravellingLight(JsonFields& fields, Shading& shading) {
  if (fields.has("shadow")) {
    JsonFields shadow = fields.object("shadow");
    shadow.number("strength", shading.shadow.strength, fraction);
    shadow.number("softness_deg", shading.shadow.softnessDeg, {0.0, 45.0});
    shadow.finish();
  }
  if (fields.has("occlusion")) {
    JsonFields occlusion = fields.object("occlusion");
    occlusion.number("strength", shading.occlusion.strength, fraction);
    occlusion.number("reach_mm", shading.occlusion.reachMm, {0.0, 1e6, true});
    occlusion.finish();
  }
}

Until readUntil(JsonFields fields) {
  Until until;
  int given = 0;
  if (fields.has("paths")) {
    fields.integer("paths", until.emplace<UntilPaths>().paths, 1, mostPaths);
    ++given;
  }
  if (fields.has("levels")) {
    fields.number("levels", until.emplace<UntilLevels>().levels, {0.0, 255.0, true});
    ++given;
  }
  if (fields.has("seconds")) {
    fields.number("seconds", until.emplace<UntilSeconds>().seconds, {0.0, mostPathSeconds, true});
    ++given;
  }
  fields.finish();
  if (given != 1)
    fields.fail(given == 0 ? "paths" : "levels",
                Message::tr("must be the only end: {\"paths\": n}, {\"levels\": x} or {\"seconds\": s}"));
  return until;
}

PhysicalLight readPhysicalLight(JsonFields fields) {
  PhysicalLight light;
  fields.number("density", light.density, {0.01, 100.0});
  fields.number("anisotropy", light.anisotropy, {-0.95, 0.95});
  fields.number("surface", light.surface, fraction);
  fields.number("specular_share", light.specularShare, fraction);
  fields.number("key_irradiance", light.keyIrradiance, {0.0, 1e6});
  fields.number("key_radius_deg", light.keyRadiusDeg, {0.0, 45.0});
  fields.pair("sky", light.sky.below, light.sky.above, {0.0, 1e6});
  fields.number("exposure_ev", light.exposureEv, {-20.0, 20.0});
  int seed = static_cast<int>(light.seed);
  fields.integer("seed", seed, 0, std::numeric_limits<int>::max());
  light.seed = static_cast<std::uint32_t>(seed);
  if (fields.has("until"))
    light.until = readUntil(fields.object("until"));
  fields.boolean("filter_noise", light.filtersNoise);
  fields.finish();
  return light;
}

void readRobustFields(JsonFields& fields, Shading& shading) {
  fields.boolean("energy_factor", shading.energyFactor);
  if (fields.has("significance")) {
    shading.significance.reset();
    Significance window;
    if (!fields.child("significance").is_null()) {
      fields.pair("significance", window.low, window.high, fraction);
      if (!(window.low < window.high))
        fields.fail("significance", Message::tr("must name the smaller number first"));
      shading.significance = window;
    }
  }
  if (fields.has("knee")) {
    shading.knee.reset();
    double knee = 0.0;
    if (!fields.child("knee").is_null()) {
      fields.number("knee", knee, {0.0, 0.999});
      shading.knee = knee;
    }
  }
}

Shading readShading(JsonFields fields) {
  Shading shading;
  fields.choice("model", shading.model, shadingModels);
  fields.number("ambient", shading.ambient, notNegative);
  fields.number("diffuse", shading.diffuse, notNegative);
  fields.number("specular", shading.specular, notNegative);
  fields.number("ambient_intensity", shading.ambientIntensity, notNegative);
  fields.number("light_intensity", shading.lightIntensity, notNegative);
  fields.number("exponent", shading.exponent, exponentLimits);
  readRange(fields, "exponent_range", shading.exponentRange, exponentLimits);
  readRange(fields, "opacity_range", shading.opacityRange, coefficientLimits);
  if (fields.has("gradient_reference"))
    shading.gradientReference = readGradientReference(fields);
  if (fields.has("gradient_curve"))
    shading.gradientCurve = readGradientCurve(fields.object("gradient_curve"));
  fields.number("gradient_smoothing_mm", shading.gradientSmoothing, {0.0, mostGradientSmoothing});
  readRobustFields(fields, shading);
  fields.choice("specular_color", shading.specularColor, specularColorWords);
  fields.choice("reflection", shading.reflection, reflectionWords);
  fields.boolean("two_sided", shading.twoSided);
  readLightDirection(fields, shading);
  readTravellingLight(fields, shading);
  if (fields.has("physical"))
    shading.physical = readPhysicalLight(fields.object("physical"));
  fields.finish();
  return shading;
}

std::optional<GradientOpacity> readGradientOpacity(JsonFields& parent) {
  if (parent.child("gradient_opacity").is_null())
    return std::nullopt;
  JsonFields fields = parent.object("gradient_opacity");
  GradientOpacity curve;
  if (!fields.has("points") || !fields.child("points").is_array())
    fields.fail("points", Message::tr("must be a list of points with gradient and opacity"));
  for (const nlohmann::json& item : fields.child("points")) {
    JsonFields point(item, fields.document(), placeIn("gradient_opacity.points", curve.points.size()));
    GradientOpacityPoint control;
    if (!point.number("gradient", control.gradient, notNegative))
      point.fail("gradient", Message::tr("is missing"));
    point.number("opacity", control.opacity, fraction);
    point.finish();
    if (!curve.points.empty() && control.gradient < curve.points.back().gradient)
      point.fail("gradient", Message::tr("must not be smaller than that of the point before"));
    curve.points.push_back(control);
  }
  fields.finish();
  return curve;
}

Fog readFog(JsonFields fields) {
  Fog fog;
  fields.choice("mode", fog.mode, fogWords);
  fields.vector("color", fog.color, fraction);
  fields.number("density_per_mm", fog.densityPerMm, notNegative);
  fields.number("start_mm", fog.startMm);
  fields.number("end_mm", fog.endMm);
  fields.finish();
  return fog;
}

CropBox readCrop(JsonFields fields) {
  CropBox crop;
  fields.vector("lower", crop.lower, fraction);
  fields.vector("upper", crop.upper, fraction);
  for (int axis = 0; axis < 3; ++axis)
    if (!(crop.lower[axis] < crop.upper[axis]))
      fields.fail("lower", Message::tr("must be smaller than \"crop.upper\" on every axis"));
  fields.finish();
  return crop;
}

bool readProjection(JsonFields& fields, Projection& projection) {
  return fields.choice("projection", projection, projections);
}

// A fineness belongs to the tolerance for which it was found.
void readTolerance(JsonFields& fields, Quality& quality) {
  if (fields.has("tolerance_levels"))
    fields.number("tolerance_levels", quality.toleranceLevels.emplace(), {0.0, 255.0, true});
  if (!fields.has("fineness"))
    return;
  if (!quality.toleranceLevels)
    fields.fail("fineness", Message::tr("needs a tolerance_levels beside it"));
  fields.number("fineness", quality.fineness.emplace(), {Fineness::least, Fineness::most});
}

Quality readQuality(JsonFields fields) {
  Quality quality;
  fields.number("step_voxels", quality.stepVoxels, {0.0, 1e6, true});
  fields.choice("preintegrated", quality.preintegrated, preintegrationWords);
  fields.number("early_termination", quality.earlyTermination, {0.0, 1.0, true});
  fields.boolean("jitter", quality.jitter);
  readTolerance(fields, quality);
  fields.boolean("own_weights", quality.ownWeights);
  fields.finish();
  return quality;
}

ImageSettings readImageSettings(JsonFields fields) {
  ImageSettings image;
  fields.integer("width", image.width, 1, 16384);
  fields.integer("height", image.height, 1, 16384);
  fields.vector("background", image.background, fraction);
  fields.finish();
  return image;
}

bool readIsovalue(JsonFields& fields, double& isovalue) {
  if (!fields.has("isosurface"))
    return false;
  JsonFields isosurface = fields.object("isosurface");
  const bool isGiven = isosurface.number("value", isovalue);
  isosurface.finish();
  return isGiven;
}

constexpr Limits slabLimits{0.0, thickestSlabMm};
constexpr Limits accuracyLimits{0.0, 255.0};

GreyWindow readGreyWindow(JsonFields fields) {
  GreyWindow window;
  fields.number("centre", window.centre);
  fields.number("width", window.width, positive);
  fields.finish();
  return window;
}

Slab readSlab(JsonFields fields) {
  Slab slab;
  fields.choice("mode", slab.mode, slabModes);
  fields.number("thickness_mm", slab.thicknessMm, slabLimits);
  fields.finish();
  return slab;
}

// A look that leaves light open has that of the scene.
ShownSides readSides(JsonFields fields, const Shading& shading) {
  ShownSides sides;
  fields.choice("layout", sides.layout, compareLayouts);
  fields.choice("left", sides.left, shadingModels);
  fields.choice("right", sides.right, shadingModels);
  fields.number("wipe", sides.wipe, fraction);
  if (fields.has("look")) {
    JsonFields its = fields.object("look");
    Preset& look = sides.look.emplace(readPreset(its));
    look.isWhole = true;
    if (!look.shading)
      look.shading = shading;
    look.shading->model = sides.left;
  }
  fields.finish();
  return sides;
}

} // namespace

std::string placeIn(const char* list, std::size_t index) {
  return std::string(list).append("[").append(std::to_string(index)).append("]");
}

TransferFunction readTransferFunction(JsonFields fields, const std::string& where) {
  TransferFunction function;
  const std::string list = where + ".points";
  fields.number("unit_distance_mm", function.unitDistanceMm, positive);
  if (fields.has("points")) {
    const nlohmann::json& points = fields.child("points");
    if (!points.is_array())
      fields.fail("points", Message::tr("must be a list of control points"));
    for (const nlohmann::json& item : points) {
      JsonFields point(item, fields.document(), placeIn(list.c_str(), function.points.size()));
      ControlPoint control;
      if (!point.number("value", control.value))
        point.fail("value", Message::tr("is missing"));
      point.vector("color", control.color, fraction);
      point.number("opacity", control.opacity, fraction);
      point.finish();
      function.points.push_back(control);
    }
  }
  fields.finish();
  return normalised(std::move(function));
}

PictureAccuracy readAccuracy(JsonFields fields) {
  PictureAccuracy accuracy;
  AccuracyOfPaths paths;
  const auto levels = [&](const char* key, std::optional<double>& target) {
    if (double number = 0.0; fields.number(key, number, accuracyLimits))
      target = number;
  };
  levels("within_levels", accuracy.levels);
  levels("rms_levels", paths.rmsLevels);
  levels("filter_rms_levels", paths.filterRms);
  levels("filter_largest_levels", paths.filterLargest);
  if (double count = 0.0; fields.number("paths", count, positive)) {
    paths.count = static_cast<int>(std::min<double>(count, std::numeric_limits<int>::max()));
    accuracy.paths = paths;
  }
  fields.text("statement", accuracy.sentence);
  fields.finish();
  return accuracy;
}

SceneDocument readScene(JsonFields fields) {
  requireVersion(fields, "limn_scene", Message::tr("scene"));
  SceneDocument document;
  Scene& scene = document.scene;
  if (!fields.text("volume", document.volume) || document.volume.empty())
    fields.fail("volume", Message::tr("is missing, which names the file or folder of the volume"));
  if (fields.text("orientation", document.orientation) && !areAxisLetters(document.orientation))
    fields.fail("orientation",
                Message::tr("must be three letters, one of L and R, one of P and A, one of S and I"));
  document.hasCamera = fields.has("camera");
  if (document.hasCamera)
    scene.camera = readCamera(fields.object("camera"));
  document.hasTransferFunction = fields.has("transfer_function");
  if (document.hasTransferFunction)
    scene.transferFunction = readTransferFunction(fields.object("transfer_function"), "transfer_function");
  if (fields.has("shading"))
    scene.shading = readShading(fields.object("shading"));
  if (fields.has("gradient_opacity"))
    scene.gradientOpacity = readGradientOpacity(fields);
  if (fields.has("fog"))
    scene.fog = readFog(fields.object("fog"));
  if (fields.has("crop"))
    scene.crop = readCrop(fields.object("crop"));
  if (fields.has("keep"))
    document.keep = readKeptPart(fields);
  readProjection(fields, scene.projection);
  readIsovalue(fields, scene.isovalue);
  if (fields.has("quality"))
    scene.quality = readQuality(fields.object("quality"));
  if (fields.has("image"))
    scene.image = readImageSettings(fields.object("image"));
  document.measurements = readMeasurements(fields);
  if (fields.has("views"))
    document.views = readViews(fields);
  if (fields.has("accuracy"))
    readAccuracy(fields.object("accuracy"));
  if (fields.has("shown"))
    document.sides = readSides(fields.object("shown"), scene.shading);
  fields.finish();
  return document;
}

SceneDocument parseScene(std::string_view text, const std::string& name) {
  const nlohmann::json json = parsedJson(text, name);
  return readScene(JsonFields(json, name, ""));
}

std::optional<PictureAccuracy> accuracyIn(std::string_view text, const std::string& name) {
  const nlohmann::json json = parsedJson(text, name);
  JsonFields fields(json, name, "");
  return fields.has("accuracy") ? std::optional(readAccuracy(fields.object("accuracy"))) : std::nullopt;
}

SceneDocument readSceneFile(const std::filesystem::path& path) {
  return located(parseScene(readTextFile(path), path.filename().string()), path);
}

SceneDocument located(SceneDocument document, const std::filesystem::path& file) {
  const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
  for (std::string* path : {&document.volume, &document.keep.labels})
    if (!path->empty())
      *path = (folder / *path).lexically_normal().string();
  for (std::string& path : document.keep.moreLabels)
    path = (folder / path).lexically_normal().string();
  return document;
}

bool looksLikeScene(std::string_view text) {
  const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  return json.is_object() && json.contains("limn_scene");
}

static Landmarks readLandmarks(JsonFields& fields) {
  Landmarks landmarks;
  JsonFields values = fields.object("landmarks");
  values.number("background", landmarks.background);
  values.number("object", landmarks.object);
  values.number("brightest", landmarks.brightest);
  values.finish();
  if (!(landmarks.background < landmarks.object && landmarks.object < landmarks.brightest))
    fields.fail("landmarks", Message::tr("must ascend: background, object, brightest"));
  return landmarks;
}

Preset parsePreset(std::string_view text, const std::string& name) {
  const nlohmann::json json = parsedJson(text, name);
  JsonFields fields(json, name, "");
  requireVersion(fields, "limn_preset", Message::tr("preset"));
  return readPreset(fields);
}

Preset readPreset(JsonFields& fields) {
  Preset preset;
  if (!fields.text("name", preset.name) || preset.name.empty())
    fields.fail("name", Message::tr("is missing"));
  fields.text("modality", preset.modality);
  fields.text("note", preset.note);
  fields.text("folder", preset.folder);
  if (!fields.has("transfer_function"))
    fields.fail("transfer_function", Message::tr("is missing"));
  preset.transferFunction = readTransferFunction(fields.object("transfer_function"), "transfer_function");
  if (fields.has("gradient_opacity"))
    preset.gradientOpacity = readGradientOpacity(fields);
  if (fields.has("shading"))
    preset.shading = readShading(fields.object("shading"));
  Projection projection = Projection::composite;
  if (readProjection(fields, projection))
    preset.projection = projection;
  double isovalue = 0.0;
  if (readIsovalue(fields, isovalue))
    preset.isovalue = isovalue;
  if (fields.has("landmarks"))
    preset.landmarks = readLandmarks(fields);
  fields.finish();
  return preset;
}

PlaneSettings readPlanes(JsonFields fields, std::vector<Measurement>& measurements) {
  PlaneSettings settings;
  fields.choice("layout", settings.layout, planeLayouts);
  fields.choice("large", settings.large, patientPlanes);
  if (fields.has("crosshair_mm"))
    fields.vector("crosshair_mm", settings.crosshairMm.emplace(), placeLimits);
  if (fields.has("window"))
    settings.window = readGreyWindow(fields.object("window"));
  fields.choice("interpolation", settings.interpolation, planeInterpolations);
  if (fields.has("slab"))
    settings.slab = readSlab(fields.object("slab"));
  fields.boolean("tinted", settings.isTinted);
  fields.boolean("region_outlined", settings.outlinesRegion);
  if (fields.has("distance"))
    measurements.push_back(readOldDistance(fields.object("distance")));
  fields.finish();
  return settings;
}

std::string readTextFile(const std::filesystem::path& path, std::size_t limit) {
  // Settings and scenes may lie where only their owner looks: the name says enough.
  const std::filesystem::path name = path.filename();
  std::error_code failed;
  const auto size = std::filesystem::file_size(path, failed);
  if (failed)
    failReading(name, Message::tr("there is no such file"), Message::tr("check the path"));
  if (size > limit)
    failReading(name, Message::tr("it is far larger than any file of this kind"),
                Message::tr("choose another file"));
  std::ifstream file(path, std::ios::binary);
  std::string text(size, '\0');
  if (!file.read(text.data(), static_cast<std::streamsize>(size)))
    failReading(name, Message::tr("it cannot be opened"), Message::tr("check that you may read it"));
  return text;
}

} // namespace limn
