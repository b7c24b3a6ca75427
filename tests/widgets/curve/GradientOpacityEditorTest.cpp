// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/curve/GradientOpacityEditor.h"
#include "scene/light/GradientHistogram.h"
#include "widgets/FindWidget.h"
#include "widgets/WidgetSamples.h"
#include "widgets/controls/ColorPicker.h"
#include "widgets/controls/NumberField.h"
#include "widgets/curve/CurvePanel.h"
#include "widgets/curve/PointFields.h"
#include "widgets/curve/TransferFunctionEditor.h"
#include "widgets/curve/canvas/TransferFunctionCanvas.h"

#include <QApplication>
#include <QCheckBox>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

#include <gtest/gtest.h>

namespace limn {
namespace {

// Falls evenly over 0..1000 HU/mm.
Histogram fallingGradients() {
  Histogram histogram{{0.0, 1000.0}, std::vector<std::uint64_t>(1000)};
  for (std::size_t i = 0; i < 1000; ++i)
    histogram.counts[i] = 1000 - i;
  return histogram;
}

NumberField* valueFieldOf(const QWidget& parent) {
  return widgetNamed<NumberField>(parent, "Gradient of the selected point");
}

class GradientEditor : public testing::Test {
protected:
  GradientEditor() {
    m_panel.resize(1200, 300);
    m_panel.show();
    m_panel.showGradient(true);
    editor().setUnit(QStringLiteral("HU"));
    QObject::connect(&editor(), &GradientOpacityEditor::gradientOpacityEdited, &editor(),
                     [this](const std::optional<GradientOpacity>& curve, const Gesture& gesture) {
                       m_edits.emplace_back(curve, gesture);
                       editor().setGradientOpacity(curve); // as a session echoes it
                     });
  }

  GradientOpacityEditor& editor() { return *m_panel.gradientEditor(); }
  TransferFunctionCanvas& canvas() { return *editor().editor()->canvas(); }
  QPoint pixel(double gradient, double opacity) {
    return QPointF(xOfValue(canvas().transform(), gradient), yOfOpacity(canvas().transform(), opacity))
        .toPoint();
  }
  void drag(const QPoint& from, const QPoint& to) {
    QTest::mousePress(&canvas(), Qt::LeftButton, {}, from);
    for (const QPoint& at : {(from + to) / 2, to}) {
      QMouseEvent event(QEvent::MouseMove, at, canvas().mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
      QApplication::sendEvent(&canvas(), &event);
    }
    QTest::mouseRelease(&canvas(), Qt::LeftButton, {}, to);
  }
  QCheckBox* useBox() {
    return widgetNamed<QCheckBox>(editor(), "Use the curve of opacity over the gradient");
  }
  void tick() { QTest::mouseClick(useBox(), Qt::LeftButton, {}, {8, useBox()->height() / 2}); }

  CurvePanel m_panel;
  std::vector<std::pair<std::optional<GradientOpacity>, Gesture>> m_edits;
};

TEST_F(GradientEditor, isSwitchedOnWithARampOfTheVolumesOwnGradients) {
  EXPECT_FALSE(useBox()->isEnabled()); // there is nothing to make a ramp of
  editor().setHistogram(fallingGradients());
  EXPECT_FALSE(canvas().isEnabled());
  EXPECT_TRUE(m_edits.empty());
  tick();
  ASSERT_EQ(m_edits.size(), 1u);
  EXPECT_EQ(m_edits[0].first, boundaryRamp(fallingGradients()));
  EXPECT_EQ(m_edits[0].second.text, QStringLiteral("use opacity over gradient"));
  EXPECT_TRUE(canvas().isEnabled());
  EXPECT_EQ(canvas().transferFunction().points.size(), 2u);
}

TEST_F(GradientEditor, comesBackAsItWasWhenSwitchedOffAndOn) {
  editor().setHistogram(fallingGradients());
  const GradientOpacity own{{{10.0, 0.25}, {500.0, 0.75}}};
  editor().setGradientOpacity(own);
  EXPECT_TRUE(useBox()->isChecked());
  tick();
  EXPECT_FALSE(m_edits.back().first.has_value());
  EXPECT_TRUE(canvas().transferFunction().points.empty());
  tick();
  EXPECT_EQ(m_edits.back().first, own);
  EXPECT_NE(m_edits[0].second.id, m_edits[1].second.id);
}

TEST_F(GradientEditor, anotherVolumesCurveDoesNotComeBack) {
  editor().setHistogram(fallingGradients());
  editor().setGradientOpacity(GradientOpacity{{{10.0, 0.25}}});
  editor().setGradientOpacity(std::nullopt);
  editor().setHistogram(std::nullopt); // another volume
  editor().setHistogram(fallingGradients());
  tick();
  EXPECT_EQ(m_edits.back().first, boundaryRamp(fallingGradients()));
}

TEST_F(GradientEditor, aPointIsDraggedAsOneGestureAndNotBelowZero) {
  editor().setHistogram(fallingGradients());
  editor().setGradientOpacity(GradientOpacity{{{200.0, 0.2}, {600.0, 0.9}}});
  drag(pixel(200.0, 0.2), pixel(200.0, 0.2) + QPoint(-400, -30));
  ASSERT_GE(m_edits.size(), 2u);
  for (const auto& [curve, gesture] : m_edits)
    EXPECT_EQ(gesture.id, m_edits[0].second.id);
  EXPECT_EQ(m_edits.back().second.text, QString(QStringLiteral("move point to 0%1HU/mm")).arg(QChar(0x00a0)));
  ASSERT_EQ(m_edits.back().first->points.size(), 2u);
  EXPECT_EQ(m_edits.back().first->points[0].gradient, 0.0);
  EXPECT_GT(m_edits.back().first->points[0].opacity, 0.2);
  EXPECT_EQ(m_edits.back().first->points[1], (GradientOpacityPoint{600.0, 0.9}));
}

TEST_F(GradientEditor, pointsAreAddedAndDeletedLikeThoseOfTheOtherCurve) {
  editor().setHistogram(fallingGradients());
  editor().setGradientOpacity(GradientOpacity{{{200.0, 0.0}, {600.0, 1.0}}});
  QTest::mouseClick(&canvas(), Qt::LeftButton, {}, pixel(400.0, 0.5)); // on the curve
  ASSERT_EQ(m_edits.back().first->points.size(), 3u);
  EXPECT_NEAR(m_edits.back().first->points[1].gradient, 400.0, valuePerPixel(canvas().transform()));
  canvas().setFocus();
  QTest::keyClick(&canvas(), Qt::Key_Delete);
  EXPECT_EQ(m_edits.back().first, (GradientOpacity{{{200.0, 0.0}, {600.0, 1.0}}}));
}

TEST_F(GradientEditor, hasNoColours) {
  editor().setHistogram(fallingGradients());
  editor().setGradientOpacity(GradientOpacity{{{200.0, 0.0}, {600.0, 1.0}}});
  canvas().selectPoints({0});
  EXPECT_EQ(valueFieldOf(editor())->minimum(), 0.0) << "below which no gradient is";
  canvas().selectPoints({1});
  EXPECT_TRUE(valueFieldOf(editor())->isVisible());
  EXPECT_FALSE(editor().findChild<ColorButton*>()->isVisible());
  QTest::mouseDClick(&canvas(), Qt::LeftButton, {}, pixel(600.0, 1.0));
  auto* popup = editor().findChild<PointPopup*>();
  ASSERT_NE(popup, nullptr);
  EXPECT_FALSE(popup->findChild<ColorPicker*>()->isVisible());
  EXPECT_EQ(valueFieldOf(*popup)->minimum(), 200.0) << "where its neighbour is";
  popup->close();
}

TEST_F(GradientEditor, theSwitchChoosesTheCurveAndTellsWhetherItIsUsed) {
  QSignalSpy shown(&m_panel, &CurvePanel::gradientShown);
  const auto visibleButton = [this](const QString& text) -> QToolButton* {
    for (QToolButton* button : m_panel.findChildren<QToolButton*>())
      if (button->isVisible() && button->text() == text)
        return button;
    return nullptr;
  };
  ASSERT_NE(visibleButton(QStringLiteral("Value")), nullptr);
  QTest::mouseClick(visibleButton(QStringLiteral("Value")), Qt::LeftButton);
  EXPECT_FALSE(m_panel.gradientIsShown());
  EXPECT_TRUE(m_panel.valueEditor()->isVisible());
  ASSERT_EQ(shown.count(), 1);
  EXPECT_FALSE(shown[0][0].toBool());
  m_panel.setGradientState(CurvePanel::GradientState::unused);
  EXPECT_NE(visibleButton(QStringLiteral("Gradient: unused")), nullptr);
  m_panel.setGradientState(CurvePanel::GradientState::on);
  ASSERT_NE(visibleButton(QStringLiteral("Gradient: on")), nullptr);
  QTest::mouseClick(visibleButton(QStringLiteral("Gradient: on")), Qt::LeftButton);
  EXPECT_TRUE(m_panel.gradientIsShown());
  ASSERT_NE(visibleButton(QStringLiteral("Gradient")), nullptr) << "where a tick says it";
  EXPECT_TRUE(visibleButton(QStringLiteral("Gradient"))->isChecked());
  EXPECT_FALSE(visibleButton(QStringLiteral("Value"))->isChecked());
}

TEST(GradientOpacityAsControlPoints, keepsEveryNumber) {
  const GradientOpacity curve{{{0.1, 1.0 / 3.0}, {0.1, 0.5}, {1e5, 1.0}}};
  EXPECT_EQ(asGradientOpacity(asControlPoints(curve)), curve);
}

} // namespace
} // namespace limn
