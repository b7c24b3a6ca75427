// SPDX-License-Identifier: GPL-3.0-or-later
// What assistive technology finds in the controls that paint themselves, asked as a screen reader asks.
#include "widgets/controls/ColorPicker.h"
#include "widgets/controls/FoldingSection.h"
#include "widgets/controls/NumberSliders.h"
#include "widgets/controls/TrackSlider.h"
#include "widgets/curve/TransferFunctionEditor.h"

#include <QAbstractButton>
#include <QAccessible>
#include <QApplication>
#include <QHelpEvent>
#include <QTest>
#include <QToolTip>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace limn {
namespace {

QAccessibleInterface& accessible(QObject* object) {
  return *QAccessible::queryAccessibleInterface(object);
}

double currentOf(QAccessibleInterface& interface) {
  return interface.valueInterface()->currentValue().toDouble();
}

NumberSpec sharpness(const SliderScale& scale) {
  return {.label = QStringLiteral("Sharpness"),
          .help = QStringLiteral("Help."),
          .unit = {},
          .scale = scale,
          .lowest = 0.0,
          .highest = 1024.0,
          .defaultValue = 2.0,
          .defaultUpper = 4.0,
          .decimals = 2,
          .lowerName = QStringLiteral("in even tissue")};
}

TEST(AccessibleSlider, isASliderWithNameNumberAndLimits) {
  ValueSlider slider(sharpness({1.0, 1024.0, true}));
  slider.setValue(32.0);
  QAccessibleInterface& track = accessible(slider.findChild<TrackSlider*>());
  EXPECT_EQ(track.role(), QAccessible::Slider);
  EXPECT_EQ(track.text(QAccessible::Name), QStringLiteral("Sharpness"));
  EXPECT_EQ(track.childCount(), 0);
  QAccessibleValueInterface* value = track.valueInterface();
  ASSERT_NE(value, nullptr);
  EXPECT_EQ(value->currentValue().toDouble(), 32.0);
  EXPECT_EQ(value->minimumValue().toDouble(), 1.0);
  EXPECT_EQ(value->maximumValue().toDouble(), 1024.0);
  // A hundredth of the track from the middle, as an arrow key goes: 32 · (1024^0.01 - 1).
  EXPECT_NEAR(value->minimumStepSize().toDouble(), 32.0 * (std::pow(1024.0, 0.01) - 1.0), 1e-9);
}

TEST(AccessibleSlider, aNumberSetIsAnEditOfTheUsers) {
  ValueSlider slider(sharpness({1.0, 1024.0, true}));
  std::vector<std::pair<double, Gesture>> edits;
  QObject::connect(&slider, &ValueSlider::valueEdited, &slider,
                   [&](double number, const Gesture& gesture) { edits.emplace_back(number, gesture); });
  QAccessibleValueInterface* value = accessible(slider.findChild<TrackSlider*>()).valueInterface();
  value->setCurrentValue(100.0);
  value->setCurrentValue(5000.0); // beyond the scale
  ASSERT_EQ(edits.size(), 2u);
  EXPECT_EQ(edits[0].first, 100.0);
  EXPECT_EQ(edits[0].second.text, QStringLiteral("change sharpness"));
  EXPECT_EQ(edits[1].first, 1024.0);
  EXPECT_NE(edits[0].second.id, edits[1].second.id);
  value->setCurrentValue(std::numeric_limits<double>::quiet_NaN());
  slider.setUnavailable(QStringLiteral("Not now."));
  value->setCurrentValue(10.0);
  EXPECT_EQ(edits.size(), 2u);
  EXPECT_TRUE(accessible(slider.findChild<TrackSlider*>()).state().disabled);
}

TEST(AccessibleSlider, aSpringIsPulledOnceAndSpringsBack) {
  SpringSlider spring(QStringLiteral("Opacity"), {}, {0.1, 10.0, true}, 1.0,
                      [](double v) { return QString::number(v); });
  std::vector<double> pulled;
  QObject::connect(&spring, &SpringSlider::pulled, &spring, [&](double v) { pulled.push_back(v); });
  QAccessibleInterface& track = accessible(spring.findChild<TrackSlider*>());
  EXPECT_EQ(track.text(QAccessible::Name), QStringLiteral("Opacity"));
  track.valueInterface()->setCurrentValue(2.0);
  EXPECT_EQ(pulled, std::vector<double>{2.0});
  EXPECT_EQ(currentOf(track), 1.0);
}

class AccessibleRange : public testing::Test {
protected:
  AccessibleRange() : m_range(sharpness({0.0, 8.0, false})) {
    m_range.resize(300, 60);
    m_range.setRange(1.0, 5.0);
    m_range.show();
    QObject::connect(&m_range, &RangeSlider::rangeEdited, &m_range, [this](double lower, double upper) {
      m_edits.push_back({lower, upper});
    });
  }
  QAccessibleInterface& group() const { return accessible(m_range.findChild<TrackSlider*>()); }
  QAccessibleInterface& handle(int index) const { return *group().child(index); }

  RangeSlider m_range;
  std::vector<std::array<double, 2>> m_edits;
};

TEST_F(AccessibleRange, isAGroupOfTwoNamedSliders) {
  EXPECT_EQ(group().role(), QAccessible::Grouping);
  EXPECT_EQ(group().text(QAccessible::Name), QStringLiteral("Sharpness"));
  EXPECT_EQ(group().valueInterface(), nullptr);
  ASSERT_EQ(group().childCount(), 2);
  EXPECT_EQ(group().child(2), nullptr);
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(handle(i).role(), QAccessible::Slider);
    EXPECT_EQ(handle(i).parent(), &group());
    EXPECT_EQ(group().indexOfChild(&handle(i)), i);
    EXPECT_EQ(group().child(i), &handle(i)); // one and the same whenever asked for
    const QPoint centre = m_range.findChild<TrackSlider*>()->mapToGlobal(
        m_range.findChild<TrackSlider*>()->handleCentre(i).toPoint());
    EXPECT_TRUE(handle(i).rect().contains(centre));
    EXPECT_EQ(group().childAt(centre.x(), centre.y()), &handle(i));
  }
  EXPECT_EQ(handle(0).text(QAccessible::Name), QStringLiteral("Sharpness, in even tissue"));
  EXPECT_EQ(handle(1).text(QAccessible::Name), QStringLiteral("Sharpness, to"));
}

TEST_F(AccessibleRange, eachHandleEndsWhereTheOtherIs) {
  const auto limits = [&](int index) {
    QAccessibleValueInterface* value = handle(index).valueInterface();
    return std::array{value->minimumValue().toDouble(), currentOf(handle(index)),
                      value->maximumValue().toDouble()};
  };
  EXPECT_EQ(limits(0), (std::array{0.0, 1.0, 5.0}));
  EXPECT_EQ(limits(1), (std::array{1.0, 5.0, 8.0}));
}

TEST_F(AccessibleRange, aNumberSetMovesThatHandleUpToTheOther) {
  handle(1).valueInterface()->setCurrentValue(6.5);
  handle(0).valueInterface()->setCurrentValue(7.0);
  EXPECT_EQ(m_edits, (std::vector<std::array<double, 2>>{{1.0, 6.5}, {6.5, 6.5}}));
}

TEST_F(AccessibleRange, theFocusIsOnAHandle) {
  handle(1).actionInterface()->doAction(QAccessibleActionInterface::setFocusAction());
  QApplication::processEvents();
  EXPECT_EQ(QApplication::focusWidget(), m_range.findChild<TrackSlider*>());
  EXPECT_EQ(group().focusChild(), &handle(1));
  EXPECT_TRUE(handle(1).state().focused);
  EXPECT_FALSE(handle(0).state().focused);
  EXPECT_FALSE(group().state().focused);
  QTest::keyClick(m_range.findChild<TrackSlider*>(), Qt::Key_Right);
  ASSERT_EQ(m_edits.size(), 1u);
  EXPECT_NEAR(m_edits[0][1], 5.08, 1e-9); // a hundredth of the track
  QTest::keyClick(m_range.findChild<TrackSlider*>(), Qt::Key_Backtab, Qt::ShiftModifier);
  EXPECT_EQ(group().focusChild(), &handle(0));
}

TEST_F(AccessibleRange, handlesGoWithTheirSlider) {
  auto range = std::make_unique<RangeSlider>(sharpness({0.0, 8.0, false}));
  const QAccessible::Id id = QAccessible::uniqueId(accessible(range->findChild<TrackSlider*>()).child(0));
  EXPECT_NE(QAccessible::accessibleInterface(id), nullptr);
  range.reset();
  EXPECT_EQ(QAccessible::accessibleInterface(id), nullptr);
}

TEST(AccessibleFolding, aHeaderIsAButtonThatIsExpandedOrCollapsed) {
  FoldingSection section(QStringLiteral("Light"));
  section.show();
  std::vector<bool> folded;
  QObject::connect(&section, &FoldingSection::foldedByUser, &section, [&](bool on) { folded.push_back(on); });
  QAccessibleInterface& header = accessible(section.findChild<QAbstractButton*>());
  EXPECT_EQ(header.role(), QAccessible::Button);
  EXPECT_EQ(header.text(QAccessible::Name), QStringLiteral("Light"));
  EXPECT_TRUE(header.state().expandable && header.state().expanded && header.state().focusable);
  EXPECT_FALSE(header.state().collapsed || header.state().checkable);
  header.actionInterface()->doAction(QAccessibleActionInterface::pressAction());
  EXPECT_TRUE(section.isFolded());
  EXPECT_EQ(folded, std::vector<bool>{true});
  EXPECT_TRUE(header.state().collapsed);
  EXPECT_FALSE(header.state().expanded);
}

TEST(AccessiblePicker, aSwatchOfThePickerTellsItsTissueAndItsKeyWhereThePointerRests) {
  ColorPicker picker;
  picker.show();
  const auto tipAt = [&picker](const QPoint& at) {
    QHelpEvent help(QEvent::ToolTip, at, picker.mapToGlobal(at));
    QApplication::sendEvent(&picker, &help);
    return QToolTip::text();
  };
  // Swatches stand below the field, in a row as wide as the picker.
  const int row = picker.height() - 26 - 8 - 13;
  EXPECT_EQ(tipAt({13, row}), QStringLiteral("Bone (key 1)"));
  EXPECT_EQ(tipAt({picker.width() - 13, row}), QStringLiteral("Metal (key 8)"));
  EXPECT_EQ(tipAt({picker.width() / 2 + 13, row}), QStringLiteral("Vessel (key 5)"));
}

} // namespace
} // namespace limn
