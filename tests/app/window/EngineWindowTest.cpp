// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/core/drawing/PictureMaker.h"
#include "app/frame/dialogs/DialogController.h"
#include "widgets/FindWidget.h"
#include "widgets/accuracy/AccuracyPanel.h"
#include "widgets/properties/EffectTimes.h"

#include <QComboBox>
#include <QMenu>
#include <QWindow>

#include <algorithm>
#include <fstream>

// Which engine draws the program's window: as chosen in the menu, as remembered, or as a trial has shown.

namespace limn {
namespace {

class EngineWindow : public test::WindowHarness {
protected:
  EngineWindow() : WindowHarness(Engine::cpu) {}

  // A window that is opened with these settings.
  void openAnew(std::optional<Engine> setting, const std::optional<EngineTimes>& times,
                const std::optional<MemoryBudget>& memory = {}) {
    window.reset();
    std::filesystem::remove(settingsFile());
    Settings settings(settingsFile());
    settings.setEngine(setting);
    if (times)
      settings.engineMemory().remember(machine(), *times);
    window = std::make_unique<MainWindow>(UserFolders::below(folder.path()), memory);
    window->view().setRefinesAtRest(false);
    window->resize(900, 640);
    window->show();
    ASSERT_TRUE(test::waitUntilExposed(*window));
  }
  std::filesystem::path settingsFile() const { return UserFolders::below(folder.path()).settings; }
  static std::string machine() { return machineWith(openGlOffer().renderer.toStdString()); }
  QAction* entry(const char* name) const {
    return window->findChild<QAction*>(QStringLiteral("engine-") + QLatin1String(name));
  }
};

TEST_F(EngineWindow, theOneChosenInTheMenuDrawsAndIsRemembered) {
  ASSERT_TRUE(openAlone(QStringLiteral("phantom:8")));
  ASSERT_TRUE(rest());
  EXPECT_EQ(view().engine(), Engine::cpu);
  EXPECT_TRUE(entry("cpu")->isChecked());
  EXPECT_TRUE(labelSays(QStringLiteral("processor")));
  const auto shown = view().restingImage(0);
  EXPECT_TRUE(makePictures({view().sceneOfSide(0)}, shown->size, Engine::cpu, 1).front().image == *shown);

  entry("gl")->trigger();
  ASSERT_TRUE(rest());
  EXPECT_EQ(view().engine(), Engine::rayCaster);
  EXPECT_TRUE(entry("gl")->isChecked());
  EXPECT_FALSE(entry("cpu")->isChecked());
  EXPECT_TRUE(labelSays(QStringLiteral("OpenGL")));
  EXPECT_EQ(Settings(settingsFile()).engine(), Engine::rayCaster);
}

// Qt makes the window anew for OpenGL.
TEST_F(EngineWindow, theSettingsStayAboveTheWindowAndKeepTheKeyboard) {
  window->findChild<QAction*>(QStringLiteral("settings"))->trigger();
  auto* settings = window->findChild<SettingsDialog*>();
  ASSERT_TRUE(test::waitUntil([&] { return settings->isActiveWindow(); }));
  const WId before = window->winId();
  auto* box = widgetNamed<QComboBox>(*settings, "Draw with");
  box->setFocus();
  QTest::keyClick(box, Qt::Key_Up);
  ASSERT_EQ(view().engine(), Engine::rayCaster);
  ASSERT_NE(window->winId(), before);
  EXPECT_TRUE(
      test::waitUntil([&] { return settings->windowHandle()->transientParent() == window->windowHandle(); }));
  EXPECT_TRUE(test::waitUntil([&] { return settings->isActiveWindow(); }));
  EXPECT_TRUE(settings->isVisible() && box->hasFocus());
}

TEST_F(EngineWindow, whatATrialHasShownIsTakenWithoutAnother) {
  openAnew(std::nullopt, EngineTimes{100.0, 1.0});
  EXPECT_EQ(view().engine(), Engine::cpu);
  EXPECT_EQ(entry("auto")->text(), QStringLiteral("&Automatic: processor"));
  EXPECT_TRUE(entry("auto")->toolTip().contains(QStringLiteral("1.0 ms with the processor")))
      << entry("auto")->toolTip().toStdString();
  openAnew(std::nullopt, EngineTimes{1.0, 100.0});
  EXPECT_EQ(view().engine(), Engine::rayCaster);
  ASSERT_TRUE(open(QStringLiteral("phantom:16")));
  ASSERT_TRUE(rest());
  EXPECT_EQ(Settings(settingsFile()).engineMemory().recall(machine()), (EngineTimes{1.0, 100.0}));
  EXPECT_EQ(view().engine(), Engine::rayCaster);
}

TEST_F(EngineWindow, bothAreTriedOnceTheFirstPictureRestsAndTheFasterDraws) {
  openAnew(std::nullopt, std::nullopt);
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  ASSERT_TRUE(rest());
  std::optional<EngineTimes> times;
  ASSERT_TRUE(test::waitUntil([&] {
    times = Settings(settingsFile()).engineMemory().recall(machine());
    return times.has_value();
  }));
  const Engine faster = times->processorMs < times->openGlMs ? Engine::cpu : Engine::rayCaster;
  ASSERT_TRUE(test::waitUntil([&] { return view().engine() == faster && view().pictureState().resting; }));
  EXPECT_TRUE(view().pictureState().engineReason.contains(QStringLiteral("trial")));
}

TEST_F(EngineWindow, whatItCostsIsMeasuredWithTheEngineThatDraws) {
  window->resize(800, 560); // small pictures converge soon
  ASSERT_TRUE(open(QStringLiteral("phantom:20")));
  session().setCamera(zoomed(scene().camera, 0.5)); // and pixels that see nothing at once
  ASSERT_TRUE(rest());
  EffectTimes times;
  QObject::connect(&view(), &CompareView::told, [&](const ViewNews& news) { times = news.times; });
  view().measureEffects();
  ASSERT_TRUE(test::waitUntil([&] { return !times.costs.empty(); }));
  EXPECT_EQ(times.method, QStringLiteral("timed by the clock"));
  AccuracyPanel& panel = *window->findChild<AccuracyPanel*>();
  emit panel.measureRequested();
  ASSERT_TRUE(test::waitUntil([&] { return panel.work() == AccuracyWork::none; }));
  ASSERT_TRUE(panel.measured()) << messages().sentence().toStdString();
  EXPECT_TRUE(panel.measured()->report.renderer.starts_with("CPU engine"))
      << panel.measured()->report.renderer;
}

// 400 x 400 x 520 voxels of 8 bits are 83 MB, all but a bright block holes in the file.
void writeVolumeOfHoles(const std::filesystem::path& header) {
  std::ofstream(header) << "ObjectType = Image\nNDims = 3\nDimSize = 400 400 520\nElementSpacing = 1 1 1\n"
                           "ElementType = MET_UCHAR\nElementDataFile = voxels.raw\n";
  std::ofstream voxels(header.parent_path() / "voxels.raw", std::ios::binary);
  const std::string row(100, '\xc8');
  for (std::int64_t z = 200; z < 300; ++z)
    for (std::int64_t y = 150; y < 250; ++y) {
      voxels.seekp((z * 400 + y) * 400 + 150);
      voxels.write(row.data(), static_cast<std::streamsize>(row.size()));
    }
  voxels.close();
  std::filesystem::resize_file(header.parent_path() / "voxels.raw", 400 * 400 * 520);
}

// Of 64 MB a third is too little for the voxels, and an eighth for every second of them along each axis,
// which are 10.4 MB: what moves is drawn from every fourth, however near it is.
TEST_F(EngineWindow, whatMovesKeepsToTheMemoryThatTheWindowWasGiven) {
  openAnew(Engine::cpu, std::nullopt, MemoryBudget(MemoryBudget::least));
  writeVolumeOfHoles(folder.path() / "holes.mhd");
  std::vector<int> reductions;
  QObject::connect(&view(), &CompareView::told, [&](const ViewNews& news) {
    for (const SideState& side : news.state.sides)
      if (side.coarseness)
        reductions.push_back(side.coarseness->reduction);
  });
  ASSERT_TRUE(openAlone(pathTo("holes.mhd")));
  ASSERT_TRUE(rest());
  EXPECT_TRUE(scene().volume->room()) << "opened without a word on memory";
  EXPECT_TRUE(labelSays(QStringLiteral("0 to 200 · on the disk"))) << "also at rest";
  reductions.clear();
  Camera near = scene().camera;
  near.position = near.target + 0.3 * (near.position - near.target);
  session().setCamera(near);
  ASSERT_TRUE(test::waitUntil([&] { return !reductions.empty(); }));
  ASSERT_TRUE(rest());
  EXPECT_EQ(std::ranges::count(reductions, 4), std::ssize(reductions)) << reductions.front();
}

TEST_F(EngineWindow, aTrialIsNoReasonToWaitWhenTheWindowCloses) {
  openAnew(std::nullopt, std::nullopt);
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  ASSERT_TRUE(rest());
  window.reset();
  EXPECT_EQ(Settings(settingsFile()).engine(), std::nullopt);
}

// CTest runs this on Qt's offscreen platform, which makes no OpenGL context: the state of a machine without a
// driver.
class WindowWithoutOpenGl : public test::OpenGlWindow {
protected:
  void SetUp() override {
    if (QGuiApplication::platformName() != QLatin1String("offscreen"))
      GTEST_SKIP() << "needs Qt's offscreen platform; CTest runs it so as limn_window_without_opengl";
    OpenGlWindow::SetUp();
  }
};

TEST_F(WindowWithoutOpenGl, everythingWorksAndTheMenuSaysWhyTheProcessorDraws) {
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  ASSERT_TRUE(rest());
  EXPECT_EQ(view().engine(), Engine::cpu);
  EXPECT_EQ(view().findChild<QOpenGLWidget*>(), nullptr);
  const QAction* openGl = window->findChild<QAction*>(QStringLiteral("engine-gl"));
  EXPECT_FALSE(openGl->isEnabled());
  EXPECT_TRUE(openGl->toolTip().contains(QStringLiteral("no OpenGL 3.0")));
  EXPECT_TRUE(openGl->isChecked()) << "what was chosen elsewhere is kept";
  dragAPoint();
  EXPECT_EQ(undo().count(), 1);
  ASSERT_TRUE(rest());
  saving().writePicture(pathTo("saved.png"));
  const LoadedScene inside = loadScene((folder.path() / "saved.png").string(), {}, {});
  EXPECT_EQ(inside.scene.transferFunction, scene().transferFunction);
}

} // namespace
} // namespace limn
