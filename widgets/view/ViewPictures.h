// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view/CompareLayout.h"
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
  ViewPictures() = default;

  /// Asks for pictures of these scenes (one or two), all of one size.
  void want(const std::vector<Scene>& scenes, const glm::ivec2& size);

  /// Draws what is seen of every wanted picture at a level and returns the time, ms.
  double drawCoarsely(int level, const std::array<Columns, 2>& seen);

  /// Draws strips, alternately, until `budgetMs` is spent or all pictures are complete and read back.
  /// True when they are.
  bool refine(double budgetMs);

  /// Does one piece of what is done at rest. False when there was nothing to do.
  bool workAtRest();
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

  int count() const { return m_count; }
  const SidePicture& side(int index) const { return m_sides[index]; }
  int compiledPrograms() const { return m_caster.compiledPrograms(); }
  QString limitation() const { return QString::fromStdString(m_caster.limitation()); }

private:
  void showDifference(const Arrangement& arrangement, const glm::dvec3& background) const;
  SidePicture* leastComplete();

  RayCaster m_caster;
  PicturePresenter m_presenter;
  std::array<SidePicture, 2> m_sides;
  RestWork m_rest;
  int m_count = 0;
};

} // namespace limn
