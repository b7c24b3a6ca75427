// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/properties/EffectsPanel.h"

#include "widgets/controls/WorkRow.h"

#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

namespace limn {
namespace {

const std::vector<EffectRow> rows{{"fog", "Fog", false, "fog is off", {Effect::fogExp}},
                                  {"specular", "Highlights", true, "surfaces shine", {Effect::specular}}};

struct EffectsPanelTest : testing::Test {
  QPushButton* button() { return panel.findChild<QPushButton*>(QStringLiteral("measureCost")); }
  bool says(const QString& text) {
    for (const QLabel* label : panel.findChildren<QLabel*>())
      if (label->isVisibleTo(&panel) && label->text().contains(text))
        return true;
    return false;
  }
  EffectsPanel panel;
};

TEST_F(EffectsPanelTest, showsEachEffectWithItsReason) {
  panel.setRows(rows, QStringLiteral("Enhanced (right)"));
  EXPECT_TRUE(says(QStringLiteral("Enhanced (right): the picture calls for 1 of 2 effects")));
  EXPECT_TRUE(says(QStringLiteral("Fog is off")));
  const auto shown = panel.findChildren<EffectRowWidget*>();
  ASSERT_EQ(shown.size(), 2);
  EXPECT_EQ(shown[0]->accessibleName(), QStringLiteral("Fog: off"));
  EXPECT_EQ(shown[1]->accessibleName(), QStringLiteral("Highlights: on"));
}

TEST_F(EffectsPanelTest, isEmptyWithoutAVolume) {
  panel.setRows(rows, QStringLiteral("Classic"));
  panel.setRows({}, {});
  EXPECT_FALSE(says(QStringLiteral("Fog is off")));
  EXPECT_FALSE(button()->isEnabled());
  EXPECT_TRUE(says(QStringLiteral("Open a volume")));
}

TEST_F(EffectsPanelTest, asksForCostsAndShowsThemWithTheirMethodAndPictureSize) {
  panel.setRows(rows, QStringLiteral("Classic"));
  QSignalSpy asked(&panel, &EffectsPanel::measureRequested);
  QTest::mouseClick(button(), Qt::LeftButton);
  EXPECT_EQ(asked.count(), 1);
  EffectTimes times;
  times.isMeasuring = true;
  times.fraction = 0.25;
  panel.setTimes(times);
  EXPECT_FALSE(button()->isEnabled());
  EXPECT_TRUE(says(QStringLiteral("Measuring… 25 %")));
  QSignalSpy cancelled(&panel, &EffectsPanel::cancelRequested);
  auto* work = panel.findChild<WorkRow*>();
  QTest::mouseClick(work->findChild<QPushButton*>(), Qt::LeftButton);
  EXPECT_EQ(cancelled.count(), 1);
  panel.setTimes({false,
                  1.0,
                  {std::nullopt, EffectCost{-12.4, 0.5, {}, 43.4}},
                  31.0,
                  QStringLiteral("a clock"),
                  {256, 128}});
  EXPECT_TRUE(says(QStringLiteral("saves 12 ± 0.5 of 43 ms")));
  EXPECT_TRUE(says(QStringLiteral("31 ms at 256 × 128 pixels")));
  EXPECT_TRUE(says(QStringLiteral("a clock")));
  EXPECT_TRUE(button()->isEnabled());
  panel.setTimes({});
  EXPECT_FALSE(says(QStringLiteral("saves 12 ± 0.5 of 43 ms"))) << "a changed scene has other costs";
}

TEST_F(EffectsPanelTest, saysWhatLightBroughtToThePicture) {
  panel.setRows({{"shadow", "Shadows", true, "what stands in its way dims light", {Effect::shadow}},
                 {"occlusion", "Hollows", true, "hollows are darker", {Effect::occlusion}}},
                QStringLiteral("Classic"));
  panel.setTimes(
      {false,
       1.0,
       {EffectCost{3.0, 0.5, PictureChange{84.6, 4.23}}, EffectCost{2.0, 0.5, PictureChange{0.2, 0.01}}},
       31.0,
       QStringLiteral("a clock"),
       {256, 128}});
  EXPECT_TRUE(says(QStringLiteral("What stands in its way dims light; it changes this picture by up to 85 of "
                                  "255 levels, by 4.2 on average.")));
  EXPECT_TRUE(says(QStringLiteral("Hollows are darker; it changes nothing in this picture that could be "
                                  "seen.")));
  panel.setTimes({});
  EXPECT_FALSE(says(QStringLiteral("it changes"))) << "another scene has another picture";
}

TEST_F(EffectsPanelTest, saysWhatWouldBeTakenByWhatIsOff) {
  panel.setRows({{"shadow", "Shadows", false, "the strength of shadows is set to 0", {Effect::shadow}},
                 {"jitter", "Jitter", false, "it is switched off", {Effect::jitter}}},
                QStringLiteral("Classic"));
  panel.setTimes({false,
                  1.0,
                  {std::nullopt, std::nullopt},
                  31.0,
                  QStringLiteral("a clock"),
                  {256, 128},
                  {EffectCost{38.0, 0.5, PictureChange{84.6, 4.23}, 31.0}, EffectCost{2.0, 0.5, {}, 31.0}}});
  EXPECT_TRUE(says(
      QStringLiteral("The strength of shadows is set to 0; switched on it would take 38 ms more, and would "
                     "change this picture by up to 85 of 255 levels, by 4.2 on average.")));
  EXPECT_TRUE(says(QStringLiteral("It is switched off; switched on it would take 2.0 ms more.")));
  panel.setTimes({});
  EXPECT_FALSE(says(QStringLiteral("would take"))) << "another scene has other costs";
}

} // namespace
} // namespace limn
