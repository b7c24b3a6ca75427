// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/panels/HintBar.h"
#include "support/Waiting.h"

#include <QCoreApplication>
#include <QWidget>

#include <gtest/gtest.h>

#include <optional>
#include <vector>

namespace limn {
namespace {

/// A bar over a view in which something else lies over the lower edge.
class HintBarOverOthers : public testing::Test {
protected:
  HintBarOverOthers() {
    view.resize(900, 500);
    cover.setGeometry(680, 400, 220, 90);
    bar.setWritten([] { return std::vector<QRectF>(); },
                   [](const QRectF&, const QRectF&, const std::vector<QRectF>&) {
                     return std::optional<QRectF>(); // no room beside what is written
                   });
    bar.setCoveredBelow(
        [this] { return cover.isHidden() ? std::vector<QRect>() : std::vector<QRect>{cover.geometry()}; });
    bar.followCover(cover);
    view.show();
    bar.showHint(QStringLiteral("Click both ends"), {});
  }

  // Whether it comes to stand so far above the view's lower edge.
  [[nodiscard]] bool stands(int aboveEdge) {
    return test::waitUntil([&] { return view.height() - bar.geometry().bottom() - 1 == aboveEdge; });
  }

  QWidget view;
  QWidget cover{&view};
  HintBar bar{QStringLiteral("Measuring"), &view};
};

TEST_F(HintBarOverOthers, keepsItsPlaceBesideWhatDoesNotReachIt) {
  EXPECT_TRUE(stands(44));
}

TEST_F(HintBarOverOthers, followsWhatMovesBelowIt) {
  cover.move(340, 400);
  EXPECT_TRUE(stands(108)) << "8 above it";
  cover.setGeometry(340, 380, 220, 110);
  EXPECT_TRUE(stands(128));
  cover.hide();
  EXPECT_TRUE(stands(44));
  cover.show();
  EXPECT_TRUE(stands(128));
  cover.move(680, 380);
  EXPECT_TRUE(stands(44));
}

TEST_F(HintBarOverOthers, staysUnderThePointerUnlessSomethingLiesOnIt) {
  cover.move(340, 400);
  ASSERT_TRUE(stands(108));
  bar.setAttribute(Qt::WA_UnderMouse);
  cover.hide();
  for (int turn = 0; turn < 3; ++turn)
    QCoreApplication::processEvents();
  EXPECT_TRUE(stands(108)) << "a click on its button is one";
  cover.setGeometry(340, 380, 220, 110);
  cover.show();
  EXPECT_TRUE(stands(128));
  cover.hide();
  bar.setAttribute(Qt::WA_UnderMouse, false);
  QEvent leave(QEvent::Leave);
  QCoreApplication::sendEvent(&bar, &leave);
  EXPECT_TRUE(stands(44));
}

} // namespace
} // namespace limn
