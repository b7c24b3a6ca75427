// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/properties/MeasureSection.h"

#include "scene/volume/Phantom.h"
#include "widgets/ValueText.h"

#include <QLineEdit>
#include <QPushButton>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>

#include <gtest/gtest.h>

namespace limn {
namespace {

using Kind = Measurement::Kind;

QString plain(QString text) {
  return text.replace(QChar(0xa0), QLatin1Char(' '));
}

// The section with one of each kind, answered as the session answers.
class MeasureSectionTest : public testing::Test {
protected:
  MeasureSectionTest() {
    measured = {{{Kind::distance, PatientPlane::axial, {{0, 0, 0}, {3, 4, 0}}}, {}},
                {{Kind::angle, std::nullopt, {{1, 0, 0}, {0, 0, 0}, {0, 1, 0}}, "Cobb"}, {}},
                {{Kind::ellipse, PatientPlane::coronal, {{0, 0, 0}, {9, 0, 7}}},
                 {49.48, 51, 38.4, 12.2, -20.0, 80.0}},
                {{Kind::mark, std::nullopt, {{7, 8, 9}}, "1"}, {}}};
    QObject::connect(&section, &MeasureSection::measurementsEdited, &section,
                     [this](const MeasurementsEdited& edited) {
                       std::vector<Measured> next;
                       for (const Measurement& one : edited.measurements)
                         next.push_back({one, {}});
                       measured = next;
                       texts << plain(edited.gesture.text);
                       section.setMeasured(measured, volume, edited.inHand);
                     });
    section.resize(320, 400);
    section.show();
    section.setMeasured(measured, volume, std::nullopt);
  }

  QTreeWidget& list() { return *section.findChild<QTreeWidget*>(); }
  QString at(int row, int column) { return plain(list().topLevelItem(row)->text(column)); }

  std::shared_ptr<const Volume> volume = phantomVolume({12.0, 0.0, 1});
  std::vector<Measured> measured;
  MeasureSection section;
  QStringList texts;
};

TEST_F(MeasureSectionTest, aRowTellsNameAndValue) {
  ASSERT_EQ(list().topLevelItemCount(), 4);
  EXPECT_EQ(at(0, 0), QStringLiteral("Distance"));
  EXPECT_EQ(at(0, 1), QStringLiteral("5.0 mm"));
  EXPECT_EQ(at(1, 0), QStringLiteral("Cobb"));
  EXPECT_EQ(at(1, 1), QStringLiteral("90.0°"));
  EXPECT_EQ(at(2, 1), QStringLiteral("38 ± 12 HU · 49.5 mm²"));
  EXPECT_EQ(at(3, 0), QStringLiteral("1"));
  EXPECT_EQ(at(3, 1), QString());
  const QString tip = plain(list().topLevelItem(2)->toolTip(0));
  EXPECT_TRUE(tip.contains(QStringLiteral("51 voxels")) && tip.contains(QStringLiteral("from −20 to 80 HU")))
      << tip.toStdString();
}

TEST_F(MeasureSectionTest, aDoubleClickRenamesAndAnEmptyNameIsTheKind) {
  const QPoint row = list().visualItemRect(list().topLevelItem(0)).center();
  QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, row);
  QTest::mouseDClick(list().viewport(), Qt::LeftButton, {}, row);
  auto* editor = list().viewport()->findChild<QLineEdit*>();
  ASSERT_NE(editor, nullptr);
  QTest::keyClicks(editor, QStringLiteral("Tumour"));
  QTest::keyClick(editor, Qt::Key_Return);
  QCoreApplication::processEvents(); // the list commits what was typed once the key is through
  ASSERT_EQ(measured[0].measurement.name, "Tumour");
  EXPECT_EQ(texts.last(), QStringLiteral("rename: Distance 5.0 mm · Tumour"));
  list().topLevelItem(0)->setText(0, QStringLiteral("  "));
  EXPECT_EQ(measured[0].measurement.name, "");
  EXPECT_EQ(at(0, 0), QStringLiteral("Distance"));
}

TEST_F(MeasureSectionTest, marksHideAndTheDeleteKeyDeletes) {
  list().topLevelItem(1)->setCheckState(0, Qt::Unchecked);
  EXPECT_FALSE(measured[1].measurement.isShown);
  EXPECT_EQ(texts.last(), QStringLiteral("hide: Angle 90.0° · Cobb"));
  list().topLevelItem(1)->setCheckState(0, Qt::Checked);
  EXPECT_EQ(texts.last(), QStringLiteral("show: Angle 90.0° · Cobb"));
  list().setCurrentItem(list().topLevelItem(3));
  QTest::keyClick(&list(), Qt::Key_Delete);
  EXPECT_EQ(measured.size(), 3u);
  EXPECT_EQ(texts.last(), QStringLiteral("delete: Mark 1"));
  QTest::keyClick(&list(), Qt::Key_Delete);
  EXPECT_EQ(measured.size(), 3u) << "none is chosen any more";
}

TEST_F(MeasureSectionTest, aValueCannotBeEdited) {
  list().topLevelItem(0)->setText(1, QStringLiteral("99 mm"));
  EXPECT_EQ(at(0, 1), QStringLiteral("5.0 mm"));
  EXPECT_TRUE(texts.empty());
}

TEST_F(MeasureSectionTest, withoutAVolumeThereIsNothingToMeasure) {
  section.setMeasured({}, nullptr, std::nullopt);
  EXPECT_FALSE(list().isVisible());
  for (const QToolButton* button : section.findChildren<QToolButton*>())
    EXPECT_FALSE(button->isEnabled());
}

TEST_F(MeasureSectionTest, buttonsAskForTools) {
  std::vector<Kind> asked;
  QObject::connect(&section, &MeasureSection::toolRequested, [&](Kind kind) { asked.push_back(kind); });
  for (const Kind kind : measurementKinds) {
    auto* button = section.findChild<QToolButton*>(QStringLiteral("measure-") + QLatin1String(nameOf(kind)));
    ASSERT_NE(button, nullptr);
    EXPECT_FALSE(button->accessibleName().isEmpty());
    EXPECT_FALSE(button->icon().isNull());
    QTest::mouseClick(button, Qt::LeftButton);
  }
  EXPECT_EQ(asked, std::vector<Kind>(measurementKinds.begin(), measurementKinds.end()));
}

// As many as the voxels carry: of 8 bits values have none, their mean may.
TEST(MeasureText, meanAndDeviationHaveTheDigitsThatTheVoxelsCarry) {
  Grid grid;
  grid.dims = {2, 1, 1};
  const auto text = [&](auto stored, double slope, double mean, double deviation, std::size_t voxels) {
    const Volume volume(grid, std::move(stored), Rescale{slope, 0.0}, std::nullopt, {});
    return plain(meanText(mean, deviation, voxels, volume));
  };
  const std::vector<std::uint8_t> bytes{0, 255};
  EXPECT_EQ(text(bytes, 1.0, 38.23, 0.74, 1), QStringLiteral("38 ± 1"));
  EXPECT_EQ(text(bytes, 1.0, 38.23, 0.74, 60), QStringLiteral("38.2 ± 0.7")) << "of 60 within 1/8";
  EXPECT_EQ(text(bytes, 1.0, 38.0, 0.0, 60), QStringLiteral("38.0 ± 0.0"));
  EXPECT_EQ(text(bytes, 1.0, 38.23, 12.24, 60), QStringLiteral("38 ± 12")) << "of 60 within 1.6";
  EXPECT_EQ(text(bytes, 1.0, 38.23, 12.24, 100000), QStringLiteral("38.2 ± 12.2"))
      << "one more than values have";
  EXPECT_EQ(text(bytes, 0.01, 0.3823, 0.0074, 60), QStringLiteral("0.382 ± 0.007"));
  EXPECT_EQ(text(std::vector<std::int16_t>{-1024, 3071}, 1.0, -38.23, 0.74, 60),
            QString(QChar(0x2212)) + QStringLiteral("38.2 ± 0.7"));
  EXPECT_EQ(text(std::vector<float>{0.0f, 1.0f}, 1.0, 0.38234, 0.00741, 60),
            QStringLiteral("0.3823 ± 0.0074"));
  EXPECT_EQ(decimalsOfMean(1.0, 0.0, 1), 0);
  EXPECT_EQ(decimalsOfMean(0.5, 0.0, 100), 2);
}

TEST(MeasureText, lengthsOfAnUnknownSpacingAreVoxels) {
  VolumeInfo info;
  info.spacingKnown = false;
  Grid grid;
  grid.dims = {2, 1, 1};
  const Volume volume(grid, std::vector<float>{0.0f, 10.0f}, Rescale{}, std::nullopt, info);
  EXPECT_EQ(plain(measureValueText({{Kind::distance, std::nullopt, {{0, 0, 0}, {3, 4, 0}}}, {}}, volume)),
            QStringLiteral("5.0 voxels"));
  const Measured begun{{Kind::distance, std::nullopt, {{3, 4, 0}, {3, 4, 0}}}, {}};
  EXPECT_EQ(measureNoteText(begun, volume), QString()) << "its other end is still to come";
  EXPECT_EQ(plain(measureValueText({{Kind::ellipse, PatientPlane::axial, {{0, 0, 0}, {1, 1, 0}}}, {250.0}},
                                   volume)),
            QStringLiteral("no voxels · 250 voxels²"));
  EXPECT_EQ(measureValueText({{Kind::angle, std::nullopt, {{0, 0, 0}, {0, 0, 0}, {1, 1, 0}}}, {}}, volume),
            QStringLiteral("no angle: two places are one"));
}

TEST(MeasureText, oneVoxelIsOne) {
  const auto details = [](std::size_t voxels) {
    const Measured ellipse{{Kind::ellipse, PatientPlane::axial, {{0, 0, 0}, {1, 1, 0}}},
                           {1.0, voxels, 7.0, 0.0, 7.0, 7.0}};
    return measureDetails(ellipse, *phantomVolume({12.0, 0.0, 1}));
  };
  EXPECT_TRUE(details(1).contains(QStringLiteral("deviation of 1 voxel\n"))) << details(1).toStdString();
  EXPECT_TRUE(details(2).contains(QStringLiteral("deviation of 2 voxels\n"))) << details(2).toStdString();
}

} // namespace
} // namespace limn
