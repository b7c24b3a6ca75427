// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/curves/LookLight.h"

#include "io/looks/text/LookText.h"
#include "scene/light/Shading.h"

#include <algorithm>

namespace limn {
namespace {

constexpr double lowestExponent = 0.01;
constexpr double highestExponent = 1024.0; // DEFINITION section 4

void tellLostModel(const Shading& shading, std::vector<Message>& changes) {
  if (shading.model == ShadingModel::enhanced || shading.model == ShadingModel::robust)
    tell(changes,
         Message::tr("The shading model %1 became the classic one, whose opacity and highlights do not "
                     "follow the gradient.")
             .arg(nameOf(shading.model)));
  if (shading.lightDirection)
    tell(changes, Message::tr("The light's direction was left out: it comes from the viewer there."));
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
  light.exponent = toldExponent(*shading, reflection, ofLight);
  tellLostModel(*shading, ofLight);
  if (light.isOn) // what is not lit loses nothing
    for (const Message& sentence : ofLight)
      tell(changes, sentence);
  return light;
}

} // namespace limn
