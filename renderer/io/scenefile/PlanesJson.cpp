// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/scenefile/PlanesJson.h"

#include <nlohmann/json.hpp>

namespace limn {
namespace {

using Json = nlohmann::ordered_json;

constexpr Limits slabLimits{0.0, thickestSlabMm};
// Of places: a kilometre from the origin lies no patient.
constexpr Limits placeLimits{-1e6, 1e6};

Json listOf(const glm::dvec3& vector) {
  return {vector.x, vector.y, vector.z};
}

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

MeasuredDistance readDistance(JsonFields fields) {
  MeasuredDistance distance;
  fields.choice("plane", distance.plane, patientPlanes);
  fields.vector("from_mm", distance.from, placeLimits);
  fields.vector("to_mm", distance.to, placeLimits);
  fields.finish();
  return distance;
}

} // namespace

PlaneSettings readPlanes(JsonFields fields) {
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
    settings.distance = readDistance(fields.object("distance"));
  fields.finish();
  return settings;
}

Json planesJson(const PlaneSettings& settings) {
  Json json = {{"layout", nameOf(settings.layout)}, {"large", nameOf(settings.large)}};
  if (settings.crosshairMm)
    json["crosshair_mm"] = listOf(*settings.crosshairMm);
  if (settings.window)
    json["window"] = {{"centre", settings.window->centre}, {"width", settings.window->width}};
  json["interpolation"] = nameOf(settings.interpolation);
  json["slab"] = {{"mode", nameOf(settings.slab.mode)}, {"thickness_mm", settings.slab.thicknessMm}};
  json["tinted"] = settings.isTinted;
  json["region_outlined"] = settings.outlinesRegion;
  if (const auto& distance = settings.distance)
    json["distance"] = {{"plane", nameOf(distance->plane)},
                        {"from_mm", listOf(distance->from)},
                        {"to_mm", listOf(distance->to)}};
  return json;
}

} // namespace limn
