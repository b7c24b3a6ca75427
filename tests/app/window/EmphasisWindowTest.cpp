// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "scene/function/PointShare.h"
#include "widgets/curve/PointLight.h"
#include "widgets/planes/PlaneDeck.h"
#include "widgets/planes/PlaneView.h"

// What a point of the curve governs, lit up in slices and picture.

namespace limn {
namespace {

class EmphasisWindow : public test::WindowHarness {
protected:
  void SetUp() override {
    WindowHarness::SetUp();
    window->resize(1280, 800);
    ASSERT_TRUE(openAlone(QStringLiteral("phantom:4")));
    window->findChild<QAction*>(QStringLiteral("planes-picture_and_three"))->trigger();
    session().setTransferFunction(
        {1.0, {{-200.0, {0.9, 0.6, 0.5}, 0.0}, {60.0, {0.8, 0.3, 0.2}, 0.3}, {900.0, {1.0, 1.0, 0.9}, 0.8}}},
        {nextGestureId(), "three points"});
    undo().clear();
    ASSERT_TRUE(rest());
  }

  TransferFunctionCanvas& plot() const { return *curves().valueEditor()->canvas(); }

  QPoint inWindow(std::size_t point) const {
    const ControlPoint& at = plot().transferFunction().points[point];
    const QPointF place(xOfValue(plot().transform(), at.value), yOfOpacity(plot().transform(), at.opacity));
    return plot().mapTo(window.get(), place).toPoint();
  }

  void moveTo(const QPoint& at) {
    QTest::mouseMove(window->windowHandle(), at - QPoint(3, 0));
    QTest::mouseMove(window->windowHandle(), at);
  }

  std::optional<std::size_t> litInSlices() const {
    return window->findChild<PlaneDeck*>()->view(PatientPlane::axial)->content().emphasisedPoint;
  }
  bool isLit(std::size_t point) {
    return litInSlices() == point &&
           view().scene().transferFunction == withPointEmphasised(scene().transferFunction, point);
  }
  bool isDark() { return !litInSlices() && view().scene() == scene(); }

  // Whether the pointer is on a point that will light up if it stays.
  bool rests() const { return window->findChild<PointLight*>()->findChild<QTimer*>()->isActive(); }

  // Greener than any tissue.
  int greenPixels(QWidget& part) const {
    const QImage picture = part.grab().toImage();
    int green = 0;
    for (int y = 0; y < picture.height(); ++y)
      for (int x = 0; x < picture.width(); ++x) {
        const QColor color = picture.pixelColor(x, y);
        green += color.green() > color.red() + 60 && color.green() > color.blue() + 40 ? 1 : 0;
      }
    return green;
  }
};

TEST_F(EmphasisWindow, restingOnAPointLightsUpWhatItGovernsAndLeavingItDoesNot) {
  QWidget& axial = *window->findChild<PlaneDeck*>()->view(PatientPlane::axial);
  EXPECT_EQ(greenPixels(axial), 0);
  moveTo(inWindow(1));
  ASSERT_TRUE(test::waitUntil([this] { return isLit(1); }));
  ASSERT_TRUE(rest());
  EXPECT_GT(greenPixels(axial), 500) << "brain and muscle";
  EXPECT_GT(greenPixels(view()), 500);
  const auto noted = [this] { return QString::fromStdString(view().order().comparison.preview); };
  EXPECT_EQ(noted().replace(QChar(0xa0), QLatin1Char(' ')),
            QStringLiteral("in green what the point at 60 HU governs"));
  moveTo(inWindow(2));
  ASSERT_TRUE(test::waitUntil([this] { return isLit(2); })) << "the other point takes over";
  moveTo(inWindow(2) + QPoint(0, 60));
  ASSERT_TRUE(test::waitUntil([this] { return isDark(); }));
  ASSERT_TRUE(rest());
  EXPECT_EQ(noted(), QString());
  EXPECT_EQ(greenPixels(axial), 0);
  EXPECT_EQ(undo().count(), 0) << "looking is no edit";
}

TEST_F(EmphasisWindow, aDragIsNotInItsLight) {
  moveTo(inWindow(1));
  EXPECT_TRUE(test::waitUntil([this] { return rests(); }));
  ASSERT_TRUE(test::waitUntil([this] { return isLit(1); }));
  const QPoint from = inWindow(1);
  QTest::mousePress(window->windowHandle(), Qt::LeftButton, {}, from);
  EXPECT_TRUE(isDark()) << "at the press";
  for (int step = 1; step <= 5; ++step) {
    QTest::mouseEvent(QTest::MouseMove, window->windowHandle(), Qt::NoButton, {}, from - QPoint(0, 4 * step));
    EXPECT_TRUE(isDark());
    EXPECT_FALSE(rests()) << "nor will it be";
  }
  QTest::mouseRelease(window->windowHandle(), Qt::LeftButton, {}, from - QPoint(0, 20));
  EXPECT_EQ(undo().count(), 1);
  EXPECT_GT(scene().transferFunction.points[1].opacity, 0.3);
}

TEST_F(EmphasisWindow, theKeyboardLightsUpThePointInHand) {
  plot().setFocus();
  plot().selectPoints({2});
  QTest::keyClick(window->windowHandle(), Qt::Key_H);
  EXPECT_TRUE(isLit(2));
  QTest::keyClick(window->windowHandle(), Qt::Key_H);
  EXPECT_TRUE(isDark());
  QTest::keyClick(window->windowHandle(), Qt::Key_H);
  ASSERT_TRUE(isLit(2));
  QTest::keyClick(window->windowHandle(), Qt::Key_Up);
  EXPECT_TRUE(isDark()) << "an edit is seen as it is";
  QTest::keyClick(window->windowHandle(), Qt::Key_H);
  ASSERT_TRUE(isLit(2));
  session().undoStack().undo();
  EXPECT_TRUE(isDark()) << "so is what comes from elsewhere";
}

} // namespace
} // namespace limn
