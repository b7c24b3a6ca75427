// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/picture/CutController.h"
#include "app/picture/RegionController.h"
#include "scene/LabelLooks.h"
#include "widgets/ValueText.h"
#include "widgets/curve/CurvePanel.h"
#include "widgets/curve/TransferFunctionEditor.h"
#include "widgets/curve/canvas/TransferFunctionCanvas.h"
#include "widgets/properties/CutSection.h"
#include "widgets/properties/PropertiesPanel.h"
#include "widgets/view/gestures/ViewInput.h"
#include "widgets/view/overlay/Titles.h"
#include "widgets/view/panels/CutBar.h"

#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QRegularExpression>
#include <QStatusBar>
#include <QToolButton>
#include <QWheelEvent>

#include <fstream>

// What is cut by hand, in the program's window: lines drawn on the picture, pieces pointed at, and the
// list of both.

namespace limn {
namespace {

class CutWindow : public test::WindowHarness {
protected:
  void SetUp() override {
    WindowHarness::SetUp();
    ASSERT_TRUE(openAlone(QStringLiteral("phantom:6")));
    ASSERT_TRUE(rest());
  }

  QPoint inPicture(const QPoint& fromMiddle) {
    const QRectF picture = view().logicalRect(0);
    return view().mapTo(window.get(), picture.center().toPoint()) + fromMiddle;
  }
  void moveTo(const QPoint& at, Qt::KeyboardModifiers keys = {}) {
    QTest::mouseEvent(QTest::MouseMove, window->windowHandle(), Qt::NoButton, keys, inPicture(at));
  }
  void draw(const QList<QPoint>& corners, Qt::KeyboardModifiers keys = {}) {
    QTest::mousePress(window->windowHandle(), Qt::LeftButton, keys, inPicture(corners.front()));
    for (const QPoint& corner : corners)
      moveTo(corner, keys);
    QTest::mouseRelease(window->windowHandle(), Qt::LeftButton, keys, inPicture(corners.back()));
    QCoreApplication::processEvents();
  }
  void click(const QPoint& at) {
    QTest::mouseClick(window->windowHandle(), Qt::LeftButton, {}, inPicture(at));
    QCoreApplication::processEvents();
  }
  void press(Qt::Key key) {
    view().setFocus();
    QTest::keyClick(&view(), key);
    QCoreApplication::processEvents();
  }
  void turnWheel(int notches, Qt::KeyboardModifiers keys = {}) {
    const QPointF at = view().logicalRect(0).center();
    QWheelEvent event(at, view().mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton, keys,
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&view(), &event);
  }

  RegionController& regions() { return *window->findChild<RegionController*>(); }
  CutController& cutting() { return *window->findChild<CutController*>(); }
  [[nodiscard]] bool ready() {
    return test::waitUntil([this] { return !regions().isBusy() && !cutting().isBusy(); });
  }
  const std::vector<Cut>& cuts() { return scene().keep.cuts; }
  CutBar& bar() { return *view().findChild<CutBar*>(); }
  QPushButton& button(const QString& text) {
    for (QPushButton* button : bar().findChildren<QPushButton*>())
      if (button->text() == text)
        return *button;
    ADD_FAILURE() << "no button " << text.toStdString();
    return *bar().findChild<QPushButton*>();
  }
  QListWidget& list() { return *window->findChild<CutSection*>()->findChild<QListWidget*>(); }
  double weightInTheMiddle() {
    return weightAt(scene().keep, 0.5 * glm::dvec3(scene().volume->grid().dims - 1));
  }

  // Around the middle of the picture.
  static QList<QPoint> loop() {
    return {{-40, -40}, {0, -55}, {40, -40}, {55, 0}, {40, 40}, {0, 55}, {-40, 40}, {-55, 0}};
  }
};

TEST_F(CutWindow, aLineDrawnAroundSomethingTakesItAwayInOneUndoStep) {
  press(Qt::Key_X);
  EXPECT_EQ(view().tool(), ViewTool::scissors);
  EXPECT_TRUE(bar().isVisible());
  draw(loop());
  ASSERT_TRUE(ready());
  ASSERT_EQ(cuts().size(), 1u);
  const auto& scissors = std::get<Scissors>(cuts().front().how);
  EXPECT_EQ(scissors.camera, scene().camera);
  EXPECT_TRUE(scissors.removesInside);
  EXPECT_FALSE(scissors.depthMm);
  EXPECT_NEAR(scissors.aspect, view().logicalRect(0).width() / view().logicalRect(0).height(), 1e-9);
  const double half = view().logicalRect(0).height() / 2.0;
  // Pixels of the view are whole, its middle may lie between two.
  EXPECT_NEAR(scissors.polygon.front().x, -40.0 / half, 1.0 / half);
  EXPECT_NEAR(scissors.polygon.front().y, 40.0 / half, 1.0 / half);
  EXPECT_EQ(weightInTheMiddle(), 0.0);
  EXPECT_EQ(undo().undoText(), QStringLiteral("cut away inside a line"));
  EXPECT_EQ(undo().count(), 1);
  undo().undo();
  EXPECT_EQ(scene().keep, Region{});
  undo().redo();
  EXPECT_EQ(weightInTheMiddle(), 0.0);
  press(Qt::Key_Escape);
  EXPECT_EQ(view().tool(), ViewTool::rotate);
  EXPECT_FALSE(bar().isVisible());
}

TEST_F(CutWindow, outsideKeepsWhatTheLineGoesAround) {
  press(Qt::Key_X);
  QTest::mouseClick(&button(QStringLiteral("Outside")), Qt::LeftButton);
  draw(loop());
  ASSERT_TRUE(ready());
  ASSERT_EQ(cuts().size(), 1u);
  EXPECT_EQ(weightInTheMiddle(), 1.0);
  EXPECT_EQ(weightAt(scene().keep, {0.0, 0.0, 0.0}), 0.0);
}

TEST_F(CutWindow, whatIsSeenIsCutToItsDepthAndNoFurther) {
  press(Qt::Key_X);
  QTest::mouseClick(&button(QStringLiteral("What is seen")), Qt::LeftButton);
  draw(loop());
  ASSERT_TRUE(ready());
  ASSERT_EQ(cuts().size(), 1u);
  const auto& scissors = std::get<Scissors>(cuts().front().how);
  ASSERT_TRUE(scissors.depthMm);
  const double toMiddle = glm::length(boxCentreMm(scene().volume->grid()) - scene().camera.position);
  EXPECT_LT(scissors.depthMm->y, toMiddle) << "the skin in front";
  EXPECT_EQ(weightInTheMiddle(), 1.0);
}

TEST_F(CutWindow, cornersAreClickedTakenBackAndClosedByEnter) {
  press(Qt::Key_X);
  for (const QPoint& corner : {QPoint(-50, -50), QPoint(50, -50), QPoint(60, 40), QPoint(0, 30)})
    click(corner);
  moveTo({-20, 20});
  ASSERT_TRUE(view().input().cutLine());
  EXPECT_EQ(view().input().cutLine()->corners.size(), 4u);
  press(Qt::Key_Backspace);
  EXPECT_EQ(view().input().cutLine()->corners.size(), 3u);
  press(Qt::Key_Return);
  ASSERT_TRUE(ready());
  ASSERT_EQ(cuts().size(), 1u);
  EXPECT_EQ(std::get<Scissors>(cuts().front().how).polygon.size(), 3u);
  EXPECT_FALSE(view().input().cutLine());
  // Or by a click on the first corner.
  for (const QPoint& corner : {QPoint(-150, -50), QPoint(-60, -50), QPoint(-60, 50), QPoint(-148, -52)})
    click(corner);
  ASSERT_TRUE(ready());
  EXPECT_EQ(cuts().size(), 2u);
  // Esc takes an open line back, then the tool.
  click({0, 0});
  press(Qt::Key_Escape);
  EXPECT_FALSE(view().input().cutLine());
  EXPECT_EQ(view().tool(), ViewTool::scissors);
}

TEST_F(CutWindow, theBarStandsAsideWhileALineOfCornersIsOpen) {
  press(Qt::Key_X);
  EXPECT_TRUE(bar().isVisible());
  click({-50, -50});
  click({50, -50});
  EXPECT_TRUE(test::waitUntil([this] { return !bar().isVisible(); })) << "what it lies on may be cut, too";
  press(Qt::Key_Escape);
  EXPECT_TRUE(test::waitUntil([this] { return bar().isVisible(); }));
  for (const QPoint& corner : {QPoint(-50, -50), QPoint(50, -50), QPoint(0, 50)})
    click(corner);
  press(Qt::Key_Return);
  ASSERT_TRUE(ready());
  EXPECT_EQ(cuts().size(), 1u);
  EXPECT_TRUE(test::waitUntil([this] { return bar().isVisible(); }));
  for (QPushButton* button : bar().findChildren<QPushButton*>())
    if (button->text() == QStringLiteral("Done"))
      QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_FALSE(bar().isVisible());
  EXPECT_TRUE(view().hasFocus());
}

TEST_F(CutWindow, aLineGoesWithThePictureItWasDrawnOn) {
  press(Qt::Key_X);
  click({-50, -50});
  click({50, -50});
  ASSERT_TRUE(view().input().cutLine());
  turnWheel(1);
  EXPECT_FALSE(view().input().cutLine()) << "it would go around other things";
}

TEST_F(CutWindow, aLineAroundNothingSaysSoAndCutsNothing) {
  press(Qt::Key_X);
  const QPoint corner = QPoint(-static_cast<int>(view().logicalRect(0).width() / 2) + 2, 100);
  draw({corner, corner + QPoint(12, 0), corner + QPoint(12, 12), corner + QPoint(0, 12)});
  ASSERT_TRUE(ready());
  EXPECT_TRUE(cuts().empty());
  EXPECT_TRUE(window->findChild<MessageBar*>(QStringLiteral("messageBar"))
                  ->sentence()
                  .contains(QStringLiteral("takes nothing away")));
  EXPECT_EQ(undo().count(), 0);
}

TEST_F(CutWindow, aCutIsNamedByF2AndKeepsItsNameInTheSession) {
  press(Qt::Key_X);
  draw(loop());
  ASSERT_TRUE(ready());
  const std::shared_ptr<const LabelMap> made = scene().keep.labels;
  list().setFocus();
  list().setCurrentRow(0);
  QTest::keyClick(&list(), Qt::Key_F2);
  auto* editor = list().findChild<QLineEdit*>();
  ASSERT_NE(editor, nullptr);
  EXPECT_TRUE(editor->text().isEmpty()) << "a name, not what it does";
  QTest::keyClicks(editor, QStringLiteral("the jaw"));
  QTest::keyClick(editor, Qt::Key_Return);
  ASSERT_TRUE(test::waitUntil([this] { return cuts().front().name == "the jaw"; }));
  EXPECT_EQ(list().item(0)->text(), QStringLiteral("1  the jaw"));
  EXPECT_EQ(scene().keep.labels, made) << "nothing is cut again";
  EXPECT_EQ(undo().undoText(), QStringLiteral("name cut 1"));
  saving().writeSession(pathTo("named.json"));
  ASSERT_TRUE(open(pathTo("named.json")));
  ASSERT_TRUE(ready());
  EXPECT_EQ(list().item(0)->text(), QStringLiteral("1  the jaw"));
  EXPECT_EQ(list().item(0)->toolTip(), QStringLiteral("Scissors, inside"));
}

TEST_F(CutWindow, aPieceLightsUpIsNarrowedByTheWheelAndHidden) {
  press(Qt::Key_K);
  EXPECT_FALSE(button(QStringLiteral("Hide")).isVisible());
  click({0, 0});
  ASSERT_TRUE(ready());
  ASSERT_TRUE(cutting().hasPiece());
  EXPECT_EQ(scene().keep, Region{}) << "what is lit is no edit";
  EXPECT_NE(view().scene().keep, scene().keep);
  EXPECT_FALSE(view().order().comparison.preview.empty());
  // Its range, its volume and the mean in it, as long as it is lit.
  const QRegularExpression extent(QStringLiteral("^−?\\d+ – −?\\d+.* · \\d+.* ml · mean −?\\d+"));
  const QString wide = bar().hint().replace(QChar(0xa0), QLatin1Char(' '));
  EXPECT_TRUE(extent.match(wide).hasMatch()) << wide.toStdString();
  EXPECT_FALSE(bar().findChild<QLabel*>()->visibleRegion().isEmpty());
  const Camera before = scene().camera;
  turnWheel(2);
  ASSERT_TRUE(ready());
  const QString narrow = bar().hint().replace(QChar(0xa0), QLatin1Char(' '));
  EXPECT_NE(narrow, wide);
  EXPECT_TRUE(extent.match(narrow).hasMatch()) << narrow.toStdString();
  EXPECT_EQ(scene().camera, before);
  ASSERT_TRUE(cutting().hasPiece());
  QTest::mouseClick(&button(QStringLiteral("Hide")), Qt::LeftButton);
  ASSERT_TRUE(ready());
  ASSERT_EQ(cuts().size(), 1u);
  const auto& piece = std::get<ConnectedPiece>(cuts().front().how);
  EXPECT_EQ(piece.fate, ConnectedPiece::Fate::hidden);
  const glm::dvec3 seed = worldToIndex(scene().volume->grid(), piece.seedMm);
  EXPECT_EQ(weightAt(scene().keep, glm::floor(seed + 0.5)), 0.0);
  EXPECT_EQ(view().scene().keep, scene().keep);
  EXPECT_TRUE(view().order().comparison.preview.empty());
  EXPECT_EQ(undo().undoText(), QStringLiteral("hide a piece"));
  turnWheel(1);
  EXPECT_NE(scene().camera, before) << "the wheel zooms again";
}

// Not all that hangs together: the values around the place, no farther than is chosen.
TEST_F(CutWindow, aPieceIsHeldToSimilarValuesAndToAReach) {
  press(Qt::Key_K);
  EXPECT_TRUE(bar().hint().contains(QStringLiteral("wheel"))) << bar().hint().toStdString();
  click({0, 0});
  ASSERT_TRUE(ready());
  ASSERT_TRUE(cutting().hasPiece());
  EXPECT_FALSE(bar().reachMm());
  const QPushButton& less = button(QStringLiteral("Less"));
  ASSERT_TRUE(less.isVisible() && less.menu());
  const auto choose = [&](const QString& text) {
    for (QAction* entry : less.menu()->actions())
      if (entry->text().replace(QChar(0xa0), QLatin1Char(' ')).startsWith(text))
        return entry->trigger();
    ADD_FAILURE() << "no entry " << text.toStdString();
  };
  choose(QStringLiteral("Within 5 mm"));
  ASSERT_TRUE(ready());
  EXPECT_EQ(bar().reachMm(), 5.0);
  turnWheel(1, Qt::ShiftModifier);
  ASSERT_TRUE(ready());
  choose(QStringLiteral("Values like"));
  ASSERT_TRUE(ready());
  // On and on: then it says why it goes no further.
  for (int turn = 0; turn < 12; ++turn) {
    turnWheel(10);
    ASSERT_TRUE(ready());
  }
  EXPECT_TRUE(bar().hint().contains(QStringLiteral("no narrower"))) << bar().hint().toStdString();
  QTest::mouseClick(&button(QStringLiteral("Hide")), Qt::LeftButton);
  ASSERT_TRUE(ready());
  ASSERT_EQ(cuts().size(), 1u);
  const auto& piece = std::get<ConnectedPiece>(cuts().front().how);
  EXPECT_EQ(piece.reachMm, 5.0);
  EXPECT_LT(piece.range.y, scene().volume->range().highest) << "it has an upper end of its own";
}

// A curve may go on beyond the values there are; a piece does not.
TEST_F(CutWindow, theRangeOfAPieceEndsWhereTheValuesDo) {
  const ValueRange values = scene().volume->range();
  ConnectedPiece piece;
  piece.range = {values.highest - 10.0, values.highest + 1000.0};
  EXPECT_EQ(foundRange(piece, *scene().volume), (ValueRange{values.highest - 10.0, values.highest}));
  const QString said = cutText({piece}, *scene().volume);
  EXPECT_TRUE(said.contains(plainNumber(values.highest, 0))) << said.toStdString();
}

// What it lies on may be what is to be cut.
TEST_F(CutWindow, theBarIsDraggedAwayAndComesBackToItsPlaceWithTheNextTool) {
  press(Qt::Key_X);
  ASSERT_TRUE(bar().isVisible());
  const QRect home = bar().geometry();
  const QPoint grip = bar().mapTo(window.get(), QPoint(3, home.height() / 2)); // beside its words
  QWindow* handle = window->windowHandle();
  QTest::mousePress(handle, Qt::LeftButton, {}, grip);
  for (int step = 1; step <= 5; ++step)
    QTest::mouseEvent(QTest::MouseMove, handle, Qt::NoButton, {}, grip - QPoint(0, 30 * step));
  QTest::mouseRelease(handle, Qt::LeftButton, {}, grip - QPoint(0, 150));
  EXPECT_EQ(bar().geometry().top(), home.top() - 150);
  EXPECT_TRUE(bar().isVisible());
  EXPECT_TRUE(cuts().empty()) << "no line was drawn";
  click({0, 0});
  QTest::keyClick(&view(), Qt::Key_Escape);
  QTest::keyClick(&view(), Qt::Key_Escape);
  ASSERT_FALSE(bar().isVisible());
  press(Qt::Key_X);
  EXPECT_EQ(bar().geometry(), home);
}

// A message that waits for an answer would hide what is said of a piece, and the buttons.
TEST_F(CutWindow, theBarStandsAboveAMessage) {
  const auto bottom = [this] { return bar().mapTo(window.get(), QPoint(0, bar().height())).y(); };
  const auto top = [this] { return messages().mapTo(window.get(), QPoint(0, 0)).y(); };
  press(Qt::Key_K);
  ASSERT_TRUE(bar().isVisible());
  const int alone = bottom();
  messages().show(MessageBar::Kind::question, QStringLiteral("Is it?"));
  EXPECT_TRUE(test::waitUntil([&] { return bottom() < alone; }));
  EXPECT_LT(bottom(), top());
  click({0, 0});
  ASSERT_TRUE(ready());
  EXPECT_TRUE(bar().isVisible());
  EXPECT_LT(bottom(), top()) << "also with a piece";
  messages().hide();
  EXPECT_TRUE(test::waitUntil([&] { return bottom() == alone; }));
}

TEST_F(CutWindow, aPieceThatIsGivenItsOwnCurveComesIntoTheCurvePanel) {
  const TransferFunction function = scene().transferFunction;
  press(Qt::Key_K);
  click({0, 0});
  ASSERT_TRUE(ready() && cutting().hasPiece());
  QTest::mouseClick(&button(QStringLiteral("Its own curve")), Qt::LeftButton);
  ASSERT_TRUE(ready());
  ASSERT_EQ(cuts().size(), 1u);
  EXPECT_EQ(undo().undoText(), QStringLiteral("give a piece its own curve"));
  EXPECT_EQ(weightInTheMiddle(), 1.0) << "nothing is taken away";
  ASSERT_EQ(scene().keep.looks.size(), 1u);
  EXPECT_EQ(scene().keep.looks[0], inOneColor(function, scene().keep.looks[0].points[0].color));
  EXPECT_NE(scene().keep.looks[0], function) << "it is told from the rest at once";
  TransferFunctionCanvas& canvas = *curves().valueEditor()->canvas();
  TransferFunction edited = function;
  for (ControlPoint& point : edited.points)
    point.color = {1.0, 0.0, 0.5};
  canvas.edit(edited, {nextGestureId(), QStringLiteral("change colour")});
  EXPECT_EQ(undo().undoText(), QStringLiteral("Piece 1: change colour"));
  EXPECT_EQ(scene().transferFunction, function);
  EXPECT_EQ(std::get<ConnectedPiece>(cuts().front().how).look, edited);
  EXPECT_EQ(scene().keep.looks, std::vector<TransferFunction>{edited});
  // Behind its curve stand its own values, not those into which it is grown.
  const double lowest = std::get<ConnectedPiece>(cuts().front().how).range.x;
  const auto isCounted =
      [&](double value) { // above the points on the axis, unlike where no histogram reaches
        const QRectF plot = canvas.transform().plot;
        const QImage shown = canvas.grab().toImage();
        const int x = qRound(xOfValue(canvas.transform(), value));
        return shown.pixelColor(x, qRound(plot.bottom()) - 14) !=
               shown.pixelColor(x, qRound(plot.top()) + 30);
      };
  TransferFunction clear = edited;
  for (ControlPoint& point : clear.points)
    point.opacity = 0.0;
  canvas.edit(clear, {nextGestureId(), QStringLiteral("clear it")});
  EXPECT_TRUE(test::waitUntil([&] { return !isCounted(lowest - 60.0) && isCounted(lowest + 300.0); }));
  undo().undo();
  // Sessions keep it, and a click in the list takes it in hand again.
  std::ofstream(folder.path() / "session.json") << sessionToJson(window->sessionDocument());
  ASSERT_TRUE(open(pathTo("session.json")) && ready());
  EXPECT_EQ(scene().keep.looks, std::vector<TransferFunction>{edited});
  EXPECT_EQ(canvas.transferFunction(), edited) << "whose curve was in hand when it was saved";
  emit curves().curveChosen(std::nullopt);
  EXPECT_EQ(canvas.transferFunction(), function);
  QListWidgetItem* row = list().item(0);
  EXPECT_TRUE(row->text().endsWith(QStringLiteral("own curve"))) << row->text().toStdString();
  QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, list().visualItemRect(row).center());
  EXPECT_EQ(canvas.transferFunction(), edited);
  // Switched off it shows as before, and its curve with it.
  row->setCheckState(Qt::Unchecked);
  ASSERT_TRUE(ready());
  EXPECT_TRUE(scene().keep.looks.empty());
  EXPECT_EQ(canvas.transferFunction(), function);
}

TEST_F(CutWindow, aPieceStaysLitWhileThePictureIsTurnedAndGoesOutWithTheTool) {
  press(Qt::Key_K);
  click({0, 0});
  ASSERT_TRUE(ready());
  const Camera before = scene().camera;
  draw({{0, 0}, {20, 0}, {40, 5}});
  EXPECT_NE(scene().camera, before);
  EXPECT_TRUE(cutting().hasPiece());
  EXPECT_NE(view().scene().keep, scene().keep);
  EXPECT_EQ(view().scene().camera, scene().camera);
  press(Qt::Key_Escape);
  EXPECT_FALSE(cutting().hasPiece());
  EXPECT_EQ(view().scene(), scene());
  EXPECT_EQ(undo().count(), 0);
}

TEST_F(CutWindow, theCutsOfTheVolumeBeforeAreOfferedOnTheSameGrid) {
  press(Qt::Key_X);
  draw(loop());
  ASSERT_TRUE(ready());
  ASSERT_EQ(cuts().size(), 1u);
  const auto offer = [this] { return window->findChild<MessageBar*>(QStringLiteral("messageBar")); };
  ASSERT_TRUE(open(QStringLiteral("phantom:7")));
  EXPECT_FALSE(offer()->sentence().contains(QStringLiteral("same grid")));
  EXPECT_TRUE(cuts().empty());
  press(Qt::Key_X);
  draw(loop());
  ASSERT_TRUE(ready());
  ASSERT_TRUE(open(QStringLiteral("phantom:7")));
  ASSERT_TRUE(offer()->isVisible());
  EXPECT_TRUE(offer()->sentence().contains(QStringLiteral("same grid"))) << offer()->sentence().toStdString();
  EXPECT_TRUE(cuts().empty()) << "it is offered, not done";
  for (QToolButton* button : offer()->findChildren<QToolButton*>())
    if (button->text() == QStringLiteral("Cut this one likewise"))
      button->click();
  ASSERT_TRUE(ready());
  ASSERT_EQ(cuts().size(), 1u);
  EXPECT_EQ(undo().undoText(), QStringLiteral("cuts of the volume before"));
  EXPECT_FALSE(offer()->isVisible());
}

TEST_F(CutWindow, whereNothingIsSeenThereIsNoPiece) {
  press(Qt::Key_K);
  click({-static_cast<int>(view().logicalRect(0).width() / 2) + 4, 0});
  ASSERT_TRUE(ready());
  EXPECT_FALSE(cutting().hasPiece());
  EXPECT_EQ(window->statusBar()->currentMessage(), QStringLiteral("Nothing is seen there."));
}

// A cut that takes nothing in its new place says so; its mark in the list alone would promise more.
TEST_F(CutWindow, aPieceWhosePlaceIsCutAwayBeforeItSaysSo) {
  press(Qt::Key_K);
  click({0, 0});
  ASSERT_TRUE(ready());
  button(QStringLiteral("Only this")).click();
  ASSERT_TRUE(ready());
  press(Qt::Key_X);
  draw(loop());
  ASSERT_TRUE(ready());
  ASSERT_EQ(cuts().size(), 2u);
  window->findChild<MessageBar*>()->hide();
  list().setCurrentRow(0);
  for (QPushButton* button : window->findChild<CutSection*>()->findChildren<QPushButton*>())
    if (button->text() == QStringLiteral("Down"))
      button->click();
  ASSERT_TRUE(ready());
  ASSERT_TRUE(std::holds_alternative<ConnectedPiece>(cuts()[1].how));
  EXPECT_TRUE(messages().sentence().startsWith(QStringLiteral("Cut 2 finds no piece")))
      << messages().sentence().toStdString();
}

TEST_F(CutWindow, theScissorsDrawOverWhatStandsAboveThePicture) {
  press(Qt::Key_X);
  const QPointF plate = labelsOf({view().order(), view().pictureState()}).front().plate.center();
  QTest::mouseClick(window->windowHandle(), Qt::LeftButton, {}, view().mapTo(window.get(), plate.toPoint()));
  EXPECT_EQ(QApplication::activePopupWidget(), nullptr);
  ASSERT_TRUE(view().input().cutLine());
  EXPECT_EQ(view().input().cutLine()->corners.size(), 1u);
}

// Nobody means to cut what they have just opened.
TEST_F(CutWindow, theToolIsLaidDownWhenAnotherVolumeIsOpened) {
  press(Qt::Key_X);
  button(QStringLiteral("Outside")).click();
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  EXPECT_EQ(view().tool(), ViewTool::rotate);
  EXPECT_FALSE(bar().isVisible());
  press(Qt::Key_X);
  EXPECT_TRUE(button(QStringLiteral("Inside")).isChecked());
}

TEST_F(CutWindow, theListSwitchesMovesAndDeletes) {
  press(Qt::Key_X);
  draw(loop());
  ASSERT_TRUE(ready());
  draw({{-120, -20}, {-80, -20}, {-80, 20}, {-120, 20}});
  ASSERT_TRUE(ready());
  ASSERT_EQ(list().count(), 2);
  EXPECT_EQ(list().currentRow(), 1) << "Delete means what was made last";
  list().item(0)->setCheckState(Qt::Unchecked);
  ASSERT_TRUE(ready());
  EXPECT_FALSE(cuts()[0].isOn);
  EXPECT_EQ(weightInTheMiddle(), 1.0);
  EXPECT_EQ(undo().undoText(), QStringLiteral("switch cut 1 off"));
  list().setCurrentRow(0);
  const std::vector<Cut> before = cuts();
  const auto section = window->findChild<CutSection*>();
  const auto buttonOf = [&](const QString& text) -> QPushButton& {
    for (QPushButton* button : section->findChildren<QPushButton*>())
      if (button->text() == text)
        return *button;
    throw std::runtime_error("no such button");
  };
  buttonOf(QStringLiteral("Down")).click();
  ASSERT_TRUE(ready());
  EXPECT_EQ(cuts()[1], before[0]);
  EXPECT_EQ(list().currentRow(), 1);
  buttonOf(QStringLiteral("Delete")).click();
  ASSERT_TRUE(ready());
  EXPECT_EQ(cuts(), (std::vector<Cut>{before[1]}));
  buttonOf(QStringLiteral("Delete")).click();
  ASSERT_TRUE(ready());
  EXPECT_EQ(scene().keep, Region{});
  EXPECT_EQ(list().count(), 0);
}

TEST_F(CutWindow, theNoteShowsEverythingAndTheCutsStayInTheirList) {
  press(Qt::Key_X);
  draw(loop());
  ASSERT_TRUE(ready());
  press(Qt::Key_Escape);
  ASSERT_TRUE(rest());
  std::optional<QPoint> note;
  for (const HiddenNote& hidden : hiddenNotesOf({view().order(), view().pictureState()}))
    if (hidden.by == HiddenBy::region)
      note = view().mapTo(window.get(), hidden.note.plate.center().toPoint());
  ASSERT_TRUE(note);
  QTest::mouseClick(window->windowHandle(), Qt::LeftButton, {}, *note);
  ASSERT_TRUE(ready());
  EXPECT_FALSE(isRestricting(scene().keep));
  ASSERT_EQ(cuts().size(), 1u);
  EXPECT_FALSE(cuts().front().isOn);
  EXPECT_EQ(weightInTheMiddle(), 1.0);
}

TEST_F(CutWindow, cutsHoldWhenOtherThingsAreKeptAndComeBackWithTheSession) {
  press(Qt::Key_X);
  draw(loop());
  ASSERT_TRUE(ready());
  window->findChild<QAction*>(QStringLiteral("bodyOnly"))->trigger();
  ASSERT_TRUE(ready());
  EXPECT_EQ(scene().keep.kind, Region::Kind::body);
  EXPECT_EQ(cuts().size(), 1u);
  EXPECT_EQ(weightInTheMiddle(), 0.0);
  const Region both = scene().keep; // the note brings back what was cut first, then what Body only hides
  emit view().findChild<ViewInput*>()->everythingRequested();
  ASSERT_TRUE(ready());
  EXPECT_EQ(scene().keep.kind, Region::Kind::body);
  EXPECT_FALSE(cuts().front().isOn);
  EXPECT_EQ(undo().undoText(), QStringLiteral("show what was cut away"));
  emit view().findChild<ViewInput*>()->everythingRequested();
  ASSERT_TRUE(ready());
  EXPECT_EQ(scene().keep.kind, Region::Kind::all);
  EXPECT_EQ(undo().undoText(), QStringLiteral("show everything"));
  undo().undo();
  undo().undo();
  EXPECT_EQ(scene().keep.weights, both.weights);
  typeName(pathTo("cut.limn"));
  window->findChild<QAction*>(QStringLiteral("saveSession"))->trigger();
  ASSERT_TRUE(test::waitUntil([this] { return QFile::exists(pathTo("cut.limn")); }));
  const std::vector<Cut> before = cuts();
  const Region kept = scene().keep;
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  EXPECT_TRUE(cuts().empty());
  ASSERT_TRUE(open(pathTo("cut.limn")));
  EXPECT_EQ(cuts(), before);
  EXPECT_EQ(scene().keep.weights, kept.weights);
  EXPECT_EQ(weightInTheMiddle(), 0.0);
}

} // namespace
} // namespace limn
