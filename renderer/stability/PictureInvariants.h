// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "scene/basics/Image.h"

#include <string>
#include <vector>

namespace limn {

/// What must hold for every picture, whatever it shows (HARD_CASES section 4), as sentences about what does
/// not, each with the first pixel at fault; empty where all holds. Every channel is finite, 0 ≤ A ≤ 1, every
/// premultiplied colour lies within 0..A + `rounding` (each model limits the light to 0..1 and fog is no
/// brighter), and pixels whose rays surely miss what the crop leaves of the volume are zero bit for bit.
std::vector<std::string> brokenInvariants(const Scene& scene, const Image& image, double rounding = 1e-6);

/// Says where two pictures that must be the same bit for bit differ first; empty where they do not.
std::string firstDifference(const Image& image, const Image& again);

} // namespace limn
