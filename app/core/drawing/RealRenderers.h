// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/Tolerance.h"
#include "accuracy/sweep/AccuracySweep.h"

#include <functional>
#include <memory>

namespace limn {

/// What casts the rays of a scene: the ray caster where there is a context without display to be had on this
/// thread, the voxels lie in memory and no light travels, otherwise the CPU engine.
Engine raysAtHand(const Scene& scene);

/// The program's own renderers for a sweep, with OpenGL in a context of their own. They belong to the thread
/// that made them: every call, the end included, comes from it. Textures and programs are kept from one
/// picture to the next, as in the window.
class RealRenderers {
public:
  /// `threads` of the reference, 0: every core. `isCancelled` may be empty; where it returns true, what the
  /// processor draws ends with Cancelled. Throws Error (openGl).
  explicit RealRenderers(int threads = 0, std::function<bool()> isCancelled = {},
                         Engine rays = Engine::rayCaster);
  ~RealRenderers();

  /// Whether a point can be drawn: without OpenGL there are neither slices nor stored gradients.
  bool canDraw(const OperatingPoint& point) const;

  /// Who casts the rays, for people.
  std::string name() const;

  /// Valid while this lives.
  SweepRenderers forSweep();
  DrawPrecisely precisely();

  /// How rays keep a tolerance.
  StepControl control() const;

  /// Of the weights between voxels of what draws rays (SceneFacts).
  int filterBits();

  /// A picture of a scene as it is, drawn with rays.
  Image render(const Scene& scene, const glm::ivec2& size);

private:
  struct Parts;
  std::unique_ptr<Parts> m_parts;
};

/// A report on a scene with nothing in it yet: what it is called, who draws, on which machine, how large.
AccuracyReport reportOn(const std::string& name, const std::string& renderer, const Scene& scene,
                        const glm::ivec2& size);

/// Measures error and time of those points of a scene that the renderers can draw against its converged
/// picture, which is known already;
/// everything else of the report but the decisions is filled in. Where the picture did not converge the
/// points keep their times and have no errors to be told.
AccuracyReport measureAccuracy(const std::string& name, const Scene& scene, const glm::ivec2& size,
                               const std::vector<OperatingPoint>& points, const ConvergedPicture& converged,
                               RealRenderers& renderers, const ReportProgress& progress);

} // namespace limn
