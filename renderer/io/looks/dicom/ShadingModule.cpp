// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/dicom/ShadingModule.h"

#include "io/reading/ReadError.h"

#include <algorithm>

namespace limn::dicom {
namespace {

void putFraction(DcmItem& object, const DcmTagKey& tag, double number) {
  putNumbers(object, tag, {std::clamp(number, 0.0, 1.0)});
}

double fractionIn(DcmItem& object, const DcmTagKey& tag, const std::string& name) {
  const double number = numberIn(object, tag).value_or(0.0);
  if (number < 0.0 || number > 1.0)
    failReading(name, Message::tr("%1 is not within 0 to 1").arg(nameOf(tag)), exportAgain);
  return number;
}

} // namespace

void putShading(DcmItem& object, const Shading& shading, const Camera& camera) {
  if (shading.model == ShadingModel::none)
    return;
  putText(object, DCM_ShadingStyle, shading.twoSided ? "DOUBLESIDED" : "SINGLESIDED");
  putFraction(object, DCM_AmbientReflectionIntensity, shading.ambient * shading.ambientIntensity);
  // However short, a direction is one: scaled first, so that the square of its length is no 0.
  glm::dvec3 travels = shading.lightDirection.value_or(basisOf(camera).forward);
  travels /= std::max({std::abs(travels.x), std::abs(travels.y), std::abs(travels.z)});
  travels = glm::normalize(travels);
  putNumbers(object, DCM_LightDirection, {travels.x, travels.y, travels.z});
  putFraction(object, DCM_DiffuseReflectionIntensity, shading.diffuse * shading.lightIntensity);
  putFraction(object, DCM_SpecularReflectionIntensity, shading.specular * shading.lightIntensity);
  // A highlight of half the angle (Blinn) is as wide as a reflected one of a quarter of the exponent.
  const double exponent = shading.exponent * (shading.reflection == Reflection::blinn ? 0.25 : 1.0);
  putFraction(object, DCM_Shininess, exponent / largestExponent);
}

Shading shadingIn(DcmItem& object, const std::string& name, std::vector<Message>& changes) {
  Shading shading;
  shading.model = ShadingModel::none;
  if (!holds(object, DCM_ShadingStyle) && !holds(object, DCM_AmbientReflectionIntensity))
    return shading;
  shading.model = ShadingModel::classic;
  shading.reflection = Reflection::phong;
  shading.specularColor = SpecularColor::light;
  shading.twoSided = textIn(object, DCM_ShadingStyle) == "DOUBLESIDED";
  shading.ambientIntensity = 1.0;
  shading.lightIntensity = 1.0;
  shading.ambient = fractionIn(object, DCM_AmbientReflectionIntensity, name);
  shading.diffuse = fractionIn(object, DCM_DiffuseReflectionIntensity, name);
  shading.specular = fractionIn(object, DCM_SpecularReflectionIntensity, name);
  shading.exponent = std::max(1.0, largestExponent * fractionIn(object, DCM_Shininess, name));
  const std::vector<double> travels = numbersIn(object, DCM_LightDirection);
  if (travels.size() == 3 && (travels[0] != 0.0 || travels[1] != 0.0 || travels[2] != 0.0))
    shading.lightDirection = glm::dvec3(travels[0], travels[1], travels[2]);
  else if (shading.diffuse > 0.0 || shading.specular > 0.0)
    changes.push_back(Message::tr("The direction of the light is missing; it comes from the viewer."));
  return shading;
}

} // namespace limn::dicom
