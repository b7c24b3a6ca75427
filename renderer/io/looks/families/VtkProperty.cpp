// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/families/VtkProperty.h"

#include "io/looks/curves/LookCurves.h"
#include "io/looks/text/LookText.h"
#include "io/reading/ReadError.h"
#include "scene/light/LightingTerms.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace limn {
namespace {

constexpr double lowestExponent = 0.01;
constexpr double highestExponent = 1024.0; // DEFINITION section 4

void tellLostLight(const Shading& shading, std::vector<Message>& changes) {
  if (shading.lightDirection)
    tell(changes, Message::tr("The light's direction was left out: it comes from the viewer there."));
  const LightingTerms terms = lightingTerms(shading);
  if (terms.shadow.strength > 0.0)
    tell(changes, Message::tr("Shadows were left out."));
  if (terms.occlusion.strength > 0.0)
    tell(changes, Message::tr("Occlusion was left out: ambient light reaches everything alike there."));
  if (shading.model != ShadingModel::none && shading.gradientSmoothing > 0.0)
    tell(changes, Message::tr("The smoothing of normals was left out."));
  if (!shading.twoSided)
    tell(changes, Message::tr("Surfaces turned away from the light are lit there, too."));
}

// The exponent in the reflection asked for.
double toldExponent(const Shading& shading, Reflection reflection, std::vector<Message>& changes) {
  const bool shines = shading.specular * shading.lightIntensity > 0.0;
  if (shines && shading.specularColor == SpecularColor::material)
    tell(changes, Message::tr("Highlights in the material's colour became white ones."));
  if (shading.reflection == reflection)
    return shading.exponent;
  const bool toPhong = reflection == Reflection::phong;
  const double exponent = toPhong ? phongExponent(shading.exponent) : blinnExponent(shading.exponent);
  if (shines)
    tell(changes,
         (toPhong ? Message::tr("The exponent %1 of highlights after Blinn-Phong became %2 after Phong, "
                                "which are as wide.")
                  : Message::tr("The exponent %1 of highlights after Phong became %2 after Blinn-Phong, "
                                "which are as wide."))
             .arg(Message::rounded(shading.exponent, 4), Message::rounded(exponent, 4)));
  return exponent;
}

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

double phongExponent(double blinnExponent) {
  return blinnExponent / 4.0;
}

double blinnExponent(double phongExponent) {
  return phongExponent * 4.0;
}

Shading shadingOf(const HeadLight& light, std::vector<Message>& changes) {
  Shading shading;
  shading.model = light.isOn ? ShadingModel::classic : ShadingModel::none;
  shading.ambient = std::max(0.0, light.ambient);
  shading.diffuse = std::max(0.0, light.diffuse);
  shading.specular = std::max(0.0, light.specular);
  shading.ambientIntensity = 1.0;
  shading.lightIntensity = 1.0;
  shading.exponent = std::clamp(light.exponent, lowestExponent, highestExponent);
  shading.reflection = light.reflection;
  shading.specularColor = SpecularColor::light;
  shading.twoSided = true;
  const bool isLimited = shading.ambient != light.ambient || shading.diffuse != light.diffuse ||
                         shading.specular != light.specular ||
                         (shading.exponent != light.exponent && light.specular > 0.0);
  if (isLimited)
    tell(changes, Message::tr("Numbers of the light were limited to what Limn draws: no coefficient below 0, "
                              "exponents from %1 to %2.")
                      .arg(Message::rounded(lowestExponent, 2), Message::rounded(highestExponent, 4)));
  return shading;
}

HeadLight headLightOf(const std::optional<Shading>& shading, Reflection reflection,
                      std::vector<Message>& changes) {
  HeadLight light;
  light.reflection = reflection;
  if (!shading) {
    tell(changes, Message::tr("The look says nothing of light; the usual one of such programs was written."));
    return light;
  }
  light.isOn = shading->model != ShadingModel::none;
  light.ambient = shading->ambient * shading->ambientIntensity;
  light.diffuse = shading->diffuse * shading->lightIntensity;
  light.specular = shading->specular * shading->lightIntensity;
  std::vector<Message> ofLight;
  tellLostModel(shading, ofLight); // first: what is told of numbers is told of the classic model
  light.exponent = toldExponent(*shading, reflection, ofLight);
  tellLostLight(*shading, ofLight);
  if (light.isOn) // what is not lit loses nothing
    for (const Message& sentence : ofLight)
      tell(changes, sentence);
  return light;
}

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
  property.light =
      headLightOf(preset.shading, Reflection::phong, changes); // first, what was lost of the model
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
  tellLostParts(preset, changes);
  return property;
}

} // namespace limn
