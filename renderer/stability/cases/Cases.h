// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "stability/HardCase.h"

/// The hard cases by what they are about. Their numbers are those of the project's notes on numerics.
namespace limn {

/// All hard cases, in order of their numbers.
std::vector<HardCase> hardCases();

std::vector<HardCase> formulaCases();  ///< gradients, powers: H1 to H3
std::vector<HardCase> opacityCases();  ///< opacities of 0 and 1: H4, H5
std::vector<HardCase> stepCases();     ///< tiny and huge steps, long sums: H6 to H8
std::vector<HardCase> rayCases();      ///< rays in faces, eyes inside: H9, H10, H14
std::vector<HardCase> cameraCases();   ///< degenerate and far cameras, huge worlds: H11 to H13
std::vector<HardCase> voxelCases();    ///< voxels that are no numbers, huge, tiny, equal, padding: H15 to H19
std::vector<HardCase> functionCases(); ///< transfer functions and how they are stored: H20, H24, H26, H27
std::vector<HardCase> volumeShapeCases();    ///< few voxels, interpolation between them: H21, H29, H30
std::vector<HardCase> gradientCases();       ///< normals, borders, gradient opacity: H22, H23, H28, H33
std::vector<HardCase> samplingCases();       ///< jitter, early termination: H31, H32
std::vector<HardCase> reuseCases();          ///< caches, empty space, tiles: H34, H35, H46
std::vector<HardCase> preintegrationCases(); ///< H25, H36, H37
std::vector<HardCase> blendingCases();       ///< colour times opacity, display values, fog: H38, H39, H42
std::vector<HardCase> highlightCases();      ///< H40
std::vector<HardCase> projectionCases();     ///< surfaces, extremes, turning: H41, H43, H44
std::vector<HardCase> driverCases();         ///< timers, any camera: H45, H47
std::vector<HardCase> regionCases();         ///< H48

} // namespace limn
