// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/curve/CanvasFixture.h"

#include <QApplication>
#include <QKeyEvent>

#include <numeric>

namespace limn {
namespace {

TEST_F(CanvasFixture, tabWalksThePointsForwardsAndBackwards) {
  QTest::keyClick(&m_canvas, Qt::Key_Tab);
  EXPECT_EQ(m_canvas.selected(), PointIndices{0});
  QTest::keyClick(&m_canvas, Qt::Key_Tab);
  EXPECT_EQ(m_canvas.selected(), PointIndices{1});
  QTest::keyClick(&m_canvas, Qt::Key_Backtab, Qt::ShiftModifier);
  EXPECT_EQ(m_canvas.selected(), PointIndices{0});
  EXPECT_TRUE(m_edits.empty());
}

TEST_F(CanvasFixture, arrowsMoveByOneUnitOrAHundredthShiftTimesTenAltATenth) {
  struct Case {
    Qt::KeyboardModifiers modifiers;
    double factor;
  };
  for (const auto& [modifiers, factor] : {Case{{}, 1.0}, {Qt::ShiftModifier, 10.0}, {Qt::AltModifier, 0.1}}) {
    m_canvas.setTransferFunction(sampleFunction());
    m_canvas.selectPoints({2});
    QTest::keyClick(&m_canvas, Qt::Key_Right, modifiers);
    EXPECT_NEAR(points()[2].value, 60.0 + factor, 1e-9);
    QTest::keyClick(&m_canvas, Qt::Key_Up, modifiers);
    EXPECT_NEAR(points()[2].opacity, 0.2 + 0.01 * factor, 1e-12);
    QTest::keyClick(&m_canvas, Qt::Key_Left, modifiers);
    QTest::keyClick(&m_canvas, Qt::Key_Down, modifiers);
    EXPECT_NEAR(points()[2].value, 60.0, 1e-9);
    EXPECT_NEAR(points()[2].opacity, 0.2, 1e-12);
  }
}

TEST_F(CanvasFixture, arrowsAlongOneAxisAreOneGestureUntilSomethingElseHappens) {
  const auto idOf = [&](Qt::Key key) {
    const std::size_t before = m_edits.size();
    QTest::keyClick(&m_canvas, key);
    EXPECT_EQ(m_edits.size(), before + 1);
    return m_edits.back().second.id;
  };
  m_canvas.selectPoints({2});
  const auto first = idOf(Qt::Key_Right);
  EXPECT_EQ(idOf(Qt::Key_Right), first);
  QKeyEvent repeat(QEvent::KeyPress, Qt::Key_Right, Qt::NoModifier, QString(), true);
  QApplication::sendEvent(&m_canvas, &repeat);
  EXPECT_EQ(m_edits.back().second.id, first);
  EXPECT_EQ(idOf(Qt::Key_Left), first);
  const auto upwards = idOf(Qt::Key_Up);
  EXPECT_NE(upwards, first) << "another axis";
  EXPECT_EQ(idOf(Qt::Key_Down), upwards);
  m_canvas.selectPoints({1});
  const auto other = idOf(Qt::Key_Up);
  EXPECT_NE(other, upwards) << "another point";
  m_canvas.setTransferFunction(sampleFunction()); // as undo does
  m_canvas.selectPoints({1});
  EXPECT_NE(idOf(Qt::Key_Up), other) << "something else in between";
}

TEST_F(CanvasFixture, deleteRemovesTheSelectionAndOnePointAlwaysStays) {
  m_canvas.selectPoints({1, 2});
  QTest::keyClick(&m_canvas, Qt::Key_Delete);
  ASSERT_EQ(points().size(), 3u);
  EXPECT_EQ(m_edits.back().second.text, QStringLiteral("delete 2 points"));
  QTest::keyClick(&m_canvas, Qt::Key_A, Qt::ControlModifier);
  QTest::keyClick(&m_canvas, Qt::Key_Delete);
  ASSERT_EQ(points().size(), 1u);
  const std::size_t edits = m_edits.size();
  QTest::keyClick(&m_canvas, Qt::Key_Delete);
  EXPECT_EQ(points().size(), 1u);
  EXPECT_EQ(m_edits.size(), edits);
}

TEST_F(CanvasFixture, controlASelectsAllAndControlDNone) {
  QTest::keyClick(&m_canvas, Qt::Key_A, Qt::ControlModifier);
  EXPECT_EQ(m_canvas.selected().size(), 5u);
  QTest::keyClick(&m_canvas, Qt::Key_D, Qt::ControlModifier);
  EXPECT_TRUE(m_canvas.selected().empty());
}

TEST_F(CanvasFixture, nAddsAPointOnTheCurveBesideTheOneInHand) {
  m_canvas.selectPoints({2});
  const std::vector<ControlPoint> before = points();
  const double middle = std::midpoint(before[2].value, before[3].value);
  const double opacity = classify(m_canvas.transferFunction(), middle).opacity;
  QTest::keyClick(&m_canvas, Qt::Key_N);
  ASSERT_EQ(points().size(), before.size() + 1);
  EXPECT_EQ(points()[3].value, middle);
  EXPECT_EQ(points()[3].opacity, opacity);
  EXPECT_EQ(m_canvas.selected(), PointIndices{3});
  EXPECT_EQ(m_edits.size(), 1u);
}

TEST_F(CanvasFixture, insertBesideTheLastPointGoesBeforeItAndWithoutAPointToTheMiddleOfThePlot) {
  m_canvas.selectPoints({points().size() - 1});
  const std::vector<ControlPoint> before = points();
  QTest::keyClick(&m_canvas, Qt::Key_Insert);
  ASSERT_EQ(points().size(), before.size() + 1);
  EXPECT_EQ(points()[before.size() - 1].value,
            std::midpoint(before[before.size() - 2].value, before.back().value));
  m_canvas.selectPoints({});
  const ValueRange visible = m_canvas.transform().visible;
  QTest::keyClick(&m_canvas, Qt::Key_Insert);
  ASSERT_EQ(m_canvas.selected().size(), 1u);
  EXPECT_EQ(points()[m_canvas.selected().front()].value, std::midpoint(visible.lowest, visible.highest));
}

TEST_F(CanvasFixture, aPointThatKeysReachComesIntoSight) {
  const auto isInSight = [&](std::size_t i) {
    const double x = xOfValue(m_canvas.transform(), points()[i].value);
    const QRectF plot = m_canvas.transform().plot;
    return x >= plot.left() && x <= plot.right();
  };
  wheel(pixelOf(2), 12); // twelve notches of 1.25: a fifteenth of the axis
  ASSERT_TRUE(isInSight(2));
  ASSERT_FALSE(isInSight(0));
  ASSERT_FALSE(isInSight(4));
  const double perPixelBefore = perPixel();
  for (std::size_t i = 0; i < points().size(); ++i) {
    QTest::keyClick(&m_canvas, Qt::Key_Tab);
    ASSERT_EQ(m_canvas.selected(), PointIndices{i});
    EXPECT_TRUE(isInSight(i)) << i;
  }
  EXPECT_NEAR(perPixel(), perPixelBefore, 1e-9 * perPixelBefore); // moved, not zoomed
  for (int press = 0; press < 60; ++press)
    QTest::keyClick(&m_canvas, Qt::Key_Left, Qt::ShiftModifier);
  EXPECT_TRUE(isInSight(4));
}

TEST_F(CanvasFixture, controlWithPlusMinusArrowsAndZeroShowsPartsOfTheAxis) {
  const PlotTransform all = m_canvas.transform();
  m_canvas.selectPoints({2});
  const int x = pixelOf(2).x();
  QTest::keyClick(&m_canvas, Qt::Key_Plus, Qt::ControlModifier);
  EXPECT_NEAR(perPixel(), valuePerPixel(all) / 1.25, 1e-9); // a notch of the wheel
  EXPECT_EQ(pixelOf(2).x(), x);
  const ValueRange zoomed = m_canvas.transform().visible;
  QTest::keyClick(&m_canvas, Qt::Key_Right, Qt::ControlModifier);
  EXPECT_NEAR(m_canvas.transform().visible.lowest, zoomed.lowest + 80.0 * perPixel(), 1e-9);
  EXPECT_TRUE(m_edits.empty());
  QTest::keyClick(&m_canvas, Qt::Key_0, Qt::ControlModifier);
  EXPECT_EQ(m_canvas.transform(), all);
}

TEST_F(CanvasFixture, enterAsksForNumbers) {
  QSignalSpy numbers(&m_canvas, &TransferFunctionCanvas::numbersRequested);
  m_canvas.selectPoints({2});
  QTest::keyClick(&m_canvas, Qt::Key_Return);
  EXPECT_EQ(numbers.count(), 1);
}

TEST_F(CanvasFixture, itsKeysComeBeforeTheWindowsShortcuts) {
  m_canvas.selectPoints({2});
  m_canvas.setAttribute(Qt::WA_UnderMouse);
  for (const int key : {Qt::Key_Space, Qt::Key_Delete, Qt::Key_Left, Qt::Key_Return}) {
    QKeyEvent event(QEvent::ShortcutOverride, key, Qt::NoModifier);
    event.ignore();
    QApplication::sendEvent(&m_canvas, &event);
    EXPECT_TRUE(event.isAccepted()) << key;
  }
  m_canvas.setAttribute(Qt::WA_UnderMouse, false);
  m_canvas.selectPoints({});
  for (const int key : {Qt::Key_Space, Qt::Key_Left}) { // nothing to pan or move: the picture's keys
    QKeyEvent event(QEvent::ShortcutOverride, key, Qt::NoModifier);
    event.ignore();
    QApplication::sendEvent(&m_canvas, &event);
    EXPECT_FALSE(event.isAccepted()) << key;
  }
  QKeyEvent undo(QEvent::ShortcutOverride, Qt::Key_Z, Qt::ControlModifier);
  undo.ignore();
  QApplication::sendEvent(&m_canvas, &undo);
  EXPECT_FALSE(undo.isAccepted());
}

} // namespace
} // namespace limn
