// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/families/VtkProperty.h"

#include "io/looks/curves/LookCurves.h"
#include "io/looks/curves/LookUnits.h"
#include "io/reading/ReadError.h"

#include <array>
#include <cmath>

namespace limn {
namespace {

std::vector<ControlPoint> straightCurve(std::vector<BentPoint> points, const std::string& file,
                                        std::vector<Message>& changes) {
  return straightened(checkedCurve(std::move(points), file, changes), {}, file, changes);
}

std::optional<GradientOpacity> gradientOpacityOf(VtkProperty& property, const std::string& file,
                                                 const std::optional<LookTarget>& target,
                                                 std::vector<Message>& changes) {
  if (property.gradientOpacity.empty())
    return std::nullopt;
  std::vector<Message> onTheWay;
  std::optional<GradientOpacity> opacity = gradientOpacityFromVtk(
      straightCurve(std::move(property.gradientOpacity), file, onTheWay), target, onTheWay);
  if (opacity && property.gradientOpacityIsOff) {
    tell(changes, Message::tr("Its gradient opacity, which is switched off there, was left out."));
    return std::nullopt;
  }
  for (const Message& sentence : onTheWay)
    tell(changes, sentence);
  return opacity;
}

void requireFinite(const HeadLight& light, const std::string& file) {
  for (const double number : {light.ambient, light.diffuse, light.specular, light.exponent})
    if (!std::isfinite(number))
      failReading(file, Message::tr("a number of its light is not finite"), saveLookAgain);
}

} // namespace

std::string modalityIn(const std::string& name) {
  const std::string word = name.substr(0, name.find_first_of(" -_"));
  constexpr std::array words{std::pair{"CT", "CT"},  std::pair{"CTA", "CT"}, std::pair{"MR", "MR"},
                             std::pair{"MRI", "MR"}, std::pair{"DTI", "MR"}, std::pair{"PET", "PT"},
                             std::pair{"PT", "PT"},  std::pair{"US", "US"}};
  for (const auto& [start, modality] : words)
    if (word == start)
      return modality;
  return "";
}

ReadLook lookOf(VtkProperty property, const std::string& file, std::size_t index,
                const std::optional<LookTarget>& target, std::vector<Message> changes) {
  requireFinite(property.light, file);
  const double unitDistance = property.unitDistanceMm.value_or(1.0);
  if (!(unitDistance > 0.0) || !std::isfinite(unitDistance))
    failReading(file, Message::tr("the length over which its opacities hold is not a positive number"),
                saveLookAgain);
  ReadLook look;
  look.preset.name = property.name.empty() ? lookNameOf(file, index) : plainText(property.name, 200);
  look.preset.modality = modalityIn(look.preset.name);
  look.preset.transferFunction = merged(straightCurve(std::move(property.opacity), file, changes),
                                        straightCurve(std::move(property.color), file, changes), changes);
  look.preset.transferFunction.unitDistanceMm = unitDistance;
  if (!property.unitDistanceMm)
    tell(changes, oneMillimetreTaken);
  look.preset.gradientOpacity = gradientOpacityOf(property, file, target, changes);
  look.preset.shading = shadingOf(property.light, changes);
  look.changes = std::move(changes);
  return look;
}

VtkProperty vtkPropertyOf(const Preset& preset, bool holdsUnitDistance,
                          const std::optional<LookTarget>& target, std::vector<Message>& changes) {
  VtkProperty property;
  property.name = preset.name;
  TransferFunction function = preset.transferFunction;
  if (holdsUnitDistance)
    property.unitDistanceMm = function.unitDistanceMm;
  else
    function = overOneMillimetre(function, changes);
  if (function.points.empty())
    function.points = {{}}; // as transparent
  for (const ControlPoint& point : function.points) {
    property.opacity.push_back({point});
    property.color.push_back({point});
  }
  for (const GradientOpacityPoint& point : gradientOpacityForVtk(preset.gradientOpacity, target, changes))
    property.gradientOpacity.push_back({{point.gradient, glm::dvec3(1.0), point.opacity}});
  property.light = headLightOf(preset.shading, Reflection::phong, changes);
  tellLostParts(preset, changes);
  return property;
}

} // namespace limn
