// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "scene/basics/Image.h"

#include <functional>

/// Rules that the pictures of every renderer keep, and what more than one renderer's tests draw.
namespace limn::test {

/// Draws a whole picture with the renderer that is tested.
using DrawPicture = std::function<Image(const Scene& scene, const glm::ivec2& size)>;

/// The head phantom of 4 mm with noise, seen by the default camera in steps of half a voxel.
Scene noisyPhantom(ShadingModel model);

/// The largest difference of any channel, 0..1.
double largestDifference(const Image& a, const Image& b);

/// Every case of analytic_cases.json that a grid holds exactly meets its closed form, within the tolerance
/// that it states for floats; prints by how much.
void expectClosedForms(const DrawPicture& draw);

/// A camera that moves through a homogeneous box of 2 mm sees alpha fall with the path that is left.
void expectNoJumpThroughTheBox(const DrawPicture& draw);

/// Pixel centres on the lattice of voxel faces: a box of 8 voxels lights exactly 8 x 8 of 16 pixels,
/// whichever way it is looked through (half-open box: the lower faces belong to it).
void expectFacesLitOnce(const DrawPicture& draw);

} // namespace limn::test
