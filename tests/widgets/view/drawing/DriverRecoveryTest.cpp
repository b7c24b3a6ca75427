// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/drawing/DriverRecovery.h"

#include "gl/DriverHealth.h"
#include "support/GlTest.h"

#include <QCoreApplication>

// What happens when drawing fails, without a window.

namespace limn {
namespace {

// Keeps what is asked for.
class Recovery : public test::GlTest {
protected:
  Recovery() {
    QObject::connect(&recovery, &DriverRecovery::stopped, [this] { ++stops; });
    QObject::connect(&recovery, &DriverRecovery::rebuildNeeded, [this] { ++rebuilds; });
    QObject::connect(&recovery, &DriverRecovery::givenUp, [this] { ++givenUp; });
    QObject::connect(&recovery, &DriverRecovery::failed, [this] { ++failures; });
    QObject::connect(&recovery, &DriverRecovery::restored, [this] { ++restored; });
  }
  void failDriver() {
    recovery.guard([] { throw DriverError("The driver refused a shader.", "a line of a test"); });
    QCoreApplication::processEvents();
  }

  DriverRecovery recovery;
  int stops = 0, rebuilds = 0, givenUp = 0, failures = 0, restored = 0;
};

TEST_F(Recovery, whatWorksIsLeftAlone) {
  bool worked = false;
  recovery.guard([&] { worked = true; });
  recovery.noteSuccess();
  QCoreApplication::processEvents();
  EXPECT_TRUE(worked);
  EXPECT_FALSE(recovery.hasFailed());
  EXPECT_EQ(stops + rebuilds + givenUp + failures + restored, 0);
}

TEST_F(Recovery, aDriverIsGivenUpOnlyAfterItFailedThreeTimesInARow) {
  failDriver();
  EXPECT_EQ(recovery.sentence(), QStringLiteral("The driver refused a shader."));
  EXPECT_EQ(recovery.details(), QStringLiteral("a line of a test"));
  EXPECT_EQ(rebuilds, 1);
  recovery.retry();
  failDriver();
  EXPECT_EQ(rebuilds, 2);
  EXPECT_EQ(givenUp, 0);
  recovery.retry();
  failDriver();
  EXPECT_EQ(rebuilds, 2);
  EXPECT_EQ(givenUp, 1);
  EXPECT_EQ(stops, 3);
  EXPECT_EQ(failures, 0) << "whoever gives up says why";
}

TEST_F(Recovery, aDriverThatCannotBeUsedAtAllIsGivenUpAtOnce) {
  recovery.giveUp(QStringLiteral("There is no context."));
  EXPECT_EQ(givenUp, 1);
  EXPECT_EQ(stops, 1);
  EXPECT_EQ(recovery.sentence(), QStringLiteral("There is no context."));
}

TEST_F(Recovery, aCompletePictureEndsTheCount) {
  for (int time = 0; time < 2; ++time) {
    failDriver();
    recovery.retry();
  }
  recovery.noteSuccess();
  EXPECT_EQ(restored, 1);
  failDriver();
  EXPECT_EQ(givenUp, 0);
  EXPECT_EQ(rebuilds, 3);
}

TEST_F(Recovery, anErrorOfOpenGlCountsAsAFailureOfTheDriver) {
  recovery.guard([] { throw Error(Error::Kind::openGl, "No memory."); });
  QCoreApplication::processEvents();
  EXPECT_EQ(rebuilds, 1);
  EXPECT_TRUE(recovery.details().isEmpty());
}

TEST_F(Recovery, whatIsNotTheDriversFaultIsSaidAtOnce) {
  recovery.guard([] { throw Error(Error::Kind::input, "The volume is broken."); });
  QCoreApplication::processEvents();
  EXPECT_EQ(failures, 1);
  EXPECT_EQ(rebuilds, 0);
  recovery.retry();
  EXPECT_FALSE(recovery.hasFailed());
}

} // namespace
} // namespace limn
