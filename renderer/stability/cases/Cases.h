// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "stability/Workbench.h"

/// The hard cases by what they are about. Their numbers are those of the project's notes on numerics.
namespace limn {

/// All hard cases, in order of their numbers.
std::vector<HardCase> hardCases();

std::vector<HardCase> formulaCases();    ///< gradients, powers, highlights: H1 to H3, H40
std::vector<HardCase> blendingCases();   ///< opacity, display values, fog: H4, H5, H38, H39, H42
std::vector<HardCase> rayCases();        ///< steps, faces, cameras, jitter: H6 to H14, H31, H32
std::vector<HardCase> voxelCases();      ///< of any value, few, between them: H15 to H19, H21, H29, H30, H48
std::vector<HardCase> functionCases();   ///< as stored, in exact steps: H20, H24 to H27, H36, H37
std::vector<HardCase> gradientCases();   ///< normals, borders, gradient opacity: H22, H23, H28, H33
std::vector<HardCase> reuseCases();      ///< caches, empty space, tiles: H34, H35, H46
std::vector<HardCase> projectionCases(); ///< surfaces, extremes, turning: H41, H43, H44
std::vector<HardCase> driverCases();     ///< timers, any camera: H45, H47

} // namespace limn
