// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/presets/PresetStore.h"
#include "scene/presets/PresetFit.h"
#include "widgets/FindWidget.h"
#include "widgets/controls/TrackSlider.h"
#include "widgets/theme/LookStyle.h"

#include <QCheckBox>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QInputDialog>
#include <QMenu>
#include <QMimeData>
#include <QPushButton>
#include <QStatusBar>
#include <QUrl>

#include <algorithm>
#include <fstream>

namespace limn::test {
namespace {

/// How much of the window pictures, messages and panels take.
class Room : public WindowHarness {
protected:
  ComparisonController& comparison() const { return *window->findChild<ComparisonController*>(); }
  MessageBar& bar(const char* name) const { return *window->findChild<MessageBar*>(QLatin1String(name)); }
  QAction& named(const char* name) const { return *window->findChild<QAction*>(QLatin1String(name)); }

  /// The window in this size, once everything in it has its place.
  void setSize(const QSize& size) {
    window->resize(size);
    ASSERT_TRUE(test::waitUntil([&] { return window->size() == size && rest(); }));
  }

  /// Of the window, by the pictures and what parts them.
  double shareOfPictures() const {
    const QSize view = window->view().size();
    return double(view.width()) * view.height() / (double(window->width()) * window->height());
  }

  void giveFirstSizes(const QSize& size) {
    const FirstDockSizes docks = firstDockSizes(size);
    const auto dock = [this](const char* name) {
      return window->findChild<QDockWidget*>(QLatin1String(name));
    };
    window->resizeDocks({dock("presetDock"), dock("shadingDock")},
                        {docks.presetsWidth, docks.propertiesWidth}, Qt::Horizontal);
    window->resizeDocks({dock("curveDock")}, {docks.curveHeight}, Qt::Vertical);
  }
};

TEST_F(Room, twoPicturesHaveTwoFifthsOfALargeWindowAndOneAloneNearlyAll) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  const QSize size(1440, 900);
  setSize(size);
  giveFirstSizes(size);
  ASSERT_TRUE(rest());
  EXPECT_EQ(view().compareLayout(), CompareLayout::sideBySide);
  EXPECT_GE(shareOfPictures(), 0.40);
  setLayout(CompareLayout::single);
  named("pictureOnly").trigger();
  // All but the menus.
  EXPECT_TRUE(test::waitUntil([this] { return shareOfPictures() > 0.95; })) << shareOfPictures();
}

TEST_F(Room, messagesTakeNoneFromThePictureAndOneIsSeenAtATime) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  ASSERT_TRUE(rest());
  const QSize before = view().size();
  bar("tourBar").show(MessageBar::Kind::question, QStringLiteral("Shall I?"));
  ASSERT_TRUE(bar("tourBar").isVisible());
  ASSERT_TRUE(open(pathTo("missing.nii")));
  EXPECT_TRUE(messages().isVisible());
  EXPECT_FALSE(bar("tourBar").isVisible()) << "one at a time, what went wrong first";
  EXPECT_TRUE(bar("tourBar").isWanted());
  EXPECT_EQ(view().size(), before);
  EXPECT_TRUE(window->centralWidget()->rect().contains(messages().geometry()));
  messages().hide();
  EXPECT_TRUE(bar("tourBar").isVisible());
  EXPECT_EQ(view().size(), before);
}

// Where slices are shown, too, a message stands in the place of the picture: they are read meanwhile.
TEST_F(Room, messagesLieOverThePictureAndNotOverSlices) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  setSize({1440, 900});
  named("planes-picture_and_three").trigger();
  ASSERT_TRUE(rest());
  const QString sentence = QStringLiteral("The slices lie far apart, and surfaces show a band for each.");
  messages().show(MessageBar::Kind::warning, sentence);
  QCoreApplication::processEvents();
  const auto picture = [this] {
    return QRect(view().mapTo(window->centralWidget(), QPoint()), view().size());
  };
  ASSERT_LT(picture().width(), window->centralWidget()->width());
  EXPECT_TRUE(picture().contains(messages().geometry()));
  const int beside = messages().width();
  // It follows the picture, and lies over everything where it has more to say than that holds.
  named("planes-picture").trigger();
  QCoreApplication::processEvents();
  EXPECT_GT(messages().width(), beside);
  named("planes-picture_and_three").trigger();
  QCoreApplication::processEvents();
  EXPECT_TRUE(picture().contains(messages().geometry()));
  messages().show(MessageBar::Kind::warning, QString(sentence + QLatin1Char(' ')).repeated(20));
  QCoreApplication::processEvents();
  EXPECT_FALSE(picture().contains(messages().geometry()));
  EXPECT_TRUE(window->centralWidget()->rect().contains(messages().geometry()));
}

TEST_F(Room, aNoteGoesByItselfUnlessItIsRead) {
  const auto runs = [this] { return messages().findChild<QTimer*>()->isActive(); };
  messages().show(MessageBar::Kind::note, QStringLiteral("Said in passing."));
  EXPECT_TRUE(runs());
  QEvent enters(QEvent::Enter);
  QApplication::sendEvent(&messages(), &enters);
  EXPECT_FALSE(runs());
  messages().show(MessageBar::Kind::error, QStringLiteral("This went wrong."));
  EXPECT_FALSE(runs()) << "stays until it is dismissed";
  EXPECT_GE(MessageBar::readingMs(QString(200, QLatin1Char('x'))), 20000);
}

TEST_F(Room, besideSlicesThereIsOneModelUntilBothAreAskedFor) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  setLayout(CompareLayout::sideBySide);
  named("planes-picture_and_three").trigger();
  ASSERT_TRUE(rest());
  EXPECT_EQ(view().compareLayout(), CompareLayout::single);
  setLayout(CompareLayout::sideBySide);
  EXPECT_EQ(view().compareLayout(), CompareLayout::sideBySide) << "asked for";
  named("planes-picture").trigger();
  EXPECT_EQ(session().planes().layout, PlaneLayout::pictureOnly);
}

TEST_F(Room, picturesNarrowerThanFourHundredPixelsBecomeOne) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  comparison().begin(); // nobody asks for anything
  ASSERT_LT(view().width(), 800);
  EXPECT_EQ(view().compareLayout(), CompareLayout::single);
  EXPECT_TRUE(named("layout-single").isChecked());
  setSize({1600, 900});
  ASSERT_GE(view().width(), 800);
  ASSERT_TRUE(test::waitUntil([this] { return view().compareLayout() == CompareLayout::sideBySide; }));
  setLayout(CompareLayout::sideBySide);
  setSize({900, 640});
  EXPECT_EQ(view().compareLayout(), CompareLayout::sideBySide) << "asked for";
}

// It is saved as what was wanted, so that it comes back with the room.
TEST_F(Room, aSessionOfWhatGaveWayHasBothPicturesAgainWhereThereIsRoom) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  comparison().begin();
  ASSERT_LT(view().width(), 800);
  ASSERT_EQ(view().compareLayout(), CompareLayout::single);
  std::ofstream(folder.path() / "narrow.json") << sessionToJson(window->sessionDocument());
  setLayout(CompareLayout::single);
  std::ofstream(folder.path() / "single.json") << sessionToJson(window->sessionDocument());
  ASSERT_TRUE(open(pathTo("narrow.json")));
  EXPECT_EQ(view().compareLayout(), CompareLayout::single) << "it still has no room";
  setSize({1600, 900});
  EXPECT_TRUE(test::waitUntil([this] { return view().compareLayout() == CompareLayout::sideBySide; }));
  ASSERT_TRUE(open(pathTo("single.json")));
  EXPECT_EQ(view().compareLayout(), CompareLayout::single) << "asked for";
  ASSERT_TRUE(open(pathTo("narrow.json")));
  EXPECT_EQ(view().compareLayout(), CompareLayout::sideBySide);
}

TEST_F(Room, buttonsOfAMessageStandBelowItWhereThePictureIsNarrow) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  const auto showIn = [&](const QSize& size) {
    setSize(size);
    messages().show(
        MessageBar::Kind::warning,
        QStringLiteral("Schnitt 3 nimmt nichts weg: Seine Linie umschließt nichts, was noch da ist."),
        {QStringLiteral("Noch etwas.")}, {QStringLiteral("Orientierung festlegen…"), [] {}});
    QCoreApplication::processEvents();
    QList<QToolButton*> buttons = messages().findChildren<QToolButton*>();
    buttons.removeIf([](const QToolButton* button) { return button->isHidden(); });
    EXPECT_EQ(buttons.size(), 3);
    const auto* sentence = messages().findChild<QLabel*>();
    for (const QToolButton* button : buttons) {
      EXPECT_GE(button->width(), button->sizeHint().width()) << button->text().toStdString();
      EXPECT_TRUE(messages().rect().contains(button->geometry()));
      EXPECT_FALSE(sentence->geometry().intersects(button->geometry()));
    }
    EXPECT_GE(sentence->width(), 240);
    return buttons.front()->y() >= sentence->geometry().bottom();
  };
  EXPECT_TRUE(showIn({1024, 700}));
  EXPECT_FALSE(showIn({1440, 900})) << "beside it where there is room";
}

// What can be had elsewhere does not ask to be dismissed in its turn: late, it goes by itself.
TEST_F(Room, messagesThatHadToWaitAreBriefAndErrorsGoFirst) {
  const auto goes = [](const MessageBar& one) { return one.findChild<QTimer*>()->isActive(); };
  for (const char* name : {"tourBar", "patientBar", "keptBar"})
    bar(name).hide();
  messages().hide();
  QTest::mouseMove(window->windowHandle(), QPoint(2, 2)); // or it would be read
  view().setFocus();
  MessageBar& tour = bar("tourBar");
  tour.show(MessageBar::Kind::question, QStringLiteral("Shall I?"));
  ASSERT_TRUE(tour.isVisible());
  EXPECT_FALSE(goes(tour)) << "what comes first stays until it is answered";
  messages().show(MessageBar::Kind::warning, QStringLiteral("Slices are missing."));
  ASSERT_TRUE(messages().isVisible() && !tour.isVisible());
  EXPECT_FALSE(goes(messages()));
  bar("keptBar").show(MessageBar::Kind::note, QStringLiteral("Your work is kept."));
  EXPECT_TRUE(messages().isVisible() && !bar("keptBar").isVisible()) << "what was opened comes first";
  messages().hide();
  EXPECT_TRUE(bar("keptBar").isVisible());
  EXPECT_TRUE(goes(bar("keptBar")));
  messages().show(MessageBar::Kind::error, QStringLiteral("This went wrong."));
  EXPECT_TRUE(messages().isVisible() && !bar("keptBar").isVisible()) << "errors wait for no note";
  messages().hide();
  EXPECT_TRUE(bar("keptBar").isVisible()) << "not lost";
  bar("keptBar").hide();
  ASSERT_TRUE(tour.isVisible());
  EXPECT_TRUE(goes(tour)) << "it had to wait";
  tour.show(MessageBar::Kind::question, QStringLiteral("Shall I now?"));
  EXPECT_FALSE(goes(tour));
  bar("recoveryBar").show(MessageBar::Kind::question, QStringLiteral("Restore?"));
  bar("unsafeBar").show(MessageBar::Kind::warning, QStringLiteral("Not safe."));
  bar("unsafeBar").hide();
  ASSERT_TRUE(bar("recoveryBar").isVisible());
  EXPECT_FALSE(goes(bar("recoveryBar"))) << "work is at stake";
  messages().show(MessageBar::Kind::error, QStringLiteral("This went wrong."));
  EXPECT_TRUE(messages().isVisible() && !bar("recoveryBar").isVisible()) << "errors wait for no question";
  messages().hide();
  EXPECT_TRUE(bar("recoveryBar").isVisible()) << "not lost";
  bar("recoveryBar").hide();
}

// In the program's own style; in Qt's the button is narrower than what our sheet puts around its icon.
TEST(ToolBarStyle, leavesTheButtonForMoreToolsRoomToBeSeen) {
  const LookStyle style;
  EXPECT_GE(style.pixelMetric(QStyle::PM_ToolBarExtensionExtent, nullptr, nullptr), 24);
  EXPECT_FALSE(style.standardIcon(QStyle::SP_ToolBarHorizontalExtensionButton, nullptr, nullptr).isNull());
}

TEST_F(Room, panelsFoldAndComeBackAsTheyWere) {
  auto& dock = *window->findChild<QDockWidget*>(QStringLiteral("effectsDock"));
  dock.raise();
  ASSERT_TRUE(test::waitUntil([&] { return !dock.widget()->visibleRegion().isEmpty(); }));
  QAction& fold = named("panels-right");
  EXPECT_TRUE(fold.isChecked());
  fold.trigger();
  EXPECT_FALSE(fold.isChecked());
  EXPECT_TRUE(window->findChild<QDockWidget*>(QStringLiteral("shadingDock"))->isHidden());
  fold.trigger();
  ASSERT_TRUE(test::waitUntil([&] { return !dock.widget()->visibleRegion().isEmpty(); }));
}

TEST_F(Room, aNarrowWindowFoldsThePanelsAtTheRight) {
  const auto isFolded = [this] {
    return window->findChild<QDockWidget*>(QStringLiteral("shadingDock"))->isHidden();
  };
  ASSERT_FALSE(isFolded());
  window->resize(820, 600);
  ASSERT_TRUE(test::waitUntil(isFolded));
  window->resize(1000, 700);
  ASSERT_TRUE(test::waitUntil([&] { return !isFolded(); }));
}

TEST(FirstPlace, hasRoomForTheFrameOnEveryScreen) {
  for (const QRect screen : {QRect(0, 0, 1440, 900), QRect(0, 27, 1366, 741), QRect(0, 0, 3840, 2160)}) {
    // Of common window managers: a title of up to 30 pixels, 8 at the sides and below.
    const QRect frame = firstWindowPlace(screen).adjusted(-8, -30, 8, 8);
    EXPECT_TRUE(screen.contains(frame)) << screen.width();
  }
}

TEST_F(Room, theFrameOfTheCropBoxEndsWithItsVolume) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  named("cropBox").trigger();
  EXPECT_TRUE(view().cropBoxIsVisible());
  ASSERT_TRUE(open(QStringLiteral("phantom:3")));
  EXPECT_FALSE(view().cropBoxIsVisible());
}

TEST_F(Room, filesThatAreHeldOverTheWindowShowThatTheyMayFall) {
  QMimeData files;
  files.setUrls({QUrl::fromLocalFile(pathTo("head.nii"))});
  QDragEnterEvent enters({10, 10}, Qt::CopyAction, &files, Qt::LeftButton, {});
  QApplication::sendEvent(window.get(), &enters);
  auto* hint = window->findChild<QWidget*>(QStringLiteral("dropHint"));
  ASSERT_TRUE(hint->isVisible());
  EXPECT_TRUE(hint->accessibleName().contains(QStringLiteral("head.nii")));
  QDragLeaveEvent leaves;
  QApplication::sendEvent(window.get(), &leaves);
  EXPECT_FALSE(hint->isVisible());
}

/// A ball without a unit: from 0 outside to 200 in the middle.
void writeBallWithoutUnit(const std::filesystem::path& path) {
  constexpr int side = 24;
  std::ofstream file(path, std::ios::binary);
  file << "NRRD0004\ntype: unsigned char\ndimension: 3\nsizes: 24 24 24\nspacings: 1 1 1\nencoding: raw\n\n";
  for (int z = 0; z < side; ++z)
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        const double radius = glm::length(glm::dvec3(x, y, z) - glm::dvec3((side - 1) / 2.0));
        file.put(static_cast<char>(static_cast<unsigned char>(std::max(0.0, 200.0 - 20.0 * radius))));
      }
}

TEST_F(Room, theToolsOfTheCurveHaveRoomBesideThePointInHand) {
  ASSERT_TRUE(open(QStringLiteral("phantom:6")));
  setSize({1440, 900});
  TransferFunctionEditor& editor = *curves().valueEditor();
  editor.canvas()->selectPoints({2});
  EXPECT_TRUE(widgetNamed<TrackSlider>(editor, "Shift")->isVisible());
  EXPECT_FALSE(editor.findChild<QToolButton*>(QStringLiteral("moreCurveTools"))->isVisible());
}

/// Looks, as they are compared, named and told of.
class Looks : public Room {
protected:
  /// Chooses a preset for a side in the menu that its label opens.
  void choose(int side, const QString& preset) {
    QMenu menu;
    emit view().presetMenuAsked(&menu, side);
    for (QAction* action : menu.actions())
      if (action->text() == preset)
        return action->trigger();
    FAIL() << "no preset " << preset.toStdString();
  }
  PresetController& presets() { return *window->findChild<PresetController*>(); }
  /// Opens a ball without unit; one's own preset "mylook" is of data with far larger values.
  Preset openWithPresetOfOtherValues() {
    Preset mine;
    mine.name = "mylook";
    mine.modality = "MR";
    mine.landmarks = Landmarks{0.0, 20000.0, 90000.0};
    mine.transferFunction = {
        1.0, {{0.0, glm::dvec3(0.5), 0.0}, {20000.0, glm::dvec3(0.8), 0.3}, {90000.0, glm::dvec3(1.0), 1.0}}};
    PresetStore(UserFolders::below(folder.path()).presets).save(mine);
    writeBallWithoutUnit(folder.path() / "ball.nrrd");
    EXPECT_TRUE(open(pathTo("ball.nrrd")));
    presets().refresh();
    return mine;
  }
  QStringList names() {
    const auto& look = view().order().comparison.look;
    return look ? QStringList{QString::fromStdString(look->names[0]), QString::fromStdString(look->names[1])}
                : QStringList();
  }
};

TEST_F(Looks, twoPresetsAreComparedFromTheirLabelsUnderTheirNames) {
  ASSERT_TRUE(open(QStringLiteral("phantom:6")));
  setLayout(CompareLayout::sideBySide);
  choose(0, QStringLiteral("CT bone"));
  choose(1, QStringLiteral("CT skin"));
  EXPECT_EQ(names(), (QStringList{QStringLiteral("CT bone"), QStringLiteral("CT skin")}));
  const std::vector<Scene> sides = view().scenesOfSides();
  ASSERT_EQ(sides.size(), 2u);
  EXPECT_NE(sides[0].transferFunction, sides[1].transferFunction);
  choose(0, QStringLiteral("CT muscle"));
  EXPECT_EQ(names().value(0), QStringLiteral("CT muscle"));
}

// What was a comparison of two models stays one: a preset brings curve and light to a side, and no model.
TEST_F(Looks, comeToASideWhoseModelStays) {
  const auto models = [this] {
    std::vector<ShadingModel> shown;
    for (const Scene& side : view().scenesOfSides())
      shown.push_back(side.shading.model);
    return shown;
  };
  using Models = std::vector<ShadingModel>;
  ASSERT_TRUE(open(QStringLiteral("phantom:6")));
  setLayout(CompareLayout::sideBySide);
  ASSERT_EQ(models(), (Models{ShadingModel::classic, ShadingModel::enhanced}));
  choose(0, QStringLiteral("CT bone"));
  EXPECT_EQ(models(), (Models{ShadingModel::classic, ShadingModel::enhanced}));
  const SessionDocument kept = window->sessionDocument();
  EXPECT_EQ(kept.ownModel, ShadingModel::enhanced);
  named("compareModels").trigger();
  ASSERT_EQ(models(), (Models{ShadingModel::classic, ShadingModel::enhanced}));
  choose(1, QStringLiteral("CT skin"));
  EXPECT_EQ(models(), (Models{ShadingModel::classic, ShadingModel::enhanced}));
  // What somebody chose for a side outlasts every other preset, and undo of it.
  emit view().modelChosen(1, ShadingModel::robust);
  emit view().modelChosen(0, ShadingModel::none);
  choose(1, QStringLiteral("CT muscle"));
  choose(0, QStringLiteral("CT lung"));
  EXPECT_EQ(models(), (Models{ShadingModel::none, ShadingModel::robust}));
  undo().undo();
  undo().undo();
  EXPECT_EQ(models(), (Models{ShadingModel::none, ShadingModel::robust}));
}

// Before and now differ by the looks alone.
TEST_F(Looks, thatWereRememberedAreShownByTheModelOfTheRight) {
  ASSERT_TRUE(open(QStringLiteral("phantom:6")));
  setLayout(CompareLayout::sideBySide);
  named("takeSnapshot").trigger();
  dragAPoint();
  named("compareSnapshot").trigger();
  for (const Scene& side : view().scenesOfSides())
    EXPECT_EQ(side.shading.model, ShadingModel::enhanced);
}

TEST_F(Looks, whatIsRememberedIsNamedAfterItsPreset) {
  ASSERT_TRUE(open(QStringLiteral("phantom:6")));
  choose(0, QStringLiteral("CT bone")); // compared at the left; the scene's own is what it opened with
  named("compareModels").trigger();
  window->findChild<PresetController*>()->use(QStringLiteral("CT bone"));
  named("takeSnapshot").trigger();
  EXPECT_EQ(window->statusBar()->currentMessage(),
            QStringLiteral("Remembered; Ctrl+Shift+B compares with \"CT bone\"."))
      << "the keys first: it may be cut";
  dragAPoint();
  named("compareSnapshot").trigger();
  EXPECT_EQ(names(), (QStringList{QStringLiteral("CT bone"), QStringLiteral("CT bone, modified")}));
}

TEST_F(Looks, theHistorySaysWhatChanged) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  TransferFunction function = scene().transferFunction;
  ASSERT_GE(function.points.size(), 3u);
  ControlPoint& point = function.points[2];
  const double before = point.opacity;
  point.opacity = before > 0.5 ? 0.25 : 0.75;
  const std::uint64_t gesture = nextGestureId();
  session().setTransferFunction(function, {gesture, QStringLiteral("move point")});
  const QString text = undo().undoText();
  EXPECT_TRUE(text.startsWith(QStringLiteral("opacity at "))) << text.toStdString();
  EXPECT_TRUE(text.contains(QStringLiteral(" → "))) << text.toStdString();
  point.opacity = 0.5; // the same drag goes on
  session().setTransferFunction(function, {gesture, QStringLiteral("move point")});
  EXPECT_EQ(undo().count(), 1);
  EXPECT_TRUE(undo().undoText().endsWith(QStringLiteral("→ 0.5"))) << undo().undoText().toStdString();
  Shading shading = scene().shading;
  shading.exponent = 12.0;
  session().setShading(shading, {nextGestureId(), QStringLiteral("change sharpness")});
  EXPECT_TRUE(undo().undoText().endsWith(QStringLiteral("→ 12"))) << undo().undoText().toStdString();
  point.color = glm::dvec3(1.0) - point.color;
  session().setTransferFunction(function, {nextGestureId(), QStringLiteral("change colour of point")});
  EXPECT_TRUE(undo().undoText().startsWith(QStringLiteral("change colour at ")))
      << undo().undoText().toStdString();
}

TEST_F(Looks, thePapersNumbersAreOneClickAway) {
  ASSERT_TRUE(open(QStringLiteral("phantom:6")));
  setLayout(CompareLayout::sideBySide); // enhanced is shown
  const Shading tuned = scene().shading;
  EXPECT_NE(tuned.exponentRange, Shading{}.exponentRange) << "the preset has numbers of its own";
  auto& button = *window->findChild<QPushButton*>(QStringLiteral("asInThePaper"));
  ASSERT_TRUE(button.isEnabled());
  button.click();
  Shading expected = tuned;
  expected.exponentRange = Shading{}.exponentRange;
  expected.opacityRange = Shading{}.opacityRange;
  expected.gradientReference = AutomaticReference{};
  expected.gradientCurve = GradientCurve{};
  EXPECT_EQ(scene().shading, expected);
  EXPECT_FALSE(button.isEnabled());
  undo().undo();
  EXPECT_EQ(scene().shading, tuned);
}

TEST_F(Looks, effectsAreSwitchedWhereTheyAreListed) {
  ASSERT_TRUE(openAlone(QStringLiteral("phantom:6")));
  window->findChild<QDockWidget*>(QStringLiteral("effectsDock"))->raise();
  ASSERT_TRUE(rest());
  const auto highlights = [this]() -> QCheckBox* {
    for (QCheckBox* one : window->findChildren<QCheckBox*>())
      if (one->accessibleName() == QStringLiteral("Highlights"))
        return one;
    return nullptr;
  };
  ASSERT_TRUE(test::waitUntil([&] { return highlights() && highlights()->isVisible(); }));
  const Scene before = scene();
  ASSERT_GT(before.shading.specular, 0.0);
  highlights()->click();
  EXPECT_EQ(scene().shading.specular, 0.0);
  ASSERT_TRUE(test::waitUntil([&] { return highlights()->isVisible() && !highlights()->isChecked(); }));
  highlights()->click();
  EXPECT_EQ(scene().shading, before.shading);
  EXPECT_EQ(undo().count(), 2);
}

TEST_F(Looks, ownPresetsOfValuesWithoutUnitsKnowTheirData) {
  writeBallWithoutUnit(folder.path() / "ball.nrrd");
  ASSERT_TRUE(open(pathTo("ball.nrrd")));
  ASSERT_FALSE(looksLikeHounsfield(*scene().volume));
  onceAsked<QInputDialog>([](QInputDialog& dialog) {
    dialog.setTextValue(QStringLiteral("Mine"));
    dialog.accept();
  });
  window->findChild<OwnPresetController*>()->askForName();
  const auto own = [this] { return PresetStore(UserFolders::below(folder.path()).presets).find("Mine"); };
  ASSERT_TRUE(test::waitUntil([&] { return own().has_value(); }));
  EXPECT_TRUE(own()->landmarks.has_value());
}

TEST_F(Looks, anOwnPresetThatIsFittedToAnotherVolumeSaysSoAndCanBeUsedAsSaved) {
  const Preset mine = openWithPresetOfOtherValues();
  presets().use(QStringLiteral("mylook"));
  EXPECT_NE(scene().transferFunction, mine.transferFunction) << "fitting is what happens unasked";
  ASSERT_TRUE(messages().isVisible());
  EXPECT_EQ(messages().sentence(), QStringLiteral("\"mylook\" was fitted to this volume's values."));
  QTest::mouseClick(messages().findChild<QToolButton*>(QStringLiteral("messageAction")), Qt::LeftButton);
  EXPECT_EQ(scene().transferFunction, mine.transferFunction);
  EXPECT_FALSE(messages().isVisible()) << "it is fitted no longer";
  EXPECT_EQ(undo().undoText(), QStringLiteral("use preset mylook as saved")) << "told from the step before";

  presets().use(QStringLiteral("mylook"));
  ASSERT_TRUE(messages().isVisible());
  session().setCamera(orbited(scene().camera, 0.3, 0.0));
  EXPECT_TRUE(messages().isVisible()) << "that holds from every side";
  TransferFunction edited = scene().transferFunction;
  edited.points.back().opacity *= 0.5;
  session().setTransferFunction(edited, {nextGestureId(), QStringLiteral("move point")});
  EXPECT_FALSE(messages().isVisible()) << "the curve is another";

  presets().use(QStringLiteral("mylook"));
  ASSERT_TRUE(messages().isVisible());
  undo().undo();
  EXPECT_FALSE(messages().isVisible()) << "it is not in use";
}

// How smooth normals are is the volume's where presets ask for nothing.
TEST_F(Looks, ofTwoPresetsTheOneThatIsEditedIsCalledModified) {
  ASSERT_TRUE(open(QStringLiteral("phantom:6")));
  setLayout(CompareLayout::sideBySide);
  choose(0, QStringLiteral("CT bone"));
  choose(1, QStringLiteral("CT skin"));
  Shading shading = scene().shading;
  shading.gradientSmoothing += 2.0;
  session().setShading(shading, {nextGestureId(), QStringLiteral("smooth normals")});
  for (const Scene& side : view().scenesOfSides())
    EXPECT_EQ(side.shading.gradientSmoothing, shading.gradientSmoothing);
  EXPECT_EQ(names(), (QStringList{QStringLiteral("CT bone"), QStringLiteral("CT skin")}));
  shading.specular *= 0.5;
  session().setShading(shading, {nextGestureId(), QStringLiteral("duller")});
  EXPECT_EQ(names(), (QStringList{QStringLiteral("CT bone"), QStringLiteral("CT skin, modified")}));
}

TEST_F(Looks, ofWhichACurveWasFittedSayThatInTheirNames) {
  openWithPresetOfOtherValues();
  setLayout(CompareLayout::sideBySide);
  presets().compare(QStringLiteral("mylook"), 1);
  EXPECT_EQ(names().value(0), QStringLiteral("mylook, fitted"));
  presets().use(QStringLiteral("mylook"));
  EXPECT_EQ(names(), (QStringList{QStringLiteral("mylook, fitted"), QStringLiteral("mylook, fitted")}));
  ASSERT_TRUE(messages().isVisible());
  QTest::mouseClick(messages().findChild<QToolButton*>(QStringLiteral("messageAction")), Qt::LeftButton);
  EXPECT_EQ(names(), (QStringList{QStringLiteral("mylook, fitted"), QStringLiteral("mylook")}));
}

TEST_F(Looks, builtInOnesInHounsfieldUnitsSayWhereThoseWereNotUsed) {
  openWithPresetOfOtherValues();
  setLayout(CompareLayout::sideBySide);
  presets().compare(QStringLiteral("CT skin"), 1);
  presets().use(QStringLiteral("CT bone"));
  EXPECT_EQ(names(), (QStringList{QStringLiteral("CT skin, fitted"), QStringLiteral("CT bone, fitted")}));
  ASSERT_TRUE(messages().isVisible());
  QTest::mouseClick(messages().findChild<QToolButton*>(QStringLiteral("messageAction")), Qt::LeftButton);
  EXPECT_EQ(names().value(1), QStringLiteral("CT bone")) << "its own numbers";
  presets().use(QStringLiteral("MR head"));
  EXPECT_EQ(names().value(1), QStringLiteral("MR head")) << "it has none of its own";
}

TEST_F(Looks, aPresetThatShowsNothingOffersToFitItAtOnce) {
  Preset far;
  far.name = "Far";
  far.modality = "MR";
  far.transferFunction = {
      1.0,
      {{90000.0, glm::dvec3(0.5), 0.0}, {95000.0, glm::dvec3(0.8), 0.5}, {99000.0, glm::dvec3(1.0), 1.0}}};
  PresetStore(UserFolders::below(folder.path()).presets).save(far);
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  auto& presets = *window->findChild<PresetController*>();
  presets.refresh();
  presets.use(QStringLiteral("Far"));
  ASSERT_TRUE(messages().isVisible());
  EXPECT_TRUE(messages().sentence().contains(QStringLiteral("shows nothing")));
  QTest::mouseClick(messages().findChild<QToolButton*>(QStringLiteral("messageAction")), Qt::LeftButton);
  const ValueRange range = scene().volume->range();
  EXPECT_LT(scene().transferFunction.points[1].value, range.highest);
}

} // namespace
} // namespace limn::test
