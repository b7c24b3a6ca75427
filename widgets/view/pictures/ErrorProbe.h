// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/ErrorEstimate.h"
#include "scene/Scene.h"
#include "widgets/view/pictures/PictureScreen.h"

#include <memory>
#include <optional>
#include <vector>

namespace limn {

class DrawingEngine;

/// Estimates the error of the pictures from small ones of the same camera, whose rays are a fair sample of
/// theirs: drawn at the step shown, at its half and at its quarter. Cheap enough for pictures that move.
/// Lives where its screen does.
class ErrorProbe {
public:
  explicit ErrorProbe(PictureScreen& screen) : m_sheet(screen.makeSheet()) {}

  /// The pixels on the longer side of a small picture.
  static constexpr int longest = 64;

  /// The scenes as they are shown, with their steps, in pictures of `size`. Estimates of the same volume and
  /// kind of picture stay until newer ones are measured.
  void want(const std::vector<Scene>& shown, const glm::ivec2& size);

  /// Measures one side, where that needs no program that is not compiled yet. False when every side is
  /// measured.
  bool step(DrawingEngine& engine);

  /// The estimate of side `side` drawn with a step, with what early ends cost: measured, or scaled from what
  /// was measured last by the order that it showed; absent before anything was.
  std::optional<ErrorEstimate> estimate(int side, double stepVoxels) const;

private:
  struct Measured {
    double stepVoxels = 0.0;
    ErrorEstimate steps;
    ImageError earlyEnds, filter;
  };
  struct Side {
    Scene scene;
    bool isDue = false;
    std::optional<Measured> measured;
  };

  Measured measure(DrawingEngine& engine, const Scene& scene);
  ImageError ofFilter(DrawingEngine& engine, const Scene& scene);
  Image draw(DrawingEngine& engine, const Scene& scene);

  std::vector<Side> m_sides;
  glm::ivec2 m_size{1};
  std::unique_ptr<PictureSheet> m_sheet;
};

} // namespace limn
