// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/times/Timing.h"
#include "app/lab/bench/Contender.h"
#include "io/ImageFile.h"

namespace limn {

/// The picture that a contender drew last, 8 bits over the scene's background. Throws what `save` throws.
BytePicture pictureOf(Contender& contender);

/// How far the pictures of contenders lie from the exact one of a scene as they light it: the CPU engine's,
/// cell by cell with fineness 9, and exact where the projection does not integrate; no early termination. On
/// the shared heads that is within 0.05 level of the converged picture in double.
class PictureErrors {
public:
  /// Draws the exact pictures of the first view for those contenders on `threads` (0: all).
  PictureErrors(const Scene& scene, const std::vector<std::unique_ptr<Contender>>& contenders, int threads);

  /// The mean error of the contender's picture in 8-bit levels over the covered pixels, its rounding to 8
  /// bits included; draws it. Throws what the contender throws.
  double meanError(Contender& contender, const Scene& scene) const;

private:
  Image m_exact;
  Image m_exactOfBothSides; // empty where nobody lights so
  glm::dvec3 m_background{0.0};
};

/// Error and time of one contender at steps of 2, 1, 1/2 and 1/4 voxel and, of Limn's engines, at
/// error-controlled ones: each drawn `frames` times, the median of the times.
std::vector<ErrorAndTime> errorCurve(Contender& contender, const Scene& scene, const PictureErrors& errors,
                                     int frames);

/// Every contender at the errors that the first of `vtk-gpu`, or else the first contender, makes with steps
/// of 1 and of 1/2 voxel. `advance` is called after every contender.
std::vector<EqualErrorRow> equalErrorRows(const std::string& name, const Scene& scene,
                                          const std::vector<std::unique_ptr<Contender>>& contenders,
                                          const PictureErrors& errors, int frames,
                                          const std::function<void()>& advance);

} // namespace limn
