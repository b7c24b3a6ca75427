// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "stability/Workbench.h"
#include "stability/scenes/SimpleScenes.h"

#include <array>

namespace limn {

/// Along each axis, both ways.
inline const std::array<glm::dvec3, 6> axisDirections = {glm::dvec3(1, 0, 0), glm::dvec3(-1, 0, 0),
                                                         glm::dvec3(0, 1, 0), glm::dvec3(0, -1, 0),
                                                         glm::dvec3(0, 0, 1), glm::dvec3(0, 0, -1)};

/// The largest difference of any channel, of any pixel; a value that is not a number is infinitely far.
double largestDifference(const glm::dvec4& a, const glm::dvec4& b);
double largestDifference(const DrawnPicture& a, const DrawnPicture& b);

/// As largestDifference, of the pixels more than two voxels beside one. The pictures have a pixel per voxel
/// along y: pixel (x, y) sees the column i = x, k = height - 1 - y.
double differenceBeside(const glm::ivec3& voxel, const DrawnPicture& a, const DrawnPicture& b);

/// The largest difference of any pixel's alpha from `expected`.
double largestAlphaError(const DrawnPicture& picture, double expected);

/// How many pixels are unsound: a channel that is not finite or below 0, an alpha above 1, or a colour above
/// alpha by more than 1e-6 (colours are limited to 1 before compositing).
int unsoundPixels(const DrawnPicture& picture);

/// How many pixels show anything.
int visiblePixels(const DrawnPicture& picture);

/// A value that is not a number counts as infinitely large, so that no bound admits it.
double finiteOrInfinite(double figure);

/// A scene that shows a whole volume orthographically along `direction` (world), lit by the model, with steps
/// of half a voxel and no early termination; the function rises from nothing at `lowest` to 0.6 at `highest`.
Scene wholeVolume(std::shared_ptr<const Volume> volume, ShadingModel model, double lowest, double highest,
                  const glm::dvec3& direction = {0.0, 1.0, 0.0});

/// A volume of `edge`³ voxels of 1 mm that is smooth, has gradients in all directions and values 0..100.
std::shared_ptr<const Volume> smoothVolume(int edge, double scale = 1.0);

/// A finding of the ray caster with a decision about accuracy taken otherwise than the program takes it.
Finding takenOtherwise(const Workbench& bench, const Decisions& decisions, const std::string& what,
                       double bound, const std::string& reason,
                       const std::function<double(const Draw& draw)>& figure);

} // namespace limn
