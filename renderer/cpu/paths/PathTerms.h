// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cpu/rays/PictureTerms.h"
#include "scene/LabelLooks.h"
#include "scene/light/PhysicalLight.h"
#include "scene/regions/Region.h"

#include <glm/glm.hpp>

#include <array>
#include <vector>

namespace limn::cpu {

/// The largest extinction that paths are drawn with, per length: light flies a thousandth of a voxel through
/// it on average. Where the curve says more the picture would be the same, and paths would take a step of
/// less than a float tells from the next.
inline constexpr float mostExtinction = 1024.0f;

/// Extinctions that nothing in a block exceeds, per length (Majorants).
struct MajorantTerms {
  const float* ofBlocks = nullptr; ///< x fastest
  glm::ivec3 blocks{0};
  const std::uint8_t* distances = nullptr; ///< as in BlocksAlike; null: nothing is leapt over
};

/// What all random paths of a picture share (DEFINITION section 12), in the units of rays: lengths in
/// smallest spacings, places as voxel indices, directions of unit length along the grid's axes, scalars
/// normalised over the volume's range. The density is part of the unit distances. Points to what others keep.
struct PathTerms {
  VoxelSource voxels;
  const PiecewiseTable* function = nullptr;
  const PiecewiseTable* gradientCurve = nullptr; ///< null: opacities do not depend on gradients
  VoxelSource region;
  VoxelSource smoothed; ///< whose gradients count where `smoothsNormals`
  bool smoothsNormals = false;
  bool hasRegion = false;
  float perUnitDistance = 1.0f; ///< unit distances in a length

  const LabelLooks* looks = nullptr; ///< null: no label has another look
  const Region* keep = nullptr;      ///< beside looks
  std::vector<float> perUnitOfLooks; ///< as perUnitDistance, of each
  ValueRange range;

  MajorantTerms majorants;
  glm::vec3 perLength{1.0f};          ///< voxels in a length along each axis
  glm::vec3 lower{0.0f}, upper{0.0f}; ///< the box outside which nothing is
  bool isCut = false;                 ///< surfaces near the crop's faces face as those do
  glm::vec3 cutLower{0.0f}, cutUpper{0.0f};
  glm::vec3 spacing{1.0f}; ///< lengths from voxel to voxel

  glm::vec3 gradientScale{0.0f}; ///< as in PictureTerms
  float flatModulus = 0.0f;
  float perReference = 0.0f;
  GradientCurve curve;

  float anisotropy = 0.0f;
  float surface = 0.0f;
  float specularShare = 0.0f;
  float exponentAtFlat = 1.0f, exponentAtBoundary = 1.0f;

  float keyFluence = 0.0f;    ///< what comes of the key through a place, all directions together
  float keyCosine = 1.0f;     ///< of its angular radius
  bool isHeadlight = false;   ///< it comes along the ray of the camera, whatever path is followed then
  glm::vec3 towardsKey{0.0f}; ///< its middle, where it is no headlight
  float skyBelow = 0.0f, skyAbove = 0.0f;
  glm::vec3 up{0.0f, 0.0f, 1.0f};

  static constexpr int linearSteps = 1024;
  std::array<float, linearSteps + 2> linear{}; ///< decoded sRGB over 0..1, to be interpolated
};

/// One place of a picture from where paths begin: where its ray enters the box, and how far it stays.
struct PathStart {
  glm::vec3 place{0.0f};     ///< voxel index
  glm::vec3 direction{0.0f}; ///< unit length
  float length = 0.0f;       ///< 0: the ray misses the box
};

} // namespace limn::cpu
