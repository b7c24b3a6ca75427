// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/files/opening/SeriesDialog.h"
#include "app/files/saving/SavingController.h"
#include "app/panels/presets/NameDialog.h"
#include "app/panels/presets/PresetController.h"
#include "app/pictures/SharedVolumes.h"
#include "app/presets/PresetStore.h"
#include "scene/ProjectionFacts.h"
#include "widgets/PresetNames.h"
#include "widgets/presets/PresetBrowser.h"

#include <QAction>
#include <QContextMenuEvent>
#include <QInputDialog>
#include <QMenu>
#include <QMessageBox>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>

// Presets in the program's window, by mouse and keys.

namespace limn {
namespace {

class PresetWindow : public test::WindowHarness {
protected:
  PresetBrowser& browser() const { return *window->findChild<PresetBrowser*>(); }
  QTreeView& list() const { return *browser().findChild<QTreeView*>(); }

  // Never twice to the same place: Qt lets nobody know of a pointer that has not moved.
  void pointTo(const char* preset) {
    m_nudge = 1 - m_nudge;
    const QPoint place = rowOf(browser(), QLatin1String(preset)).center() + QPoint(m_nudge, 0);
    QTest::mouseMove(window->windowHandle(), list().viewport()->mapTo(window.get(), place));
  }
  // The X server tells where its own pointer is, too, and may do so after us.
  [[nodiscard]] bool pointUntilSeen(const char* preset, const Scene& before) {
    return test::waitUntil([&] {
      if (view().scene() == before)
        pointTo(preset);
      return view().scene() != before;
    });
  }
  void click(const char* preset) {
    const QPoint place = rowOf(browser(), QLatin1String(preset)).center();
    QTest::mouseClick(window->windowHandle(), Qt::LeftButton, {},
                      list().viewport()->mapTo(window.get(), place));
  }

private:
  int m_nudge = 0;
};

// Of the phantom, and of every volume below LIMN_SHARED where that is set.
TEST_F(PresetWindow, whatAPresetShowsDoesNotDependOnWhatWasUsedBefore) {
  std::vector<std::string> sources{"phantom:8"};
  if (const char* const shared = std::getenv("LIMN_SHARED"))
    for (const std::filesystem::path& path : test::volumesBelow(std::filesystem::path(shared) / "data"))
      sources.push_back(path.string());
  for (const std::string& source : sources) {
    SCOPED_TRACE(source);
    const auto before = scene().volume;
    ASSERT_TRUE(open(QString::fromStdString(source)));
    if (auto* dialog = window->findChild<SeriesDialog*>()) {
      QTest::keyClick(dialog, Qt::Key_Return);
      ASSERT_TRUE(test::waitUntil([this] { return !window->loader().isLoading(); }));
    }
    if (scene().volume == before) {
      std::printf("left out: %s: %s\n", source.c_str(), qPrintable(messages().sentence()));
      continue;
    }
    const QStringList names = browser().presets();
    ASSERT_GT(names.size(), 25);
    std::map<QString, Scene> alone;
    for (const QString& name : names) {
      emit browser().presetChosen(name);
      alone.emplace(name, scene());
    }
    // The other way round, and each after one with everything else.
    for (qsizetype n = names.size(); n-- > 0;) {
      Scene changed = scene();
      changed.shading.ambientIntensity = 0.9;
      changed.shading.exponent = 3.0;
      changed.shading.opacityRange.atBoundary = 7.0;
      changed.gradientOpacity = GradientOpacity{{{5.0, 0.5}}};
      session().edit(changed, {nextGestureId(), QStringLiteral("other light")});
      emit browser().presetChosen(names[n]);
      Scene again = scene();
      if (!showsSurface(again.projection)) // a value for surfaces waits, unseen, for the next
        again.isovalue = alone.at(names[n]).isovalue;
      EXPECT_TRUE(again == alone.at(names[n])) << names[n].toStdString();
    }
  }
}

TEST_F(PresetWindow, theHistoryCallsAPresetByItsNameWhateverItChanges) {
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  emit browser().presetChosen(QStringLiteral("CT bone"));
  Scene other = scene();
  other.shading.specular += 0.1;
  session().edit(other, {nextGestureId(), QStringLiteral("highlights")});
  emit browser().presetChosen(QStringLiteral("CT bone"));
  EXPECT_EQ(undo().undoText(), QStringLiteral("use preset CT bone")) << "one number of the light";
  other = scene();
  other.transferFunction.points.back().opacity *= 0.5;
  session().edit(other, {nextGestureId(), QStringLiteral("a point")});
  emit browser().presetChosen(QStringLiteral("CT bone"));
  EXPECT_EQ(undo().undoText(), QStringLiteral("use preset CT bone")) << "one point of the curve";
}

TEST_F(PresetWindow, lightIsKeptWhereThatIsWanted) {
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  window->findChild<QAction*>(QStringLiteral("keepLight"))->trigger();
  Scene changed = scene();
  changed.shading.ambientIntensity = 0.9;
  session().edit(changed, {nextGestureId(), QStringLiteral("other light")});
  const Shading own = scene().shading;
  emit browser().presetChosen(QStringLiteral("CT fat"));
  EXPECT_EQ(scene().shading, own);
  window->findChild<QAction*>(QStringLiteral("keepLight"))->trigger();
  emit browser().presetChosen(QStringLiteral("CT fat"));
  EXPECT_NE(scene().shading, own);
}

TEST_F(PresetWindow, thePresetUnderThePointerIsSeenAndLeavesNothingBehind) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  const Scene before = scene();
  const int steps = undo().count();
  ASSERT_TRUE(pointUntilSeen("CT lung", before));
  const Scene seen = view().scene();
  EXPECT_EQ(curves().valueEditor()->canvas()->transferFunction(), seen.transferFunction) << "the curve";
  EXPECT_EQ(scene(), before) << "what is edited";
  QTest::mouseMove(window->windowHandle(), view().mapTo(window.get(), view().rect().center()));
  ASSERT_TRUE(test::waitUntil([&] { return view().scene() == before; }));
  EXPECT_EQ(curves().valueEditor()->canvas()->transferFunction(), before.transferFunction);
  EXPECT_EQ(undo().count(), steps);
  click("CT lung");
  EXPECT_EQ(scene(), seen) << "what was seen is what a click gives";
  EXPECT_EQ(undo().count(), steps + 1);
}

TEST_F(PresetWindow, theKeyboardSeesPresetsBeforeEnterUsesOne) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  click("CT bone");
  const Scene before = scene();
  const int steps = undo().count();
  QTest::keyClick(window->windowHandle(), Qt::Key_Down);
  ASSERT_TRUE(test::waitUntil([&] { return view().scene() != before; }));
  const Scene seen = view().scene();
  EXPECT_EQ(undo().count(), steps);
  QTest::keyClick(window->windowHandle(), Qt::Key_Escape);
  EXPECT_EQ(view().scene(), before);
  QTest::keyClick(window->windowHandle(), Qt::Key_Return);
  EXPECT_EQ(scene(), seen);
  EXPECT_EQ(undo().count(), steps + 1);
}

TEST_F(PresetWindow, aPreviewGoesOnWhileTheCameraMovesAndEndsWithAnEdit) {
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  ASSERT_TRUE(pointUntilSeen("CT lung", scene()));
  const TransferFunction seen = view().scene().transferFunction;
  session().setCamera(orbited(scene().camera, 0.3, 0.0));
  EXPECT_EQ(view().scene().camera, scene().camera);
  EXPECT_EQ(view().scene().transferFunction, seen);
  Shading shading = scene().shading;
  shading.exponent += 1.0;
  session().setShading(shading, {nextGestureId(), QStringLiteral("sharper")});
  EXPECT_EQ(view().scene(), scene());
}

TEST_F(PresetWindow, aPreviewEndsWhereAnotherVolumeIsOpened) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  const Scene before = scene();
  ASSERT_TRUE(pointUntilSeen("CT lung", before));
  ASSERT_TRUE(open(QStringLiteral("phantom:3")));
  EXPECT_EQ(view().scene(), scene());
  EXPECT_NE(scene().volume, before.volume);
}

TEST_F(PresetWindow, whatWasRememberedIsComparedWithWhatBecameOfIt) {
  ASSERT_TRUE(openAlone(QStringLiteral("phantom:4")));
  click("CT bone");
  QAction& compare = *window->findChild<QAction*>(QStringLiteral("compareSnapshot"));
  EXPECT_FALSE(compare.isEnabled()) << "nothing is remembered";
  const Scene before = scene();
  QTest::keyClick(window->windowHandle(), Qt::Key_B, Qt::ControlModifier);
  click("CT lung");
  ASSERT_TRUE(compare.isEnabled());
  QTest::keyClick(window->windowHandle(), Qt::Key_B, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(view().compareLayout(), CompareLayout::sideBySide);
  // The camera fits its picture, which is narrower now.
  const auto asBefore = [this, before] {
    Scene scene = before;
    scene.camera = this->scene().camera;
    return scene;
  };
  EXPECT_EQ(view().sceneOfSide(0), asBefore());
  EXPECT_EQ(view().sceneOfSide(1), scene());
  EXPECT_NE(scene(), asBefore());
  undo().undo();
  EXPECT_EQ(view().sceneOfSide(1), asBefore()) << "the right side is what is edited";
  QTest::keyClick(window->windowHandle(), Qt::Key_B, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_FALSE(compare.isChecked());
  EXPECT_EQ(view().sceneOfSide(0).shading.model, ShadingModel::classic) << "models again";
  EXPECT_EQ(view().sceneOfSide(1).shading.model, ShadingModel::enhanced);
}

TEST_F(PresetWindow, aPresetIsComparedWithThePictureInEveryLayout) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  setLayout(CompareLayout::wipe);
  click("CT bone");
  const QPoint place = rowOf(browser(), QStringLiteral("CT lung")).center();
  QContextMenuEvent asked(QContextMenuEvent::Mouse, place, list().viewport()->mapToGlobal(place));
  QCoreApplication::sendEvent(list().viewport(), &asked);
  const int steps = undo().count();
  QAction* const entry = action(QStringLiteral("Compare with the picture"));
  ASSERT_TRUE(entry);
  entry->trigger();
  browser().findChild<QMenu*>()->close();
  EXPECT_EQ(view().compareLayout(), CompareLayout::wipe);
  // Beside it stands what stood there: the scene, by the model of that picture.
  Scene beside = scene();
  beside.shading.model = ShadingModel::enhanced;
  EXPECT_EQ(view().sceneOfSide(1), beside);
  EXPECT_EQ(view().sceneOfSide(0).shading.model, ShadingModel::enhanced) << "the looks alone differ";
  const TransferFunction lung = view().sceneOfSide(0).transferFunction;
  EXPECT_NE(lung, scene().transferFunction);
  EXPECT_EQ(undo().count(), steps + 1);
  EXPECT_EQ(undo().undoText(), QStringLiteral("Left: CT lung"));
  const Scene left = view().sceneOfSide(0);
  undo().undo();
  EXPECT_FALSE(view().order().comparison.look) << "two models are compared again";
  EXPECT_EQ(view().sceneOfSide(0).transferFunction, scene().transferFunction);
  undo().redo();
  EXPECT_EQ(view().sceneOfSide(0), left);
  click("CT lung");
  EXPECT_EQ(scene().transferFunction, lung);
  window->findChild<QAction*>(QStringLiteral("model-left-none"))->trigger();
  EXPECT_EQ(view().sceneOfSide(0).shading.model, ShadingModel::none);
  EXPECT_NE(scene().shading.model, ShadingModel::none);
  window->findChild<QAction*>(QStringLiteral("compareModels"))->trigger();
  EXPECT_EQ(view().sceneOfSide(0).transferFunction, view().sceneOfSide(1).transferFunction);
}

TEST_F(PresetWindow, anotherVolumeHasNothingToCompareWith) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  window->findChild<QAction*>(QStringLiteral("takeSnapshot"))->trigger();
  QAction& compare = *window->findChild<QAction*>(QStringLiteral("compareSnapshot"));
  compare.trigger();
  EXPECT_TRUE(compare.isChecked());
  ASSERT_TRUE(open(QStringLiteral("phantom:5")));
  EXPECT_FALSE(compare.isEnabled());
  EXPECT_FALSE(compare.isChecked());
}

TEST_F(PresetWindow, theSessionKeepsWhatIsCompared) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  click("CT bone");
  window->findChild<QAction*>(QStringLiteral("takeSnapshot"))->trigger();
  click("CT lung");
  window->findChild<QAction*>(QStringLiteral("compareSnapshot"))->trigger();
  const Scene left = view().sceneOfSide(0);
  SessionDocument kept = parseSession(sessionToJson(window->sessionDocument()), "session");
  EXPECT_EQ(kept.snapshot, window->sessionDocument().snapshot);
  window->findChild<QAction*>(QStringLiteral("compareModels"))->trigger();
  window->findChild<ComparisonController*>()->restore(kept);
  EXPECT_EQ(view().sceneOfSide(0), left);
  EXPECT_TRUE(window->findChild<QAction*>(QStringLiteral("compareSnapshot"))->isChecked());
}

TEST_F(PresetWindow, aSavedComparisonOfLooksOpensWithBothAndTheRightOneIsEdited) {
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  click("CT bone");
  window->findChild<QAction*>(QStringLiteral("takeSnapshot"))->trigger();
  click("CT skin");
  window->findChild<QAction*>(QStringLiteral("compareSnapshot"))->trigger();
  for (const bool isModified : {false, true}) {
    ASSERT_TRUE(rest());
    const TransferFunction edited = scene().transferFunction;
    const Scene left = view().sceneOfSide(0), right = view().sceneOfSide(1);
    const std::string name = view().order().comparison.look->names[0];
    saving().writePicture(pathTo("both.png"));
    ASSERT_TRUE(open(QStringLiteral("phantom:4")));
    ASSERT_TRUE(open(pathTo("both.png")));
    EXPECT_EQ(scene().transferFunction, edited);
    EXPECT_EQ(view().compareLayout(), CompareLayout::sideBySide);
    ASSERT_TRUE(view().order().comparison.look);
    EXPECT_EQ(view().order().comparison.look->names[0], isModified ? "Other look" : name);
    EXPECT_EQ(view().sceneOfSide(0).transferFunction, left.transferFunction);
    EXPECT_EQ(view().sceneOfSide(0).shading, left.shading);
    EXPECT_EQ(view().sceneOfSide(1).shading, right.shading);
    // Remembered as it was changed: the name that a person may have given it stays here.
    Scene other = scene();
    other.transferFunction.points.back().opacity *= 0.5;
    session().edit(other, {nextGestureId(), QStringLiteral("edit")});
    window->findChild<QAction*>(QStringLiteral("takeSnapshot"))->trigger();
    click("CT lung");
    window->findChild<QAction*>(QStringLiteral("compareSnapshot"))->trigger();
  }
}

TEST_F(PresetWindow, whatIsOpenedAgainShowsThePresetThatItWasMadeFrom) {
  for (const char* source : {"phantom:8", "values.nrrd"}) {
    if (source == std::string("values.nrrd")) { // in no known unit: presets are fitted
      std::ofstream file(pathTo(source).toStdString());
      file << "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 8 8 8\nspacings: 1 1 1\nencoding: ascii\n\n";
      for (int voxel = 0; voxel < 512; ++voxel)
        file << voxel % 256 << ' ';
    }
    ASSERT_TRUE(open(source == std::string("phantom:8") ? QString(source) : pathTo(source)));
    window->findChild<PresetController*>()->use(QStringLiteral("CT bone"));
    ASSERT_TRUE(rest());
    const auto inUse = [this] { return window->findChild<PresetController*>()->nameShown(); };
    ASSERT_EQ(inUse(), QStringLiteral("CT bone")) << source;
    saving().writePicture(pathTo("bone.png"));
    ASSERT_TRUE(open(QStringLiteral("phantom:16")));
    ASSERT_NE(inUse(), QStringLiteral("CT bone"));
    ASSERT_TRUE(open(pathTo("bone.png")));
    EXPECT_EQ(inUse(), QStringLiteral("CT bone")) << source;
    Shading shading = scene().shading; // the curve is still the preset's
    shading.specular = 0.77;
    session().setShading(shading, {nextGestureId(), "light"});
    ASSERT_TRUE(rest());
    saving().writePicture(pathTo("lit.png"));
    ASSERT_TRUE(open(pathTo("lit.png")));
    EXPECT_EQ(inUse(), QStringLiteral("My CT bone")) << source;
    session().setTransferFunction(shifted(scene().transferFunction, 3.0), {nextGestureId(), "shift"});
    ASSERT_TRUE(rest());
    typeName(pathTo(source) + QStringLiteral(".json"));
    saving().saveSessionAs();
    ASSERT_TRUE(open(QStringLiteral("phantom:16")));
    ASSERT_TRUE(open(pathTo(source) + QStringLiteral(".json")));
    EXPECT_EQ(inUse(), QStringLiteral("My CT bone")) << source;
  }
}

TEST_F(PresetWindow, favouritesNotesAndFoldersAreThereInTheNextWindow) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  const auto answer = [this](const QString& text) {
    onceAsked<QInputDialog>([text](QInputDialog& dialog) {
      dialog.setTextValue(text);
      dialog.accept();
    });
  };
  const auto choose = [this](const QString& entry) {
    const QPoint place = rowOf(browser(), QStringLiteral("Mine")).center();
    QContextMenuEvent asked(QContextMenuEvent::Mouse, place, list().viewport()->mapToGlobal(place));
    QCoreApplication::sendEvent(list().viewport(), &asked);
    QMenu& menu = *browser().findChild<QMenu*>();
    menu.close();
    action(entry)->trigger();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  };
  const UserFolders folders = UserFolders::below(folder.path());
  const auto mine = [&] { return PresetStore(folders.presets).find("Mine").value_or(Preset{}); };
  answer(QStringLiteral("Mine"));
  window->findChild<QAction*>(QStringLiteral("savePreset"))->trigger();
  ASSERT_TRUE(test::waitUntil([&] { return mine().name == "Mine"; }));
  answer(QStringLiteral("for the petrous bone"));
  choose(QStringLiteral("Note…"));
  ASSERT_TRUE(test::waitUntil([&] { return !mine().note.empty(); }));
  answer(QStringLiteral("Temporal"));
  choose(QStringLiteral("New folder…"));
  ASSERT_TRUE(test::waitUntil([&] { return !mine().folder.empty(); }));
  click("CT lung");
  QTest::keyClick(window->windowHandle(), Qt::Key_F);
  EXPECT_EQ(browser().presets().mid(0, 2), (QStringList{"CT lung", "Mine"}));

  window = std::make_unique<MainWindow>(folders);
  EXPECT_EQ(browser().presets().mid(0, 2), (QStringList{"CT lung", "Mine"}));
  EXPECT_EQ(mine().note, "for the petrous bone");
  EXPECT_EQ(mine().folder, "Temporal");
}

TEST_F(PresetWindow, aRenamedPresetIsSeenThoughASearchForItsFormerNameWouldHideIt) {
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  const auto answer = [this](const QString& name) {
    onceAsked<QInputDialog>([name](QInputDialog& dialog) {
      dialog.setTextValue(name);
      dialog.accept();
    });
  };
  answer(QStringLiteral("Petrous"));
  window->findChild<QAction*>(QStringLiteral("savePreset"))->trigger();
  ASSERT_TRUE(test::waitUntil([this] { return rowOf(browser(), QStringLiteral("Petrous")).isValid(); }));
  auto& search = *browser().findChild<QLineEdit*>();
  search.setFocus();
  QTest::keyClicks(&search, QStringLiteral("petrous"));
  QTest::keyClick(&search, Qt::Key_Down);
  answer(QStringLiteral("Temporal"));
  QTest::keyClick(&list(), Qt::Key_F2);
  ASSERT_TRUE(test::waitUntil([this] { return rowOf(browser(), QStringLiteral("Temporal")).isValid(); }));
  EXPECT_TRUE(search.text().isEmpty()) << "it hid what was renamed";
  EXPECT_TRUE(list().viewport()->rect().contains(rowOf(browser(), QStringLiteral("Temporal")).center()));
  EXPECT_FALSE(rowOf(browser(), QStringLiteral("Petrous")).isValid());
}

TEST_F(PresetWindow, anotherVolumeEndsTheSearchAndAPresetDoesNot) {
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  auto& search = *browser().findChild<QLineEdit*>();
  search.setFocus();
  QTest::keyClicks(&search, QStringLiteral("glass"));
  QTest::keyClick(&search, Qt::Key_Return);
  ASSERT_TRUE(rest());
  EXPECT_EQ(search.text(), QStringLiteral("glass")) << "it may be the second of them";
  ASSERT_TRUE(open(QStringLiteral("phantom:9")));
  EXPECT_TRUE(search.text().isEmpty());
  const QString shown = QString::fromStdString(session().preset().name);
  EXPECT_TRUE(rowOf(browser(), shown).isValid()) << shown.toStdString();
}

TEST_F(PresetWindow, theHeadersNameWhatWasJustSavedRenamedOrUsed) {
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  emit browser().presetChosen(QStringLiteral("CT bone"));
  emit browser().compareRequested(QStringLiteral("CT lung"));
  session().setTransferFunction(shifted(scene().transferFunction, 50.0),
                                {nextGestureId(), QStringLiteral("shift")});
  const auto right = [this] { return view().order().comparison.look->names.back(); };
  ASSERT_EQ(right(), "CT bone, modified");
  const auto answer = [this](const QString& name) {
    onceAsked<QInputDialog>([name](QInputDialog& dialog) {
      dialog.setTextValue(name);
      dialog.accept();
    });
  };
  answer(QStringLiteral("Mine"));
  window->findChild<QAction*>(QStringLiteral("savePreset"))->trigger();
  ASSERT_TRUE(test::waitUntil([this] { return rowOf(browser(), QStringLiteral("Mine")).isValid(); }));
  EXPECT_EQ(right(), "Mine");
  answer(QStringLiteral("Petrous"));
  emit browser().renameRequested(QStringLiteral("Mine"));
  ASSERT_TRUE(test::waitUntil([this] { return rowOf(browser(), QStringLiteral("Petrous")).isValid(); }));
  EXPECT_EQ(right(), "Petrous");
  Preset twin = PresetStore(UserFolders::below(folder.path()).presets).find("Petrous").value();
  twin.name = "Twin";
  PresetStore(UserFolders::below(folder.path()).presets).save(twin);
  window->findChild<PresetController*>()->refresh();
  const int steps = undo().count();
  emit browser().presetChosen(QStringLiteral("Twin"));
  EXPECT_EQ(undo().count(), steps) << "it changes nothing";
  EXPECT_EQ(right(), "Twin");
}

TEST_F(PresetWindow, theMenuOfAPictureTicksWhatItsHeaderNamesUnlessThatWasModified) {
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  const auto ticked = [this](int side) {
    QMenu menu;
    window->findChild<PresetController*>()->fillMenu(menu, side);
    QStringList names;
    for (const QAction* entry : menu.actions())
      if (entry->isChecked())
        names << entry->text();
    return names;
  };
  const auto shift = [this] {
    session().setTransferFunction(shifted(scene().transferFunction, 50.0),
                                  {nextGestureId(), QStringLiteral("shift")});
  };
  emit browser().presetChosen(QStringLiteral("CT bone"));
  EXPECT_EQ(ticked(0), QStringList{QStringLiteral("CT bone")}) << "two models of one look";
  shift();
  EXPECT_EQ(ticked(0), QStringList());
  undo().undo();
  emit browser().compareRequested(QStringLiteral("CT lung"));
  EXPECT_EQ(ticked(0), QStringList{QStringLiteral("CT lung")});
  EXPECT_EQ(ticked(1), QStringList{QStringLiteral("CT bone")});
  shift();
  EXPECT_EQ(view().order().comparison.look->names.back(), "CT bone, modified");
  EXPECT_EQ(ticked(1), QStringList());
  EXPECT_EQ(ticked(0), QStringList{QStringLiteral("CT lung")});
  window->findChild<QAction*>(QStringLiteral("swapSides"))->trigger();
  EXPECT_EQ(view().order().comparison.look->names.front(), "CT bone, modified");
  EXPECT_EQ(ticked(0), QStringList()) << "also at the left";
  EXPECT_EQ(ticked(1), QStringList{QStringLiteral("CT lung")});
}

TEST_F(PresetWindow, whatFitsTheVolumeBestStandsFirst) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  EXPECT_EQ(browser().presets().front().toStdString(), session().preset().name);
}

TEST_F(PresetWindow, whatIsDeletedOrReplacedIsBroughtBackByOneClick) {
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  const auto saveAsMine = [this] {
    onceAsked<QInputDialog>([](QInputDialog& dialog) {
      dialog.setTextValue(QStringLiteral("Mine"));
      dialog.accept();
    });
    window->findChild<QAction*>(QStringLiteral("savePreset"))->trigger();
    return test::waitUntil([this] { return rowOf(browser(), QStringLiteral("Mine")).isValid(); });
  };
  const auto kept = [this] {
    const std::vector<Preset> own = PresetStore(UserFolders::below(folder.path()).presets).read().presets;
    return own.empty() ? std::nullopt : std::optional(own.front());
  };
  const auto bringBack = [this] {
    QTest::mouseClick(messages().findChild<QToolButton*>(QStringLiteral("messageAction")), Qt::LeftButton);
  };
  ASSERT_TRUE(saveAsMine());
  const std::optional<Preset> first = kept();
  ASSERT_TRUE(first);
  session().setTransferFunction(shifted(scene().transferFunction, 50.0),
                                {nextGestureId(), QStringLiteral("shift")});
  const auto answer = [this](QMessageBox::ButtonRole role) {
    onceAsked<QMessageBox>([role](QMessageBox& box) {
      for (QAbstractButton* button : box.buttons())
        if (box.buttonRole(button) == role)
          return QTest::mouseClick(button, Qt::LeftButton);
    });
  };
  answer(QMessageBox::RejectRole);
  ASSERT_TRUE(saveAsMine());
  EXPECT_EQ(kept(), first) << "it was asked, and not wanted";
  answer(QMessageBox::AcceptRole);
  ASSERT_TRUE(saveAsMine());
  ASSERT_TRUE(test::waitUntil([&] { return kept() != first; }));
  EXPECT_TRUE(messages().sentence().contains(QStringLiteral("was replaced")))
      << messages().sentence().toStdString();
  bringBack();
  EXPECT_EQ(kept(), first);
  emit browser().deleteRequested(QStringLiteral("Mine"));
  EXPECT_FALSE(kept());
  EXPECT_TRUE(messages().sentence().contains(QStringLiteral("was deleted")))
      << messages().sentence().toStdString();
  bringBack();
  EXPECT_EQ(kept(), first);
  EXPECT_TRUE(rowOf(browser(), QStringLiteral("Mine")).isValid());
  EXPECT_TRUE(messages().isNote()) << "it is back: " << messages().sentence().toStdString();
  EXPECT_FALSE(messages().sentence().contains(QStringLiteral("was deleted")));
}

TEST_F(PresetWindow, aCopyReplacesAnotherPresetOnlyWhereThatIsWanted) {
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  const auto kept = [this] {
    return PresetStore(UserFolders::below(folder.path()).presets).find("Mine").value_or(Preset{});
  };
  const auto copyAsMine = [this](const char* preset) {
    emit browser().duplicateRequested(QLatin1String(preset));
    auto& dialog = *window->findChild<NameDialog*>();
    dialog.setTextValue(QStringLiteral("Mine"));
    dialog.accept();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  };
  copyAsMine("CT lung");
  const Preset first = kept();
  ASSERT_EQ(first.name, "Mine");
  onceAsked<QMessageBox>([](QMessageBox& box) { QTest::keyClick(&box, Qt::Key_Return); });
  copyAsMine("CT bone");
  EXPECT_EQ(kept(), first) << "Enter loses nothing";
  onceAsked<QMessageBox>([](QMessageBox& box) {
    for (QAbstractButton* button : box.buttons())
      if (box.buttonRole(button) == QMessageBox::AcceptRole)
        return QTest::mouseClick(button, Qt::LeftButton);
  });
  copyAsMine("CT bone");
  EXPECT_NE(kept(), first);
  QTest::mouseClick(messages().findChild<QToolButton*>(QStringLiteral("messageAction")), Qt::LeftButton);
  EXPECT_EQ(kept(), first);
}

TEST_F(PresetWindow, aNameThatIsRefusedCanBeCorrected) {
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  window->findChild<QAction*>(QStringLiteral("savePreset"))->trigger();
  auto& dialog = *window->findChild<NameDialog*>();
  for (const QString& name : {QStringLiteral("CT bone"), QString(300, QLatin1Char('x'))}) {
    dialog.setTextValue(name);
    dialog.accept();
    EXPECT_TRUE(dialog.isVisible()) << name.toStdString();
    EXPECT_EQ(dialog.textValue(), name) << "it stays as it was typed";
    EXPECT_FALSE(dialog.said().isEmpty());
    EXPECT_TRUE(dialog.findChild<QLineEdit*>()->property("isRefused").toBool());
  }
  dialog.setTextValue(QStringLiteral("Mine"));
  EXPECT_TRUE(dialog.said().isEmpty());
  EXPECT_FALSE(dialog.findChild<QLineEdit*>()->property("isRefused").toBool());
  dialog.accept();
  EXPECT_FALSE(dialog.isVisible());
  EXPECT_TRUE(rowOf(browser(), QStringLiteral("Mine")).isValid());
}

} // namespace
} // namespace limn
