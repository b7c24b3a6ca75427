// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cpu/rays/PictureTerms.h"

#include <optional>

namespace limn::cpu {

/// One ray in equal steps, as its samples read it. Sample i lies `offset + i` steps behind the entry; the
/// samples of [from, to) are those that may show.
struct Ray {
  int count = 0; ///< N of DEFINITION section 7
  int from = 0, to = 0;
  float offset = 0.5f;
  glm::vec3 first{0.0f}, stride{0.0f};           ///< voxel index of sample 0, per step
  glm::vec3 firstIndex{0.0f}, strideIndex{0.0f}; ///< centred index likewise
  float firstDepth = 0.0f, strideDepth = 0.0f;   ///< distance from the eye less that of the anchor plane
  float units = 0.0f;                            ///< a step in unit distances
  glm::vec3 toViewer{0.0f}, toLight{0.0f}, halfway{0.0f};
  FramedRay framed;
  RaySpan span; ///< mm
};

/// The ray of a pixel; absent where it misses the box, or the part of it where something shows.
std::optional<Ray> rayOf(const PictureTerms& terms, int x, int y);

/// A ray of pixel (x, y) ended `steps` steps behind its entry and divided anew: what lies before a surface.
/// Absent where nothing lies before it.
std::optional<Ray> rayUpTo(const PictureTerms& terms, const Ray& ray, int x, int y, double steps);

/// The same ray with steps of one unit of length, sample 0 at its entry: for samples at lengths of their own.
Ray inLengths(const PictureTerms& terms, const Ray& ray);

} // namespace limn::cpu
