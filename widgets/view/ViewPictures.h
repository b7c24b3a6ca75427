// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view/CompareLayout.h"
#include "widgets/view/ErrorProbe.h"
#include "widgets/view/PictureState.h"
#include "widgets/view/Refinement.h"
#include "widgets/view/RestWork.h"
#include "widgets/view/SidePicture.h"

#include <QString>

#include <array>
#include <vector>

namespace limn {

/// Everything of the compare view that lives in its OpenGL context: one ray caster for both sides, so that
/// the volume is uploaded once, their pictures, and what puts them on the screen. Needs that context current
/// for every call, construction and destruction.
class ViewPictures {
public:
  /// Throws Error (openGl).
  ViewPictures();

  /// Asks for pictures of these scenes (one or two), all of one size.
  void want(const std::vector<Scene>& scenes, const glm::ivec2& size);

  /// Draws what is seen of every wanted picture at a level and returns the time, ms.
  double drawCoarsely(int level, const std::array<Columns, 2>& seen);

  /// Draws strips, alternately, until `budgetMs` is spent or all pictures are complete and read back.
  /// True when they are.
  bool refine(double budgetMs);

  /// Measures from small pictures how far one side lies from the exact picture. False when all are measured.
  bool probeError();

  /// Does one piece, of at most about `budgetMs`, of what is done at rest: small measures first, then, where
  /// `refines`, pictures of smaller steps.
  RestTurn workAtRest(bool refines, double budgetMs);
  void leaveRefinementPass() { m_refinement.leavePass(sides()); }
  void giveUpRefinement() {
    leaveRefinementPass();
    m_refinement.giveUp();
  }
  RestWork& rest() { return m_rest; }
  const RestWork& rest() const { return m_rest; }

  /// What the picture of a side calls for at rest.
  std::vector<EffectRow> effectRowsOf(int side);

  /// How the finished and half-finished pictures are put together on the screen.
  struct Arrangement {
    CompareLayout layout = CompareLayout::single;
    std::vector<PixelRect> places; ///< one per picture, y down
    glm::ivec2 size{0};            ///< of the framebuffer
    int wipeColumn = 0;
    bool swapped = false; ///< left and right exchanged
  };

  /// Draws the arrangement into framebuffer `framebuffer`.
  void show(const Arrangement& arrangement, unsigned framebuffer, const glm::dvec3& background) const;

  /// What is shown at the moment.
  PictureState state() const;

  int count() const { return m_count; }
  const SidePicture& side(int index) const { return m_sides[index]; }
  int compiledPrograms() const { return m_caster.compiledPrograms(); }

private:
  std::span<SidePicture> sides() { return {m_sides.data(), static_cast<std::size_t>(m_count)}; }
  SideState stateOf(int index) const;
  void noteShown();
  void showDifference(const Arrangement& arrangement, const glm::dvec3& background) const;
  SidePicture* leastComplete();

  RayCaster m_caster;
  PicturePresenter m_presenter;
  std::array<SidePicture, 2> m_sides;
  RestWork m_rest;
  ErrorProbe m_probe;
  Refinement m_refinement;
  std::array<bool, 2> m_isResolved{true, true}; ///< what is shown of each side
  QString m_limitation;                         ///< of the scenes at their own step
  QString m_renderer;
  int m_count = 0;
};

} // namespace limn
