// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/core/sources/BuiltInPresets.h"
#include "app/panels/presets/PresetController.h"
#include "app/picture/ComparisonController.h"
#include "scene/presets/Preset.h"
#include "widgets/FindWidget.h"
#include "widgets/controls/ChoiceRow.h"
#include "widgets/controls/NumberSliders.h"
#include "widgets/properties/PropertiesPanel.h"
#include "widgets/view/overlay/Overlay.h"
#include "widgets/view/panels/PictureStatus.h"

#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QTimer>

#include <algorithm>
#include <array>
#include <fstream>

// Where the shading models of the pictures are chosen, in the program's window.

namespace limn {
namespace {

class ModelWindow : public test::OpenGlWindow {
protected:
  void SetUp() override {
    OpenGlWindow::SetUp();
    window->resize(1280, 800);
    ASSERT_TRUE(open(QStringLiteral("phantom:6")));
  }

  QToolButton* button(int side) const {
    return window->findChild<QToolButton*>(side == 0 ? QStringLiteral("modelButton")
                                                     : QStringLiteral("rightModelButton"));
  }

  // Clicks the button of a side and chooses the entry of this place, from 1 on, by the keyboard.
  void choose(int side, int entry) {
    QTimer::singleShot(0, window.get(), [entry] {
      QWidget* menu = QApplication::activePopupWidget();
      ASSERT_NE(menu, nullptr);
      for (int key = 0; key < entry; ++key)
        QTest::keyClick(menu, Qt::Key_Down);
      QTest::keyClick(menu, Qt::Key_Return);
    });
    QTest::mouseClick(button(side), Qt::LeftButton);
    QCoreApplication::processEvents();
  }

  std::vector<ShadingModel> shown() {
    std::vector<ShadingModel> models;
    for (const Scene& one : view().scenesOfSides())
      models.push_back(one.shading.model);
    return models;
  }

  using Models = std::vector<ShadingModel>;
};

TEST_F(ModelWindow, aComparisonHasAButtonForEachSideThatChangesItAndEndsNothing) {
  ASSERT_TRUE(button(0)->isVisible() && button(1)->isVisible());
  EXPECT_EQ(button(0)->text(), QStringLiteral("Left: Classic"));
  EXPECT_EQ(button(1)->text(), QStringLiteral("Right: Enhanced"));
  choose(1, 4);
  EXPECT_EQ(shown(), (Models{ShadingModel::classic, ShadingModel::robust}));
  EXPECT_EQ(view().compareLayout(), CompareLayout::sideBySide);
  EXPECT_EQ(button(1)->text(), QStringLiteral("Right: Robust"));
  EXPECT_TRUE(button(1)->menu()->actions()[3]->isChecked());
  setLayout(CompareLayout::wipe);
  choose(0, 1);
  EXPECT_EQ(shown(), (Models{ShadingModel::none, ShadingModel::robust}));
  EXPECT_EQ(view().compareLayout(), CompareLayout::wipe);
  EXPECT_TRUE(rest());
  ASSERT_EQ(undo().count(), 2);
  EXPECT_EQ(undo().undoText(), QStringLiteral("Left: Unlit"));
  undo().undo();
  EXPECT_EQ(shown(), (Models{ShadingModel::classic, ShadingModel::robust}));
  EXPECT_EQ(view().compareLayout(), CompareLayout::wipe) << "which is no part of the step";
  undo().undo();
  EXPECT_EQ(shown(), (Models{ShadingModel::classic, ShadingModel::enhanced}));
  undo().redo();
  EXPECT_EQ(button(1)->text(), QStringLiteral("Right: Robust"));
}

TEST_F(ModelWindow, physicalLightChosenForASideIsAStepThatIsTakenBack) {
  choose(1, 5);
  EXPECT_EQ(shown(), (Models{ShadingModel::classic, ShadingModel::physical}));
  EXPECT_EQ(undo().undoText(), QStringLiteral("Right: Physical"));
  undo().undo();
  EXPECT_EQ(shown(), (Models{ShadingModel::classic, ShadingModel::enhanced}));
  EXPECT_EQ(button(1)->text(), QStringLiteral("Right: Enhanced"));
}

// The driver cannot: the processor draws, coarsely at once, then as many paths again and again.
TEST_F(ModelWindow, physicalLightIsDrawnByTheProcessorWithMorePathsWhileNothingMoves) {
  window->resize(1280, 560); // fewer pixels to follow paths for
  setLayout(CompareLayout::single);
  ASSERT_TRUE(rest());
  view().setRefinesAtRest(true);
  choose(0, 5);
  EXPECT_EQ(shown(), Models{ShadingModel::physical});
  EXPECT_EQ(button(0)->text(), QStringLiteral("Physical"));
  const auto paths = [this] {
    const PictureState& state = view().pictureState();
    const bool isShown = state.resting && !state.sides.empty() && state.sides[0].paths.has_value();
    return isShown ? state.sides[0].paths->paths : 0;
  };
  ASSERT_TRUE(test::waitUntil([&] { return paths() >= 8; }));
  EXPECT_EQ(view().pictureState().engine, Engine::cpu);
  // The error is found over what was followed, beside the event loop.
  const auto status = [this] { return window->findChild<PictureStatus*>()->text().line(); };
  EXPECT_TRUE(test::waitUntil([&] { return status().contains(QStringLiteral("levels RMS after")); }))
      << status().toStdString();
  // A gesture ends what is followed, and another picture begins.
  const Scene before = scene();
  dragAPoint();
  ASSERT_NE(scene(), before);
  EXPECT_EQ(paths(), 0) << "nothing rests";
  ASSERT_TRUE(test::waitUntil([&] { return paths() > 0; }));
  choose(0, 2);
  EXPECT_EQ(shown(), Models{ShadingModel::classic});
  EXPECT_TRUE(rest());
}

TEST_F(ModelWindow, anImageIsShownAloneAndTheNextVolumeIsComparedAgain) {
  const QString image = pathTo("image.nrrd");
  std::ofstream(image.toStdString()) << "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 3 2 1\n"
                                        "spacings: 1 1 1\nencoding: ascii\n\n0 50 100 150 200 250\n";
  ASSERT_TRUE(open(image));
  EXPECT_EQ(view().compareLayout(), CompareLayout::single);
  EXPECT_EQ(shown(), Models{ShadingModel::none});
  ASSERT_TRUE(open(QStringLiteral("phantom:6")));
  EXPECT_EQ(view().compareLayout(), CompareLayout::sideBySide);
  EXPECT_EQ(shown(), (Models{ShadingModel::classic, ShadingModel::enhanced}));
  ASSERT_TRUE(open(image));
  setLayout(CompareLayout::wipe);
  ASSERT_TRUE(open(QStringLiteral("phantom:6")));
  EXPECT_EQ(view().compareLayout(), CompareLayout::wipe) << "chosen meanwhile";
}

TEST_F(ModelWindow, aPicturesOwnLabelOffersToSwapTheSidesAndThatLasts) {
  ASSERT_TRUE(rest());
  QTimer::singleShot(0, window.get(), [] {
    QWidget* menu = QApplication::activePopupWidget();
    ASSERT_NE(menu, nullptr);
    QTest::keyClick(menu, Qt::Key_Up); // the last entry
    QTest::keyClick(menu, Qt::Key_Return);
  });
  const QPointF plate = labelsOf({view().order(), view().pictureState()}).front().plate.center();
  QTest::mouseClick(window->windowHandle(), Qt::LeftButton, {}, view().mapTo(window.get(), plate.toPoint()));
  ASSERT_TRUE(test::waitUntil([this] { return undo().count() == 1; }));
  EXPECT_EQ(shown(), (Models{ShadingModel::enhanced, ShadingModel::classic}));
  EXPECT_EQ(button(0)->text(), QStringLiteral("Left: Enhanced"));
  EXPECT_EQ(button(1)->text(), QStringLiteral("Right: Classic"));
  EXPECT_EQ(undo().undoText(), QStringLiteral("swap the sides"));
  undo().undo();
  EXPECT_EQ(shown(), (Models{ShadingModel::classic, ShadingModel::enhanced}));
  QAction& swap = *window->findChild<QAction*>(QStringLiteral("swapSides"));
  EXPECT_TRUE(swap.isEnabled());
  setLayout(CompareLayout::single);
  EXPECT_FALSE(swap.isEnabled()) << "there is one";
}

TEST_F(ModelWindow, twoLooksChangeSidesWithTheirNamesAndUndoTakesThemBack) {
  const std::vector<Preset> presets = builtInPresets();
  const auto named = [&](const char* name) {
    return *std::ranges::find(presets, std::string(name), &Preset::name);
  };
  auto& comparison = *window->findChild<ComparisonController*>();
  session().usePreset(named("CT bone"), {nextGestureId(), "preset"});
  comparison.compareWith(named("CT skin"));
  const auto names = [&] { return view().order().comparison.look->names; };
  using Names = std::array<std::string, 2>;
  ASSERT_EQ(names(), (Names{"CT skin", "CT bone"}));
  const std::vector<Scene> before = view().scenesOfSides();
  const Scene own = scene();
  ASSERT_NE(before[0].transferFunction, before[1].transferFunction);
  const int steps = undo().count();
  QAction& swap = *window->findChild<QAction*>(QStringLiteral("swapSides"));
  swap.trigger();
  EXPECT_EQ(view().scenesOfSides(), (std::vector{before[1], before[0]})) << "models too";
  EXPECT_EQ(names(), (Names{"CT bone", "CT skin"}));
  EXPECT_EQ(scene().transferFunction, before[0].transferFunction) << "the right one is edited";
  ASSERT_EQ(undo().count(), steps + 1);
  EXPECT_EQ(undo().undoText(), QStringLiteral("swap the sides"));
  undo().undo();
  EXPECT_EQ(view().scenesOfSides(), before);
  EXPECT_EQ(scene(), own);
  EXPECT_EQ(names(), (Names{"CT skin", "CT bone"}));
  undo().redo();
  EXPECT_EQ(view().scenesOfSides(), (std::vector{before[1], before[0]}));
  swap.trigger();
  EXPECT_EQ(view().scenesOfSides(), before) << "twice is once too often";
  EXPECT_EQ(names(), (Names{"CT skin", "CT bone"}));
  // What was remembered changes sides, too, and is still remembered.
  comparison.setLayout(CompareLayout::sideBySide);
  window->findChild<QAction*>(QStringLiteral("takeSnapshot"))->trigger();
  session().setTransferFunction(shifted(scene().transferFunction, 50.0), {nextGestureId(), "shift"});
  QAction& compareBefore = *window->findChild<QAction*>(QStringLiteral("compareSnapshot"));
  compareBefore.trigger();
  const std::vector<Scene> remembered = view().scenesOfSides();
  const Names both = names();
  ASSERT_NE(remembered[0], remembered[1]);
  swap.trigger();
  EXPECT_EQ(view().scenesOfSides(), (std::vector{remembered[1], remembered[0]}));
  EXPECT_EQ(names(), (Names{both[1], both[0]}));
  EXPECT_FALSE(compareBefore.isChecked());
  EXPECT_TRUE(compareBefore.isEnabled());
}

TEST_F(ModelWindow, propertiesSayWhichOfTwoLooksTheyEdit) {
  const auto* said = window->findChild<QLabel*>(QStringLiteral("keptLook"));
  const auto* sharpness = rowNamed<ValueSlider>(*window, "Highlight sharpness (SP)");
  ASSERT_TRUE(said && sharpness);
  EXPECT_TRUE(said->isHidden());
  EXPECT_TRUE(sharpness->isEnabled()) << "the left model has it";
  auto& presets = *window->findChild<PresetController*>();
  presets.use(QStringLiteral("CT bone"));
  presets.compare(QStringLiteral("CT skin"), 0);
  ASSERT_EQ(shown(), (Models{ShadingModel::classic, ShadingModel::enhanced}));
  EXPECT_FALSE(said->isHidden());
  EXPECT_TRUE(said->text().contains(QStringLiteral("\"CT skin\""))) << said->text().toStdString();
  EXPECT_FALSE(sharpness->isEnabled()) << "the left look keeps its own";
  QAction& swap = *window->findChild<QAction*>(QStringLiteral("swapSides"));
  swap.trigger();
  EXPECT_TRUE(said->text().contains(QStringLiteral("\"CT bone\""))) << said->text().toStdString();
  EXPECT_TRUE(sharpness->isEnabled()) << "the right one is classic now";
  setLayout(CompareLayout::single);
  EXPECT_TRUE(said->isHidden());
  setLayout(CompareLayout::sideBySide);
  EXPECT_FALSE(said->isHidden());
  window->findChild<QAction*>(QStringLiteral("compareModels"))->trigger();
  EXPECT_TRUE(said->isHidden());
}

// What stands at the left was changed since it was a preset; so it is told of it wherever it comes to stand.
TEST_F(ModelWindow, aLookThatWasChangedSaysSoOnEitherSideAndAfterEveryUndo) {
  const auto& presets = *window->findChild<PresetController*>();
  window->findChild<PresetController*>()->use(QStringLiteral("CT bone"));
  session().setTransferFunction(shifted(scene().transferFunction, 50.0), {nextGestureId(), "shift"});
  QMenu menu;
  window->findChild<PresetController*>()->fillMenu(menu, 1);
  const auto entries = menu.actions();
  const auto skin =
      std::ranges::find_if(entries, [](const QAction* entry) { return entry->text() == "CT skin"; });
  ASSERT_NE(skin, entries.end());
  (*skin)->trigger();
  const auto names = [&] { return view().order().comparison.look->names; };
  using Names = std::array<std::string, 2>;
  const Names both{"CT bone, modified", "CT skin"};
  ASSERT_EQ(names(), both);
  EXPECT_EQ(shown(), (Models{ShadingModel::classic, ShadingModel::enhanced}));
  QAction& swap = *window->findChild<QAction*>(QStringLiteral("swapSides"));
  swap.trigger();
  EXPECT_EQ(names(), (Names{both[1], both[0]}));
  EXPECT_EQ(presets.nameShown(), QStringLiteral("My CT bone"));
  const SessionDocument kept = parseSession(sessionToJson(window->sessionDocument()), "session");
  swap.trigger();
  EXPECT_EQ(names(), both);
  EXPECT_EQ(presets.nameShown(), QStringLiteral("CT skin"));
  const SessionDocument keptLook = parseSession(sessionToJson(window->sessionDocument()), "session");
  undo().undo();
  EXPECT_EQ(names(), (Names{both[1], both[0]}));
  EXPECT_EQ(presets.nameShown(), QStringLiteral("My CT bone"));
  undo().undo();
  EXPECT_EQ(names(), both);
  undo().undo(); // the preset at the right
  EXPECT_EQ(names()[0], both[0]);
  EXPECT_EQ(presets.nameShown(), QStringLiteral("My CT bone"));
  ASSERT_TRUE(kept.changedPreset);
  EXPECT_EQ(kept.changedPreset->name, "CT bone");
  window->findChild<ComparisonController*>()->restore(keptLook);
  EXPECT_EQ(names()[0], both[0]) << "in a session, too";
}

TEST_F(ModelWindow, aSinglePictureHasOneButton) {
  setLayout(CompareLayout::single);
  EXPECT_TRUE(test::waitUntil([this] { return !button(1)->isVisible(); })); // once the tool bar is laid out
  EXPECT_EQ(button(0)->text(), QStringLiteral("Classic"));
  choose(0, 3);
  EXPECT_EQ(shown(), Models{ShadingModel::enhanced});
  EXPECT_EQ(button(0)->text(), QStringLiteral("Enhanced"));
  EXPECT_EQ(undo().count(), 1);
  undo().undo();
  EXPECT_EQ(button(0)->text(), QStringLiteral("Classic"));
}

TEST_F(ModelWindow, onePictureShowsTheModelOfTheSideThatWasWorkedInAndThePairComesBack) {
  window->resize(1380, 800); // every button fits
  QCoreApplication::processEvents();
  choose(0, 5);
  const Models pair{ShadingModel::physical, ShadingModel::enhanced};
  ASSERT_EQ(shown(), pair);
  clickTool(QStringLiteral("Single"));
  EXPECT_EQ(shown(), Models{ShadingModel::physical});
  EXPECT_EQ(button(0)->text(), QStringLiteral("Physical"));
  clickTool(QStringLiteral("Side by side"));
  EXPECT_EQ(shown(), pair);
  undo().undo();
  EXPECT_EQ(shown(), pair) << "the step before it";
  EXPECT_EQ(scene().shading.model, ShadingModel::classic);
  undo().redo();
  EXPECT_EQ(shown(), Models{ShadingModel::physical});
  undo().undo();
  EXPECT_EQ(shown(), pair);
  // A press in the right picture is work there.
  const QPointF right = view().logicalRect(1).center();
  QTest::mouseClick(window->windowHandle(), Qt::LeftButton, {}, view().mapTo(window.get(), right.toPoint()));
  clickTool(QStringLiteral("Single"));
  EXPECT_EQ(shown(), Models{ShadingModel::enhanced});
  clickTool(QStringLiteral("Side by side"));
  EXPECT_EQ(shown(), pair);
}

// A swap takes the side along that was worked in, and so does the way back.
TEST_F(ModelWindow, theSideThatWasWorkedInIsTheSameAfterASwapThatIsUndone) {
  window->resize(1380, 800);
  QCoreApplication::processEvents();
  const Models pair{ShadingModel::classic, ShadingModel::enhanced};
  ASSERT_EQ(shown(), pair);
  const QPointF right = view().logicalRect(1).center();
  QTest::mouseClick(window->windowHandle(), Qt::LeftButton, {}, view().mapTo(window.get(), right.toPoint()));
  window->findChild<QAction*>(QStringLiteral("swapSides"))->trigger();
  undo().undo();
  ASSERT_EQ(shown(), pair);
  clickTool(QStringLiteral("Single"));
  EXPECT_EQ(shown(), Models{ShadingModel::enhanced}) << "that of the right";
}

// The difference of two models is a picture of both.
TEST_F(ModelWindow, aPressInTheDifferenceIsWorkInNeitherSide) {
  window->resize(1380, 800);
  QCoreApplication::processEvents();
  const QPointF right = view().logicalRect(1).center();
  QTest::mouseClick(window->windowHandle(), Qt::LeftButton, {}, view().mapTo(window.get(), right.toPoint()));
  clickTool(QStringLiteral("Difference"));
  const QPoint middle = view().rect().center();
  QTest::mouseClick(window->windowHandle(), Qt::LeftButton, {}, view().mapTo(window.get(), middle));
  clickTool(QStringLiteral("Single"));
  EXPECT_EQ(shown(), Models{ShadingModel::enhanced}) << "that of the right";
}

TEST_F(ModelWindow, onePictureOfTwoLooksKeepsTheModelOfTheRightOne) {
  window->resize(1380, 800);
  QCoreApplication::processEvents();
  auto& comparison = *window->findChild<ComparisonController*>();
  comparison.compareOwn();
  const Models pair = shown();
  ASSERT_EQ(pair.back(), ShadingModel::enhanced);
  clickTool(QStringLiteral("Single"));
  EXPECT_EQ(shown(), Models{ShadingModel::enhanced});
  clickTool(QStringLiteral("Side by side"));
  EXPECT_EQ(shown(), pair);
}

TEST_F(ModelWindow, thePropertiesChangeTheSideInQuestion) {
  auto& properties = *window->findChild<PropertiesPanel*>();
  auto* right = rowNamed<ChoiceRow>(properties, "Model, right");
  ASSERT_TRUE(right->isVisible() && right->isEnabled());
  right->box()->setFocus();
  QTest::keyClick(right->box(), Qt::Key_Down);
  EXPECT_EQ(shown(), (Models{ShadingModel::classic, ShadingModel::robust}));
  EXPECT_EQ(button(1)->text(), QStringLiteral("Right: Robust"));
  setLayout(CompareLayout::single);
  EXPECT_FALSE(right->isVisible());
  EXPECT_TRUE(rowNamed<ChoiceRow>(properties, "Model")->isVisible());
}

} // namespace
} // namespace limn
