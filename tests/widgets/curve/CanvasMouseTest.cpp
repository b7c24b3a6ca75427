// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/ValueText.h"
#include "widgets/curve/CanvasFixture.h"

#include <QApplication>
#include <QMenu>
#include <QMouseEvent>

namespace limn {
namespace {

// Pixels are whole, so a dragged point lands within half a pixel of the wish: 4.3 HU on this plot.
constexpr double halfPixel = 0.5;

TEST_F(CanvasFixture, settingValuesEmitsNothing) {
  m_canvas.setTransferFunction(shifted(sampleFunction(), 10.0));
  m_canvas.setHistogram(sampleHistogram());
  m_canvas.setUnit(QStringLiteral("HU"));
  m_canvas.setMark(ValueMark{12.0});
  m_canvas.setPinnedValue(40.0);
  m_canvas.setFineLowOpacities(true);
  EXPECT_TRUE(m_edits.empty());
}

TEST_F(CanvasFixture, aClickOnTheCurveAddsAPointOfTheCurvesOpacityAndColour) {
  const TransferFunction before = m_canvas.transferFunction();
  // Halfway between 300 HU (0.4) and 1200 HU (0.9): opacity 0.65 at 750 HU.
  const QPoint place = pixel(750.0, 0.65);
  QTest::mouseClick(&m_canvas, Qt::LeftButton, {}, place);
  ASSERT_EQ(m_edits.size(), 1u);
  ASSERT_EQ(points().size(), 6u);
  // As it is told, in whole HU: a pixel spans several.
  const double value = std::round(valueAtX(m_canvas.transform(), place.x()));
  ASSERT_GT(valuePerPixel(m_canvas.transform()), 1.0);
  EXPECT_EQ(points()[4].value, value);
  EXPECT_DOUBLE_EQ(points()[4].opacity, classify(before, value).opacity);
  EXPECT_EQ(points()[4].color, classify(before, value).color);
  EXPECT_EQ(m_canvas.selected(), PointIndices{4});
  EXPECT_TRUE(m_edits[0].second.text.startsWith(QStringLiteral("add point at 7")));
}

TEST_F(CanvasFixture, aPressOnTheCurveThatGoesOnAsADragIsOneGesture) {
  const QPoint from = pixel(750.0, 0.65);
  drag(from, from + QPoint(20, 30));
  EXPECT_EQ(points().size(), 6u);
  EXPECT_GT(m_edits.size(), 2u);
  expectOneGesture();
}

TEST_F(CanvasFixture, aDoubleClickOnEmptySpaceAddsAPointThere) {
  const QPoint place = emptyPlace();
  QTest::mouseDClick(&m_canvas, Qt::LeftButton, {}, place);
  ASSERT_EQ(points().size(), 6u);
  ASSERT_EQ(m_edits.size(), 1u);
  EXPECT_EQ(points()[0].value, std::round(valueAtX(m_canvas.transform(), place.x())));
  EXPECT_DOUBLE_EQ(points()[0].opacity, opacityAtY(m_canvas.transform(), place.y()));
}

TEST_F(CanvasFixture, aDoubleClickOnTheCurveAddsOnePointAndOpensNothing) {
  int details = 0;
  QObject::connect(&m_canvas, &TransferFunctionCanvas::pointDetailsRequested, &m_canvas, [&] { ++details; });
  QTest::mouseDClick(&m_canvas, Qt::LeftButton, {}, pixel(750.0, 0.65)); // the first press adds
  EXPECT_EQ(points().size(), 6u);
  EXPECT_EQ(details, 0);
}

TEST_F(CanvasFixture, aDoubleClickOnAPointAsksForItsDetails) {
  std::vector<std::size_t> asked;
  QObject::connect(&m_canvas, &TransferFunctionCanvas::pointDetailsRequested, &m_canvas,
                   [&](std::size_t index) { asked.push_back(index); });
  QTest::mouseDClick(&m_canvas, Qt::LeftButton, {}, pixelOf(3));
  EXPECT_EQ(asked, std::vector<std::size_t>{3});
  EXPECT_TRUE(m_edits.empty());
}

TEST_F(CanvasFixture, aDoubleClickOnOneOfSeveralPointsKeepsThemInHand) {
  std::vector<PointIndices> inHand;
  QObject::connect(&m_canvas, &TransferFunctionCanvas::pointDetailsRequested, &m_canvas,
                   [&](std::size_t) { inHand.push_back(m_canvas.selected()); });
  // As a window gets it: the second press comes as a double click.
  const auto doubleClick = [this](std::size_t point) {
    const QPointF at = pixelOf(point);
    QTest::mouseClick(&m_canvas, Qt::LeftButton, {}, at.toPoint());
    QMouseEvent second(QEvent::MouseButtonDblClick, at, m_canvas.mapToGlobal(at), Qt::LeftButton,
                       Qt::LeftButton, {});
    QApplication::sendEvent(&m_canvas, &second);
    QTest::mouseRelease(&m_canvas, Qt::LeftButton, {}, at.toPoint());
  };
  m_canvas.selectPoints({1, 3});
  doubleClick(3);
  EXPECT_EQ(inHand, (std::vector<PointIndices>{{1, 3}}));
  EXPECT_EQ(m_canvas.selected(), (PointIndices{1, 3}));
  doubleClick(2);
  EXPECT_EQ(inHand.back(), PointIndices{2}) << "which was none of them";
  // One click takes one of several, as ever.
  m_canvas.selectPoints({1, 3});
  QTest::mouseClick(&m_canvas, Qt::LeftButton, {}, pixelOf(3));
  EXPECT_EQ(m_canvas.selected(), PointIndices{3});
  EXPECT_TRUE(m_edits.empty());
}

TEST_F(CanvasFixture, aClickOnEmptySpaceClearsTheSelectionAndChangesNothing) {
  m_canvas.selectPoints({1, 2});
  QTest::mouseClick(&m_canvas, Qt::LeftButton, {}, emptyPlace());
  EXPECT_TRUE(m_canvas.selected().empty());
  EXPECT_TRUE(m_edits.empty());
}

TEST_F(CanvasFixture, draggingAPointMovesItUnderOneGestureNamedByItsValue) {
  const QPoint from = pixelOf(2);
  const QPoint to = from + QPoint(25, -40);
  drag(from, to);
  expectOneGesture();
  const double value = std::round(60.0 + 25.0 * perPixel());
  EXPECT_NEAR(points()[2].value, value, 1e-9);
  EXPECT_NEAR(points()[2].opacity, 0.2 + 40.0 / m_canvas.transform().plot.height(), 1e-12);
  EXPECT_EQ(m_edits.back().second.text, QStringLiteral("move point to ") +
                                            valueText(value, QStringLiteral("HU"), m_canvas.shownDecimals()));
}

TEST_F(CanvasFixture, aDraggedPointStopsAtItsNeighbours) {
  const QPoint from = pixelOf(2);
  drag(from, from + QPoint(400, 0));
  EXPECT_DOUBLE_EQ(points()[2].value, 300.0);
  EXPECT_DOUBLE_EQ(points()[2].opacity, 0.2);
}

TEST_F(CanvasFixture, endPointsMoveToo) {
  const QPoint from = pixelOf(4);
  drag(from, from + QPoint(30, 0));
  EXPECT_NEAR(points()[4].value, std::round(1200.0 + 30.0 * perPixel()), 1e-9);
}

TEST_F(CanvasFixture, shiftLocksTheAxisAlongWhichTheDragWentLess) {
  const QPoint from = pixelOf(2);
  drag(from, from + QPoint(20, -9), Qt::ShiftModifier);
  EXPECT_DOUBLE_EQ(points()[2].opacity, 0.2);
  EXPECT_NEAR(points()[2].value, std::round(60.0 + 20.0 * perPixel()), 1e-9);
}

TEST_F(CanvasFixture, altMovesATenthAsFar) {
  const QPoint from = pixelOf(2);
  drag(from, from + QPoint(30, -50), Qt::AltModifier);
  EXPECT_NEAR(points()[2].value, 60.0 + 3.0 * perPixel(), 1e-9);
  EXPECT_NEAR(points()[2].opacity, 0.2 + 5.0 / m_canvas.transform().plot.height(), 1e-12);
}

TEST_F(CanvasFixture, escBringsBackTheFunctionUnderTheSameGesture) {
  const TransferFunction before = m_canvas.transferFunction();
  pressAndMove(pixelOf(2), pixelOf(2) + QPoint(30, -50));
  ASSERT_NE(m_canvas.transferFunction(), before);
  QTest::keyClick(&m_canvas, Qt::Key_Escape);
  EXPECT_EQ(m_canvas.transferFunction(), before);
  EXPECT_EQ(m_edits.back().first, before);
  expectOneGesture();
  const std::size_t edits = m_edits.size();
  moveTo(pixelOf(2), pixelOf(2) + QPoint(60, 0)); // the button is still down
  EXPECT_EQ(m_edits.size(), edits);
}

TEST_F(CanvasFixture, escTakesBackAPointThatThePressAdded) {
  const TransferFunction before = m_canvas.transferFunction();
  const QPoint from = pixel(750.0, 0.65);
  pressAndMove(from, from + QPoint(20, 30));
  QTest::keyClick(&m_canvas, Qt::Key_Escape);
  EXPECT_EQ(m_canvas.transferFunction(), before);
  expectOneGesture();
}

TEST_F(CanvasFixture, aForeignFunctionEndsTheDrag) {
  pressAndMove(pixelOf(2), pixelOf(2) + QPoint(30, 0));
  const TransferFunction other = shifted(sampleFunction(), 500.0);
  m_canvas.setTransferFunction(other);
  const std::size_t edits = m_edits.size();
  moveTo(pixelOf(2), pixelOf(2) + QPoint(50, 0));
  EXPECT_EQ(m_canvas.transferFunction(), other);
  EXPECT_EQ(m_edits.size(), edits);
}

TEST_F(CanvasFixture, aRubberBandSelectsThePointsInside) {
  drag(pixel(-500.0, 0.5), pixel(200.0, 0.02));
  EXPECT_EQ(m_canvas.selected(), (PointIndices{1, 2}));
  EXPECT_TRUE(m_edits.empty());
}

TEST_F(CanvasFixture, draggingOneSelectedPointMovesAll) {
  m_canvas.selectPoints({1, 2});
  const QPoint from = pixelOf(2);
  drag(from, from + QPoint(10, -20));
  const double offset = std::round(10.0 * perPixel()); // the point in hand lands on a whole value
  const double rise = 20.0 / m_canvas.transform().plot.height();
  EXPECT_NEAR(points()[1].value, -60.0 + offset, 1e-9);
  EXPECT_NEAR(points()[2].value, 60.0 + offset, 1e-9);
  EXPECT_NEAR(points()[1].opacity, 0.05 + rise, 1e-12);
  EXPECT_NEAR(points()[2].opacity, 0.2 + rise, 1e-12);
  EXPECT_EQ(m_edits.back().second.text, QStringLiteral("move 2 points"));
  expectOneGesture();
}

TEST_F(CanvasFixture, aMiddleClickOnAPointDeletesIt) {
  QTest::mouseClick(&m_canvas, Qt::MiddleButton, {}, pixelOf(1));
  ASSERT_EQ(points().size(), 4u);
  EXPECT_DOUBLE_EQ(points()[1].value, 60.0);
  EXPECT_EQ(m_edits.size(), 1u);
}

TEST_F(CanvasFixture, theMiddleButtonPansAndChangesNoPoint) {
  wheel(pixel(200.0, 0.5), 8); // there is nothing to pan while all is shown
  const PlotTransform before = m_canvas.transform();
  drag(pixel(200.0, 0.8), pixel(200.0, 0.8) + QPoint(40, 0), {}, Qt::MiddleButton);
  EXPECT_NEAR(m_canvas.transform().visible.lowest, before.visible.lowest - 40.0 * valuePerPixel(before),
              1e-9);
  EXPECT_TRUE(m_edits.empty());
}

TEST_F(CanvasFixture, spaceAndTheLeftButtonPan) {
  wheel(pixel(200.0, 0.5), 8);
  const PlotTransform before = m_canvas.transform();
  QTest::keyPress(&m_canvas, Qt::Key_Space);
  drag(pixelOf(2), pixelOf(2) + QPoint(-30, 0));
  QTest::keyRelease(&m_canvas, Qt::Key_Space);
  EXPECT_NEAR(m_canvas.transform().visible.lowest, before.visible.lowest + 30.0 * valuePerPixel(before),
              1e-9);
  EXPECT_TRUE(m_edits.empty());
}

TEST_F(CanvasFixture, theRightButtonOpensAMenuThatStartsWithDelete) {
  QTest::mouseClick(&m_canvas, Qt::RightButton, {}, pixelOf(2));
  auto* menu = m_canvas.findChild<QMenu*>();
  ASSERT_NE(menu, nullptr);
  EXPECT_EQ(menu->actions().front()->text(), QStringLiteral("Delete"));
  menu->actions().front()->trigger();
  menu->close();
  ASSERT_EQ(m_edits.size(), 1u);
  EXPECT_EQ(points().size(), 4u);
}

TEST_F(CanvasFixture, draggingTheBarShiftsTheWholeCurve) {
  const QPoint from = barGrip();
  drag(from, from + QPoint(35, 4));
  const TransferFunction expected = shifted(sampleFunction(), 35.0 * perPixel());
  for (std::size_t i = 0; i < points().size(); ++i)
    EXPECT_NEAR(points()[i].value, expected.points[i].value, 1e-9);
  EXPECT_TRUE(m_edits.back().second.text.startsWith(QStringLiteral("shift curve by")));
  expectOneGesture();
}

TEST_F(CanvasFixture, altOnTheBarChangesTheWidthAroundTheMiddle) {
  const QPoint from = barGrip();
  QTest::mousePress(&m_canvas, Qt::LeftButton, Qt::AltModifier, from);
  moveTo(from, from + QPoint(120, 0), Qt::AltModifier);
  QTest::mouseRelease(&m_canvas, Qt::LeftButton, Qt::AltModifier, from + QPoint(120, 0));
  // 120 pixels double the width: 1400 HU about 500 HU become 2800 HU.
  EXPECT_NEAR(points().front().value, 500.0 - 1400.0, 1e-9);
  EXPECT_NEAR(points().back().value, 500.0 + 1400.0, 1e-9);
  expectOneGesture();
}

TEST_F(CanvasFixture, theEndsOfTheBarFollowThePointer) {
  const CurveBar bar = *curveBar(m_canvas.transform(), m_canvas.transferFunction());
  const QPoint from = bar.end.toPoint();
  drag(from, from + QPoint(50, 0));
  EXPECT_NEAR(points().back().value, 1200.0 + 50.0 * perPixel(), halfPixel * perPixel());
  EXPECT_NEAR(middleValue(m_canvas.transferFunction()), 500.0, 1e-9);
}

TEST_F(CanvasFixture, theWheelZoomsAtTheCursor) {
  const QPoint place = pixel(200.0, 0.5);
  const double held = valueAtX(m_canvas.transform(), place.x());
  const double before = perPixel();
  wheel(place, 3);
  EXPECT_NEAR(perPixel(), before / std::pow(1.25, 3), 1e-9);
  EXPECT_NEAR(valueAtX(m_canvas.transform(), place.x()), held, 1e-9);
  EXPECT_TRUE(m_edits.empty());
}

TEST_F(CanvasFixture, shiftAndTheWheelPan) {
  wheel(pixel(200.0, 0.5), 8);
  const ValueRange before = m_canvas.transform().visible;
  wheel(pixel(200.0, 0.5), 1, Qt::ShiftModifier);
  const ValueRange after = m_canvas.transform().visible;
  EXPECT_LT(after.lowest, before.lowest);
  EXPECT_NEAR(after.highest - after.lowest, before.highest - before.lowest, 1e-9);
}

TEST_F(CanvasFixture, aDoubleClickOnTheAxisShowsAllValues) {
  const ValueRange all = m_canvas.transform().visible;
  wheel(pixel(200.0, 0.5), 8);
  ASSERT_NE(m_canvas.transform().visible, all);
  QTest::mouseDClick(&m_canvas, Qt::LeftButton, {}, QPoint(500, m_canvas.height() - 8));
  EXPECT_EQ(m_canvas.transform().visible, all);
}

TEST_F(CanvasFixture, theHoveredValueIsReportedAndWithdrawn) {
  std::vector<std::optional<double>> hovered;
  QObject::connect(&m_canvas, &TransferFunctionCanvas::valueHovered, &m_canvas,
                   [&](std::optional<double> value) { hovered.push_back(value); });
  moveTo(emptyPlace(), emptyPlace(), {}, Qt::NoButton, 1);
  QEvent leave(QEvent::Leave);
  QApplication::sendEvent(&m_canvas, &leave);
  ASSERT_EQ(hovered.size(), 2u);
  EXPECT_DOUBLE_EQ(*hovered[0], valueAtX(m_canvas.transform(), emptyPlace().x()));
  EXPECT_EQ(hovered[1], std::nullopt);
}

TEST_F(CanvasFixture, onTheFineScaleADragFollowsThePointer) {
  m_canvas.setFineLowOpacities(true);
  const QPoint from = pixelOf(1);
  const QPoint to(from.x(), pixel(0.0, 0.001).y());
  drag(from, to);
  // Half a pixel near 0.001 is at most 3 · 0.1² · 0.5/240 = 6e-5 of opacity.
  EXPECT_NEAR(points()[1].opacity, 0.001, 1.5e-4);
}

} // namespace
} // namespace limn
