// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/looks/dicom/Items.h"
#include "scene/light/Shading.h"
#include "scene/view/Camera.h"

// The Render Shading module (PS3.3 C.11.31): Phong with coefficients alone, white highlights, one white light
// at infinity. A look without it is unlit.

namespace limn::dicom {

/// The exponent of the smoothest surface, shininess 1.
inline constexpr double largestExponent = 1024.0;

/// The nearest light that the module can hold; nothing is written for an unlit scene.
void putShading(DcmItem& object, const Shading& shading, const Camera& camera);

/// Unlit where the module is absent. Throws Error (input).
Shading shadingIn(DcmItem& object, const std::string& name, std::vector<Message>& changes);

} // namespace limn::dicom
