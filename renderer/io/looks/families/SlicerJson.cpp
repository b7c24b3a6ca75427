// SPDX-License-Identifier: GPL-3.0-or-later
// 3D Slicer's volume properties as JSON, its default since 5.4 (schema volume-property 1.0.0).
#include "io/json/JsonFields.h"
#include "io/looks/curves/LookCurves.h"
#include "io/looks/families/Families.h"
#include "io/looks/families/VtkProperty.h"
#include "io/reading/ReadError.h"

#include <nlohmann/json.hpp>

namespace limn {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr const char* schema =
    "https://raw.githubusercontent.com/Slicer/Slicer/main/Modules/Loadable/VolumeRendering/Resources/Schema/"
    "volume-property-schema-v1.0.0.json#";
constexpr double noClippedIntensity = -1e10; // Slicer's default: air

bool isSlicerJson(std::string_view text) {
  return text.find("\"volumeProperties\"") != std::string_view::npos;
}

// The list under a key; an empty one where there is none.
const json& listIn(JsonFields& fields, const std::string& key) {
  static const json none = json::array();
  if (!fields.has(key))
    return none;
  if (!fields.child(key).is_array())
    fields.fail(key, Message::tr("must be a list"));
  return fields.child(key);
}

std::vector<BentPoint> curveIn(JsonFields& component, const std::string& key) {
  std::vector<BentPoint> points;
  if (!component.has(key))
    return points;
  JsonFields curve = component.object(key);
  for (const json& item : listIn(curve, "points")) {
    JsonFields fields(item, curve.document(), key + ".points");
    BentPoint bent;
    if (!fields.number("x", bent.point.value))
      fields.fail("x", Message::tr("is missing"));
    const bool hasOpacity = fields.number("y", bent.point.opacity);
    if (!fields.vector("color", bent.point.color) && !hasOpacity)
      fields.fail("y", Message::tr("is missing"));
    fields.number("midpoint", bent.midpoint);
    fields.number("sharpness", bent.sharpness);
    points.push_back(bent);
  }
  return points;
}

HeadLight lightIn(JsonFields& component) {
  HeadLight light;
  component.boolean("shade", light.isOn);
  if (!component.has("lighting"))
    return light;
  JsonFields fields = component.object("lighting");
  fields.number("ambient", light.ambient);
  fields.number("diffuse", light.diffuse);
  fields.number("specular", light.specular);
  fields.number("specularPower", light.exponent);
  return light;
}

VtkProperty componentIn(JsonFields& component) {
  VtkProperty property;
  property.opacity = curveIn(component, "scalarOpacity");
  property.color = curveIn(component, "rgbTransferFunction");
  property.gradientOpacity = curveIn(component, "gradientOpacity");
  component.boolean("disableGradientOpacity", property.gradientOpacityIsOff);
  property.light = lightIn(component);
  property.unitDistanceMm = 1.0; // VTK's default
  component.number("scalarOpacityUnitDistance", *property.unitDistanceMm);
  return property;
}

// What beside its first component Limn does not draw.
std::vector<Message> lostIn(JsonFields& property, JsonFields& component, std::size_t components) {
  std::vector<Message> lost;
  std::string interpolation = "linear";
  property.text("interpolationType", interpolation);
  if (interpolation != "linear")
    tell(lost, Message::tr("Its interpolation \"%1\" became linear.").arg(plainText(interpolation, 40)));
  if (components > 1)
    tell(lost, Message::tr("Of its %1 components only the first was taken.").arg(components));
  if (!listIn(property, "isoSurfaceValues").empty())
    tell(lost, Message::tr("Its isosurfaces were left out."));
  double anisotropy = 0.0;
  if (property.number("scatteringAnisotropy", anisotropy) && anisotropy != 0.0)
    tell(lost, Message::tr("Its scattering was left out."));
  bool usesClipped = true;
  double clipped = noClippedIntensity;
  property.boolean("useClippedVoxelIntensity", usesClipped);
  property.number("clippedVoxelIntensity", clipped);
  if (usesClipped && clipped != noClippedIntensity)
    tell(lost, Message::tr("The value that it gives clipped voxels was left out."));
  double weight = 1.0;
  if (component.number("componentWeight", weight) && weight != 1.0)
    tell(lost, Message::tr("The weight of its component was left out."));
  return lost;
}

std::vector<ReadLook> readSlicerJson(std::string_view text, const std::string& name,
                                     const std::optional<LookTarget>& target) {
  const json document = parsedJson(text, name);
  JsonFields fields(document, name, "");
  std::vector<ReadLook> looks;
  for (const json& item : listIn(fields, "volumeProperties")) {
    JsonFields property(item, name, "volumeProperties[" + std::to_string(looks.size()) + "]");
    const json& components = listIn(property, "components");
    if (components.empty())
      failReading(name, Message::tr("a volume property in it has no components"), saveLookAgain);
    JsonFields component(components.front(), name, "components[0]");
    std::vector<Message> lost = lostIn(property, component, components.size());
    looks.push_back(lookOf(componentIn(component), name, looks.size(), target, std::move(lost)));
  }
  if (looks.empty())
    failReading(name, Message::tr("it holds no volume property"), saveLookAgain);
  return looks;
}

ordered_json opacityJson(const std::vector<BentPoint>& curve) {
  ordered_json points = ordered_json::array();
  for (const BentPoint& bent : curve)
    points.push_back(
        {{"x", bent.point.value}, {"y", bent.point.opacity}, {"midpoint", 0.5}, {"sharpness", 0.0}});
  return {{"points", points}};
}

ordered_json colorJson(const std::vector<BentPoint>& curve) {
  ordered_json points = ordered_json::array();
  for (const BentPoint& bent : curve)
    points.push_back({{"x", bent.point.value},
                      {"color", {bent.point.color.r, bent.point.color.g, bent.point.color.b}},
                      {"midpoint", 0.5},
                      {"sharpness", 0.0}});
  return {{"points", points}};
}

WrittenLook writeSlicerJson(const Preset& preset, const std::optional<LookTarget>& target) {
  WrittenLook written;
  const VtkProperty property = vtkPropertyOf(preset, true, target, written.changes);
  const ordered_json component{{"componentWeight", 1.0},
                               {"shade", property.light.isOn},
                               {"lighting",
                                {{"ambient", property.light.ambient},
                                 {"diffuse", property.light.diffuse},
                                 {"specular", property.light.specular},
                                 {"specularPower", property.light.exponent}}},
                               {"disableGradientOpacity", !preset.gradientOpacity.has_value()},
                               {"scalarOpacityUnitDistance", *property.unitDistanceMm},
                               {"scalarOpacity", opacityJson(property.opacity)},
                               {"gradientOpacity", opacityJson(property.gradientOpacity)},
                               {"rgbTransferFunction", colorJson(property.color)}};
  const ordered_json whole{
      {"effectiveRange", {property.opacity.front().point.value, property.opacity.back().point.value}},
      {"isoSurfaceValues", ordered_json::array()},
      {"independentComponents", true},
      {"interpolationType", "linear"},
      {"useClippedVoxelIntensity", true},
      {"clippedVoxelIntensity", noClippedIntensity},
      {"scatteringAnisotropy", 0.0},
      {"components", ordered_json::array({component})}};
  written.text = textOf({{"@schema", schema}, {"volumeProperties", ordered_json::array({whole})}});
  return written;
}

} // namespace

LookFormat slicerJsonFormat() {
  return {
      Message::tr("3D Slicer volume property"), {".vp.json"}, isSlicerJson, readSlicerJson, writeSlicerJson};
}

} // namespace limn
