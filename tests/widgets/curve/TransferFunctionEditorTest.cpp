// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/curve/TransferFunctionEditor.h"
#include "widgets/FindWidget.h"
#include "widgets/ValueText.h"
#include "widgets/WidgetSamples.h"
#include "widgets/controls/ColorPicker.h"
#include "widgets/controls/NumberField.h"
#include "widgets/controls/TrackSlider.h"
#include "widgets/curve/PointFields.h"
#include "widgets/curve/canvas/TransferFunctionCanvas.h"

#include <QApplication>
#include <QCheckBox>
#include <QMouseEvent>
#include <QTest>
#include <QToolButton>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace limn {
namespace {

class TransferFunctionEditorTest : public testing::Test {
protected:
  TransferFunctionEditorTest() {
    m_editor.resize(1200, 300);
    m_editor.setUnit(QStringLiteral("HU"));
    m_editor.setHistogram(sampleHistogram());
    m_editor.setTransferFunction(sampleFunction());
    m_editor.show();
    QObject::connect(&m_editor, &TransferFunctionEditor::transferFunctionEdited, &m_editor,
                     [this](const TransferFunction& function, const Gesture& gesture) {
                       m_edits.emplace_back(function, gesture);
                       m_editor.setTransferFunction(function);
                     });
  }

  NumberField* valueField() { return widgetNamed<NumberField>(m_editor, "Value of the selected point"); }
  NumberField* opacityField() { return widgetNamed<NumberField>(m_editor, "Opacity of the selected point"); }

  void type(NumberField* field, const QString& number) {
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, number);
    QTest::keyClick(field, Qt::Key_Return);
  }

  void pull(TrackSlider* slider, int pixels) {
    const QPoint from = slider->handleCentre(0).toPoint();
    QTest::mousePress(slider, Qt::LeftButton, {}, from);
    for (const int dx : {pixels / 2, pixels}) {
      const QPoint at = from + QPoint(dx, 0);
      QMouseEvent event(QEvent::MouseMove, at, slider->mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
      QApplication::sendEvent(slider, &event);
    }
    QTest::mouseRelease(slider, Qt::LeftButton, {}, from + QPoint(pixels, 0));
  }

  TransferFunctionEditor m_editor;
  std::vector<std::pair<TransferFunction, Gesture>> m_edits;
};

TEST_F(TransferFunctionEditorTest, enterLeadsToTheNumbersAndTypingMovesThePoint) {
  m_editor.activateWindow();
  m_editor.canvas()->selectPoints({2});
  QTest::keyClick(m_editor.canvas(), Qt::Key_Return);
  type(valueField(), QStringLiteral("77"));
  ASSERT_EQ(m_edits.size(), 1u);
  EXPECT_DOUBLE_EQ(m_edits.back().first.points[2].value, 77.0);
  type(opacityField(), QStringLiteral("1"));
  EXPECT_DOUBLE_EQ(m_edits.back().first.points[2].opacity, 1.0);
  EXPECT_NE(m_edits[0].second.id, m_edits[1].second.id);
}

TEST_F(TransferFunctionEditorTest, aTypedValueBeyondANeighbourIsRefusedWithItsRange) {
  const std::vector<ControlPoint> points = sampleFunction().points;
  m_editor.canvas()->selectPoints({2});
  type(valueField(), QStringLiteral("5000"));
  EXPECT_TRUE(m_edits.empty());
  EXPECT_DOUBLE_EQ(valueField()->number(), points[2].value);
  for (const std::size_t neighbour : {1, 3})
    EXPECT_TRUE(valueField()->refusal().contains(
        valueText(points[neighbour].value, QStringLiteral("HU"), valueField()->decimals())))
        << valueField()->refusal().toStdString();
  type(valueField(), QStringLiteral("300")); // its neighbour's
  ASSERT_EQ(m_edits.size(), 1u);
  EXPECT_DOUBLE_EQ(m_edits.back().first.points[2].value, 300.0);
  m_editor.canvas()->selectPoints({4});
  type(valueField(), QStringLiteral("5000"));
  EXPECT_DOUBLE_EQ(m_edits.back().first.points[4].value, 5000.0) << "the last one has nobody above it";
}

TEST_F(TransferFunctionEditorTest, toolsThatGaveWayToNumbersComeBackWithoutThem) {
  const std::array<QWidget*, 3> tools{widgetNamed<TrackSlider>(m_editor, "Overall opacity"),
                                      widgetNamed<TrackSlider>(m_editor, "Shift"),
                                      widgetNamed<QCheckBox>(m_editor, "Fine low opacities")};
  const auto inSight = [&] { return std::ranges::count_if(tools, &QWidget::isVisible); };
  m_editor.canvas()->selectPoints({});
  int width = 1200;
  while (inSight() == 3 && width > 300)
    m_editor.resize(--width, 300);
  m_editor.resize(width + 1, 300);
  ASSERT_EQ(inSight(), 3) << "barely room for all";
  m_editor.canvas()->selectPoints({2});
  EXPECT_LT(inSight(), 3);
  m_editor.canvas()->selectPoints({});
  EXPECT_EQ(inSight(), 3);
}

TEST_F(TransferFunctionEditorTest, selectingAndVisitingFieldsChangesNothing) {
  TransferFunction odd = sampleFunction();
  odd.points[2].value = 60.123456789;
  odd.points[2].opacity = 0.123456789;
  m_editor.setTransferFunction(odd);
  m_editor.canvas()->selectPoints({2});
  for (NumberField* field : {valueField(), opacityField()}) {
    field->setFocus();
    QTest::keyClick(field, Qt::Key_Return);
  }
  EXPECT_TRUE(m_edits.empty());
}

TEST_F(TransferFunctionEditorTest, overallOpacityMultipliesFromWhereItStoodAndZeroStaysZero) {
  pull(widgetNamed<TrackSlider>(m_editor, "Overall opacity"), -20);
  ASSERT_GE(m_edits.size(), 2u);
  const TransferFunction& edited = m_edits.back().first;
  EXPECT_DOUBLE_EQ(edited.points[0].opacity, 0.0);
  const double factor = edited.points[4].opacity / 0.9;
  EXPECT_LT(factor, 1.0);
  EXPECT_NEAR(edited.points[2].opacity, 0.2 * factor, 1e-12);
  EXPECT_EQ(m_edits.front().second.id, m_edits.back().second.id);
  // A second pull starts from the result.
  const double before = edited.points[4].opacity;
  pull(widgetNamed<TrackSlider>(m_editor, "Overall opacity"), -20);
  EXPECT_NEAR(m_edits.back().first.points[4].opacity, before * factor, 1e-9);
}

TEST_F(TransferFunctionEditorTest, overallOpacityTellsWhatItDidUntilTheCurveIsAnother) {
  auto* slider = widgetNamed<TrackSlider>(m_editor, "Overall opacity");
  const auto told = [](const TrackSlider* spring) {
    return spring->parentWidget()->findChildren<QLabel*>().back()->text();
  };
  EXPECT_EQ(told(slider), QString()) << "nothing was done";
  pull(slider, -20);
  const TransferFunction pulled = m_edits.back().first;
  const double factor = pulled.points[4].opacity / 0.9;
  const QString text = QChar(0x00d7) + fixedNumber(factor, 2);
  EXPECT_EQ(m_edits.back().second.text, QStringLiteral("change overall opacity ") + text);
  EXPECT_EQ(told(slider), text) << "although the slider is back";
  m_editor.setTransferFunction(pulled); // as the session answers
  EXPECT_EQ(told(slider), text);
  auto* shift = widgetNamed<TrackSlider>(m_editor, "Shift");
  pull(shift, 20);
  EXPECT_EQ(told(slider), QString()) << "something else was done";
  EXPECT_NE(told(shift), QString());
  m_editor.setTransferFunction(pulled); // undone
  EXPECT_EQ(told(shift), QString());
}

TEST_F(TransferFunctionEditorTest, lessAndMoreOfAPinnedTissueAreOneEditEach) {
  auto* less = widgetNamed<QToolButton>(m_editor, "Less of the pinned tissue");
  auto* more = widgetNamed<QToolButton>(m_editor, "More of the pinned tissue");
  EXPECT_FALSE(less->isVisible());
  m_editor.setPinnedValue(50.0);
  EXPECT_TRUE(less->isVisible());
  EXPECT_FALSE(valueField()->isVisible()) << "no room for both";
  const double before = classify(m_editor.canvas()->transferFunction(), 50.0).opacity;
  ASSERT_GT(before, 0.0);
  QTest::mouseClick(less, Qt::LeftButton);
  ASSERT_EQ(m_edits.size(), 1u);
  EXPECT_DOUBLE_EQ(classify(m_edits[0].first, 50.0).opacity, before / 2.0);
  EXPECT_EQ(m_edits[0].second.text, QStringLiteral("less of 50\u00a0HU"));
  more->setFocus();
  QTest::keyClick(more, Qt::Key_Space);
  ASSERT_EQ(m_edits.size(), 2u);
  EXPECT_DOUBLE_EQ(classify(m_edits[1].first, 50.0).opacity, before);
  EXPECT_NE(m_edits[0].second.id, m_edits[1].second.id);
  // What is turned to last is shown.
  m_editor.canvas()->selectPoints({0});
  EXPECT_FALSE(less->isVisible());
  EXPECT_TRUE(valueField()->isVisible());
  m_editor.setPinnedValue(60.0);
  EXPECT_TRUE(less->isVisible());
  m_editor.setPinnedValue(std::nullopt);
  EXPECT_FALSE(less->isVisible());
  EXPECT_TRUE(valueField()->isVisible());
}

TEST_F(TransferFunctionEditorTest, shiftMovesTheWholeCurve) {
  pull(widgetNamed<TrackSlider>(m_editor, "Shift"), 20);
  const double offset = m_edits.back().first.points[0].value - sampleFunction().points[0].value;
  EXPECT_GT(offset, 0.0);
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_NEAR(m_edits.back().first.points[i].value, sampleFunction().points[i].value + offset, 1e-9);
}

TEST_F(TransferFunctionEditorTest, aDoubleClickOnAPointOpensColourAndNumbers) {
  const TransferFunctionCanvas* canvas = m_editor.canvas();
  const QPoint at = positionOf(canvas->transform(), sampleFunction().points[3]).toPoint();
  QTest::mouseDClick(m_editor.canvas(), Qt::LeftButton, {}, at);
  auto* popup = m_editor.findChild<PointPopup*>();
  ASSERT_NE(popup, nullptr);
  QTest::mouseClick(popup->findChild<ColorPicker*>(), Qt::LeftButton, {},
                    QPoint(1, 1)); // white: no saturation, full brightness
  ASSERT_EQ(m_edits.size(), 1u);
  EXPECT_GT(glm::length(m_edits.back().first.points[3].color) / std::sqrt(3.0), 0.97);
  type(widgetNamed<NumberField>(*popup, "Opacity of the selected point"), QStringLiteral("1"));
  EXPECT_DOUBLE_EQ(m_edits.back().first.points[3].opacity, 1.0);
  popup->close();
}

TEST_F(TransferFunctionEditorTest, thePopUpOfOneOfSeveralPointsIsOfAllOfThem) {
  TransferFunctionCanvas& canvas = *m_editor.canvas();
  const std::vector<ControlPoint> before = canvas.transferFunction().points;
  canvas.selectPoints({1, 3});
  emit canvas.pointDetailsRequested(3);
  auto* popup = m_editor.findChild<PointPopup*>();
  ASSERT_NE(popup, nullptr);
  auto* picker = popup->findChild<ColorPicker*>();
  QTest::mouseClick(picker, Qt::LeftButton, {}, QPoint(1, 1)); // white
  ASSERT_EQ(m_edits.size(), 1u);
  const std::vector<ControlPoint> white = m_edits.back().first.points;
  EXPECT_EQ(white[1].color, white[3].color);
  EXPECT_GT(white[1].color.b, 0.98);
  EXPECT_EQ(white[2], before[2]);
  EXPECT_EQ(m_edits.back().second.text, QStringLiteral("change colour of 2 points"));
  EXPECT_FALSE(widgetNamed<NumberField>(*popup, "Value of the selected point")->isEnabled());
  EXPECT_EQ(canvas.selected(), (PointIndices{1, 3}));
  // Esc gives each its own colour back.
  ASSERT_NE(before[1].color, before[3].color);
  QTest::keyClick(picker, Qt::Key_Escape);
  EXPECT_EQ(m_edits.back().first.points, before);
  EXPECT_EQ(m_edits.back().second.id, m_edits.front().second.id);
}

TEST_F(TransferFunctionEditorTest, ofSeveralPointsNoNumberIsShownThatIsNotThatOfAll) {
  m_editor.activateWindow();
  TransferFunctionCanvas& canvas = *m_editor.canvas();
  canvas.selectPoints({1, 3});
  ASSERT_NE(canvas.transferFunction().points[1].opacity, canvas.transferFunction().points[3].opacity);
  EXPECT_TRUE(opacityField()->isMixed() && valueField()->isMixed());
  EXPECT_TRUE(opacityField()->text().isEmpty() && valueField()->text().isEmpty());
  const double first = canvas.transferFunction().points[1].opacity;
  type(opacityField(), QLocale().toString(first, 'f', 4));
  ASSERT_EQ(m_edits.size(), 1u) << "that of the first is for all";
  EXPECT_NEAR(m_edits.back().first.points[3].opacity, first, 1e-4);
  EXPECT_FALSE(opacityField()->isMixed());
  canvas.selectPoints({3});
  EXPECT_FALSE(valueField()->isMixed());
}

TEST_F(TransferFunctionEditorTest, escInTheColourOfSeveralPointsGivesEachItsOwnBack) {
  const std::vector<ControlPoint> before = m_editor.canvas()->transferFunction().points;
  m_editor.canvas()->selectPoints({1, 3});
  auto* button = m_editor.findChild<ColorButton*>();
  button->click();
  auto* picker = button->findChild<ColorPicker*>();
  ASSERT_NE(picker, nullptr);
  QTest::mouseClick(picker, Qt::LeftButton, {}, QPoint(1, 1));
  ASSERT_NE(m_editor.canvas()->transferFunction().points, before);
  QTest::keyClick(picker->window(), Qt::Key_Escape);
  EXPECT_EQ(m_editor.canvas()->transferFunction().points, before);
}

TEST_F(TransferFunctionEditorTest, whatFindsNoRoomStandsBehindAButtonAndWorksThere) {
  EXPECT_LE(m_editor.minimumSizeHint().width(), 300);
  auto* more = m_editor.findChild<QToolButton*>(QStringLiteral("moreCurveTools"));
  const std::array<QWidget*, 3> tools{widgetNamed<TrackSlider>(m_editor, "Overall opacity"),
                                      widgetNamed<TrackSlider>(m_editor, "Shift"),
                                      widgetNamed<QCheckBox>(m_editor, "Fine low opacities")};
  const auto inSight = [&] { return std::ranges::count_if(tools, &QWidget::isVisible); };
  const int whole = m_editor.width();
  EXPECT_EQ(inSight(), 3);
  EXPECT_FALSE(more->isVisible());
  for (const int width : {700, 600, 300}) {
    m_editor.resize(width, 300);
    EXPECT_LT(inSight(), 3) << width;
    EXPECT_TRUE(m_editor.findChild<PointFields*>()->isVisible());
    ASSERT_TRUE(more->isVisible()) << width;
    QTest::mouseClick(more, Qt::LeftButton);
    EXPECT_EQ(inSight(), 3) << width << ": each is in the row or behind the button";
    if (width == 300) {
      pull(widgetNamed<TrackSlider>(m_editor, "Shift"), 20);
      EXPECT_GT(m_edits.back().first.points[0].value, sampleFunction().points[0].value);
    }
    QApplication::activePopupWidget()->close();
    QCoreApplication::sendPostedEvents();
    EXPECT_LT(inSight(), 3) << "as before";
  }
  m_editor.resize(whole, 300);
  EXPECT_EQ(inSight(), 3);
  EXPECT_FALSE(more->isVisible());
  EXPECT_LT(tools[0]->mapTo(&m_editor, QPoint()).x(), tools[1]->mapTo(&m_editor, QPoint()).x());
  EXPECT_LT(tools[1]->mapTo(&m_editor, QPoint()).x(), tools[2]->mapTo(&m_editor, QPoint()).x())
      << "as before";
}

TEST_F(TransferFunctionEditorTest, whatIsHiddenInTheRowTakesNoRoom) {
  auto* more = m_editor.findChild<QToolButton*>(QStringLiteral("moreCurveTools"));
  auto* whose = new QToolButton;
  whose->setText(QString(40, QLatin1Char('n')));
  whose->hide();
  m_editor.addLeading(whose);
  m_editor.canvas()->selectPoints({1});
  int width = 1600;
  m_editor.resize(width, 300);
  while (!more->isVisible() && width > 300)
    m_editor.resize(--width, 300);
  ASSERT_GT(width, 300);
  m_editor.resize(width + 1, 300); // the least that has room for all
  EXPECT_FALSE(more->isVisible());
  whose->show();
  EXPECT_TRUE(more->isVisible());
  whose->hide();
  EXPECT_FALSE(more->isVisible());
}

} // namespace
} // namespace limn
