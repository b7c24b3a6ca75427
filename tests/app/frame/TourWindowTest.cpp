// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/frame/TourController.h"
#include "app/window/Docks.h"
#include "widgets/ContrastRatio.h"

#include <QDockWidget>
#include <QPushButton>

// The tour of the window: where its call-outs stand, how it is walked, and that it is in nobody's way.

namespace limn {
namespace {

class TourWindow : public test::WindowHarness {
protected:
  TourController& tour() const { return *window->findChild<TourController*>(); }
  Callout* callout() const { return window->findChild<Callout*>(); }
  QWidget& frame() const { return *window->findChild<QWidget*>(QStringLiteral("tourFrame")); }
  MessageBar& question() const { return *window->findChild<MessageBar*>(QStringLiteral("tourBar")); }
  QAction& start() const { return *window->findChild<QAction*>(QStringLiteral("tour")); }
  Settings settings() const { return Settings(UserFolders::below(folder.path()).settings); }
  QPushButton& button(const char* name) const {
    return *window->findChild<QPushButton*>(QLatin1String(name));
  }
  // What was deleted later is gone, what was placed later is placed.
  void settle() {
    QCoreApplication::processEvents();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }
  void press(Qt::Key key) {
    QTest::keyClick(window->windowHandle(), key);
    settle();
  }
};

TEST_F(TourWindow, isOfferedUntilItIsTakenOrDeclined) {
  tour().offer();
  ASSERT_TRUE(question().isVisible());
  EXPECT_EQ(tour().step(), -1) << "nothing opens by itself";
  for (QToolButton* each : question().findChildren<QToolButton*>())
    if (each->text() == QStringLiteral("No, thank you"))
      QTest::mouseClick(each, Qt::LeftButton);
  EXPECT_TRUE(settings().tourIsKnown());
  tour().offer();
  EXPECT_FALSE(question().isVisible());
}

TEST_F(TourWindow, itsOfferCoversNothingThatOneWouldClick) {
  EmptyPanel& page = view().emptyPanel();
  page.setRecentSources({QStringLiteral("a"), QStringLiteral("b"), QStringLiteral("c")});
  for (const QSize size : {QSize(1024, 700), QSize(800, 560), QSize(1280, 800)}) {
    for (const char* unfinished : {"", "CT 512×512×120"}) {
      window->resize(size);
      page.setUnfinished(QString::fromUtf8(unfinished));
      tour().offer();
      settle();
      ASSERT_TRUE(question().isVisible());
      const QRect offer(question().mapTo(window.get(), QPoint()), question().size());
      int buttons = 0;
      for (const QPushButton* each : page.findChildren<QPushButton*>()) {
        if (!each->isVisible())
          continue;
        ++buttons;
        const QRect place(each->mapTo(window.get(), QPoint()), each->size());
        EXPECT_FALSE(place.intersects(offer)) << size.width() << ": " << each->text().toStdString();
        EXPECT_TRUE(page.rect().contains({each->mapTo(&page, QPoint()), each->size()})) << size.width();
        EXPECT_GE(each->height(), each->minimumSizeHint().height()) << size.width();
      }
      EXPECT_GE(buttons, *unfinished ? 4 : 3) << size.width();
      question().hide();
    }
  }
}

TEST_F(TourWindow, sixStepsPointAtTheirPartsAndEnterGoesOn) {
  window->resize(1280, 800);
  ASSERT_TRUE(open(QStringLiteral("phantom:8")) && rest());
  window->findChild<QDockWidget*>(QStringLiteral("shadingDock"))->hide();
  start().trigger();
  settle();
  EXPECT_TRUE(settings().tourIsKnown());
  std::set<QString> titles;
  for (int step = 0; step < 6; ++step) {
    ASSERT_EQ(tour().step(), step);
    const QRect box = callout()->geometry().adjusted(12, 12, -12, -12); // without the room for its arrow
    EXPECT_TRUE(window->rect().contains(box)) << step;
    EXPECT_TRUE(frame().isVisible() && box.adjusted(-24, -24, 24, 24).intersects(frame().geometry())) << step;
    const QRect over = box.adjusted(3, 3, -3, -3) & frame().geometry();
    EXPECT_TRUE(over.isEmpty()) << step << ": the box hides what it speaks of";
    titles.insert(callout()->accessibleName());
    for (const QLabel* label : callout()->findChildren<QLabel*>())
      EXPECT_GE(label->height(), label->heightForWidth(label->width())) << step << ": its text is cut";
    press(Qt::Key_Return);
  }
  EXPECT_EQ(titles.size(), 6u);
  EXPECT_EQ(tour().step(), -1);
  EXPECT_EQ(callout(), nullptr);
  EXPECT_TRUE(window->findChild<QDockWidget*>(QStringLiteral("shadingDock"))->isVisible());
}

TEST_F(TourWindow, saysWhatIsSeenWhereThePicturesAre) {
  ASSERT_TRUE(open(QStringLiteral("phantom:8")) && rest());
  start().trigger();
  press(Qt::Key_Return);
  ASSERT_EQ(tour().step(), 1);
  const auto says = [this](const char* words) {
    return callout()->accessibleDescription().contains(QString::fromUtf8(words));
  };
  EXPECT_TRUE(says("At the left you see \"Classic\", at the right \"Enhanced\"; Space swaps them"))
      << callout()->accessibleDescription().toStdString();
  setLayout(CompareLayout::single);
  EXPECT_TRUE(test::waitUntil([&] { return says("View ▸ Side by side"); })) << "one picture is seen";
  EXPECT_FALSE(says("At the left"));
  EXPECT_FALSE(says("Space"));
  setLayout(CompareLayout::difference);
  EXPECT_TRUE(test::waitUntil([&] { return says("where \"Classic\" and \"Enhanced\" differ"); }));
  EXPECT_FALSE(says("Space"));
  for (const QLabel* label : callout()->findChildren<QLabel*>())
    EXPECT_GE(label->height(), label->heightForWidth(label->width())) << "its text is cut";
}

TEST_F(TourWindow, pointsAtWhatHoldsTheCameraWhereThatFindsNoRoom) {
  auto* bar = window->findChild<QToolBar*>();
  auto* more = bar->findChild<QToolButton*>(QStringLiteral("qt_toolbar_ext_button"));
  const QWidget* camera = bar->widgetForAction(window->findChild<QAction*>(QStringLiteral("savePicture")));
  ASSERT_TRUE(open(QStringLiteral("phantom:8")) && rest());
  window->resize(800, 700);
  start().trigger();
  for (int step = 0; step < 5; ++step)
    press(Qt::Key_Return);
  ASSERT_EQ(tour().step(), 5);
  ASSERT_TRUE(test::waitUntil([&] { return more->isVisible(); }) && !camera->isVisible());
  const auto frames = [&](const QWidget& part) {
    const QRect place(part.mapTo(window.get(), QPoint()), part.size());
    return frame().isVisible() && frame().geometry().contains(place & window->rect());
  };
  const auto says = [this](const char* words) {
    return callout()->accessibleDescription().contains(QString::fromUtf8(words));
  };
  EXPECT_TRUE(test::waitUntil([&] { return frames(*more) && says("behind »"); }));
  bar->hide();
  EXPECT_TRUE(test::waitUntil([&] { return !frame().isVisible() && says("File ▸ Save picture"); }));
  bar->show();
  window->resize(1280, 800);
  EXPECT_TRUE(test::waitUntil([&] { return camera->isVisible() && frames(*camera); }));
  EXPECT_FALSE(says("behind »"));
}

TEST_F(TourWindow, goesBackEndsByEscAndReturnsTheKeyboard) {
  ASSERT_TRUE(open(QStringLiteral("phantom:8")) && rest());
  view().setFocus();
  start().trigger();
  press(Qt::Key_Return);
  QTest::mouseClick(&button("tourBack"), Qt::LeftButton);
  EXPECT_EQ(tour().step(), 0);
  press(Qt::Key_Escape);
  EXPECT_EQ(tour().step(), -1);
  EXPECT_TRUE(view().hasFocus() || view().isAncestorOf(window->focusWidget()));
  start().trigger();
  EXPECT_EQ(tour().step(), 0) << "it is found again";
}

TEST_F(TourWindow, arrowsTurnItsPagesAndNeverLeaveIt) {
  ASSERT_TRUE(open(QStringLiteral("phantom:8")) && rest());
  const Camera camera = scene().camera;
  start().trigger();
  press(Qt::Key_Left);
  EXPECT_EQ(tour().step(), 0);
  for (int step = 1; step < 6; ++step) {
    press(Qt::Key_Right);
    EXPECT_EQ(tour().step(), step);
  }
  press(Qt::Key_Right);
  EXPECT_EQ(tour().step(), 5) << "the last page ends by Done";
  press(Qt::Key_Left);
  EXPECT_EQ(tour().step(), 4);
  press(Qt::Key_Escape);
  EXPECT_EQ(tour().step(), -1);
  EXPECT_EQ(scene().camera, camera) << "no arrow came to the picture";
}

TEST_F(TourWindow, offersTheSampleWhereNothingIsOpenAndOnlyThere) {
  start().trigger();
  EXPECT_TRUE(button("tourAction").isVisible());
  ASSERT_TRUE(open(QStringLiteral("phantom:8")) && rest());
  EXPECT_FALSE(button("tourAction").isVisible());
}

TEST_F(TourWindow, goesOnByTheKeyboardOnceTheSampleIsOpen) {
  start().trigger();
  QTest::mouseClick(&button("tourAction"), Qt::LeftButton);
  ASSERT_TRUE(test::waitUntil([this] { return scene().volume != nullptr; }) && rest());
  press(Qt::Key_Return);
  EXPECT_EQ(tour().step(), 1);
}

TEST_F(TourWindow, leavesEverythingElseAtWork) {
  ASSERT_TRUE(open(QStringLiteral("phantom:8")) && rest());
  start().trigger();
  press(Qt::Key_Return);
  press(Qt::Key_Return); // of the curve
  const TransferFunction before = scene().transferFunction;
  dragAPoint();
  EXPECT_NE(scene().transferFunction, before);
  EXPECT_EQ(tour().step(), 2);
  window->resize(1000, 700);
  ASSERT_TRUE(test::waitUntil([&] { return window->rect().contains(callout()->geometry()); }));
  curves().parentWidget()->hide(); // the dock, by whatever means
  settle();
  EXPECT_TRUE(callout()->isVisible() && !frame().isVisible()) << "of nothing that is seen";
}

TEST_F(TourWindow, everyButtonIsLegibleWithTheKeyboardOnIt) {
  ASSERT_TRUE(open(QStringLiteral("phantom:8")) && rest());
  start().trigger();
  press(Qt::Key_Return);
  for (const char* name : {"tourNext", "tourBack", "tourEnd"}) {
    for (int step = 0; step < 4 && !button(name).hasFocus(); ++step)
      press(Qt::Key_Tab);
    ASSERT_TRUE(button(name).hasFocus()) << name;
    const QImage seen = button(name).grab().toImage();
    const QColor ground = seen.pixelColor(5, 5);
    double contrast = 1.0; // of the words: the frame lies outside
    for (int x = 8; x < seen.width() - 8; ++x)
      contrast = std::max(contrast, contrastRatio(seen.pixelColor(x, seen.height() / 2), ground));
    EXPECT_GE(contrast, 4.5) << name << ": WCAG 2.1 asks that of text";
  }
}

TEST(CalloutPlaces, standBesideTheirTargetWhereThereIsRoom) {
  const QRect window(0, 0, 1000, 700);
  const QSize size(300, 150);
  const auto sideOf = [&](const QRect& target) { return calloutPlace(target, size, window, 12).side; };
  EXPECT_EQ(sideOf({0, 100, 200, 500}), CalloutSide::right);
  EXPECT_EQ(sideOf({800, 100, 200, 500}), CalloutSide::left);
  EXPECT_EQ(sideOf({0, 450, 1000, 250}), CalloutSide::above);
  EXPECT_EQ(sideOf({0, 0, 1000, 40}), CalloutSide::below);
  EXPECT_EQ(sideOf({0, 30, 80, 40}), CalloutSide::below) << "and not over its neighbours in a row";
  EXPECT_EQ(sideOf(window), CalloutSide::within);
  const CalloutPlace corner = calloutPlace({970, 0, 30, 30}, size, window, 12);
  EXPECT_TRUE(window.contains(corner.box));
  EXPECT_FALSE(corner.box.intersects({970, 0, 30, 30}));
}

TEST(FirstWindow, leavesThePictureTheLargerPartAndGrowsPanelsWithALargeOne) {
  for (const QSize screen : {QSize(1366, 728), QSize(1366, 768), QSize(1280, 800), QSize(1440, 900)}) {
    const QSize window = firstWindowSize(screen);
    const int bars = 132; // of menus, tools and status
    const int curve = firstDockSizes(window).curveHeight;
    EXPECT_GT(window.height() - bars - curve, 5 * curve / 4) << screen.height();
  }
  EXPECT_EQ(firstDockSizes({1440, 860}).curveHeight, 189);
  EXPECT_EQ(firstDockSizes({1440, 860}).presetsWidth, 180) << "less than they need: as narrow as they can be";
  EXPECT_EQ(firstDockSizes(firstWindowSize({3840, 2160})).presetsWidth, 340);
}

TEST(FirstWindow, fromALargerScreenComesBackWholly) {
  const QRect small(0, 0, 1366, 768);
  EXPECT_EQ(withinScreen({0, 20, 1400, 860}, small), QRect(0, 20, 1366, 728)) << "room for a title bar";
  EXPECT_EQ(withinScreen({900, 500, 800, 600}, small), QRect(566, 168, 800, 600));
  EXPECT_EQ(withinScreen({-900, -50, 800, 600}, small), QRect(0, 0, 800, 600));
  EXPECT_EQ(withinScreen({10, 30, 1000, 700}, small), QRect(10, 30, 1000, 700)) << "as it was left";
}

TEST(FirstWindow, fitsSmallScreensAndFillsLargeOnes) {
  EXPECT_EQ(firstWindowSize({1366, 728}), QSize(1350, 688)) << "1366 × 768 with a bar of 40 pixels";
  EXPECT_EQ(firstWindowSize({1440, 900}), QSize(1424, 860));
  EXPECT_EQ(firstWindowSize({1920, 1040}), QSize(1536, 900));
  EXPECT_EQ(firstWindowSize({3840, 2160}), QSize(3072, 1728));
}

} // namespace
} // namespace limn
