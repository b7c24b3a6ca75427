// SPDX-License-Identifier: GPL-3.0-or-later
// Physical light in the program's window: chosen, set, measured, and never in the way.
#include "app/WindowHarness.h"
#include "app/files/saving/PictureDialog.h"
#include "app/panels/AccuracyController.h"
#include "io/ImageFile.h"
#include "io/scenefile/SceneFile.h"
#include "support/Heart.h"
#include "support/JudgedTime.h"
#include "widgets/FindWidget.h"
#include "widgets/accuracy/AccuracyPanel.h"
#include "widgets/accuracy/DialSection.h"
#include "widgets/accuracy/ErrorMapOverlay.h"
#include "widgets/accuracy/MapSection.h"
#include "widgets/accuracy/MeasuredSection.h"
#include "widgets/accuracy/StopSlider.h"
#include "widgets/accuracy/WishSection.h"
#include "widgets/controls/ChoiceRow.h"
#include "widgets/controls/NumberSliders.h"
#include "widgets/controls/TrackSlider.h"
#include "widgets/properties/PropertiesPanel.h"
#include "widgets/shading/PhysicalSection.h"
#include "widgets/view/panels/PictureStatus.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>

#include <set>
#include <utility>

namespace limn {
namespace {

class PhysicalWindow : public test::OpenGlWindow {
protected:
  void SetUp() override {
    OpenGlWindow::SetUp();
    window->resize(800, 560); // few pixels to follow paths for
    ASSERT_TRUE(open(QStringLiteral("phantom:6")));
    session().setCamera(zoomed(scene().camera, 0.5)); // and three quarters of them see nothing
    ASSERT_TRUE(rest());
  }

  PropertiesPanel& properties() { return *window->findChild<PropertiesPanel*>(); }
  AccuracyPanel& accuracy() { return *window->findChild<AccuracyPanel*>(); }
  ChoiceRow& light() { return *rowNamed<ChoiceRow>(properties(), "Light"); }

  void choose(ChoiceRow& row, int index) {
    row.box()->setCurrentIndex(index);
    emit row.box()->activated(index);
  }
  void click(QWidget* control) {
    accuracy().ensureWidgetVisible(control);
    QCoreApplication::processEvents();
    QTest::mouseClick(control, Qt::LeftButton);
  }
  SideState lastSide() { return view().pictureState().sides.back(); }
  [[nodiscard]] bool workEnds() {
    return test::waitUntil([this] { return accuracy().work() == AccuracyWork::none; });
  }
};

TEST_F(PhysicalWindow, theLightCalledPhysicalShowsAtTheRightAndItsNumbersComeUp) {
  auto& section = *window->findChild<PhysicalSection*>();
  EXPECT_TRUE(section.isFolded());
  choose(light(), 4);
  EXPECT_EQ(view().scenesOfSides()[0].shading.model, ShadingModel::classic);
  EXPECT_EQ(view().scenesOfSides()[1].shading.model, ShadingModel::physical);
  EXPECT_FALSE(section.isFolded());
  ASSERT_TRUE(rest());
  EXPECT_TRUE(lastSide().paths);
  action(QStringLiteral("Si&ngle"))->trigger(); // as the tool bar does
  EXPECT_EQ(view().scenesOfSides()[0].shading.model, ShadingModel::physical);
  choose(light(), 1);
  EXPECT_EQ(view().scenesOfSides()[0].shading.model, ShadingModel::classic);
  EXPECT_TRUE(section.isFolded());
  undo().undo();
  EXPECT_EQ(scene().shading.model, ShadingModel::physical) << "one step back";
}

// The models of a comparison are no part of undo, but physical light is chosen as a light, which is.
TEST_F(PhysicalWindow, undoBringsBackTheModelBeforePhysicalLightInAComparison) {
  const auto models = [this] {
    std::vector<ShadingModel> shown;
    for (const Scene& side : view().scenesOfSides())
      shown.push_back(side.shading.model);
    return shown;
  };
  using Models = std::vector<ShadingModel>;
  const Models before{ShadingModel::classic, ShadingModel::robust};
  const Models physical{ShadingModel::classic, ShadingModel::physical};
  emit view().modelChosen(1, ShadingModel::robust);
  ASSERT_EQ(models(), before);
  choose(light(), 4);
  EXPECT_EQ(models(), physical);
  undo().undo();
  EXPECT_EQ(models(), before);
  undo().redo();
  EXPECT_EQ(models(), physical);
  choose(light(), 1);
  EXPECT_EQ(models(), before) << "another light leaves it";
  undo().undo();
  EXPECT_EQ(models(), physical);
  // Another model that is chosen since is a step of its own.
  emit view().modelChosen(1, ShadingModel::enhanced);
  ASSERT_EQ(models(), (Models{ShadingModel::classic, ShadingModel::enhanced}));
  undo().undo();
  EXPECT_EQ(models(), physical);
  undo().undo();
  EXPECT_EQ(models(), before);
  // Chosen as a model, another light leaves it all the same.
  emit view().modelChosen(1, ShadingModel::physical);
  ASSERT_EQ(models(), physical);
  choose(light(), 2);
  EXPECT_EQ(models(), before);
  EXPECT_EQ(scene().shading.model, ShadingModel::classic);
}

// The first picture soon, no turn of the event loop held up, and another edit is answered as soon.
TEST_F(PhysicalWindow, aPictureIsThereAtOnceAndNothingWaitsForIt) {
  window->resize(1100, 760);
  setLayout(CompareLayout::single);
  choose(light(), 4);
  ASSERT_TRUE(rest()); // OpenGL has given way
  const test::Heart heart;
  for (const double density : {2.0, 0.5, 1.5}) {
    Shading shading = scene().shading;
    shading.physical.density = density;
    QElapsedTimer clock;
    clock.start();
    session().setShading(shading, {nextGestureId(), QStringLiteral("density")});
    ASSERT_FALSE(view().pictureState().resting);
    // Of this edit: coarse, or whole at once where the machine is fast.
    ASSERT_TRUE(
        test::waitUntil([&] { return lastSide().imageScale < 1.0 || view().pictureState().resting; }));
    test::judgeMs("the first picture of physical light", static_cast<double>(clock.elapsed()), 300.0);
  }
  ASSERT_TRUE(rest());
  test::expectShortTurns(heart, "while paths are followed", 100.0);
}

// Between two passes, of which each takes as long as all before it.
TEST_F(PhysicalWindow, theErrorInTheStatusBarFallsWhileMorePathsAreFollowed) {
  window->resize(1100, 760);
  view().setRefinesAtRest(true);
  setLayout(CompareLayout::single);
  choose(light(), 4);
  ASSERT_TRUE(rest());
  const auto& status = *window->findChild<PictureStatus*>();
  std::set<double> told; // within one pass
  int paths = 0;
  const auto hasFallen = [&] {
    const SideState side = lastSide();
    if (!side.onTheWay || !side.paths)
      return false;
    if (side.paths->paths != std::exchange(paths, side.paths->paths))
      told.clear();
    EXPECT_TRUE(told.empty() || *side.onTheWay->rmsLevels <= *told.begin()) << "it never rises";
    told.insert(*side.onTheWay->rmsLevels);
    EXPECT_LE(*told.rbegin(), *side.paths->rmsLevels);
    EXPECT_TRUE(status.text().estimate.contains(levelsText(*side.onTheWay->rmsLevels)))
        << status.text().estimate.toStdString();
    return told.size() >= 3;
  };
  EXPECT_TRUE(test::waitUntil(hasFallen));
}

TEST_F(PhysicalWindow, exposureIsAStepOfTheHistoryAndCostsNoPath) {
  setLayout(CompareLayout::single);
  choose(light(), 4);
  ASSERT_TRUE(rest());
  const int paths = lastSide().paths->paths;
  const QImage before = view().grab().toImage();
  const int steps = undo().count();
  QTest::keyClick(rowNamed<ValueSlider>(properties(), "Exposure")->findChild<TrackSlider*>(), Qt::Key_End);
  EXPECT_EQ(scene().shading.physical.exposureEv, 4.0);
  EXPECT_EQ(undo().count(), steps + 1);
  EXPECT_EQ(undo().undoText(), QStringLiteral("change exposure 0 → 4\u00a0EV"));
  ASSERT_TRUE(rest());
  EXPECT_EQ(lastSide().paths->paths, paths);
  undo().undo();
  ASSERT_TRUE(rest());
  EXPECT_EQ(lastSide().paths->paths, paths);
}

TEST_F(PhysicalWindow, accuracyIsMeasuredByPathsWithTheirLawAndAMap) {
  window->findChild<QDockWidget*>(QStringLiteral("accuracyDock"))->raise();
  setLayout(CompareLayout::single);
  choose(light(), 4);
  ASSERT_TRUE(rest());
  EXPECT_FALSE(accuracy().findChild<StopSlider*>()->isVisible()) << "there is no step to choose";
  click(widgetNamed<QPushButton>(accuracy(), "Measure error and time"));
  ASSERT_EQ(accuracy().work(), AccuracyWork::measuring);
  ASSERT_TRUE(workEnds());
  ASSERT_TRUE(accuracy().measured());
  EXPECT_TRUE(accuracy().measured()->report.reference.isByChance);
  const auto textOf = [this](const QWidget& section, const char* label) {
    return section.findChild<QLabel*>(QString::fromLatin1(label))->text();
  };
  const QString summary = textOf(*accuracy().findChild<MeasuredSection*>(), "summary");
  EXPECT_TRUE(summary.contains(QStringLiteral("the law of chance"))) << summary.toStdString();
  EXPECT_TRUE(summary.contains(QStringLiteral("16 times as many paths"))) << summary.toStdString();
  click(widgetNamed<QPushButton>(accuracy(), "Use: Error at most, levels"));
  const QString answer = textOf(*accuracy().findChild<WishSection*>(), "answer");
  EXPECT_TRUE(answer.contains(QStringLiteral("By the law of chance"))) << answer.toStdString();
  // The map is of the picture on screen.
  QCheckBox* map = accuracy().findChild<MapSection*>()->findChild<QCheckBox*>();
  click(map);
  ASSERT_TRUE(workEnds());
  EXPECT_TRUE(window->findChild<ErrorMapOverlay*>()->isVisible());
  const QString sentence = textOf(*accuracy().findChild<MapSection*>(), "sentence");
  const bool isOne = lastSide().paths->paths == 1; // on a slow machine
  EXPECT_TRUE(sentence.contains(isOne ? QStringLiteral("1 path a pixel") : QStringLiteral("paths a pixel")))
      << sentence.toStdString();
}

// Of what is saved it is promised how far it is drawn, whatever the screen had by then.
TEST_F(PhysicalWindow, aSavedPictureHasThePathsThatThePanelPromises) {
  setLayout(CompareLayout::single);
  choose(light(), 4);
  Shading shading = scene().shading;
  for (const bool filters : {true, false}) {
    shading.physical.filtersNoise = filters;
    session().setShading(shading, {nextGestureId(), QStringLiteral("saved pictures")});
    ASSERT_TRUE(rest());
    const int promised = 2 * lastSide().paths->paths + 1; // no power of two, as pictures on screen have
    shading.physical.until = UntilPaths{promised};
    session().setShading(shading, {nextGestureId(), QStringLiteral("saved pictures")});
    ASSERT_TRUE(rest());
    ASSERT_LT(lastSide().paths->paths, promised);
    const char* name = filters ? "filtered.png" : "plain.png";
    saving().writePicture(pathTo(name));
    ASSERT_TRUE(test::waitUntil([&] { return isWholePicture(folder.path() / name); }));
    const SceneDocument saved = parseScene(readImageDescription(folder.path() / name), name);
    EXPECT_EQ(saved.scene.shading.physical.until, Until(UntilPaths{promised}));
    const QJsonObject told =
        QJsonDocument::fromJson(QByteArray::fromStdString(readImageDescription(folder.path() / name)))
            .object()[QStringLiteral("accuracy")]
            .toObject();
    EXPECT_EQ(told[QStringLiteral("paths")].toInt(), promised);
    EXPECT_GT(told[QStringLiteral("rms_levels")].toDouble(), 0.0);
    EXPECT_EQ(told.contains(QStringLiteral("filter_largest_levels")), filters);
    EXPECT_TRUE(test::waitUntil([&] {
      return messages().isVisible() &&
             messages().sentence().contains(QStringLiteral("after %1 paths a pixel").arg(promised));
    })) << messages().sentence().toStdString();
    messages().hide();
  }
  // What the screen has already is not drawn again.
  shading.physical.until = UntilPaths{1};
  session().setShading(shading, {nextGestureId(), QStringLiteral("saved pictures")});
  ASSERT_TRUE(rest());
  const int paths = lastSide().paths->paths;
  saving().writePicture(pathTo("shown.png"));
  ASSERT_TRUE(isWholePicture(folder.path() / "shown.png"));
  const SceneDocument shown = parseScene(readImageDescription(folder.path() / "shown.png"), "shown.png");
  EXPECT_EQ(shown.scene.shading.physical.until, Until(UntilPaths{paths}));
}

TEST_F(PhysicalWindow, whatSavedPicturesAloneHaveLeavesScreenAndPresetAsTheyAre) {
  setLayout(CompareLayout::single);
  choose(light(), 4);
  ASSERT_TRUE(rest());
  session().adoptPreset(presetOf(scene(), "mine"));
  const int paths = lastSide().paths->paths;
  Shading shading = scene().shading;
  shading.physical.filtersNoise = true;
  shading.physical.until = UntilLevels{3.0};
  session().setShading(shading, {nextGestureId(), QStringLiteral("saved pictures")});
  EXPECT_TRUE(view().pictureState().resting) << "nothing is drawn anew";
  EXPECT_EQ(lastSide().paths->paths, paths);
  EXPECT_EQ(withPreset(scene(), session().preset(), true), scene()) << "the preset is not modified";
}

TEST_F(PhysicalWindow, theDialogSaysHowFarItIsDrawnAndLeadsToWhereThatIsSet) {
  window->resize(1100, 760);
  setLayout(CompareLayout::single);
  choose(light(), 4);
  ASSERT_TRUE(rest());
  Shading shading = scene().shading;
  shading.physical.filtersNoise = true;
  session().setShading(shading, {nextGestureId(), QStringLiteral("saved pictures")});
  auto& section = *window->findChild<PhysicalSection*>();
  section.setFolded(true);
  window->findChild<QDockWidget*>(QStringLiteral("accuracyDock"))->raise();
  QString said;
  onceAsked<PictureDialog>([&said](PictureDialog& dialog) {
    auto* paths = dialog.findChild<QLabel*>(QStringLiteral("picturePaths"));
    said = paths ? paths->text() : QString();
    dialog.findChild<QComboBox*>(QStringLiteral("pictureSize"))->setCurrentIndex(1);
    if (paths)
      emit paths->linkActivated(QStringLiteral("#"));
    else
      dialog.reject();
  });
  action(QStringLiteral("Save &picture…"))->trigger();
  EXPECT_TRUE(said.startsWith(QStringLiteral("256 paths a pixel, noise filtered"))) << said.toStdString();
  EXPECT_FALSE(section.isFolded());
  EXPECT_EQ(window->focusWidget(), section.until()->box())
      << "it has the keyboard once the window has, not " << window->focusWidget()->metaObject()->className();
  EXPECT_FALSE(section.until()->visibleRegion().isEmpty());
  int size = -1;
  onceAsked<PictureDialog>([&size](PictureDialog& dialog) {
    size = dialog.findChild<QComboBox*>(QStringLiteral("pictureSize"))->currentIndex();
    dialog.reject();
  });
  action(QStringLiteral("Save &picture…"))->trigger();
  EXPECT_EQ(size, 1) << "what was chosen before is still chosen";
}

// Of what a single path tells there is no map of zeros, and work that takes long tells how far it is and
// ends.
TEST_F(PhysicalWindow, aMapOfPathsSaysWhatItDoesNotKnowAndIsCancelled) {
  Scene drawn = scene();
  drawn.shading.model = ShadingModel::physical;
  AccuracyMeasurer measurer;
  measurer.setRays(Engine::cpu);
  QSignalSpy progressed(&measurer, &AccuracyMeasurer::progressed);
  QSignalSpy compared(&measurer, &AccuracyMeasurer::compared);
  drawn.quality.paths = 1 << 20; // takes hours
  measurer.compare(drawn, {64, 48});
  ASSERT_TRUE(test::waitUntil([&] { return !progressed.isEmpty(); }));
  EXPECT_EQ(progressed[0][1].toString(), QStringLiteral("Following 1048576 paths a pixel"));
  measurer.cancel();
  drawn.quality.paths = 1;
  measurer.compare(drawn, {64, 48}); // begins once the other has ended
  ASSERT_TRUE(test::waitUntil([&] { return !compared.isEmpty(); }));
  ASSERT_EQ(compared.size(), 1);
  const auto picture = compared[0][0].value<ComparedPicture>();
  EXPECT_EQ(picture.point.paths, 1);
  EXPECT_FALSE(picture.error);
}

} // namespace
} // namespace limn
