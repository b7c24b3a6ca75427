// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/FindWidget.h"
#include "widgets/controls/ChoiceRow.h"
#include "widgets/controls/ColorPicker.h"
#include "widgets/controls/FoldingSection.h"
#include "widgets/controls/LabelledRow.h"
#include "widgets/controls/NumberField.h"
#include "widgets/controls/NumberSliders.h"
#include "widgets/controls/TrackSlider.h"
#include "widgets/curve/TransferFunctionEditor.h"

#include <QApplication>
#include <QComboBox>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>
#include <QTest>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace limn {
namespace {

void drag(QWidget& widget, const QPoint& from, const QPoint& to, Qt::KeyboardModifiers modifiers = {}) {
  QTest::mousePress(&widget, Qt::LeftButton, {}, from);
  for (const QPoint& at : {(from + to) / 2, to}) {
    QMouseEvent event(QEvent::MouseMove, at, widget.mapToGlobal(at), Qt::NoButton, Qt::LeftButton, modifiers);
    QApplication::sendEvent(&widget, &event);
  }
  QTest::mouseRelease(&widget, Qt::LeftButton, {}, to);
}

NumberSpec spec(bool logarithmic) {
  return {.label = QStringLiteral("Sharpness"),
          .help = QStringLiteral("Help."),
          .unit = {},
          .scale = logarithmic ? SliderScale{1.0, 1024.0, true} : SliderScale{0.0, 8.0, false},
          .lowest = 0.0,
          .highest = 1024.0,
          .defaultValue = 2.0,
          .defaultUpper = 4.0,
          .decimals = 2};
}

TEST(SliderScale, isExactAtItsEndsAndGeometricInTheMiddle) {
  const SliderScale scale{1.0, 1024.0, true};
  EXPECT_DOUBLE_EQ(valueAtFraction(scale, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(valueAtFraction(scale, 1.0), 1024.0);
  EXPECT_NEAR(valueAtFraction(scale, 0.5), 32.0, 1e-9); // sqrt(1 · 1024)
  EXPECT_NEAR(fractionOf(scale, 32.0), 0.5, 1e-12);
  EXPECT_DOUBLE_EQ(fractionOf(scale, 5000.0), 1.0);
}

class RangeSliderTest : public testing::Test {
protected:
  RangeSliderTest() : m_range(spec(false)) {
    m_range.resize(340, 60);
    m_range.setRange(1.0, 5.0);
    m_range.show();
    QObject::connect(&m_range, &RangeSlider::rangeEdited, &m_range,
                     [this](double lower, double upper, const Gesture& gesture) {
                       m_edits.push_back({lower, upper});
                       m_ids.push_back(gesture.id);
                     });
  }
  NumberField* lowerField() const { return widgetNamed<NumberField>(m_range, "Sharpness, from"); }
  QPoint handle(int i) const { return m_range.findChild<TrackSlider*>()->handleCentre(i).toPoint(); }
  double perPixel() const { return 8.0 / (m_range.findChild<TrackSlider*>()->width() - 16.0); }

  RangeSlider m_range;
  std::vector<std::array<double, 2>> m_edits;
  std::vector<std::uint64_t> m_ids;
};

TEST_F(RangeSliderTest, aRangeHasItsColumnsWhereOneNumberHasThem) {
  ValueSlider one(spec(false));
  one.resize(340, 30);
  one.show();
  const auto* track = m_range.findChild<TrackSlider*>();
  const auto* oneTrack = one.findChild<TrackSlider*>();
  EXPECT_EQ(track->x(), oneTrack->x());
  EXPECT_EQ(track->width(), oneTrack->width());
  const auto* oneField = one.findChild<NumberField*>();
  const QList<NumberField*> fields = m_range.findChildren<NumberField*>();
  ASSERT_EQ(fields.size(), 2);
  for (const NumberField* field : fields) {
    EXPECT_EQ(field->x(), oneField->x());
    EXPECT_EQ(field->width(), oneField->width());
  }
  EXPECT_GE(fields[1]->y(), fields[0]->geometry().bottom());
}

TEST_F(RangeSliderTest, itsTrackIsLongerThanItsFieldsHoweverNarrowThePanelIs) {
  m_range.resize(m_range.minimumSizeHint());
  QCoreApplication::sendPostedEvents(); // layouts
  EXPECT_GE(m_range.findChild<TrackSlider*>()->width(), 100);
  EXPECT_GT(m_range.findChild<TrackSlider*>()->width(), lowerField()->width());
}

TEST_F(RangeSliderTest, settingEmitsNothing) {
  m_range.setRange(2.0, 3.0);
  EXPECT_TRUE(m_edits.empty());
}

TEST_F(RangeSliderTest, eachHandleMovesItsEndUnderOneGesture) {
  drag(*m_range.findChild<TrackSlider*>(), handle(0), handle(0) + QPoint(20, 0));
  ASSERT_GE(m_edits.size(), 2u);
  EXPECT_NEAR(m_edits.back()[0], 1.0 + 20.0 * perPixel(), 0.005); // rounded to two decimals
  EXPECT_DOUBLE_EQ(m_edits.back()[1], 5.0);
  EXPECT_EQ(m_ids.front(), m_ids.back());
  const std::uint64_t first = m_ids.back();
  drag(*m_range.findChild<TrackSlider*>(), handle(1), handle(1) + QPoint(20, 0));
  EXPECT_NEAR(m_edits.back()[1], 5.0 + 20.0 * perPixel(), 0.005);
  EXPECT_NE(m_ids.back(), first);
}

TEST_F(RangeSliderTest, handlesDoNotPassEachOther) {
  drag(*m_range.findChild<TrackSlider*>(), handle(0), handle(1) + QPoint(60, 0));
  EXPECT_EQ(m_edits.back(), (std::array{5.0, 5.0}));
}

TEST_F(RangeSliderTest, handlesOnOneSpotAtTheTopCanBePulledApart) {
  m_range.setRange(8.0, 8.0);
  drag(*m_range.findChild<TrackSlider*>(), handle(1), handle(1) - QPoint(40, 0));
  EXPECT_LT(m_edits.back()[0], 8.0);
  EXPECT_DOUBLE_EQ(m_edits.back()[1], 8.0);
}

TEST_F(RangeSliderTest, escBringsBackTheExactNumbers) {
  m_range.setRange(1.23456789, 5.0);
  QTest::mousePress(m_range.findChild<TrackSlider*>(), Qt::LeftButton, {}, handle(0));
  const QPoint to = handle(0) + QPoint(30, 0);
  QMouseEvent move(QEvent::MouseMove, to, m_range.findChild<TrackSlider*>()->mapToGlobal(to), Qt::NoButton,
                   Qt::LeftButton, {});
  QApplication::sendEvent(m_range.findChild<TrackSlider*>(), &move);
  ASSERT_NE(m_edits.back()[0], 1.23456789);
  QTest::keyClick(m_range.findChild<TrackSlider*>(), Qt::Key_Escape);
  EXPECT_EQ(m_edits.back()[0], 1.23456789);
  EXPECT_EQ(m_ids.front(), m_ids.back());
}

TEST_F(RangeSliderTest, anEndThatIsTypedBeyondTheOtherIsRefusedWithWhatFits) {
  const auto type = [this](const QString& text) {
    lowerField()->setFocus();
    lowerField()->selectAll();
    QTest::keyClicks(lowerField(), text);
    QTest::keyClick(lowerField(), Qt::Key_Return);
  };
  const int width = lowerField()->width();
  type(QStringLiteral("7"));
  EXPECT_TRUE(m_edits.empty());
  EXPECT_EQ(lowerField()->refusal(), QStringLiteral("7 does not fit: give a number from 0 to 5."));
  EXPECT_EQ(lowerField()->number(), 1.0);
  type(QStringLiteral("5"));
  ASSERT_EQ(m_edits.size(), 1u);
  EXPECT_EQ(m_edits.back(), (std::array{5.0, 5.0}));
  m_range.setRange(1.0, 8.0);
  type(QStringLiteral("7"));
  EXPECT_EQ(m_edits.back(), (std::array{7.0, 8.0}));
  m_range.setRange(1.0, 8.0);
  m_range.setLeastApart(2.0);
  type(QStringLiteral("7"));
  EXPECT_EQ(lowerField()->refusal(), QStringLiteral("7 does not fit: give a number from 0 to 6."));
  QCoreApplication::sendPostedEvents(); // layouts
  EXPECT_EQ(lowerField()->width(), width);
}

TEST_F(RangeSliderTest, aDoubleClickOnTheNameResetsBothEnds) {
  QTest::mouseDClick(m_range.findChild<ResetLabel*>(), Qt::LeftButton);
  ASSERT_EQ(m_edits.size(), 1u);
  EXPECT_EQ(m_edits.back(), (std::array{2.0, 4.0}));
}

class ValueSliderTest : public testing::Test {
protected:
  ValueSliderTest() : m_slider(spec(true)) {
    m_slider.resize(300, 60);
    m_slider.show();
    QObject::connect(&m_slider, &ValueSlider::valueEdited, &m_slider,
                     [this](double value, const Gesture& gesture) { m_edits.emplace_back(value, gesture); });
  }
  ValueSlider m_slider;
  std::vector<std::pair<double, Gesture>> m_edits;
};

TEST_F(ValueSliderTest, aLogarithmicSliderMultipliesByEqualFactorsPerPixel) {
  m_slider.setValue(32.0);
  EXPECT_TRUE(m_edits.empty());
  const QPoint from = m_slider.findChild<TrackSlider*>()->handleCentre(0).toPoint();
  drag(*m_slider.findChild<TrackSlider*>(), from, from + QPoint(30, 0));
  const double track = m_slider.findChild<TrackSlider*>()->width() - 16.0;
  EXPECT_NEAR(m_edits.back().first, 32.0 * std::pow(1024.0, 30.0 / track), 0.005);
  EXPECT_EQ(m_edits.back().second.text, QStringLiteral("change sharpness"));
}

TEST_F(ValueSliderTest, keysAndTypingEdit) {
  m_slider.setValue(32.0);
  m_slider.findChild<TrackSlider*>()->setFocus();
  QTest::keyClick(m_slider.findChild<TrackSlider*>(), Qt::Key_Right);
  EXPECT_NEAR(m_edits.back().first, 32.0 * std::pow(1024.0, 0.01), 0.005);
  m_slider.findChild<NumberField*>()->setFocus();
  m_slider.findChild<NumberField*>()->selectAll();
  QTest::keyClicks(m_slider.findChild<NumberField*>(), QStringLiteral("100"));
  QTest::keyClick(m_slider.findChild<NumberField*>(), Qt::Key_Return);
  EXPECT_DOUBLE_EQ(m_edits.back().first, 100.0);
  QTest::keyClick(m_slider.findChild<NumberField*>(), Qt::Key_Up);
  EXPECT_DOUBLE_EQ(m_edits.back().first, 110.0); // adaptive: a tenth of the number's decade
}

TEST_F(ValueSliderTest, aFieldThatIsOnlyVisitedKeepsTheExactNumber) {
  m_slider.setValue(3.14159265);
  m_slider.findChild<NumberField*>()->setFocus();
  QTest::keyClick(m_slider.findChild<NumberField*>(), Qt::Key_Return);
  m_slider.findChild<TrackSlider*>()->setFocus();
  EXPECT_TRUE(m_edits.empty());
  EXPECT_EQ(m_slider.findChild<NumberField*>()->number(), 3.14159265);
}

TEST_F(ValueSliderTest, theReasonForBeingDisabledStandsInTheToolTip) {
  m_slider.setUnavailable(QStringLiteral("Not now."));
  EXPECT_FALSE(m_slider.isEnabled());
  EXPECT_EQ(m_slider.toolTip(), QStringLiteral("Not now."));
  m_slider.setUnavailable({});
  EXPECT_TRUE(m_slider.isEnabled());
  EXPECT_TRUE(m_slider.toolTip().contains(QStringLiteral("default 2")));
}

TEST(SpringSlider, springsBackAndStartsANewPull) {
  SpringSlider spring(QStringLiteral("Opacity"), {}, {0.1, 10.0, true}, 1.0,
                      [](double v) { return QString::number(v); });
  spring.resize(300, 30);
  spring.show();
  std::vector<double> pulled;
  QObject::connect(&spring, &SpringSlider::pulled, &spring, [&](double v) { pulled.push_back(v); });
  TrackSlider* slider = spring.findChild<TrackSlider*>();
  const QPoint from = slider->handleCentre(0).toPoint();
  drag(*slider, from, from + QPoint(20, 0));
  EXPECT_GT(pulled.back(), 1.0);
  EXPECT_DOUBLE_EQ(slider->values().front(), 1.0);
}

TEST(FoldingSection, foldsByClickAndKeyAndStaysQuietWhenSet) {
  FoldingSection section(QStringLiteral("Light"));
  section.resize(300, 200);
  section.show();
  std::vector<bool> folded;
  QObject::connect(&section, &FoldingSection::foldedByUser, &section, [&](bool on) { folded.push_back(on); });
  section.setFolded(true);
  EXPECT_TRUE(folded.empty());
  QWidget* header = section.childAt(20, 12);
  while (header->focusPolicy() == Qt::NoFocus)
    header = header->parentWidget();
  QTest::mouseClick(header, Qt::LeftButton);
  QTest::keyClick(header, Qt::Key_Space);
  EXPECT_EQ(folded, (std::vector<bool>{false, true}));
}

TEST(ChoiceRow, reportsOnlyWhatTheUserChose) {
  ChoiceRow row(QStringLiteral("Model"), QStringLiteral("Help."), {QStringLiteral("A"), QStringLiteral("B")},
                0);
  row.show();
  std::vector<int> chosen;
  QObject::connect(&row, &ChoiceRow::indexEdited, &row, [&](int i) { chosen.push_back(i); });
  row.setIndex(1);
  EXPECT_TRUE(chosen.empty());
  row.box()->setFocus();
  QTest::keyClick(row.box(), Qt::Key_Up);
  EXPECT_EQ(chosen, std::vector<int>{0});
}

TEST(ColorPicker, allThatIsPickedIsOneGestureThatCanBeTakenBack) {
  ColorPicker picker;
  const glm::dvec3 before(0.8765, 0.123, 0.0); // none of 256 shares
  picker.setColor(before);
  picker.show();
  std::vector<std::pair<glm::dvec3, std::uint64_t>> picked;
  QObject::connect(&picker, &ColorPicker::colorPicked, &picker,
                   [&](const glm::dvec3& color, std::uint64_t id) { picked.emplace_back(color, id); });
  std::vector<std::uint64_t> takenBack;
  QObject::connect(&picker, &ColorPicker::takenBack, &picker,
                   [&](std::uint64_t id) { takenBack.push_back(id); });
  drag(picker, {100, 100}, {0, 0});
  ASSERT_GE(picked.size(), 2u);
  EXPECT_EQ(picked.back().first, glm::dvec3(1.0)); // the field's corner of no saturation and full brightness
  EXPECT_EQ(picked.front().second, picked.back().second);
  auto* hex = picker.findChild<QLineEdit*>();
  hex->setText(QString());
  QTest::keyClicks(hex, QStringLiteral("#336699"));
  QTest::keyClick(hex, Qt::Key_Return);
  EXPECT_EQ(picked.back().first, glm::dvec3(0x33, 0x66, 0x99) / 255.0);
  EXPECT_EQ(picked.front().second, picked.back().second);
  picker.takeBack();
  EXPECT_EQ(picked.back(), std::pair(before, picked.front().second)) << "exactly, by the same gesture";
  const std::size_t count = picked.size();
  picker.takeBack();
  EXPECT_EQ(picked.size(), count) << "nothing was picked since";
  EXPECT_EQ(takenBack, std::vector{picked.front().second}) << "once";
  QTest::mouseClick(&picker, Qt::LeftButton, {}, {100, 100});
  EXPECT_NE(picked.back().second, picked.front().second) << "another one";
}

TEST(ColorPicker, takesNamesAndCodesAndRefusesTheRestWithASentence) {
  ColorPicker picker;
  picker.setColor({0.0, 0.0, 0.0});
  picker.show();
  std::vector<glm::dvec3> picked;
  QObject::connect(&picker, &ColorPicker::colorPicked, &picker,
                   [&](const glm::dvec3& color) { picked.push_back(color); });
  auto* hex = picker.findChild<QLineEdit*>();
  const auto type = [&](const char* text) {
    hex->selectAll();
    QTest::keyClicks(hex, QString::fromLatin1(text));
    QTest::keyClick(hex, Qt::Key_Return);
  };
  const glm::dvec3 red(1.0, 0.0, 0.0), green(0.0, 1.0, 0.0);
  type("red");
  EXPECT_EQ(picked, std::vector{red});
  EXPECT_EQ(hex->text(), QStringLiteral("#ff0000"));
  type("0f0");
  EXPECT_EQ(picked, (std::vector{red, green}));
  type("rot");
  EXPECT_EQ(picked.size(), 2u);
  EXPECT_TRUE(picker.refusal().startsWith(QStringLiteral("rot is no colour")))
      << picker.refusal().toStdString();
  EXPECT_EQ(hex->text(), QStringLiteral("rot")) << "so that it is seen what was wrong";
  EXPECT_EQ(hex->accessibleDescription(), picker.refusal());
  type("#0000ff");
  EXPECT_TRUE(picker.refusal().isEmpty());
  EXPECT_EQ(picked.back(), glm::dvec3(0.0, 0.0, 1.0));
}

TEST(ColorPicker, itsRingIsWholeInACorner) {
  ColorPicker picker;
  picker.setColor({1.0, 0.0, 0.0}); // upper right
  const QImage image = picker.grab().toImage();
  const double ratio = image.devicePixelRatio();
  const double right = picker.width() - 24.0; // of the field of colours, pixels
  const QColor onRing =
      image.pixelColor(static_cast<int>(ratio * (right - 1.5)), static_cast<int>(ratio * 8.5));
  EXPECT_GT(onRing.green(), 200) << onRing.name().toStdString();
}

TEST(ColorPicker, isWorkedByKeys) {
  ColorPicker picker;
  picker.setColor({1.0, 0.0, 0.0});
  picker.show();
  std::vector<glm::dvec3> picked;
  QObject::connect(&picker, &ColorPicker::colorPicked, &picker,
                   [&](const glm::dvec3& color) { picked.push_back(color); });
  EXPECT_TRUE(picker.focusPolicy() & Qt::TabFocus);
  QTest::keyClick(&picker, Qt::Key_Down, Qt::ShiftModifier);
  // The picker counts in 65535ths of a share, and colours on screen in 255ths.
  EXPECT_NEAR(picked.back().r, 0.9, 0.5 / 255.0);
  QTest::keyClick(&picker, Qt::Key_Left, Qt::ShiftModifier);
  EXPECT_NEAR(picked.back().g, 0.09, 0.5 / 255.0);
  QTest::keyClick(&picker, Qt::Key_PageDown, Qt::ShiftModifier);
  EXPECT_GT(picked.back().g, picked.back().b) << "towards yellow";
  QTest::keyClick(&picker, Qt::Key_5);
  EXPECT_EQ(picked.back(), glm::dvec3(0xd8, 0x26, 0x1c) / 255.0) << "the fifth swatch: vessels";
}

TEST(ColorButton, enterKeepsWhatWasPickedAndClosesWhereItIsAColour) {
  ColorButton button(QStringLiteral("change colour"));
  button.setColor({0.5, 0.5, 0.5});
  button.show();
  button.click();
  auto* picker = button.findChild<ColorPicker*>();
  ASSERT_NE(picker, nullptr);
  auto* hex = picker->findChild<QLineEdit*>();
  EXPECT_EQ(picker->window()->focusWidget(), hex) << "to type at once";
  QTest::keyClicks(hex, QStringLiteral("rot"));
  QTest::keyClick(hex, Qt::Key_Return);
  EXPECT_TRUE(picker->isVisible()) << "to be typed once more";
  QTest::keyClicks(hex, QStringLiteral("#ff0000"));
  QTest::keyClick(hex, Qt::Key_Return);
  EXPECT_FALSE(picker->isVisible());
  EXPECT_EQ(button.color(), glm::dvec3(1.0, 0.0, 0.0));
}

TEST(ColorButton, escTakesBackWhatWasPicked) {
  ColorButton button(QStringLiteral("change colour"));
  const glm::dvec3 before(0.8765, 0.123, 0.0);
  button.setColor(before);
  button.show();
  std::vector<std::uint64_t> gestures;
  QObject::connect(&button, &ColorButton::colorEdited, &button,
                   [&](const glm::dvec3&, const Gesture& gesture) { gestures.push_back(gesture.id); });
  for (const bool isInHex : {false, true}) {
    button.click();
    auto* picker = button.findChild<ColorPicker*>();
    ASSERT_NE(picker, nullptr);
    const auto* ends = picker->window()->findChild<QLabel*>();
    ASSERT_NE(ends, nullptr) << "says so";
    EXPECT_TRUE(ends->isVisible() && ends->text().contains(QStringLiteral("Esc takes it back")));
    QTest::mouseClick(picker, Qt::LeftButton, {}, {100, 100});
    ASSERT_NE(button.color(), before);
    QWidget* const hex = picker->findChild<QLineEdit*>();
    QTest::keyClick(isInHex ? hex : picker->window(), Qt::Key_Escape);
    EXPECT_EQ(button.color(), before);
    EXPECT_FALSE(picker->isVisible());
    EXPECT_EQ(gestures.front(), gestures.back()) << "so that no step is left";
    gestures.clear();
    delete picker->window();
  }
}

} // namespace
} // namespace limn
