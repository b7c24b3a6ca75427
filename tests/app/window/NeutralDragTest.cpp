// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "support/Heart.h"
#include "support/Sanitizers.h"
#include "widgets/FindWidget.h"
#include "widgets/controls/LabelledRow.h"
#include "widgets/controls/NumberSliders.h"
#include "widgets/controls/TrackSlider.h"
#include "widgets/properties/FogSection.h"
#include "widgets/properties/PropertiesPanel.h"
#include "widgets/shading/ShadingSection.h"

#include <QElapsedTimer>

#include <algorithm>
#include <cstdio>
#include <functional>

// Sliders are dragged off and across the value at which an effect vanishes: no frame may wait for a shader.
// CTest runs these twice, with the driver's cache of shaders and without.

namespace limn {
namespace {

constexpr int frames = 24;

// The times of a drag's frames.
struct FrameTimes {
  double medianMs = 0.0;
  double longestMs = 0.0;
  /// A program takes a driver a quarter of a second and more; a frame aims at 40 ms.
  double mostMs() const { return std::max(250.0, 2.5 * medianMs); }
};

FrameTimes frameTimes(std::vector<double> ms) {
  std::sort(ms.begin(), ms.end());
  return {ms[ms.size() / 2], ms.back()};
}

struct DragFigures {
  int compiled = 0; ///< programs, during the drag
  FrameTimes clock;
  FrameTimes own; ///< processor time of the window's thread, in which a driver compiles
};

class NeutralDrag : public test::OpenGlWindow {
protected:
  // Shows the phantom with the scene changed, with nothing left to do.
  [[nodiscard]] bool show(const std::function<void(Scene&)>& change, CompareLayout layout) {
    if (!open(QStringLiteral("phantom:4")))
      return false;
    setLayout(layout);
    for (FoldingSection* section : window->findChildren<FoldingSection*>())
      section->setFolded(false);
    Scene changed = scene();
    change(changed);
    session().edit(changed, {nextGestureId(), QStringLiteral("start")});
    return idle();
  }

  template <class Slider>
  TrackSlider* track(const char* label) {
    auto* row = rowNamed<Slider>(*window, label);
    return row ? row->template findChild<TrackSlider*>() : nullptr;
  }

  // One mouse move until its frame is shown.
  void moveUntilShown(TrackSlider& slider, const QPoint& to) {
    bool isShown = false;
    const auto connection =
        QObject::connect(&canvas(), &QOpenGLWidget::frameSwapped, [&isShown] { isShown = true; });
    QTest::mouseEvent(QTest::MouseMove, &slider, Qt::NoButton, {}, to);
    EXPECT_TRUE(test::waitUntil([&] { return isShown; }));
    QObject::disconnect(connection);
  }

  // Drags a handle by `pixels`, or to the end of its track, and back again. Beyond the end nothing changes,
  // so that no frame would answer a move.
  DragFigures drag(TrackSlider& slider, int handle, int pixels) {
    const QPoint from = slider.handleCentre(handle).toPoint();
    constexpr int halfHandle = 10;
    pixels = std::min(pixels, slider.width() - halfHandle - from.x());
    EXPECT_GE(pixels, frames / 2) << "each move is another place";
    const int programs = compiledPrograms();
    std::vector<double> clockMs, ownMs;
    QTest::mousePress(&slider, Qt::LeftButton, {}, from);
    for (int i = 1; i <= frames; ++i) {
      const int half = frames / 2;
      const int part = i <= half ? i : frames - i;
      const double ownBefore = test::threadMs();
      QElapsedTimer clock;
      clock.start();
      moveUntilShown(slider, from + QPoint(pixels * part / half, 0));
      clockMs.push_back(1e-6 * static_cast<double>(clock.nsecsElapsed()));
      ownMs.push_back(test::threadMs() - ownBefore);
    }
    const int compiled = compiledPrograms() - programs;
    QTest::mouseRelease(&slider, Qt::LeftButton, {}, from);
    return {compiled, frameTimes(clockMs), frameTimes(ownMs)};
  }

  void expectNoStall(const std::string& what, const DragFigures& figures) {
    std::printf("%s: %d programs compiled, median frame %.1f ms\n", what.c_str(), figures.compiled,
                figures.clock.medianMs);
    EXPECT_EQ(figures.compiled, 0);
    LIMN_NEEDS_ITS_OWN_TIME;
    EXPECT_LE(figures.own.longestMs, figures.own.mostMs());
    test::judgeMs("longest frame of the drag of " + what, figures.clock.longestMs, figures.clock.mostMs());
  }
};

TEST_F(NeutralDrag, highlightsLeaveZeroWithoutAStall) {
  ASSERT_TRUE(show([](Scene& s) { s.shading.specular = 0.0; }, CompareLayout::sideBySide));
  TrackSlider* slider = track<ValueSlider>("Highlights (ks)");
  ASSERT_NE(slider, nullptr);
  expectNoStall("specular", drag(*slider, 0, 80));
  EXPECT_EQ(scene().shading.specular, 0.0) << "the drag ends where it began";
}

TEST_F(NeutralDrag, boundaryEmphasisOpensWithoutAStall) {
  ASSERT_TRUE(show(
      [](Scene& s) {
        s.shading.model = ShadingModel::enhanced;
        s.shading.opacityRange = {1.0, 1.0};
        s.shading.exponentRange = {32.0, 32.0};
      },
      CompareLayout::single));
  TrackSlider* slider = track<RangeSlider>("Boundary emphasis (O)");
  ASSERT_NE(slider, nullptr);
  expectNoStall("boundary emphasis", drag(*slider, 1, 60));
}

TEST_F(NeutralDrag, highlightSharpnessOpensWithoutAStall) {
  ASSERT_TRUE(show(
      [](Scene& s) {
        s.shading.model = ShadingModel::robust;
        s.shading.opacityRange = {1.0, 1.0};
        s.shading.exponentRange = {32.0, 32.0};
      },
      CompareLayout::single));
  TrackSlider* slider = track<RangeSlider>("Highlight sharpness (SP)");
  ASSERT_NE(slider, nullptr);
  expectNoStall("highlight sharpness", drag(*slider, 1, 40));
}

TEST_F(NeutralDrag, fogRisesWithoutAStall) {
  ASSERT_TRUE(show(
      [](Scene& s) {
        s.fog = {Fog::Mode::exp2, glm::dvec3(0.1), 0.0, 0.0, 1000.0};
      },
      CompareLayout::sideBySide));
  TrackSlider* slider = track<ValueSlider>("Density (ρ)");
  ASSERT_NE(slider, nullptr);
  // Over a quarter of the track, however long the panel makes it.
  expectNoStall("fog", drag(*slider, 0, slider->width() * 28 / 100));
}

TEST_F(NeutralDrag, restEndsWithTheFiguresOfBothSidesAndNothingLeftToCompile) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  ASSERT_TRUE(rest());
  const test::Heart heart;
  ASSERT_TRUE(idle());
  // A program is compiled in one piece, so a driver without its cache decides how long a turn can be.
  std::printf("at rest: %d programs, longest turn of the event loop %.0f ms\n", compiledPrograms(),
              heart.longestMs());
  const PictureState& state = view().pictureState();
  ASSERT_EQ(state.sides.size(), 2u);
  for (const SideState& side : state.sides) {
    EXPECT_TRUE(side.contrast);
    EXPECT_TRUE(side.overflow);
  }
  const int programs = compiledPrograms();
  // The same scene at rest again compiles nothing more.
  view().update();
  ASSERT_TRUE(idle());
  EXPECT_EQ(compiledPrograms(), programs);
}

} // namespace
} // namespace limn
