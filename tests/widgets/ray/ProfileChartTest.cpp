// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/ray/RayPanel.h"

#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

namespace limn {
namespace {

// Four pieces of 10 mm with the values 0, 100, 200, 300; the third gives 0.6, the last 0.2.
RayProfile fourPieces(Projection projection = Projection::composite) {
  RayProfile profile;
  profile.projection = projection;
  profile.lengthMm = 40.0;
  profile.alpha = 0.8;
  for (int i = 0; i < 4; ++i)
    profile.samples.push_back({5.0 + 10.0 * i, 10.0, 100.0 * i, 0.1 * i, 0.0, glm::dvec3(1.0)});
  profile.samples[2].contribution = 0.6;
  profile.samples[3].contribution = 0.2;
  return profile;
}

const ProfileNames inHu{QStringLiteral("HU"), QStringLiteral("mm"), 0};

TEST(ProfileText, saysWhereHalfOfTheLightComesFrom) {
  // 0.4 of 0.6 lie in two thirds of the third piece.
  EXPECT_NEAR(halfLightDepth(fourPieces()).value(), 20.0 + 20.0 / 3.0, 1e-12);
  const QString text = profileSummary(fourPieces(), inHu);
  EXPECT_TRUE(text.contains(QStringLiteral("26.7")) && text.contains(QStringLiteral("200")))
      << text.toStdString();
  EXPECT_TRUE(text.contains(QStringLiteral("80"))) << "how opaque the pixel is";
}

TEST(ProfileText, saysWhatOtherProjectionsShowInstead) {
  QStringList said;
  for (const Projection projection : {Projection::composite, Projection::mip, Projection::minip,
                                      Projection::average, Projection::xray, Projection::isosurface})
    said << profileSummary(fourPieces(projection), inHu);
  said.removeDuplicates();
  EXPECT_EQ(said.size(), 6);
  EXPECT_FALSE(profileSummary(fourPieces(Projection::average), inHu).contains(QStringLiteral("mm")));
  RayProfile empty = fourPieces();
  empty.alpha = 0.0;
  for (RayProfile::Sample& sample : empty.samples)
    sample.contribution = 0.0;
  EXPECT_TRUE(profileSummary(empty, inHu).contains(QStringLiteral("Nothing shows")));
}

TEST(ProfileText, readsADepthAndClaimsNoLengthsThatTheFileDoesNotTell) {
  const QString read = readingAt(fourPieces(), inHu, 30.0);
  EXPECT_TRUE(read.contains(QStringLiteral("200")) && read.contains(QStringLiteral("75")))
      << read.toStdString();
  const ProfileNames unknown{QString(), QString(), 0};
  for (const QString& text : {readingAt(fourPieces(), unknown, 30.0), profileSummary(fourPieces(), unknown),
                              laneTexts(fourPieces(), unknown)[1].title})
    EXPECT_FALSE(text.contains(QStringLiteral("mm"))) << text.toStdString();
}

TEST(ProfileChartWidget, readsByPointerAndKeysChoosesAndZooms) {
  ProfileChart chart;
  chart.resize(300, 300);
  chart.setProfile(fourPieces(), inHu, 12.0);
  QSignalSpy chosen(&chart, &ProfileChart::depthChosen);
  const double x = xOfValue(chart.depths(), 25.0);
  QTest::mouseClick(&chart, Qt::LeftButton, {}, QPoint(static_cast<int>(x), 150));
  ASSERT_EQ(chosen.count(), 1);
  EXPECT_NEAR(chosen.front().front().toDouble(), 25.0, valuePerPixel(chart.depths()));
  QTest::keyClick(&chart, Qt::Key_H);
  EXPECT_NEAR(chart.cursor().value(), 20.0 + 20.0 / 3.0, 1e-12);
  QTest::keyClick(&chart, Qt::Key_Plus);
  EXPECT_LT(chart.depths().visible.highest - chart.depths().visible.lowest, 40.0);
  QTest::keyClick(&chart, Qt::Key_End);
  EXPECT_EQ(chart.cursor(), 40.0);
  EXPECT_NEAR(chart.depths().visible.highest, 40.0, 1e-9) << "what is read is in sight";
  QTest::keyClick(&chart, Qt::Key_F);
  EXPECT_EQ(chart.depths().visible, (ValueRange{0.0, 40.0}));
  EXPECT_FALSE(chart.grab().isNull());
}

TEST(ProfileChartWidget, takesAShorterRayWhileItIsZoomed) {
  ProfileChart chart;
  chart.resize(300, 300);
  chart.setProfile(fourPieces(), inHu, std::nullopt);
  QTest::keyClick(&chart, Qt::Key_End);
  for (int i = 0; i < 10; ++i)
    QTest::keyClick(&chart, Qt::Key_Plus);
  RayProfile shorter = fourPieces();
  shorter.samples.resize(1);
  shorter.lengthMm = 10.0;
  chart.setProfile(shorter, inHu, std::nullopt);
  EXPECT_LT(chart.depths().visible.lowest, chart.depths().visible.highest);
  EXPECT_LE(chart.depths().visible.highest, 10.0);
  EXPECT_LE(chart.cursor().value(), 10.0);
  EXPECT_FALSE(chart.grab().isNull());
}

TEST(ProfileChart, namesTheLabelThatADepthLiesIn) {
  ProfileNames names = inHu;
  const QString without = readingAt(fourPieces(), names, 15.0);
  names.labels = {{}, QStringLiteral("liver"), {}, {}};
  const QString reading = readingAt(fourPieces(), names, 15.0);
  EXPECT_TRUE(reading.contains(QStringLiteral(", liver, "))) << reading.toStdString();
  EXPECT_EQ(QString(reading).remove(QStringLiteral(", liver")), without);
  EXPECT_FALSE(readingAt(fourPieces(), names, 25.0).contains(QStringLiteral("liver")));
}

} // namespace
} // namespace limn
