// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/picture/MeasureController.h"
#include "widgets/planes/PlaneDeck.h"
#include "widgets/planes/PlaneView.h"
#include "widgets/properties/MeasureSection.h"

#include <QStatusBar>
#include <QTreeWidget>

// What was begun in a slice and waits for its next click while the pointer is elsewhere, in the program's
// window.

namespace limn {
namespace {

class MeasureWait : public test::WindowHarness {
protected:
  void SetUp() override {
    WindowHarness::SetUp();
    window->resize(1280, 800);
    ASSERT_TRUE(openAlone(QStringLiteral("phantom:4")));
    choose("picture_and_three");
    ASSERT_TRUE(rest());
    press(axial(), Qt::Key_D);
  }

  void choose(const char* layout) {
    window->findChild<QAction*>(QStringLiteral("planes-") + QLatin1String(layout))->trigger();
    QCoreApplication::processEvents();
  }
  const std::vector<Measurement>& measurements() const { return session().measurements(); }
  PlaneDeck& slices() const { return *window->findChild<PlaneDeck*>(); }
  PlaneView& axial() const { return *slices().view(PatientPlane::axial); }
  PlaneView& coronal() const { return *slices().view(PatientPlane::coronal); }
  QTreeWidget& list() const {
    return *window->findChild<MeasureSection*>()->findChild<QTreeWidget*>(QStringLiteral("measurements"));
  }

  // Logical pixels from the middle of a part of the window.
  QPoint in(const QWidget& part, const QPoint& fromMiddle = {}) const {
    return part.mapTo(window.get(), part.rect().center()) + fromMiddle;
  }
  void moveTo(const QPoint& at) {
    QTest::mouseEvent(QTest::MouseMove, window->windowHandle(), Qt::NoButton, {}, at);
    QCoreApplication::processEvents();
  }
  void click(const QPoint& at) {
    QTest::mouseClick(window->windowHandle(), Qt::LeftButton, {}, at);
    QCoreApplication::processEvents();
  }
  void press(QWidget& widget, Qt::Key key) {
    widget.setFocus();
    QTest::keyClick(&widget, key);
    QCoreApplication::processEvents();
  }
  void begin() {
    click(in(axial(), {-30, 30}));
    ASSERT_TRUE(axial().isDrawing());
  }
};

TEST_F(MeasureWait, aDistanceIsAsItWasOnceThePointerIsBack) {
  begin();
  for (const QWidget* other : {static_cast<QWidget*>(window->statusBar()), static_cast<QWidget*>(&view()),
                               static_cast<QWidget*>(&coronal())}) {
    moveTo(in(*other));
    EXPECT_TRUE(axial().isDrawing());
  }
  moveTo(in(axial(), {20, 30}));
  click(in(axial(), {20, 30}));
  EXPECT_FALSE(axial().isDrawing());
  ASSERT_EQ(measurements().size(), 1u);
  EXPECT_NEAR(lengthMm(measurements().front()), 50.0 * mmPerLogicalPixel(axial().frame()), 1e-9);
  EXPECT_EQ(undo().count(), 1);
}

TEST_F(MeasureWait, isTakenBackByKeysInAnotherSliceAndTheToolStays) {
  for (const Qt::Key key : {Qt::Key_Escape, Qt::Key_Delete, Qt::Key_Backspace}) {
    begin();
    moveTo(in(coronal()));
    press(coronal(), key);
    EXPECT_FALSE(axial().isDrawing());
    EXPECT_TRUE(measurements().empty());
    EXPECT_EQ(undo().count(), 0);
    EXPECT_EQ(slices().tool(), PlaneTool::distance);
  }
  press(coronal(), Qt::Key_Escape);
  EXPECT_EQ(slices().tool(), PlaneTool::crosshair) << "nothing was begun";
}

TEST_F(MeasureWait, endsWhereSomethingElseIsDone) {
  click(in(axial(), {-30, -30}));
  click(in(axial(), {30, -30}));
  ASSERT_EQ(measurements().size(), 1u);
  const std::vector<Measurement> measured = measurements();
  auto& controller = *window->findChild<MeasureController*>();
  begin();
  click(in(coronal(), {0, 20}));
  EXPECT_FALSE(axial().isDrawing());
  EXPECT_TRUE(coronal().isDrawing());
  EXPECT_EQ(measurements().size(), 2u) << "the one of before, and what is begun here";
  press(coronal(), Qt::Key_Escape);
  EXPECT_EQ(measurements(), measured);
  for (const auto& leave : std::vector<std::function<void()>>{
           [&] { controller.goTo(0); }, [&] { choose("picture"); },
           [&] { press(coronal(), Qt::Key_Up); }, // leads the axial slice away
           [&] {
             typeName(pathTo("scene.json"));
             window->findChild<QAction*>(QStringLiteral("saveScene"))->trigger();
             EXPECT_TRUE(test::waitUntil([&] { return QFile::exists(pathTo("scene.json")); }));
           }}) {
    choose("picture_and_three");
    controller.goTo(0);
    begin();
    leave();
    EXPECT_FALSE(slices().isDrawing());
    EXPECT_EQ(measurements(), measured);
  }
  controller.goTo(0);
  begin();
  list().topLevelItem(0)->setCheckState(0, Qt::Unchecked);
  EXPECT_FALSE(slices().isDrawing());
  ASSERT_EQ(measurements().size(), 1u);
  EXPECT_FALSE(measurements().front().isShown);
  EXPECT_EQ(list().topLevelItemCount(), 1);
}

} // namespace
} // namespace limn
