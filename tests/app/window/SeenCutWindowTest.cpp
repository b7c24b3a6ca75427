// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/picture/CutController.h"
#include "app/picture/RegionController.h"
#include "scene/LabelLooks.h"
#include "support/ShortVolume.h"
#include "widgets/view/panels/CutBar.h"

#include <QPushButton>

#include <algorithm>

// Scissors that take what is seen, where what lies behind shows through what lies before.

namespace limn {
namespace {

constexpr int boxVoxels = 60;

class SeenCutWindow : public test::WindowHarness {
protected:
  QPoint inPicture(const QPoint& fromMiddle) {
    return view().mapTo(window.get(), view().logicalRect(0).center().toPoint()) + fromMiddle;
  }

  /// Draws around the middle of the picture, and waits for the cut.
  [[nodiscard]] bool drawAroundTheMiddle() {
    const QList<QPoint> corners{{-60, -60}, {0, -80}, {60, -60}, {80, 0},
                                {60, 60},   {0, 80},  {-60, 60}, {-80, 0}};
    QWindow* handle = window->windowHandle();
    QTest::mousePress(handle, Qt::LeftButton, {}, inPicture(corners.front()));
    for (const QPoint& corner : corners)
      QTest::mouseEvent(QTest::MouseMove, handle, Qt::NoButton, {}, inPicture(corner));
    QTest::mouseRelease(handle, Qt::LeftButton, {}, inPicture(corners.back()));
    return test::waitUntil([this] {
      return !window->findChild<RegionController*>()->isBusy() &&
             !window->findChild<CutController*>()->isBusy() && !scene().keep.cuts.empty();
    });
  }
};

// A hollow box of bone, with a small hole in the wall towards the eye.
TEST_F(SeenCutWindow, leaveTheFarWallThatShowsThroughAHoleOfTheNearOne) {
  test::writeShorts(folder.path() / "box.nrrd", boxVoxels, [](const glm::ivec3& v) {
    const glm::ivec3 fromMiddle = glm::abs(2 * v - (boxVoxels - 1)); // in halves of a voxel
    const int away = std::max({fromMiddle.x, fromMiddle.y, fromMiddle.z});
    const bool isHole = v.y < boxVoxels / 2 && fromMiddle.x < 6 && fromMiddle.z < 6;
    return away < 40 && away > 32 && !isHole ? 1200 : -1000;
  });
  ASSERT_TRUE(openAlone(pathTo("box.nrrd")));
  ASSERT_TRUE(rest());
  view().setFocus();
  QTest::keyClick(&view(), Qt::Key_X);
  for (QPushButton* button : view().findChild<CutBar*>()->findChildren<QPushButton*>())
    if (button->text() == QStringLiteral("What is seen"))
      QTest::mouseClick(button, Qt::LeftButton);
  ASSERT_TRUE(drawAroundTheMiddle());
  const auto keptAt = [this](int y) { return weightAt(scene().keep, {34.0, y, 30.0}); };
  EXPECT_EQ(keptAt(11), 0.0) << "the near wall, beside the hole";
  EXPECT_EQ(keptAt(48), 1.0) << "the far wall";
}

} // namespace
} // namespace limn
