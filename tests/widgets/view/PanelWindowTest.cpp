// SPDX-License-Identifier: GPL-3.0-or-later
#include "ViewHost.h"
#include "cpu/CpuEngine.h"
#include "scene/basics/Error.h"
#include "support/BrokenDriver.h"
#include "widgets/view/drawing/DriverRecovery.h"
#include "widgets/view/panels/ViewPanels.h"

#include <QApplication>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>

#include <algorithm>
#include <atomic>
#include <thread>

// What covers the pictures, in a real window.

namespace limn {
namespace {

using test::ViewHost;

QPushButton* buttonNamed(const ViewHost& host, const char* name) {
  return host.view.findChild<QPushButton*>(QString::fromLatin1(name));
}

TEST(Panels, withoutAVolumeTheViewOffersThreeWaysToOpenOne) {
  ViewHost host({900, 700});
  ASSERT_TRUE(host.show());
  auto* panel = host.view.findChild<EmptyPanel*>();
  ASSERT_TRUE(panel->isVisible());
  const QList<QLabel*> labels = panel->findChildren<QLabel*>();
  EXPECT_TRUE(std::ranges::any_of(labels, [](const QLabel* label) {
    return label->isVisible() && label->text().contains(QStringLiteral("shows CT and MR volumes"));
  })) << "what it is";
  QSignalSpy folder(panel, &EmptyPanel::openFolderRequested);
  QSignalSpy file(panel, &EmptyPanel::openFileRequested);
  QSignalSpy sample(panel, &EmptyPanel::sampleRequested);
  QTest::mouseClick(buttonNamed(host, "openFolder"), Qt::LeftButton);
  QTest::mouseClick(buttonNamed(host, "openFile"), Qt::LeftButton);
  QTest::mouseClick(buttonNamed(host, "sample"), Qt::LeftButton);
  EXPECT_EQ(folder.count(), 1);
  EXPECT_EQ(file.count(), 1);
  EXPECT_EQ(sample.count(), 1);
  host.showPhantom();
  EXPECT_FALSE(panel->isVisible());
}

// What a place leaves behind as it moves is painted anew, but no more than that.
TEST(Panels, theFrameOfThePlaceToDropSomethingLiesWithinIt) {
  ViewHost host;
  ASSERT_TRUE(host.show());
  const QWidget& place = *buttonNamed(host, "openFolder")->parentWidget();
  const QImage image = host.view.emptyPanel().grab().toImage();
  const auto at = [&](int x, int y) { return image.pixelColor(QPoint(x, y) * image.devicePixelRatio()); };
  const QRect around = place.geometry().adjusted(-1, -1, 1, 1);
  ASSERT_TRUE(host.view.emptyPanel().rect().contains(around));
  for (int x = around.left(); x <= around.right(); ++x)
    ASSERT_EQ(at(x, around.top()), at(1, 1)) << x;
  for (int y = around.top(); y <= around.bottom(); ++y)
    ASSERT_EQ(at(around.left(), y), at(1, 1)) << y;
}

TEST(Panels, enterDoesWhatIsLikeliestWhereverThePointerIs) {
  ViewHost host;
  ASSERT_TRUE(host.show());
  auto& panel = host.view.emptyPanel();
  QSignalSpy folder(&panel, &EmptyPanel::openFolderRequested);
  QSignalSpy goingOn(&panel, &EmptyPanel::continueRequested);
  EXPECT_FALSE(buttonNamed(host, "continue")->isVisible());
  ASSERT_TRUE(test::waitUntil([&] {
    if (!host.view.isActiveWindow())
      host.view.window()->activateWindow();
    return buttonNamed(host, "openFolder")->hasFocus();
  }));
  host.move({10, 10});
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
  EXPECT_EQ(folder.count(), 1);
  panel.setUnfinished(QStringLiteral("Head & neck, 3.4.26 14:03"));
  EXPECT_TRUE(buttonNamed(host, "continue")->text().endsWith(QStringLiteral("\nHead && neck, 3.4.26 14:03")));
  EXPECT_TRUE(buttonNamed(host, "continue")->hasFocus());
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
  EXPECT_EQ(goingOn.count(), 1);
  panel.setUnfinished(QStringLiteral("Head & neck, 3.4.26 14:03"), false);
  EXPECT_TRUE(buttonNamed(host, "openFolder")->hasFocus() && buttonNamed(host, "openFolder")->isDefault());
  EXPECT_TRUE(buttonNamed(host, "continue")->isVisible() && !buttonNamed(host, "continue")->isDefault());
  panel.setUnfinished({});
  EXPECT_TRUE(buttonNamed(host, "openFolder")->hasFocus());
}

TEST(Panels, inALowViewNoButtonIsCut) {
  ViewHost host;
  ASSERT_TRUE(host.show());
  EmptyPanel& panel = host.view.emptyPanel();
  const auto isWhole = [&](const QPushButton& button) {
    return button.height() >= button.sizeHint().height() &&
           panel.rect().contains(QRect(button.mapTo(&panel, QPoint()), button.size()));
  };
  panel.setUnfinished(QStringLiteral("Head, 3.4.26 14:03"));
  panel.setRecentSources({QStringLiteral("one"), QStringLiteral("two"), QStringLiteral("three")});
  auto* recent = buttonNamed(host, "recent");
  for (const int height : {700, 400, 300, 240, 700}) {
    host.view.window()->resize(820, height);
    ASSERT_TRUE(test::waitUntil([&] { return panel.height() == height; }));
    QCoreApplication::processEvents();
    for (const char* name : {"continue", "openFolder", "openFile", "sample"})
      EXPECT_TRUE(isWhole(*buttonNamed(host, name)))
          << name << height << " is " << buttonNamed(host, name)->height() << " of "
          << buttonNamed(host, name)->sizeHint().height();
    EXPECT_TRUE(!recent->isVisible() || isWhole(*recent)) << height;
    EXPECT_EQ(recent->isVisible(), height >= 300) << height << ": before mere words, after the buttons";
  }
}

TEST(Panels, whatIsOfferedMovesOnlyWhereSomethingWouldLieOnIt) {
  ViewHost host;
  ASSERT_TRUE(host.show());
  EmptyPanel& panel = host.view.emptyPanel();
  host.view.window()->resize(820, 700);
  ASSERT_TRUE(test::waitUntil([&] { return panel.height() == 700; }));
  const auto* button = buttonNamed(host, "openFolder");
  const auto place = [&] {
    QCoreApplication::processEvents();
    return QRect(button->mapTo(&panel, QPoint()), button->size());
  };
  QWidget cover(&host.view);
  cover.setGeometry(60, 620, 700, 40);
  panel.keepClearOf(cover);
  const QRect before = place();
  cover.show();
  EXPECT_EQ(place(), before);
  cover.move(60, before.top());
  EXPECT_LT(place().bottom(), before.top());
  cover.hide();
  EXPECT_EQ(place(), before);
}

TEST(Panels, dragsAndKeysOfAnEmptyViewAskForNothing) {
  ViewHost host;
  ASSERT_TRUE(host.show());
  QTest::keyClick(&host.view, Qt::Key_A);
  host.drag({10, 10}, {60, 60});
  EXPECT_EQ(host.cameraEdits, 0);
}

// An engine that never gets ready for a volume until it is allowed to.
class UnreadyEngine final : public DrawingEngine {
public:
  explicit UnreadyEngine(const std::atomic<bool>& isReady) : m_isReady(isReady) {}

  double makeReady(const Scene& scene, const Effort& effort) override {
    while (!m_isReady) {
      effort.report(0.25);
      if (effort.isCancelled())
        throw Cancelled();
      std::this_thread::yield();
    }
    return m_engine->makeReady(scene, effort);
  }
  std::optional<Image> draw(const Scene& scene, const glm::ivec2& size, const PixelRect& tile,
                            const IsCancelled& isCancelled) override {
    return m_engine->draw(scene, size, tile, isCancelled);
  }
  Image drawUnlimited(const Scene& scene, const glm::ivec2& size) override {
    return m_engine->drawUnlimited(scene, size);
  }
  bool prepare(const Scene& scene, const glm::ivec2& size) override { return m_engine->prepare(scene, size); }
  std::unique_ptr<EffectMeasurement> measureEffects(const Scene& scene, const glm::ivec2& size) override {
    return m_engine->measureEffects(scene, size);
  }
  DrawingFacts facts(const Scene& scene) override { return m_engine->facts(scene); }
  GradientScale gradientScale() const override { return m_engine->gradientScale(); }
  int compiledPrograms() const override { return m_engine->compiledPrograms(); }
  double memoryMb() const override { return m_engine->memoryMb(); }
  std::string name() const override { return m_engine->name(); }
  Message limitation() const override { return m_engine->limitation(); }

private:
  std::unique_ptr<DrawingEngine> m_engine = makeCpuEngine();
  const std::atomic<bool>& m_isReady;
};

TEST(Panels, gettingAVolumeReadyIsSaidCanBeCancelledAndTriedAgain) {
  std::atomic<bool> isReady = false;
  ViewHost host(
      {400, 240}, [&] { return std::make_unique<UnreadyEngine>(isReady); }, Engine::cpu);
  QSignalSpy loading(&host.view, &CompareView::loadingCancelled);
  host.showPhantom();
  ASSERT_TRUE(host.show());
  auto* panel = host.view.findChild<LoadingPanel*>();
  ASSERT_TRUE(test::waitUntil([&] { return panel->isVisible(); }));
  EXPECT_TRUE(panel->findChild<QLabel*>()->text().contains(QStringLiteral("ready")));
  host.drag({100, 100}, {140, 110});
  EXPECT_TRUE(panel->isVisible()) << "another camera is no reason to begin anew";
  QTest::mouseClick(buttonNamed(host, "cancel"), Qt::LeftButton);
  auto* message = host.view.findChild<MessagePanel*>();
  ASSERT_TRUE(test::waitUntil([&] { return message->isVisible() && !panel->isVisible(); }));
  EXPECT_TRUE(message->findChild<QLabel*>(QStringLiteral("sentence"))->text().contains("cancelled"));
  EXPECT_EQ(loading.count(), 0) << "nothing is read";
  isReady = true;
  QTest::mouseClick(buttonNamed(host, "retry"), Qt::LeftButton);
  ASSERT_TRUE(host.rest());
  EXPECT_FALSE(message->isVisible());
  EXPECT_FALSE(panel->isVisible());
}

TEST(Panels, aFailureIsSaidInsteadOfABlackWindowAndCanBeOvercome) {
  ViewHost host;
  host.showPhantom();
  auto refused = std::make_unique<test::DriverWithoutTextures>();
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(test::waitUntil([&] { return !host.errors.empty(); }));
  refused.reset();
  auto* panel = host.view.findChild<MessagePanel*>();
  EXPECT_TRUE(panel->isVisible());
  EXPECT_EQ(panel->findChild<QLabel*>(QStringLiteral("sentence"))->text(), host.errors[0]);
  EXPECT_FALSE(host.errors[0].isEmpty());
  QTest::mouseClick(buttonNamed(host, "retry"), Qt::LeftButton);
  EXPECT_TRUE(host.rest());
  EXPECT_FALSE(panel->isVisible());
  EXPECT_EQ(host.errors.size(), 1u);
}

// Qt's offscreen platform makes no OpenGL context: the state of a machine without a driver.
TEST(OpenGlProblem, isSaidWhereThereIsNoOpenGl) {
  if (QGuiApplication::platformName() != QLatin1String("offscreen"))
    GTEST_SKIP() << "needs Qt's offscreen platform; CTest runs it so as limn_view_without_opengl";
  EXPECT_TRUE(openGlOffer().problem.contains(QStringLiteral("OpenGL 3.0")));
}

TEST(OpenGlProblem, isNoneWhereViewsWork) {
  if (QGuiApplication::platformName() == QLatin1String("offscreen"))
    GTEST_SKIP() << "Qt's offscreen platform has no OpenGL";
  EXPECT_EQ(openGlOffer().problem, QString());
  EXPECT_FALSE(openGlOffer().renderer.isEmpty());
}

TEST(Panels, loadingShowsItsProgressAndCanBeCancelled) {
  ViewHost host;
  ASSERT_TRUE(host.show());
  auto* panel = host.view.findChild<LoadingPanel*>();
  EXPECT_FALSE(panel->isVisible());
  host.view.setLoading(0.4, QStringLiteral("Reading slice 43 of 108…"));
  EXPECT_TRUE(panel->isVisible());
  QSignalSpy cancelled(&host.view, &CompareView::loadingCancelled);
  QTest::mouseClick(buttonNamed(host, "cancel"), Qt::LeftButton);
  EXPECT_EQ(cancelled.count(), 1);
  host.view.clearLoading();
  EXPECT_FALSE(panel->isVisible());
}

} // namespace
} // namespace limn
