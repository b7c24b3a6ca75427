// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view/pictures/ChanceCheck.h"
#include "widgets/view/pictures/ErrorProbe.h"
#include "widgets/view/pictures/LightBeside.h"
#include "widgets/view/pictures/PictureScreen.h"
#include "widgets/view/pictures/PictureState.h"
#include "widgets/view/pictures/Refinement.h"
#include "widgets/view/pictures/RestWork.h"
#include "widgets/view/pictures/SidePicture.h"

#include <QString>

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace limn {

/// One or two pictures on their way from coarse to exact, and what puts them on the screen: one engine for
/// both, so that the volume is uploaded once, strips that fit into a turn of the event loop, and what is done
/// once they rest. Everything comes from one thread; where engine or screen live on the graphics card, their
/// OpenGL context is current for every call, construction and destruction.
class Pictures {
public:
  /// `followsLight` makes what draws final pictures whose light the engine looked up (LightBeside).
  Pictures(std::unique_ptr<DrawingEngine> engine, std::unique_ptr<PictureScreen> screen,
           MakePrecise makePrecise = {}, MakeEngine followsLight = {});
  ~Pictures();

  /// Asks for pictures of these scenes (one or two), all of one size.
  void want(const std::vector<Scene>& scenes, const glm::ivec2& size);

  /// Gets the engine ready for a volume, for at most about `budgetMs` where it does so in pieces
  /// (DrawingEngine); the share that is done. Throws Cancelled.
  double makeReady(const Scene& scene, const Effort& effort, double budgetMs);

  /// The finest level at which every wanted picture may be drawn coarsely.
  int finestLevel() const;

  /// Draws what is seen of every wanted picture at a level and returns the time, ms.
  double drawCoarsely(int level, const std::array<Columns, 2>& seen);

  /// Whether any of those was drawn while its light was being found, and whether any's still is.
  bool coarseLacksLight() const;
  bool isFindingCoarseLight();

  /// Draws strips, alternately, until `budgetMs` is spent or all pictures are complete and read back.
  /// True when they are.
  bool refine(double budgetMs);

  /// Measures from small pictures how far one side lies from the exact picture. False when all are measured.
  bool probeError();

  /// Does one piece, of at most about `budgetMs`, of what is done at rest: small measures first, then, where
  /// `refines`, pictures of smaller steps and of light that is followed, then what chance says of their
  /// error; where that is more than a screen hides, pictures of a smaller tolerance, and the same of these.
  RestTurn workAtRest(bool refines, double budgetMs);
  /// Finds how far pictures that get more paths are off as they are shown by now (`SideState::onTheWay`).
  void judgePass() { m_refinement.judgePass(*m_engine, sides()); }
  void leaveRefinementPass() {
    m_refinement.leavePass(sides());
    m_light.leave();
  }
  void giveUpRefinement() {
    leaveRefinementPass();
    m_refinement.giveUp();
    m_isFinal = true;
  }
  RestWork& rest() { return m_rest; }
  const RestWork& rest() const { return m_rest; }

  /// What the picture of a side calls for at rest; while it is drawn from fewer voxels, as far as these tell.
  std::vector<EffectRow> effectRowsOf(int side);
  /// Whether any was drawn from fewer voxels on its way.
  bool hadStandIns() const;

  /// Shows the finished and half-finished pictures as an order puts them together.
  void show(const PictureOrder& order);

  /// What was shown last, where the screen is in memory.
  QImage frame() const { return m_screen->frame(); }

  /// What is shown at the moment.
  PictureState state() const;

  int count() const { return m_count; }
  const SidePicture& side(int index) const { return m_sides[index]; }
  const DrawingEngine& engine() const { return *m_engine; }

private:
  std::span<SidePicture> sides() { return {m_sides.data(), static_cast<std::size_t>(m_count)}; }
  std::span<const SidePicture> sides() const { return {m_sides.data(), static_cast<std::size_t>(m_count)}; }
  SideState stateOf(int index) const;
  void noteShown();
  RestTurn followLight();
  RestTurn checkByChance();
  void showDifference(const PictureOrder& order, const glm::dvec3& background);
  SidePicture* leastComplete();

  std::unique_ptr<DrawingEngine> m_engine;
  std::unique_ptr<PictureScreen> m_screen;
  std::array<SidePicture, 2> m_sides;
  RestWork m_rest;
  ErrorProbe m_probe;
  Refinement m_refinement;
  LightBeside m_light;
  ChanceCheck m_chance;
  std::array<bool, 2> m_isResolved{true, true}; ///< what is shown of each side
  std::array<bool, 2> m_isLightMeasured{true, true};
  bool m_isFinal = false; ///< nothing better follows what is shown
  QString m_limitation;   ///< of the scenes at their own step
  int m_count = 0;
};

} // namespace limn
