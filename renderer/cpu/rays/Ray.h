// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cpu/rays/PictureTerms.h"

namespace limn::cpu {

/// One ray in equal steps, as its samples read it. Sample i lies `offset + i` steps behind the entry; the
/// samples of [from, to) are those that may show.
struct Ray {
  glm::ivec2 pixel{0};
  int count = 0; ///< N of DEFINITION section 7
  int from = 0, to = 0;
  int ownFrom = 0, ownTo = 0; ///< the samples of [ownFrom, ownTo) lie in the brick that is drawn
  float offset = 0.5f;
  glm::vec3 first{0.0f}, stride{0.0f};         ///< voxel index of sample 0, per step
  glm::vec3 firstIndex{0.0f};                  ///< centred index of sample 0
  float firstDepth = 0.0f, strideDepth = 0.0f; ///< distance from the eye less that of the anchor plane
  float units = 0.0f;                          ///< a step in unit distances
  glm::vec3 toViewer{0.0f}, toLight{0.0f}, halfway{0.0f};
  RaySpan span; ///< mm
};

/// The same ray with steps of one unit of length, sample 0 at its entry: for samples at lengths of their own.
Ray inLengths(const PictureTerms& terms, const Ray& ray);

/// The part of the ray of a pixel in the brick that is drawn, mm; all of the span where there is none.
RaySpan partInBrick(const PictureTerms& terms, const FramedRay& ray, const RaySpan& span);

} // namespace limn::cpu
