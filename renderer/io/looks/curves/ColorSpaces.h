// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>

namespace limn {

/// Between two colours of a curve: straight in sRGB; straight in hue, saturation and value; straight in CIE
/// L*a*b* (D65); through white in Msh (K. Moreland, "Diverging color maps for scientific visualization",
/// ISVC 2009); or the second one throughout.
enum class ColorSpace { rgb, hsv, wrappedHsv, lab, diverging, step };

/// The colour a fraction `u` of the way from one to another. Of hsv, hues go the way round that avoids red's
/// end of the circle; of wrappedHsv, the shorter one. All colours are sRGB-encoded, 0..1.
glm::dvec3 mixed(ColorSpace space, const glm::dvec3& from, const glm::dvec3& to, double u);

} // namespace limn
