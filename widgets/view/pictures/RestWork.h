// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/DrawingEngine.h"
#include "scene/PictureFigures.h"
#include "scene/Scene.h"
#include "widgets/properties/EffectTimes.h"
#include "widgets/view/pictures/PictureScreen.h"

#include <memory>
#include <optional>
#include <vector>

namespace limn {

/// What is done while the pictures rest, in pieces that each fit into a turn of the event loop: programs are
/// compiled before a slider needs them, then figures of the pictures are measured, then, on request, what
/// each effect costs. Draws into pictures of its own. Lives where its screen does.
class RestWork {
public:
  explicit RestWork(PictureScreen& screen) : m_sheet(screen.makeSheet()) {}

  /// The scenes at rest; forgets everything measured of others. Costs that were asked for are measured anew
  /// where only the size of the picture is another one.
  void want(const std::vector<Scene>& scenes, const glm::ivec2& size);

  /// Asks for the costs of the effects of the scene of side `side`, anew where they were measured.
  void measureCosts(int side) {
    m_costSide = side;
    m_costs.reset();
  }

  /// Nobody waits for them any more.
  void giveUpCosts() {
    m_costSide.reset();
    m_costs.reset();
  }

  /// Does one piece. False when there was nothing to do.
  bool step(DrawingEngine& engine);

  /// Whether the last piece did nothing but wait for light that is found beside.
  bool isWaiting() const;

  /// How far the light of a side overflows; absent until measured or where it is unlit.
  const std::optional<Overflow>& overflow(int side) const {
    return m_sides[static_cast<std::size_t>(side)].overflow;
  }

  EffectTimes times() const;

private:
  struct Side {
    Scene scene;
    bool isWarm = false;
    bool hasFineLight = false; ///< where light travels
    int overflowPieces = 0;    ///< done, of 2
    std::optional<Overflow> overflow;
  };
  bool isSamePicture(const std::vector<Scene>& scenes, const glm::ivec2& size) const;
  bool warmUp(DrawingEngine& engine);
  bool findFineLight(DrawingEngine& engine);
  bool measureOverflow(DrawingEngine& engine);
  bool measureCosts(DrawingEngine& engine);
  glm::ivec2 measuredSize() const;

  std::vector<Side> m_sides;
  glm::ivec2 m_size{0};
  std::optional<int> m_costSide;
  std::unique_ptr<EffectMeasurement> m_costs;
  std::unique_ptr<PictureSheet> m_sheet;
};

/// A picture of the same shape with at most `longest` pixels on its longer side.
glm::ivec2 smallerSize(const glm::ivec2& size, int longest);

} // namespace limn
