// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"

#include <optional>

namespace limn {

/// How much coarser than at rest a picture is drawn while something moves. Only pixels and steps change: the
/// tables, the unit distance and early termination stay, so that brightness does not jump.
struct QualityLevel {
  double imageScale = 1.0; ///< of the side's width and height
  double stepFactor = 1.0; ///< of the step at rest
  bool operator==(const QualityLevel&) const = default;
};

/// Chooses the level of quality while moving from a fixed list by measured time, so that frames come often
/// enough to steer by. Knows neither OpenGL nor clock.
class InteractionQuality {
public:
  /// The drawing time of one frame aimed at unless set otherwise, ms: with showing it, 15 frames per second.
  static constexpr double usualTargetMs = 40.0;
  static constexpr int levelCount = 9;

  void setTargetMs(double ms) { m_targetMs = ms; } ///< > 0
  double targetMs() const { return m_targetMs; }

  static QualityLevel levelAt(int index); ///< 0 is full quality, levelCount - 1 the coarsest

  /// What a picture is expected to cost at a level, relative to full quality.
  static double relativeCost(int index);

  /// The level for a frame of `pixels` pixels over all sides: the coarsest until something was measured.
  int levelFor(double pixels) const;

  /// Notes that a frame of `pixels` pixels (at full scale) took `ms` at `level`.
  void measured(int level, double pixels, double ms);

  /// Forgets what was measured: another volume, another kind of picture.
  void forget() { m_msPerPixel.reset(); }

private:
  double m_targetMs = usualTargetMs;
  std::optional<double> m_msPerPixel; ///< at full quality, averaged
  int m_lastLevel = levelCount - 1;
};

/// The size of a side's picture at a level, at least one pixel each way.
glm::ivec2 sizeAt(const QualityLevel& level, const glm::ivec2& size);

/// The scene drawn with another step.
Scene withStep(Scene scene, double stepVoxels);

/// The scene drawn with the step of a level; below full quality light that travels is found coarsely. Of
/// physical light one path of each pixel is followed: more are at rest (Refinement).
Scene withQualityLevel(const Scene& scene, const QualityLevel& level);

} // namespace limn
