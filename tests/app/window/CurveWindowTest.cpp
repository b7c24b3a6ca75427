// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "widgets/FindWidget.h"
#include "widgets/controls/ColorPicker.h"
#include "widgets/curve/PointFields.h"
#include "widgets/curve/picture/CurveGeometry.h"

#include <QLineEdit>
#include <QPointer>
#include <QToolButton>

// The curve's plot in the program's window.

namespace limn {
namespace {

class CurveWindow : public test::WindowHarness {
protected:
  TransferFunctionCanvas& plot() const { return *curves().valueEditor()->canvas(); }
};

TEST_F(CurveWindow, thePopUpOfAPointLeavesItInSightAndItsPartsStandInLine) {
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  for (const QSize& size : {QSize(1280, 800), QSize(900, 640)}) {
    window->resize(size);
    QCoreApplication::processEvents();
    const PlotTransform transform = plot().transform();
    int seen = 0;
    for (const ControlPoint& point : plot().transferFunction().points) {
      const QPointF at(xOfValue(transform, point.value), yOfOpacity(transform, point.opacity));
      if (!transform.plot.contains(at))
        continue;
      QTest::mouseDClick(&plot(), Qt::LeftButton, {}, at.toPoint());
      auto* popup = window->findChild<PointPopup*>();
      ASSERT_NE(popup, nullptr);
      ASSERT_TRUE(test::waitUntilExposed(*popup));
      EXPECT_FALSE(popup->geometry().contains(plot().mapToGlobal(at).toPoint())) << point.value;
      EXPECT_TRUE(popup->screen()->geometry().contains(popup->geometry()));
      const QWidget& row = *popup->fields();
      const QWidget& picker = *popup->findChild<ColorPicker*>();
      EXPECT_EQ(picker.geometry().left(), row.geometry().left());
      EXPECT_EQ(picker.geometry().right(), row.geometry().right());
      delete popup;
      ++seen;
    }
    EXPECT_GT(seen, 1);
  }
}

TEST_F(CurveWindow, escInThePopUpOfAPointLeavesTheColourOfBefore) {
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  const TransferFunction before = scene().transferFunction;
  for (const bool isInNumbers : {true, false}) {
    const QPointF at = positionOf(plot().transform(), before.points[2]);
    QTest::mouseDClick(&plot(), Qt::LeftButton, {}, at.toPoint());
    const QPointer<PointPopup> popup = window->findChild<PointPopup*>();
    ASSERT_TRUE(popup && test::waitUntilExposed(*popup));
    auto* picker = popup->findChild<ColorPicker*>();
    for (const QPoint& place : {QPoint(10, 10), QPoint(60, 60)})
      QTest::mouseClick(picker, Qt::LeftButton, {}, place);
    ASSERT_NE(scene().transferFunction.points[2].color, before.points[2].color);
    EXPECT_EQ(undo().count(), 1) << "one step for all that was tried";
    QTest::keyClick(isInNumbers ? popup->focusWidget() : picker, Qt::Key_Escape);
    EXPECT_FALSE(popup && popup->isVisible());
    EXPECT_EQ(scene().transferFunction, before);
    EXPECT_EQ(undo().count(), 0);
    delete popup;
  }
}

// Whoever closes the pop-up is elsewhere by then, and no event tells the curve so.
TEST_F(CurveWindow, nothingStaysUnderThePointerOnceThePopUpIsClosedOrTheVolumeAnother) {
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  const QPoint at = positionOf(plot().transform(), plot().transferFunction().points[2]).toPoint();
  const auto moveOver = [&] {
    QMouseEvent event(QEvent::MouseMove, QPointF(at), plot().mapToGlobal(QPointF(at)), Qt::NoButton,
                      Qt::NoButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&plot(), &event);
  };
  QTest::mouseDClick(&plot(), Qt::LeftButton, {}, at);
  const QPointer<PointPopup> popup = window->findChild<PointPopup*>();
  ASSERT_TRUE(popup && test::waitUntilExposed(*popup));
  moveOver(); // as the release comes after the pop-up has opened
  ASSERT_TRUE(plot().picture().hoveredPoint);
  popup->close();
  ASSERT_TRUE(test::waitUntil([&] { return popup.isNull(); }));
  EXPECT_FALSE(plot().picture().hoveredPoint);
  EXPECT_FALSE(plot().picture().hoveredValue);
  moveOver();
  EXPECT_TRUE(plot().picture().hoveredPoint) << "once the pointer moves over it again";
  QTest::mouseClick(&plot(), Qt::LeftButton, {}, at);
  ASSERT_EQ(plot().selected(), PointIndices{2});
  ASSERT_TRUE(open(QStringLiteral("phantom:6")));
  EXPECT_FALSE(plot().picture().hoveredPoint);
  EXPECT_FALSE(plot().picture().hoveredValue);
  EXPECT_TRUE(plot().selected().empty());
}

TEST_F(CurveWindow, aDoubleClickOnOneOfSeveralPointsEditsAllOfThem) {
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  const TransferFunction before = scene().transferFunction;
  ASSERT_GT(before.points.size(), 3u);
  plot().selectPoints({1, 2});
  const QPoint at = plot().mapTo(window.get(), positionOf(plot().transform(), before.points[2]).toPoint());
  QTest::mouseDClick(window->windowHandle(), Qt::LeftButton, {}, at);
  const QPointer<PointPopup> popup = window->findChild<PointPopup*>();
  ASSERT_TRUE(popup && test::waitUntilExposed(*popup));
  EXPECT_EQ(plot().selected(), (PointIndices{1, 2}));
  const QPoint white =
      popup->findChild<ColorPicker*>()->mapTo(popup->window(), QPoint(1, 1)); // of the field of colours
  QTest::mouseClick(popup->windowHandle(), Qt::LeftButton, {}, white);
  const std::vector<ControlPoint>& now = scene().transferFunction.points;
  EXPECT_GT(now[1].color.b, 0.98);
  EXPECT_EQ(now[1].color, now[2].color);
  EXPECT_EQ(now[3], before.points[3]);
  EXPECT_EQ(undo().count(), 1);
  popup->close();
  EXPECT_EQ(plot().selected(), (PointIndices{1, 2}));
}

TEST_F(CurveWindow, enterAndEscInTheNumbersOfAPointLeadBackToIt) {
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  plot().setFocus();
  plot().takeInHand(2);
  const double before = plot().transferFunction().points[2].opacity;
  QTest::keyClick(&plot(), Qt::Key_Return);
  QWidget* value = QApplication::focusWidget();
  ASSERT_NE(value, &plot());
  QTest::keyClick(value, Qt::Key_Tab);
  QWidget* opacity = QApplication::focusWidget();
  QTest::keyClicks(opacity, QStringLiteral("0.25"));
  EXPECT_EQ(plot().transferFunction().points[2].opacity, before) << "not before Enter";
  QTest::keyClick(opacity, Qt::Key_Return);
  EXPECT_EQ(scene().transferFunction.points[2].opacity, 0.25);
  EXPECT_EQ(undo().count(), 1);
  EXPECT_EQ(QApplication::focusWidget(), &plot());
  EXPECT_EQ(plot().selected(), PointIndices{2});

  QTest::keyClick(&plot(), Qt::Key_Return);
  QTest::keyClicks(value, QStringLiteral("77"));
  QTest::keyClick(value, Qt::Key_Escape);
  EXPECT_EQ(undo().count(), 1) << "what was typed is taken back";
  EXPECT_EQ(QApplication::focusWidget(), &plot());
  EXPECT_EQ(plot().selected(), PointIndices{2});
  QTest::keyClick(&plot(), Qt::Key_Up);
  EXPECT_GT(scene().transferFunction.points[2].opacity, 0.25) << "the keys are the point's again";
}

TEST_F(CurveWindow, aPointGetsAColourByTheKeyboardAlone) {
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  for (const bool isInPopup : {false, true}) {
    plot().setFocus();
    plot().takeInHand(2);
    if (isInPopup) {
      const QPointF at = positionOf(plot().transform(), plot().transferFunction().points[2]);
      QTest::mouseDClick(&plot(), Qt::LeftButton, {}, at.toPoint());
    } else {
      QTest::keyClick(&plot(), Qt::Key_Return);
      QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
      QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
      QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
    }
    ColorPicker* picker = nullptr;
    for (ColorPicker* one : window->findChildren<ColorPicker*>())
      if (one->isVisible())
        picker = one;
    ASSERT_NE(picker, nullptr);
    ASSERT_TRUE(test::waitUntilExposed(*picker->window()));
    auto* hex = picker->findChild<QLineEdit*>();
    if (!isInPopup) {
      EXPECT_EQ(picker->window()->focusWidget(), hex);
    }
    hex->setFocus();
    hex->selectAll();
    QTest::keyClicks(hex, isInPopup ? QStringLiteral("blue") : QStringLiteral("#ff0000"));
    QTest::keyClick(hex, Qt::Key_Return);
    EXPECT_FALSE(picker->isVisible());
    EXPECT_EQ(scene().transferFunction.points[2].color,
              isInPopup ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(1.0, 0.0, 0.0));
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }
}

TEST_F(CurveWindow, aTissueClickedInThePictureIsMadeTransparentByOneMoreClick) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  ASSERT_TRUE(rest());
  QTest::mouseClick(window->windowHandle(), Qt::LeftButton, Qt::ShiftModifier,
                    view().mapTo(window.get(), QPoint(view().width() / 4, view().height() / 2)));
  ASSERT_TRUE(test::waitUntil([&] { return plot().pinnedValue().has_value(); }));
  const double value = *plot().pinnedValue();
  const double before = classify(scene().transferFunction, value).opacity;
  ASSERT_GT(before, 0.0) << "what was clicked is what shows";
  const int steps = undo().count();
  QTest::mouseClick(widgetNamed<QToolButton>(*curves().valueEditor(), "Less of the pinned tissue"),
                    Qt::LeftButton);
  EXPECT_NEAR(classify(scene().transferFunction, value).opacity, before / 2.0, 1e-9);
  EXPECT_EQ(undo().count(), steps + 1);
  undo().undo();
  EXPECT_EQ(classify(scene().transferFunction, value).opacity, before);
}

} // namespace
} // namespace limn
