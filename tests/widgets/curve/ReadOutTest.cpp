// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/curve/CanvasFixture.h"
#include "widgets/curve/picture/CanvasPicture.h"

// What the plot tells of a value or a point, and where.

namespace limn {
namespace {

class ReadOut : public CanvasFixture {
protected:
  QString told() { return readOutText(m_canvas.picture()); }
  void point(const QPoint& at) { moveTo(at, at, {}, Qt::NoButton, 1); }
};

TEST_F(ReadOut, namesTheTissueUnderThePointerAndOfThePointInHand) {
  m_canvas.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&m_canvas));
  EXPECT_EQ(told(), QString());
  point(pixel(500.0, 0.9));
  EXPECT_TRUE(told().endsWith(QStringLiteral(" · bone, dense contrast agent"))) << told().toStdString();
  QTest::mouseClick(&m_canvas, Qt::LeftButton, {}, pixelOf(4)); // 1200 HU
  EXPECT_EQ(told(), QString::fromUtf8("1200\u00a0HU · opacity 0.9 · compact bone, dentine"));
  point(pixel(500.0, 0.9)); // while the point is selected
  EXPECT_TRUE(told().endsWith(QStringLiteral("bone, dense contrast agent"))) << told().toStdString();
  QEvent leave(QEvent::Leave);
  QCoreApplication::sendEvent(&m_canvas, &leave);
  EXPECT_TRUE(told().endsWith(QStringLiteral("compact bone, dentine"))) << told().toStdString();
  ASSERT_TRUE(toldTissue(m_canvas.picture()));
  EXPECT_EQ(toldTissue(m_canvas.picture())->range.lowest, 700.0) << "its band is marked, too";
  QTest::keyClick(&m_canvas, Qt::Key_Backtab); // 300 HU
  EXPECT_TRUE(told().startsWith(QString::fromUtf8("300\u00a0HU · opacity 0.4"))) << told().toStdString();
  m_canvas.setUnit({});
  EXPECT_EQ(told(), QStringLiteral("300 · opacity 0.4"));
}

TEST_F(ReadOut, namesOfTissuesLieClearOfCurveAndHistogram) {
  CanvasPicture picture = m_canvas.picture();
  const QRectF& field = picture.transform.plot;
  const double left = field.center().x(), width = 60.0;
  picture.function.points.clear();
  picture.histogram.line.clear();
  EXPECT_NEAR(tissueNamePlace(picture, left, width).top(), field.top(), 2.0);
  picture.function = {1.0, {{0.0, glm::dvec3(1.0), 0.98}}};
  const QRectF lowest = tissueNamePlace(picture, left, width);
  EXPECT_NEAR(lowest.bottom(), field.bottom(), 2.0) << "the curve runs along the upper edge";
  const double height = field.height() - 6.0; // of the edge: within the lowest row
  picture.histogram.line << QPointF(0.0, height) << QPointF(field.width(), height);
  const QRectF above = tissueNamePlace(picture, left, width);
  EXPECT_LE(above.bottom(), field.top() + height);
  EXPECT_NEAR(above.bottom(), lowest.top(), 1e-9) << "in the row above that";
}

TEST_F(ReadOut, leavesBarCurveAndPointsInSight) {
  const PlotTransform transform = m_canvas.transform();
  const QPolygonF curve = curvePolygon(transform, m_canvas.transferFunction());
  for (double x = transform.plot.left(); x <= transform.plot.right(); x += 7.0) {
    const QRectF box = clearPlace(transform, m_canvas.transferFunction(), {190.0, 20.0}, x);
    EXPECT_TRUE(transform.plot.contains(box)) << "the bar is above the plot";
    for (const QPointF& corner : curve)
      EXPECT_FALSE(box.contains(corner)) << x;
    for (const ControlPoint& point : points())
      EXPECT_FALSE(box.contains(positionOf(transform, point))) << x;
    // Close to the value: beside its line at most.
    EXPECT_LE(std::max(box.left() - x, x - box.right()), 190.0) << x;
  }
}

TEST_F(ReadOut, standsAboveItsPointUnlessThatHidesAnother) {
  const PlotTransform transform = m_canvas.transform();
  const auto at = [&](double x, double y) {
    return ControlPoint{valueAtX(transform, transform.plot.left() + x), glm::dvec3(1.0),
                        opacityAtY(transform, y)};
  };
  const double middle = transform.plot.center().y();
  TransferFunction function;
  function.points = {at(100.0, middle), at(400.0, middle)};
  const QPointF first = positionOf(transform, function.points[0]);
  const QRectF above = placeAbove(transform, function, {120.0, 20.0}, first);
  EXPECT_NEAR(above.bottom(), first.y() - 12.0, 1e-9);
  function.points.insert(function.points.begin() + 1, at(130.0, middle - 20.0));
  const QRectF moved = placeAbove(transform, function, {120.0, 20.0}, first);
  for (const ControlPoint& point : function.points)
    EXPECT_FALSE(moved.adjusted(-5.0, -5.0, 5.0, 5.0).contains(positionOf(transform, point)));
}

// A curve that goes up and down every 40 pixels leaves no place of 190 free of itself, nor the edges free of
// its points.
TEST_F(ReadOut, crossesTheCurveRatherThanHideAPoint) {
  const PlotTransform transform = m_canvas.transform();
  TransferFunction zigzag;
  for (double x = transform.plot.left() + 20.0; x < transform.plot.right(); x += 40.0)
    zigzag.points.push_back(
        {valueAtX(transform, x), glm::dvec3(1.0), zigzag.points.size() % 2 == 0 ? 0.02 : 0.98});
  const QPolygonF curve = curvePolygon(transform, zigzag);
  int crossings = 0;
  for (double x = transform.plot.left(); x <= transform.plot.right(); x += 7.0) {
    const QRectF box = clearPlace(transform, zigzag, {190.0, 20.0}, x);
    EXPECT_TRUE(transform.plot.contains(box)) << x;
    for (const ControlPoint& point : zigzag.points)
      EXPECT_FALSE(box.adjusted(-5.0, -5.0, 5.0, 5.0).contains(positionOf(transform, point))) << x;
    for (qsizetype i = 1; i < curve.size(); ++i)
      for (double along = 0.0; along < 1.0; along += 0.05)
        crossings += box.contains(curve[i - 1] + along * (curve[i] - curve[i - 1]));
  }
  EXPECT_GT(crossings, 0) << "there was no other place";
}

} // namespace
} // namespace limn
