// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "support/BrokenDriver.h"

#include <QPushButton>

// What a failing driver leaves of the program's window: everything but its own pictures.

namespace limn {
namespace {

using DriverWindow = test::OpenGlWindow;

TEST_F(DriverWindow, aSessionGoesOnWhereTheDriverRefusesEveryShader) {
  auto broken = std::make_unique<test::BrokenShaders>();
  ASSERT_TRUE(open(QStringLiteral("phantom:12")));
  const auto isDone = [this] {
    return test::waitUntil(
        [this] { return view().pictureState().driverHasFailed && view().pictureState().resting; });
  };
  ASSERT_TRUE(isDone());
  EXPECT_TRUE(labelSays(QStringLiteral("processor")));
  EXPECT_TRUE(view().pictureState().engineReason.contains(QStringLiteral("refused a shader")));

  // Edits, undo and redo go on, and each is drawn.
  const Scene before = scene();
  const auto picture = [this] { return view().currentPicture(0); };
  const QImage first = picture();
  dragAPoint();
  ASSERT_TRUE(isDone());
  EXPECT_EQ(undo().count(), 1);
  EXPECT_NE(scene().transferFunction, before.transferFunction);
  EXPECT_NE(picture(), first);
  undo().undo();
  ASSERT_TRUE(isDone());
  EXPECT_EQ(scene().transferFunction, before.transferFunction);
  EXPECT_EQ(picture(), first);
  undo().redo();

  // Once the driver works, it draws the session as it is now.
  broken.reset();
  const Scene edited = scene();
  QTest::mouseClick(view().findChild<QPushButton*>(QStringLiteral("retryGraphics")), Qt::LeftButton);
  ASSERT_TRUE(rest());
  // The sentence below the picture is gone: a picture that is framed follows its height.
  Scene asEdited = scene();
  asEdited.camera = edited.camera;
  EXPECT_EQ(asEdited, edited);
  EXPECT_EQ(undo().count(), 1);
  EXPECT_FALSE(view().pictureState().driverHasFailed);
}

} // namespace
} // namespace limn
