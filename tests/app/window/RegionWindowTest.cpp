// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/picture/RegionController.h"
#include "app/picture/TurnedBoxController.h"
#include "support/ShortVolume.h"
#include "widgets/properties/LabelSection.h"
#include "widgets/view/overlay/CropBoxOverlay.h"
#include "widgets/view/overlay/Titles.h"

#include <QDragEnterEvent>
#include <QMimeData>
#include <QTreeView>

#include <algorithm>
#include <filesystem>
#include <fstream>

// What is kept of a volume, in the program's window.

namespace limn {
namespace {

namespace fs = std::filesystem;

constexpr int size = 40;

class RegionWindow : public test::WindowHarness {
protected:
  void SetUp() override {
    WindowHarness::SetUp();
    // A ball of tissue with a core of bone on a table, in air: Hounsfield units by their range.
    write("head.nrrd", [](const glm::ivec3& v) {
      const double radius = glm::length(glm::dvec3(v) - 18.0);
      return radius < 6.0                                      ? 1200
             : radius < 13.0                                   ? 40
             : v.y >= 34 && v.y < 37 && std::abs(v.x - 18) < 8 ? 200
                                                               : -1000;
    });
    write("bone.seg.nrrd",
          [](const glm::ivec3& v) { return glm::length(glm::dvec3(v) - 18.0) < 6.0 ? 7 : 0; });
  }

  template <class Value>
  void write(const char* name, const Value& value) {
    test::writeShorts(folder.path() / name, size, value);
  }

  QAction& bodyOnly() { return *window->findChild<QAction*>(QStringLiteral("bodyOnly")); }
  RegionController& controller() { return *window->findChild<RegionController*>(); }
  [[nodiscard]] bool ready() {
    return test::waitUntil([this] { return !controller().isBusy(); });
  }

  // The middle of the note in the picture that tells what hides, in the window's pixels.
  QPoint note(HiddenBy by) {
    for (const HiddenNote& hidden : hiddenNotesOf({view().order(), view().pictureState()}))
      if (hidden.by == by)
        return view().mapTo(window.get(), hidden.note.plate.center().toPoint());
    ADD_FAILURE() << "no such note";
    return {};
  }

  // All of the head, from such a side and, by its scale, so small that a box around it is seen, too.
  [[nodiscard]] bool showHeadObliquely(double scale = 0.3) {
    if (!open(pathTo("head.nrrd")))
      return false;
    setLayout(CompareLayout::single);
    bodyOnly().trigger(); // all is kept
    session().setCamera(zoomed(orbited(scene().camera, 0.5, 0.4), scale));
    return rest();
  }
  void turnBox() { window->findChild<QAction*>(QStringLiteral("turnCropBox"))->trigger(); }
  void expectBox(const TurnedBox& box, const char* when) const {
    ASSERT_TRUE(turned) << when;
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(turned->crop.lower[axis], box.crop.lower[axis], 1e-9) << when; // of a box found again
      EXPECT_NEAR(turned->crop.upper[axis], box.crop.upper[axis], 1e-9) << when;
      EXPECT_NEAR(glm::length(turned->grid.direction[axis] - box.grid.direction[axis]), 0.0, 1e-9) << when;
    }
  }

  const std::optional<TurnedBox>& turned = window->view().order().comparison.turnedBox;

  // By its handle, so many of the window's pixels, in the first picture.
  void dragFace(const CropFace& face, const QPoint& by) {
    const TurnedBox box = boxOver(view().order().comparison);
    const CropBoxShape shape =
        cropBoxShape(box.crop, box.grid, viewProjection(scene().camera, view().logicalRect(0)));
    const auto grip =
        std::ranges::find_if(shape.handles, [&](const CropHandle& handle) { return handle.face == face; });
    ASSERT_NE(grip, shape.handles.end());
    const QPoint from = view().mapTo(window.get(), grip->centre.toPoint());
    QWindow* handle = window->windowHandle();
    QTest::mousePress(handle, Qt::LeftButton, {}, from);
    for (int step = 1; step <= 6; ++step)
      QTest::mouseEvent(QTest::MouseMove, handle, Qt::NoButton, {}, from + by * step / 6);
    QTest::mouseRelease(handle, Qt::LeftButton, {}, from + by);
    QCoreApplication::processEvents();
  }

  void drop(const QString& path) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(path)});
    QDragEnterEvent enter({100, 100}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(window.get(), &enter);
    QDropEvent event({100, 100}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(window.get(), &event);
  }
};

TEST_F(RegionWindow, theTableIsHiddenOnOpeningAndOneClickShowsItAgain) {
  ASSERT_TRUE(open(pathTo("head.nrrd")));
  EXPECT_EQ(scene().keep.kind, Region::Kind::body);
  EXPECT_TRUE(bodyOnly().isChecked());
  EXPECT_EQ(weightAt(scene().keep, {18, 35, 18}), 0.0);
  EXPECT_EQ(weightAt(scene().keep, {18, 18, 18}), 1.0);
  EXPECT_FALSE(window->isWindowModified()) << "what the program did by itself is no edit";
  setLayout(CompareLayout::single);
  ASSERT_TRUE(rest());
  QTest::mouseClick(window->windowHandle(), Qt::LeftButton, {}, note(HiddenBy::region));
  EXPECT_EQ(scene().keep, Region{});
  EXPECT_FALSE(bodyOnly().isChecked());
  EXPECT_EQ(undo().undoText(), QStringLiteral("show everything"));
  undo().undo();
  EXPECT_EQ(scene().keep.kind, Region::Kind::body);
  EXPECT_TRUE(bodyOnly().isChecked());
}

// A table that is as much tissue as the body makes it doubtful which of both is the body.
TEST_F(RegionWindow, whereTheBodyIsInDoubtHidingTheTableIsAskedFor) {
  write("doubtful.nrrd", [](const glm::ivec3& v) {
    const double radius = glm::length(glm::dvec3(v) - glm::dvec3(18.0, 15.0, 18.0));
    return radius < 6.0 ? 1200 : radius < 13.0 ? 40 : v.y >= 33 && v.y < 38 ? 200 : -1000;
  });
  const QString question =
      QStringLiteral("Hide the table and the holder? It is not certain which part is the body.");
  const auto answer = [this](const QString& text) {
    for (QToolButton* button : messages().findChildren<QToolButton*>())
      if (button->isVisible() && button->text() == text)
        return QTest::mouseClick(button, Qt::LeftButton);
    ADD_FAILURE() << "nothing says " << text.toStdString();
  };
  const auto isAsked = [&] {
    return test::waitUntil([&] { return messages().isVisible() && messages().sentence() == question; });
  };
  ASSERT_TRUE(open(pathTo("doubtful.nrrd")));
  EXPECT_EQ(scene().keep, Region{}) << "nothing is hidden unasked";
  ASSERT_TRUE(isAsked());
  answer(QStringLiteral("Leave them"));
  EXPECT_FALSE(messages().isVisible());
  EXPECT_EQ(scene().keep, Region{});
  EXPECT_EQ(undo().count(), 0);

  ASSERT_TRUE(open(pathTo("doubtful.nrrd")));
  ASSERT_TRUE(isAsked());
  answer(QStringLiteral("Hide them"));
  EXPECT_FALSE(messages().isVisible());
  EXPECT_EQ(scene().keep.kind, Region::Kind::body);
  EXPECT_EQ(weightAt(scene().keep, {18, 35, 18}), 0.0) << "the table";
  EXPECT_EQ(weightAt(scene().keep, {18, 15, 18}), 1.0) << "the body";
  EXPECT_TRUE(bodyOnly().isChecked());
  EXPECT_EQ(undo().undoText(), QStringLiteral("body only"));
  undo().undo();
  EXPECT_EQ(scene().keep, Region{});

  ASSERT_TRUE(open(pathTo("doubtful.nrrd")));
  ASSERT_TRUE(isAsked());
  ASSERT_TRUE(open(pathTo("head.nrrd")));
  EXPECT_FALSE(messages().isVisible() && messages().sentence() == question) << "of the volume before";
}

// A question that waited behind something else comes as long as it matters, and no longer.
TEST_F(RegionWindow, aQuestionAboutTheTableThatIsLateIsNotAsked) {
  write("doubtful.nrrd", [](const glm::ivec3& v) {
    const double radius = glm::length(glm::dvec3(v) - glm::dvec3(18.0, 15.0, 18.0));
    return radius < 6.0 ? 1200 : radius < 13.0 ? 40 : v.y >= 33 && v.y < 38 ? 200 : -1000;
  });
  const auto isAsked = [this] {
    return messages().isVisible() && messages().sentence().startsWith(QStringLiteral("Hide the table"));
  };
  const auto afterAnother = [&](int asksForMs) {
    controller().offers().setAsksFor(asksForMs);
    EXPECT_TRUE(open(pathTo("doubtful.nrrd")));
    messages().show(MessageBar::Kind::warning, QStringLiteral("Something else"));
    EXPECT_TRUE(test::waitUntil([&] { return !controller().offers().isOffering(); }));
    messages().hide();
    for (int turn = 0; turn < 5; ++turn)
      QCoreApplication::processEvents();
    return isAsked();
  };
  EXPECT_TRUE(afterAnother(60000));
  messages().hide();
  EXPECT_FALSE(afterAnother(0));
}

TEST_F(RegionWindow, aCropIsToldWithItsBoxHiddenAndEachNoteTakesBackWhatItTells) {
  ASSERT_TRUE(openAlone(pathTo("head.nrrd")));
  CropBox crop;
  crop.upper.z = 0.6;
  session().setCrop(crop, {nextGestureId(), QStringLiteral("crop")});
  EXPECT_FALSE(view().cropBoxIsVisible());
  ASSERT_TRUE(rest());
  QTest::mouseClick(window->windowHandle(), Qt::LeftButton, {}, note(HiddenBy::crop));
  EXPECT_EQ(scene().crop, CropBox{});
  EXPECT_EQ(scene().keep.kind, Region::Kind::body);
  EXPECT_EQ(undo().undoText(), QStringLiteral("reset crop"));
  undo().undo();
  EXPECT_EQ(scene().crop, crop);
  ASSERT_TRUE(rest());
  QTest::mouseClick(window->windowHandle(), Qt::LeftButton, {}, note(HiddenBy::region));
  EXPECT_EQ(scene().keep, Region{});
  EXPECT_EQ(scene().crop, crop) << "the table alone";
}

TEST_F(RegionWindow, theActionHidesAndShowsTheTableInOneUndoStepEach) {
  ASSERT_TRUE(open(pathTo("head.nrrd")));
  const Region body = scene().keep;
  bodyOnly().trigger();
  EXPECT_EQ(scene().keep, Region{});
  bodyOnly().trigger();
  EXPECT_FALSE(controller().isBusy()) << "it is known already";
  EXPECT_EQ(scene().keep, body);
  EXPECT_EQ(undo().count(), 2);
}

TEST_F(RegionWindow, aBodyIsFoundWhereOneIsAskedFor) {
  ASSERT_TRUE(open(QStringLiteral("phantom:4")));
  EXPECT_EQ(scene().keep, Region{}) << "nothing lies beside the phantom";
  bodyOnly().trigger();
  ASSERT_TRUE(ready());
  EXPECT_EQ(scene().keep.kind, Region::Kind::body);
  EXPECT_EQ(undo().undoText(), QStringLiteral("body only"));
}

TEST_F(RegionWindow, anotherVolumeEndsTheSearch) {
  ASSERT_TRUE(open(QStringLiteral("phantom:2")));
  bodyOnly().trigger();
  ASSERT_TRUE(open(pathTo("head.nrrd")));
  ASSERT_TRUE(ready());
  ASSERT_TRUE(rest());
  EXPECT_EQ(scene().keep.labels->dims(), glm::ivec3(size));
  EXPECT_EQ(undo().count(), 0);
}

TEST_F(RegionWindow, labelsOpenBesideTheVolumeAndStayInTheSession) {
  ASSERT_TRUE(open(pathTo("head.nrrd")));
  drop(pathTo("bone.seg.nrrd"));
  ASSERT_TRUE(ready());
  ASSERT_EQ(scene().keep.kind, Region::Kind::labels);
  EXPECT_EQ(undo().undoText(), QStringLiteral("open labels bone.seg.nrrd"));
  EXPECT_TRUE(bodyOnly().isChecked()) << "the table stays hidden";
  const QAbstractItemModel* rows = window->findChild<LabelSection*>()->findChild<QTreeView*>()->model();
  EXPECT_TRUE(test::waitUntil([&] {
    return rows->data(rows->index(1, 0), Qt::ToolTipRole).toString().contains(QStringLiteral("ml ·"));
  })) << "its size and values are found beside the event loop";
  Region faded = scene().keep;
  faded.weights[1] = 0.5;
  session().setKeep(faded, {nextGestureId(), QStringLiteral("fade")});
  const SessionDocument kept = window->sessionDocument();
  EXPECT_EQ(
      kept.scene.keep,
      (KeptPart{Region::Kind::labels, pathTo("bone.seg.nrrd").toStdString(), {{7, 0.5}}, {}, {}, true}));
  std::ofstream(folder.path() / "session.json") << sessionToJson(kept);
  ASSERT_TRUE(open(pathTo("session.json")));
  EXPECT_EQ(scene().keep.weights, (std::vector<double>{1.0, 0.5, 0.0})) << "the last is the table";
}

TEST_F(RegionWindow, theTableStaysHiddenWhenLabelsOpenAndBodyOnlyHidesAndShowsIt) {
  ASSERT_TRUE(open(pathTo("head.nrrd")));
  const Region body = scene().keep;
  ASSERT_EQ(body.kind, Region::Kind::body);
  drop(pathTo("bone.seg.nrrd"));
  ASSERT_TRUE(ready());
  const Region labels = scene().keep;
  ASSERT_EQ(labels.kind, Region::Kind::labels);
  EXPECT_TRUE(bodyOnly().isChecked());
  EXPECT_FALSE(messages().isVisible()) << "nothing gave way";
  // Every voxel weighs what body and labels weigh together: labels weigh 1 at first.
  const auto weighsAsBody = [&](const Region& region, double beside) {
    int wrong = 0;
    for (std::size_t n = 0; n < static_cast<std::size_t>(size * size * size); ++n) {
      const double kept = body.weights[body.labels->placeAt(n)];
      wrong += region.weights[region.labels->placeAt(n)] != (kept > 0.0 ? 1.0 : beside);
    }
    return wrong;
  };
  EXPECT_EQ(weighsAsBody(labels, 0.0), 0);
  const QAbstractItemModel* rows = window->findChild<LabelSection*>()->findChild<QTreeView*>()->model();
  EXPECT_EQ(rows->rowCount(), 2) << "the file's labels alone are listed";
  bodyOnly().trigger();
  ASSERT_TRUE(ready());
  EXPECT_EQ(weighsAsBody(scene().keep, 1.0), 0);
  EXPECT_FALSE(bodyOnly().isChecked());
  bodyOnly().trigger();
  ASSERT_TRUE(ready());
  EXPECT_EQ(scene().keep, labels);
  // A session has both.
  std::ofstream(folder.path() / "session.json") << sessionToJson(window->sessionDocument());
  ASSERT_TRUE(open(pathTo("session.json")));
  EXPECT_EQ(scene().keep.kind, Region::Kind::labels);
  EXPECT_TRUE(bodyOnly().isChecked());
  EXPECT_EQ(weighsAsBody(scene().keep, 0.0), 0);
}

TEST_F(RegionWindow, theCropBoxBeginsAroundTheBodyAndLeavesNoTraceWhereNobodyMovesIt) {
  ASSERT_TRUE(open(pathTo("head.nrrd")));
  QAction& cropBox = *window->findChild<QAction*>(QStringLiteral("cropBox"));
  cropBox.trigger();
  const CropBox around = scene().crop;
  // The ball reaches 12 voxels around voxel 18; the body has two more of what is not tissue, the box one
  // more.
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(around.lower[axis], (18.0 - 12.0 - 3.0) / size, 1e-12);
    EXPECT_NEAR(around.upper[axis], (18.0 + 12.0 + 3.0 + 1.0) / size, 1e-12);
  }
  EXPECT_EQ(undo().count(), 1);
  cropBox.trigger();
  EXPECT_EQ(scene().crop, CropBox{});
  EXPECT_EQ(undo().count(), 0);
  cropBox.trigger();
  CropBox moved = around;
  moved.lower.x = 0.5;
  session().setCrop(moved, {nextGestureId(), QStringLiteral("move")});
  cropBox.trigger();
  EXPECT_EQ(scene().crop, moved) << "what somebody moved stays";
  cropBox.trigger();
  EXPECT_EQ(scene().crop, moved);
}

TEST_F(RegionWindow, undoOfTheBoxAroundTheBodyPutsItAwayAndRedoBringsItBack) {
  ASSERT_TRUE(open(pathTo("head.nrrd")));
  QAction& cropBox = *window->findChild<QAction*>(QStringLiteral("cropBox"));
  cropBox.trigger();
  const CropBox around = scene().crop;
  ASSERT_NE(around, CropBox{});
  undo().undo();
  EXPECT_FALSE(cropBox.isChecked());
  EXPECT_FALSE(view().cropBoxIsVisible());
  EXPECT_EQ(scene().crop, CropBox{});
  undo().redo();
  EXPECT_TRUE(cropBox.isChecked());
  EXPECT_TRUE(view().cropBoxIsVisible());
  EXPECT_EQ(scene().crop, around);
  // A step after it is another matter, and one in its place leaves the box away.
  session().setCrop({}, {nextGestureId(), QStringLiteral("reset")});
  EXPECT_TRUE(cropBox.isChecked()) << "nothing was undone";
  undo().undo();
  EXPECT_TRUE(cropBox.isChecked());
  undo().undo();
  Scene other = scene();
  other.shading.exponent += 1.0;
  session().edit(other, {nextGestureId(), "shine"});
  EXPECT_FALSE(cropBox.isChecked());
}

// A note that something is cut off is of use only where something is.
TEST_F(RegionWindow, croppedIsSaidOnlyWhereSomethingSeenIsCutAway) {
  ASSERT_TRUE(openAlone(pathTo("head.nrrd")));
  ASSERT_TRUE(rest());
  const auto saysCropped = [this] {
    const std::vector<HiddenNote> notes = hiddenNotesOf({view().order(), view().pictureState()});
    return std::ranges::any_of(notes, [](const HiddenNote& note) { return note.by == HiddenBy::crop; });
  };
  window->findChild<QAction*>(QStringLiteral("cropBox"))->trigger();
  const CropBox around = scene().crop;
  ASSERT_NE(around, CropBox{});
  ASSERT_TRUE(rest());
  EXPECT_FALSE(saysCropped()) << "around the body it takes air alone";
  CropBox half = around;
  half.lower.x = 0.5;
  session().setCrop(half, {nextGestureId(), QStringLiteral("half")});
  EXPECT_TRUE(test::waitUntil(saysCropped));
  session().setCrop(around, {nextGestureId(), QStringLiteral("all")});
  EXPECT_TRUE(test::waitUntil([&] { return !saysCropped(); }));
  // Everything is shown again: the table lies outside.
  bodyOnly().trigger();
  EXPECT_TRUE(test::waitUntil(saysCropped));
}

TEST_F(RegionWindow, aCropThatTakesNothingOfTheBodyIsPutAwayWithoutAWord) {
  ASSERT_TRUE(openAlone(pathTo("head.nrrd")));
  QAction& box = *window->findChild<QAction*>(QStringLiteral("cropBox"));
  const auto saysWhatStays = [this] {
    return messages().isVisible() && messages().sentence().contains(QStringLiteral("what its faces cut"));
  };
  box.trigger();
  CropBox crop = scene().crop;
  ASSERT_NE(crop, CropBox{}) << "around the body";
  crop.upper.z = 0.5;
  session().setCrop(crop, {nextGestureId(), QStringLiteral("cut")});
  box.trigger();
  EXPECT_TRUE(saysWhatStays());
  box.trigger();
  crop.upper.z = 1.0; // where a double click on its handle puts the face
  session().setCrop(crop, {nextGestureId(), QStringLiteral("reset")});
  box.trigger();
  EXPECT_FALSE(saysWhatStays());
}

TEST_F(RegionWindow, theCropBoxTurnsToTheViewAndWhatItsFacesCutAreCuts) {
  ASSERT_TRUE(showHeadObliquely());
  const int steps = undo().count();
  turnBox();
  ASSERT_TRUE(turned);
  EXPECT_TRUE(view().cropBoxIsVisible());
  EXPECT_EQ(undo().count(), steps) << "it takes nothing away yet";
  const CameraBasis basis = basisOf(scene().camera);
  EXPECT_NEAR(glm::length(turned->grid.direction[0] - basis.right), 0.0, 1e-12);
  EXPECT_NEAR(glm::length(turned->grid.direction[2] - basis.up), 0.0, 1e-12);

  // Its upper face is dragged 60 pixels down.
  dragFace({2, true}, {0, 60});
  ASSERT_TRUE(ready());
  ASSERT_TRUE(turned);
  ASSERT_EQ(scene().keep.cuts.size(), 1u) << "one line says what one face cuts";
  EXPECT_EQ(scene().keep.cuts[0].name, "Turned box, four sides");
  EXPECT_EQ(undo().count(), steps + 1) << "one drag";
  EXPECT_LT(turned->crop.upper.z, 1.0);
  CropBox cutting; // faces that nobody moved leave what lies outside, though nothing of it is seen
  cutting.upper.z = turned->crop.upper.z;
  const Grid& grid = scene().volume->grid();
  int gone = 0, wrong = 0;
  for (int k = 0; k < size; ++k)
    for (int j = 0; j < size; ++j)
      for (int i = 0; i < size; ++i) {
        const glm::dvec3 at =
            (worldToIndex(turned->grid, indexToWorld(grid, {i, j, k})) + 0.5) / glm::dvec3(turned->grid.dims);
        // Places on a face may fall to either side by rounding.
        const bool isInside = glm::all(glm::greaterThan(at, cutting.lower - 1e-9)) &&
                              glm::all(glm::lessThan(at, cutting.upper + 1e-9));
        const bool isOnFace = glm::any(glm::lessThan(glm::abs(at - cutting.lower), glm::dvec3(1e-6))) ||
                              glm::any(glm::lessThan(glm::abs(at - cutting.upper), glm::dvec3(1e-6)));
        const bool isKept = weightAt(scene().keep, {i, j, k}) > 0.0;
        gone += !isKept;
        wrong += !isOnFace && isKept != isInside;
      }
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(gone, 1000);
  EXPECT_LT(gone, size * size * size - 1000);
  undo().undo();
  EXPECT_TRUE(scene().keep.cuts.empty());
  EXPECT_FALSE(turned) << "the box is the crop's again";
}

// Around a head that fills the picture its sides lie beyond the edges, and are seen there from within.
TEST_F(RegionWindow, aTurnedBoxThatIsLargerThanThePictureIsHeldWhereItsSidesAreSeen) {
  ASSERT_TRUE(showHeadObliquely(1.0));
  turnBox();
  ASSERT_TRUE(turned);
  const QRectF picture = view().logicalRect(0);
  const ViewProjection projection = viewProjection(scene().camera, picture);
  int beyond = 0;
  for (const CropHandle& handle : cropBoxShape(turned->crop, turned->grid, projection).handles) {
    EXPECT_TRUE(picture.adjusted(11.9, 11.9, -11.9, -11.9).contains(handle.centre))
        << handle.face.axis << handle.face.isUpper;
    beyond += !picture.contains(*pixelOf(projection, faceCentre(turned->crop, turned->grid, handle.face)));
  }
  EXPECT_GE(beyond, 1) << "or nothing is tried";
  dragFace({2, false}, {0, -60});
  ASSERT_TRUE(ready());
  EXPECT_EQ(scene().keep.cuts.size(), 1u);
  EXPECT_GT(turned.value().crop.lower.z, 0.0);
}

TEST_F(RegionWindow, aTurnedBoxThatUndoHasEndedComesBackWithRedo) {
  ASSERT_TRUE(showHeadObliquely());
  turnBox();
  dragFace({2, true}, {0, 60});
  ASSERT_TRUE(ready());
  const TurnedBox cut = turned.value();
  undo().undo();
  ASSERT_TRUE(ready());
  ASSERT_FALSE(turned) << "the box is the crop's again";
  undo().redo();
  ASSERT_TRUE(ready());
  expectBox(cut, "and forth again");
  // Put away it stays so.
  window->findChild<QAction*>(QStringLiteral("cropBox"))->trigger();
  undo().undo();
  undo().redo();
  ASSERT_TRUE(ready());
  EXPECT_FALSE(turned);
  EXPECT_FALSE(view().cropBoxIsVisible());
}

TEST_F(RegionWindow, theLinesOfATurnedBoxAreToldApartInTheList) {
  ASSERT_TRUE(open(pathTo("head.nrrd")));
  TurnedBox box = boxTurnedTo(orbited(scene().camera, 0.5, 0.4), scene());
  box.crop = {glm::dvec3(0.4), glm::dvec3(0.6)}; // within the body
  window->findChild<RegionController*>()->setCuts(cutsOf(box), QStringLiteral("box"));
  ASSERT_TRUE(ready());
  ASSERT_EQ(scene().keep.cuts.size(), 2u);
  EXPECT_EQ(scene().keep.cuts[0].name, "Turned box, four sides");
  EXPECT_EQ(scene().keep.cuts[1].name, "Turned box, front and back");
}

// It is kept as lines, so it is found again in them: by undo, once it was put away, in a session.
TEST_F(RegionWindow, aTurnedBoxComesBackAsLongAsItsCutsAreTheLast) {
  ASSERT_TRUE(showHeadObliquely());
  turnBox();
  dragFace({2, true}, {0, 60});
  ASSERT_TRUE(ready());
  ASSERT_EQ(scene().keep.cuts.size(), 1u);
  const TurnedBox once = turned.value();
  dragFace({0, false}, {50, 0});
  ASSERT_TRUE(ready());
  const TurnedBox twice = turned.value();
  ASSERT_NE(once.crop, twice.crop);
  undo().undo();
  ASSERT_TRUE(ready());
  expectBox(once, "one step back");
  undo().redo();
  ASSERT_TRUE(ready());
  expectBox(twice, "and forth again");

  QAction& cropBox = *window->findChild<QAction*>(QStringLiteral("cropBox"));
  const CropBox crop = scene().crop;
  cropBox.trigger();
  EXPECT_FALSE(turned);
  cropBox.trigger();
  expectBox(twice, "put away and shown again");
  EXPECT_EQ(scene().crop, crop) << "no box around the body is begun beside it";

  std::ofstream(folder.path() / "session.json") << sessionToJson(window->sessionDocument());
  ASSERT_TRUE(open(pathTo("session.json")));
  ASSERT_TRUE(rest());
  expectBox(twice, "in a session");
  const std::size_t cuts = scene().keep.cuts.size();
  dragFace({2, true}, {0, 10});
  ASSERT_TRUE(ready());
  EXPECT_EQ(scene().keep.cuts.size(), cuts) << "a drag goes on with its lines";
  EXPECT_LT(turned.value().crop.upper.z, twice.crop.upper.z);

  // Another cut behind it ends it.
  std::vector<Cut> more = scene().keep.cuts;
  std::optional<glm::ivec3> left; // of the bone in the middle
  for (int z = 12; z < 25; ++z)
    for (int y = 12; y < 25; ++y)
      for (int x = 12; x < 25; ++x)
        if (valueAt(*scene().volume, {x, y, z}) >= 1000.0 && weightAt(scene().keep, {x, y, z}) > 0.0)
          left = glm::ivec3(x, y, z);
  ASSERT_TRUE(left);
  more.push_back({ConnectedPiece{indexToWorld(scene().volume->grid(), glm::dvec3(*left)), {1000.0, 1300.0}}});
  window->findChild<RegionController*>()->setCuts(more, QStringLiteral("piece"));
  ASSERT_TRUE(ready());
  EXPECT_FALSE(turned);
}

TEST_F(RegionWindow, bodyOnlyIsAskedForBesideLabelsThatAreOpen) {
  ASSERT_TRUE(open(pathTo("head.nrrd")));
  const Region body = scene().keep;
  bodyOnly().trigger();
  drop(pathTo("bone.seg.nrrd"));
  ASSERT_TRUE(ready());
  EXPECT_FALSE(bodyOnly().isChecked());
  EXPECT_FALSE(isRestricting(scene().keep));
  bodyOnly().trigger();
  ASSERT_TRUE(ready());
  EXPECT_EQ(scene().keep.kind, Region::Kind::labels);
  EXPECT_TRUE(isRestricting(scene().keep));
  EXPECT_TRUE(bodyOnly().isChecked());
}

TEST_F(RegionWindow, aFolderOfPicturesIsOfferedAsAVolume) {
  ASSERT_TRUE(open(pathTo("head.nrrd")));
  const fs::path pictures = folder.path() / "pictures";
  fs::create_directory(pictures);
  fs::copy_file(folder.path() / "head.nrrd", pictures / "first.nrrd");
  drop(pathTo("pictures"));
  ASSERT_TRUE(ready());
  QToolButton* offered = nullptr;
  for (QToolButton* button : messages().findChildren<QToolButton*>())
    if (button->isVisible() && button->text() == QStringLiteral("Open it as a volume"))
      offered = button;
  ASSERT_NE(offered, nullptr) << messages().sentence().toStdString();
  const std::shared_ptr<const Volume> before = scene().volume;
  QTest::mouseClick(offered, Qt::LeftButton);
  EXPECT_TRUE(test::waitUntil([&] { return scene().volume != before; }));
  EXPECT_EQ(scene().volume->grid(), before->grid());
}

TEST_F(RegionWindow, whatIsNoLabelMapIsRefusedInASentence) {
  ASSERT_TRUE(open(pathTo("head.nrrd")));
  const Region before = scene().keep;
  controller().openLabels(pathTo("gone.nrrd"));
  ASSERT_TRUE(ready());
  EXPECT_TRUE(messages().isVisible());
  EXPECT_TRUE(messages().sentence().contains(QStringLiteral("gone.nrrd")))
      << messages().sentence().toStdString();
  EXPECT_EQ(scene().keep, before);
}

} // namespace
} // namespace limn
