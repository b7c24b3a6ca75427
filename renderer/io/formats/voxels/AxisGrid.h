// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/volume/Grid.h"

#include <filesystem>

namespace limn {

/// The grid whose axes step by the columns of `stepsMm` (world LPS, mm per voxel) from `originMm`. Rounding
/// in the axes (up to 1e-4 off the right angle, 0.05 mm over 512 mm) is taken out. Throws Error, naming
/// `file`, where an axis has no length or the axes are sheared.
Grid gridFromAxes(const std::filesystem::path& file, const glm::ivec3& dims, const glm::dmat3& stepsMm,
                  const glm::dvec3& originMm);

/// Turns a matrix or point from RAS (NIfTI) to LPS or back: x and y change sign.
glm::dmat3 rasToLps(const glm::dmat3& matrix);
glm::dvec3 rasToLps(const glm::dvec3& point);

/// Whether every number of the matrix is finite and no column is zero or parallel to the others.
bool isUsable(const glm::dmat3& stepsMm);

} // namespace limn
