// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/picture/OrientationController.h"
#include "app/picture/RegionController.h"
#include "scene/volume/Orientation.h"
#include "support/FileBytes.h"
#include "widgets/FindWidget.h"
#include "widgets/planes/PlaneDeck.h"
#include "widgets/properties/LabelSection.h"
#include "widgets/view/gestures/ViewCommands.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QInputDialog>
#include <QKeyEvent>
#include <QPushButton>

// Which side is left where a file says nothing, said by hand in the window.

namespace limn {
namespace {

class OrientationWindow : public test::WindowHarness {
protected:
  void SetUp() override {
    WindowHarness::SetUp();
    test::writeBytes(folder.path() / "small.nrrd",
                     "NRRD0004\ntype: short\ndimension: 3\nsizes: 2 2 2\nspacings: 1 1 1\nencoding: ascii\n\n"
                     "0 100 200 300 400 500 600 700\n");
    ASSERT_TRUE(open(pathTo("small.nrrd")));
  }

  QAction* named(const char* name) const { return window->findChild<QAction*>(QLatin1String(name)); }
  // What the menu says of an entry, before its key.
  QString says(const char* name) const { return named(name)->text().section(QLatin1Char('\t'), 0, 0); }
  std::string letters() const { return scene().volume->info().orientationByHand; }

  OrientationDialog& dialog() const { return *window->findChild<OrientationDialog*>(); }
  void click(const char* name) {
    auto* button = widgetNamed<QPushButton>(dialog(), name);
    ASSERT_NE(button, nullptr) << name;
    QTest::mouseClick(button, Qt::LeftButton);
  }
  void keep() {
    auto* button = dialog().findChild<QDialogButtonBox*>()->buttons().front();
    ASSERT_EQ(button->text(), QStringLiteral("Keep"));
    QTest::mouseClick(button, Qt::LeftButton);
  }
};

TEST_F(OrientationWindow, viewsNameNoSideBeforeOneIsKnown) {
  EXPECT_EQ(says("view-left"), QStringLiteral("From the last column"));
  EXPECT_EQ(says("view-anterior"), QStringLiteral("From the first row"));
  EXPECT_EQ(says("view-inferior"), QStringLiteral("From the first slice"));
  EXPECT_TRUE(named("setOrientation")->isEnabled());
  ASSERT_TRUE(open(QStringLiteral("phantom:8"))); // which says how it lies
  EXPECT_EQ(says("view-left"), QStringLiteral("Left"));
  EXPECT_FALSE(named("setOrientation")->isEnabled());
}

TEST_F(OrientationWindow, theMenuShowsTheKeyThatThePictureHasForEachView) {
  const auto commandOfKey = [this](const char* name) {
    const QKeyCombination key =
        QKeySequence(named(name)->text().section(QLatin1Char('\t'), 1), QKeySequence::NativeText)[0];
    return commandOf(QKeyEvent(QEvent::KeyPress, key.key(), key.keyboardModifiers()));
  };
  for (const char* name :
       {"view-anterior", "view-posterior", "view-left", "view-right", "view-superior", "view-inferior"}) {
    const auto view = static_cast<StandardView>(named(name)->data().toInt());
    EXPECT_EQ(commandOfKey(name), ViewCommand(viewcommand::LookFrom{view})) << name;
    EXPECT_TRUE(named(name)->shortcut().isEmpty()) << "in a menu letters choose entries";
  }
  EXPECT_EQ(commandOfKey("resetCamera"), ViewCommand(viewcommand::Reset{}));
}

TEST_F(OrientationWindow, cancelTakesBackWhatWasTriedAndKeepKeepsIt) {
  const auto asFound = scene().volume;
  named("setOrientation")->trigger();
  click("Flip: Columns run to");
  ASSERT_EQ(letters(), "RPS");
  QTest::keyClick(&dialog(), Qt::Key_Escape);
  EXPECT_EQ(scene().volume, asFound);
  QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(letters(), "RPS") << "taking it back can be undone, too";
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  named("setOrientation")->trigger();
  click("Flip: Rows run to");
  ASSERT_EQ(letters(), "RAS");
  keep();
  EXPECT_EQ(letters(), "RAS");
}

TEST_F(OrientationWindow, theBarOffersToSetItAndEveryAnswerIsAnUndoStep) {
  ASSERT_TRUE(messages().isVisible());
  QTest::mouseClick(messages().findChild<QToolButton*>(QStringLiteral("messageAction")), Qt::LeftButton);
  ASSERT_TRUE(dialog().isVisible());
  click("Flip: Columns run to");
  EXPECT_EQ(letters(), "RPS");
  EXPECT_EQ(scene().volume->grid().direction[0], glm::dvec3(-1, 0, 0));
  EXPECT_FALSE(messages().isVisible()) << "it is known now";
  EXPECT_EQ(says("view-left"), QStringLiteral("Left"));
  EXPECT_TRUE(named("setOrientation")->isEnabled()) << "it may be corrected";
  auto* slices = widgetNamed<QComboBox>(dialog(), "Slices run to");
  slices->setFocus();
  QTest::keyClick(slices, Qt::Key_Home); // to the left: columns take the head
  EXPECT_EQ(letters(), "SPL");
  EXPECT_EQ(undo().count(), 2);
  EXPECT_EQ(undo().undoText(), QStringLiteral("set orientation SPL"));
  undo().undo();
  EXPECT_EQ(letters(), "RPS");
  EXPECT_EQ(slices->currentText(), QStringLiteral("Head"));
  undo().undo();
  EXPECT_FALSE(scene().volume->info().orientationKnown);
  EXPECT_EQ(says("view-left"), QStringLiteral("From the last column"));
  EXPECT_TRUE(rest());
}

TEST_F(OrientationWindow, whatIsAssumedCanBeUsedAsItIs) {
  named("setOrientation")->trigger();
  QTest::mouseClick(dialog().findChild<QDialogButtonBox*>()->buttons().front(), Qt::LeftButton);
  EXPECT_EQ(letters(), "LPS");
}

TEST_F(OrientationWindow, sessionAndPictureKeepIt) {
  named("setOrientation")->trigger();
  click("Flip: Rows run to");
  ASSERT_EQ(letters(), "LAS");
  keep();
  ASSERT_TRUE(rest());
  saving().writePicture(pathTo("picture.png"));
  saving().writeSession(pathTo("session.json"));
  for (const char* file : {"picture.png", "session.json"}) {
    ASSERT_TRUE(open(QStringLiteral("phantom:8")));
    ASSERT_TRUE(open(pathTo(file)));
    EXPECT_EQ(letters(), "LAS") << file;
    EXPECT_FALSE(messages().isVisible()) << file << ": " << messages().sentence().toStdString();
  }
}

TEST_F(OrientationWindow, ofSeveralRemarksTheOneAboutItGoesAndTheOthersStay) {
  test::writeBytes(folder.path() / "bare.nrrd",
                   "NRRD0004\ntype: short\ndimension: 3\nsizes: 2 2 2\nencoding: ascii\n\n"
                   "0 100 200 300 400 500 600 700\n");
  ASSERT_TRUE(open(pathTo("bare.nrrd")));
  const auto says = [this](const char* words) {
    for (const QLabel* label : messages().findChildren<QLabel*>())
      if (label->text().contains(QLatin1String(words)))
        return true;
    return false;
  };
  ASSERT_TRUE(messages().isVisible() && says("spacing") && says("Orientation unknown"));
  named("setOrientation")->trigger();
  click("Flip: Rows run to");
  EXPECT_TRUE(messages().isVisible());
  EXPECT_TRUE(says("spacing"));
  EXPECT_FALSE(says("Orientation unknown"));
  QTest::mouseClick(messages().findChild<QToolButton*>(QStringLiteral("messageAction")), Qt::LeftButton);
  EXPECT_NE(window->findChild<QInputDialog*>(), nullptr) << "the spacing can still be set";
}

// The same voxels are the same volume: what was measured stays on its tissue, its tool in hand, and the list
// of labels as it was folded.
TEST_F(OrientationWindow, measurementsAndTheListOfLabelsStayWithTheirVoxels) {
  const auto onVoxel = [this](const glm::dvec3& index) {
    return indexToWorld(scene().volume->grid(), index);
  };
  const Measurement diagonal{
      Measurement::Kind::distance, PatientPlane::axial, {onVoxel({0, 0, 1}), onVoxel({1, 1, 1})}};
  session().setMeasurements({diagonal}, {nextGestureId(), "Distance"});
  auto& deck = *window->findChild<PlaneDeck*>();
  window->findChild<QAction*>(QStringLiteral("planes-picture_and_three"))->trigger();
  deck.setTool(PlaneTool::distance);
  test::writeBytes(folder.path() / "labels.nrrd",
                   "NRRD0004\ntype: short\ndimension: 3\nsizes: 2 2 2\nspacings: 1 1 1\nencoding: ascii\n\n"
                   "0 0 0 0 0 0 0 7\n");
  RegionController& regions = *window->findChild<RegionController*>();
  regions.openLabels(pathTo("labels.nrrd"));
  ASSERT_TRUE(test::waitUntil([&] { return !regions.isBusy(); }));
  auto& list = *window->findChild<LabelSection*>();
  list.setFolded(true);
  named("setOrientation")->trigger();
  click("Flip: Columns run to");
  ASSERT_EQ(session().measurements().size(), 1u);
  const Measurement& moved = session().measurements().front();
  // Rounding of places of a millimetre.
  EXPECT_LT(glm::length(moved.placesMm[0] - onVoxel({0, 0, 1})), 1e-12);
  EXPECT_LT(glm::length(moved.placesMm[1] - onVoxel({1, 1, 1})), 1e-12);
  EXPECT_EQ(deck.tool(), PlaneTool::distance);
  EXPECT_TRUE(list.isFolded());
  undo().undo();
  EXPECT_EQ(session().measurements(), std::vector{diagonal});
  keep();
}

// A label map is of the file's voxels: whatever a person says of the file holds for it, too.
TEST_F(OrientationWindow, labelsStayOnTheirTissueHoweverTheVolumeIsTurned) {
  test::writeBytes(folder.path() / "labels.nrrd",
                   "NRRD0004\ntype: short\ndimension: 3\nsizes: 2 2 2\nspacings: 1 1 1\nencoding: ascii\n\n"
                   "0 0 0 0 0 0 0 7\n"); // on the brightest voxel
  RegionController& regions = *window->findChild<RegionController*>();
  const auto brightestIsHidden = [this] {
    Region hidden = scene().keep;
    hidden.weights.back() = 0.0;
    EXPECT_EQ(scene().volume->value({1, 1, 1}), 700.0);
    return weightAt(hidden, {1, 1, 1}) == 0.0 && weightAt(hidden, {0, 1, 1}) == 1.0;
  };
  const auto openLabels = [&] {
    regions.openLabels(pathTo("labels.nrrd"));
    return test::waitUntil([&] { return !regions.isBusy(); });
  };
  ASSERT_TRUE(openLabels());
  ASSERT_TRUE(brightestIsHidden());
  named("setOrientation")->trigger();
  for (const char* turn : {"Flip: Columns run to", "Flip: Slices run to"}) {
    click(turn);
    EXPECT_TRUE(brightestIsHidden()) << "those that were open";
    ASSERT_TRUE(openLabels());
    EXPECT_TRUE(brightestIsHidden()) << "opened after " << turn;
  }
  auto* rows = widgetNamed<QComboBox>(dialog(), "Rows run to");
  rows->setFocus();
  QTest::keyClick(rows, Qt::Key_Home); // to the left: columns take the back or the front
  EXPECT_NE(axisLettersOf(scene().volume->grid()).find('L'), std::string::npos);
  ASSERT_TRUE(openLabels());
  EXPECT_TRUE(brightestIsHidden()) << letters();
  keep();
  ASSERT_TRUE(rest());
  saving().writeSession(pathTo("session.json"));
  const std::string chosen = letters();
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  ASSERT_TRUE(open(pathTo("session.json")));
  EXPECT_EQ(letters(), chosen);
  EXPECT_TRUE(brightestIsHidden()) << "as the session opens";
}

} // namespace
} // namespace limn
