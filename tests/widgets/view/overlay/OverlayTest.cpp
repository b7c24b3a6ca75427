// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/overlay/Overlay.h"

#include "scene/volume/Phantom.h"
#include "widgets/view/gestures/ViewDrag.h"

#include <QFontMetricsF>

#include <gtest/gtest.h>

#include <array>

// What stands above the pictures, as a value.

namespace limn {
namespace {

class OverlayAbove : public testing::Test {
protected:
  OverlayAbove() {
    comparison.scene.volume = phantomVolume({12.0, 0.0, 1});
    comparison.scene.camera = defaultCamera(comparison.scene.volume->grid());
    state.resting = true;
    state.sides.resize(1);
  }
  OverlaySource source() const {
    OverlaySource source;
    source.comparison = comparison;
    source.geometry = {comparison.layout, comparison.wipe, {700, 400}, 1.0};
    source.state = state;
    return source;
  }
  Comparison comparison;
  PictureState state;
};

TEST_F(OverlayAbove, namesEachPictureWhereItStands) {
  comparison.layout = CompareLayout::sideBySide;
  const Overlay overlay = overlayOf(source());
  ASSERT_EQ(overlay.labels.size(), 2u);
  EXPECT_EQ(overlay.labels[0].label.title, QStringLiteral("Classic"));
  EXPECT_EQ(overlay.labels[1].label.title, QStringLiteral("Enhanced"));
  EXPECT_LT(overlay.labels[0].plate.right(), 350.0);
  EXPECT_GT(overlay.labels[1].plate.left(), 350.0);
  EXPECT_TRUE(overlay.gap);
  EXPECT_EQ(overlay.letters.size(), 2u);
  comparison.isSwapped = true;
  EXPECT_EQ(overlayOf(source()).labels[0].label.title, QStringLiteral("Enhanced"));
}

TEST_F(OverlayAbove, aMarkedPlaceIsMarkedInEachPictureThatHasItInView) {
  EXPECT_TRUE(overlayOf(source()).marks.empty());
  const Camera& camera = comparison.scene.camera;
  comparison.markMm = camera.target;
  EXPECT_EQ(overlayOf(source()).marks, std::vector{QPointF(350.0, 200.0)}) << "the target is in the middle";
  comparison.layout = CompareLayout::sideBySide;
  const std::vector<QPointF> marks = overlayOf(source()).marks;
  ASSERT_EQ(marks.size(), 2u);
  EXPECT_LT(marks[0].x(), 350.0);
  EXPECT_GT(marks[1].x(), 350.0);
  comparison.markMm = camera.position - (camera.target - camera.position); // behind the eye
  EXPECT_TRUE(overlayOf(source()).marks.empty());
  comparison.markMm = camera.target + 1e5 * basisOf(camera).right;
  EXPECT_TRUE(overlayOf(source()).marks.empty());
}

TEST_F(OverlayAbove, aMarkedPlaceIsMarkedAsHiddenInThePictureOfEachSideThatHidesIt) {
  comparison.markMm = comparison.scene.camera.target;
  comparison.layout = CompareLayout::sideBySide;
  comparison.markIsHidden = {false, true};
  const Overlay overlay = overlayOf(source());
  ASSERT_EQ(overlay.marks.size(), 1u);
  ASSERT_EQ(overlay.hiddenMarks.size(), 1u);
  EXPECT_LT(overlay.marks[0].x(), 350.0);
  EXPECT_GT(overlay.hiddenMarks[0].x(), 350.0);
  comparison.isSwapped = true;
  EXPECT_GT(overlayOf(source()).marks.at(0).x(), 350.0) << "it goes with its side";
  comparison.isSwapped = false;
  comparison.layout = CompareLayout::wipe;
  for (const double wipe : {0.3, 0.7}) { // the place lies in the middle
    comparison.wipe = wipe;
    EXPECT_EQ(overlayOf(source()).hiddenMarks.size(), wipe < 0.5 ? 1u : 0u);
  }
}

TEST_F(OverlayAbove, aLabelIsFoundUnderThePointerWhereThereIsAModelToChoose) {
  const QPointF point = labelsOf(source())[0].plate.center();
  EXPECT_EQ(labelAt(source(), point), 0);
  EXPECT_EQ(labelAt(source(), {350.0, 200.0}), -1);
  comparison.scene.projection = Projection::mip;
  EXPECT_EQ(labelAt(source(), labelsOf(source())[0].plate.center()), -1);
}

TEST_F(OverlayAbove, labelsStayOnTheirSideOfTheWipeWhereverItsBorderIs) {
  comparison.layout = CompareLayout::wipe;
  for (const double wipe : {0.3, 0.5, 0.7}) {
    comparison.wipe = wipe;
    const std::vector<PlacedLabel> labels = labelsOf(source());
    EXPECT_LE(labels[0].plate.right(), wipe * 700.0) << wipe; // of the view's width
    EXPECT_GE(labels[1].plate.left(), wipe * 700.0) << wipe;
  }
  comparison.wipe = 0.0; // one has no side left: both are told all the same
  const std::vector<PlacedLabel> labels = labelsOf(source());
  EXPECT_FALSE(labels[0].plate.intersects(labels[1].plate));
  EXPECT_GT(labels[0].plate.width(), 60.0);
}

// Beside each other in a window of 1440 pixels each picture has 459.
TEST_F(OverlayAbove, aLabelWithLittleRoomKeepsItsError) {
  state.sides[0].estimate = ErrorEstimate{0.42, 0.1, 1.0};
  state.sides[0].isRough = false;
  state.sides[0].completeMs = 123.4;
  const auto shown = [&](int width) {
    OverlaySource narrow = source();
    narrow.geometry.size = {width, 400};
    const PlacedLabel label = labelsOf(narrow)[0];
    EXPECT_LE(label.plate.right(), width);
    return fittingDetails(QFont(), label.label.details, label.plate.width());
  };
  EXPECT_TRUE(shown(459).startsWith(QStringLiteral("within 0.4 levels · 123 ms")));
  EXPECT_TRUE(shown(1400).endsWith(QStringLiteral("SP 32"))) << "all of it";
  for (int width = 120; width < 700; width += 20) // what does not fit is left out, not cut
    EXPECT_FALSE(shown(width).contains(QChar(0x2026))) << width;
}

// Presets may be called anything.
TEST_F(OverlayAbove, aNameThatIsTooLongShowsBothEndsAndIsWholeInItsToolTip) {
  comparison.layout = CompareLayout::sideBySide;
  comparison.look = ComparedLook{
      presetOf(comparison.scene, "long"),
      {"A name of a preset with <thin> bone as long as people give them who have many of them", "CT bone"}};
  const std::vector<PlacedLabel> labels = labelsOf(source());
  const auto fitting = [&](const PlacedLabel& label) {
    return fittingTitle(source().font, label.label, label.plate);
  };
  const QString title = labels[0].label.title;
  ASSERT_TRUE(title.endsWith(QStringLiteral("· Classic")));
  EXPECT_LE(labels[0].plate.right(), 350.0);
  EXPECT_TRUE(fitting(labels[0]).startsWith(QStringLiteral("A name")));
  EXPECT_TRUE(fitting(labels[0]).contains(QChar(0x2026)));
  EXPECT_TRUE(fitting(labels[0]).endsWith(QStringLiteral("Classic"))) << fitting(labels[0]).toStdString();
  EXPECT_LE(QFontMetricsF(titleFont(source().font)).horizontalAdvance(fitting(labels[0])),
            labels[0].plate.width());
  const QString tip = toolTipAt(source(), labels[0].plate.center());
  EXPECT_EQ(tip, QStringLiteral("<p>%1</p>").arg(title.toHtmlEscaped()));
  EXPECT_TRUE(tip.contains(QStringLiteral("with &lt;thin&gt; bone"))) << tip.toStdString();
  EXPECT_EQ(fitting(labels[1]), labels[1].label.title);
  EXPECT_TRUE(toolTipAt(source(), labels[1].plate.center()).isEmpty()) << "it is all there";
}

TEST_F(OverlayAbove, aLabelTellsNothingOfTheLastPictureAtRestWhileAnotherIsSeen) {
  state.sides[0].completeMs = 123.4;
  EXPECT_EQ(labelsOf(source())[0].label.details.size(), 2);
  state.resting = false;
  EXPECT_EQ(labelsOf(source())[0].label.details, QStringList{QStringLiteral("SP 32")});
}

TEST_F(OverlayAbove, noCaptionMovesALetter) {
  comparison.scene.camera = orbited(defaultCamera(comparison.scene.volume->grid()), 0.5, 0.4);
  const auto places = [&](const OverlaySource& of) {
    std::vector<std::optional<QRectF>> all;
    for (const LetterMarks& marks : overlayOf(of).letters)
      all.insert(all.end(), marks.places.begin(), marks.places.end());
    return all;
  };
  comparison.scene.crop.upper.z = 0.5; // so that there is a note, too
  for (const CompareLayout layout : {CompareLayout::single, CompareLayout::sideBySide, CompareLayout::wipe})
    for (const QSize size : {QSize(408, 148), QSize(204, 148), QSize(700, 400), QSize(1400, 800)}) {
      comparison.layout = layout;
      comparison.preview.clear();
      state = {};
      state.sides.resize(2);
      OverlaySource before = source();
      before.geometry.size = size;
      const auto bare = places(before);
      state.resting = true;
      for (SideState& side : state.sides) {
        side.estimate = ErrorEstimate{0.42, 0.1, 1.0};
        side.isRough = false;
        side.completeMs = 123.4;
      }
      comparison.preview = "Bone and veil";
      OverlaySource told = source();
      told.geometry.size = size;
      told.hovered = {0, false, HiddenPlace{0, HiddenBy::region}, {}};
      EXPECT_EQ(places(told), bare) << size.width() << " " << nameOf(layout);
      for (const Note& note : overlayOf(told).notes)
        for (const auto& place : places(told))
          EXPECT_FALSE(place && place->intersects(note.plate)) << note.text.toStdString();
    }
}

TEST_F(OverlayAbove, cornersOfALineSayInThePictureHowItIsClosed) {
  OverlaySource drawn = source();
  const std::size_t others = overlayOf(drawn).notes.size();
  drawn.cutLine = lineFrom({100, 100}, pictureRect(drawn.geometry, 0));
  EXPECT_EQ(overlayOf(drawn).notes.size(), others) << "one that is drawn at once";
  drawn.cutLine->isByClicks = true;
  const std::vector<Note> notes = overlayOf(drawn).notes;
  ASSERT_EQ(notes.size(), others + 1);
  EXPECT_TRUE(notes.back().text.contains(QStringLiteral("closes the line")));
}

// Four views share a window of 1366 × 768, and two pictures one of them.
TEST_F(OverlayAbove, everyLetterHasAPlaceInSmallPictures) {
  comparison.scene.camera = orbited(defaultCamera(comparison.scene.volume->grid()), 0.5, 0.4);
  for (const bool isCropped : {false, true})
    for (const CompareLayout layout : {CompareLayout::single, CompareLayout::sideBySide}) {
      comparison.layout = layout;
      comparison.scene.crop.upper.z = isCropped ? 0.5 : 1.0;
      OverlaySource small = source();
      small.geometry.size = {408, 148};
      for (const LetterMarks& marks : overlayOf(small).letters)
        for (const std::optional<QRectF>& place : marks.places)
          EXPECT_TRUE(place) << nameOf(layout) << isCropped;
    }
}

// However much of a picture what is shown fills: on plates, of which none is cut.
TEST_F(OverlayAbove, lettersStandAtTheVeryEdge) {
  comparison.scene.camera = orbited(defaultCamera(comparison.scene.volume->grid()), 0.5, 0.4);
  state.sides.resize(2);
  for (SideState& one : state.sides) {
    one.estimate = ErrorEstimate{0.42, 0.1, 1.0};
    one.isRough = false;
    one.completeMs = 123.4;
  }
  for (const CompareLayout layout : {CompareLayout::single, CompareLayout::sideBySide})
    for (const QSize size : {QSize(408, 370), QSize(830, 585), QSize(1700, 900)}) {
      comparison.layout = layout;
      OverlaySource shown = source();
      shown.geometry.size = size;
      const Overlay overlay = overlayOf(shown);
      for (std::size_t position = 0; position < overlay.letters.size(); ++position) {
        const LetterMarks& marks = overlay.letters[position];
        const QRectF side = pictureRect(shown.geometry, static_cast<int>(position));
        const std::array<std::string, 4> texts{marks.letters.left, marks.letters.right, marks.letters.top,
                                               marks.letters.bottom};
        for (std::size_t i = 0; i < texts.size(); ++i) {
          ASSERT_TRUE(marks.places[i]) << size.width() << " " << i;
          const double half =
              QFontMetricsF(titleFont(shown.font)).horizontalAdvance(QString::fromStdString(texts[i])) / 2 +
              4.0;
          EXPECT_GE(marks.places[i]->center().x() - half, side.left()) << size.width() << " " << texts[i];
          EXPECT_LE(marks.places[i]->center().x() + half, side.right()) << size.width() << " " << texts[i];
        }
        EXPECT_NEAR(marks.places[3]->bottom(), side.bottom() - 4.0, 1e-9);
        const QRectF& title = overlay.labels[position].plate;
        if (side.width() > 800.0)
          EXPECT_NEAR(marks.places[2]->top(), 4.0, 1e-9) << "beside what the title tells";
        else
          EXPECT_LE(marks.places[2]->top(), title.bottom() + 5.0) << "just below it";
        EXPECT_FALSE(marks.places[2]->intersects(title));
      }
    }
}

TEST_F(OverlayAbove, lettersKeepClearOfTheHandlesOfTheCropBox) {
  for (const double turn : {0.0, 0.3, 0.8}) {
    comparison.scene.camera = orbited(defaultCamera(comparison.scene.volume->grid()), turn, turn / 2.0);
    OverlaySource with = source();
    with.hasCropBox = true;
    const Overlay overlay = overlayOf(with);
    ASSERT_EQ(overlay.letters.size(), 1u);
    const LetterMarks& marks = overlay.letters[0];
    for (const CropHandle& handle : overlay.cropBoxes[0].shape.handles) {
      QRectF disc(0, 0, 2 * cropHandleRadius, 2 * cropHandleRadius);
      disc.moveCenter(handle.centre);
      for (const std::optional<QRectF>& place : marks.places)
        EXPECT_FALSE(place && place->intersects(disc)) << turn;
    }
  }
}

// Where a face lies across the line of sight and beyond the picture, or its corner under a title.
TEST_F(OverlayAbove, noTextHidesTheHandleOfAFaceInFrontOrBehind) {
  for (SideState& side : state.sides) {
    side.estimate = ErrorEstimate{0.42, 0.1, 1.0};
    side.isRough = false;
    side.completeMs = 123.4;
  }
  comparison.scene.crop.upper.z = 0.9;
  const Camera usual = defaultCamera(comparison.scene.volume->grid());
  for (const double near : {0.5, 0.7, 0.8, 1.0, 1.2})
    for (const QSize size : {QSize(408, 370), QSize(700, 400), QSize(1400, 900)}) {
      comparison.scene.camera = usual;
      comparison.scene.camera.position = usual.target + near * (usual.position - usual.target);
      OverlaySource with = source();
      with.geometry.size = size;
      with.hasCropBox = true;
      const Overlay overlay = overlayOf(with);
      int across = 0;
      for (const CropHandle& handle : overlay.cropBoxes[0].shape.handles) {
        if (!handle.isAcross)
          continue;
        ++across;
        QRectF disc(0, 0, 2 * cropHandleHitRadius, 2 * cropHandleHitRadius);
        disc.moveCenter(handle.centre);
        for (const PlacedLabel& label : overlay.labels)
          EXPECT_FALSE(label.plate.intersects(disc)) << near << " " << size.width();
        for (const Note& note : overlay.notes)
          EXPECT_FALSE(note.plate.intersects(disc)) << note.text.toStdString() << near << " " << size.width();
        EXPECT_FALSE(overlay.scale && overlay.scale->plate.intersects(disc)) << near << " " << size.width();
      }
      EXPECT_GE(across, 1) << near;
    }
}

TEST_F(OverlayAbove, onlyADifferenceHasATitleAndExplainsIt) {
  EXPECT_FALSE(overlayOf(source()).difference);
  comparison.layout = CompareLayout::difference;
  const std::optional<DifferenceTitle> title = overlayOf(source()).difference;
  ASSERT_TRUE(title);
  for (const PlacedLabel& label : labelsOf(source())) {
    EXPECT_FALSE(title->label.plate.intersects(label.plate));
    EXPECT_FALSE(title->note.plate.intersects(label.plate));
  }
  EXPECT_EQ(title->label.label.title, QStringLiteral("Enhanced minus Classic, ×4"));
  EXPECT_FALSE(toolTipAt(source(), title->label.plate.center()).isEmpty());
  EXPECT_TRUE(toolTipAt(source(), {350.0, 300.0}).isEmpty());
}

TEST_F(OverlayAbove, aDifferenceHasABarThatTellsItsColoursAndCoversNothing) {
  EXPECT_FALSE(overlayOf(source()).differenceBar);
  comparison.layout = CompareLayout::difference;
  const Overlay overlay = overlayOf(source());
  ASSERT_TRUE(overlay.differenceBar);
  EXPECT_EQ(overlay.differenceBar->lowest, QStringLiteral("−64")); // 255 levels over a gain of 4
  EXPECT_EQ(overlay.differenceBar->highest, QStringLiteral("+64 of 255"));
  EXPECT_EQ(overlay.differenceBar->leftBrighter, QStringLiteral("Classic brighter"));
  const QRectF& plate = overlay.differenceBar->plate;
  EXPECT_TRUE(overlay.view.contains(plate));
  for (const Note& note : overlay.notes)
    EXPECT_FALSE(plate.intersects(note.plate)) << note.text.toStdString();
  for (const PlacedLabel& label : overlay.labels)
    EXPECT_FALSE(plate.intersects(label.plate));
}

TEST_F(OverlayAbove, progressIsShownWhileSomethingIsDrawn) {
  EXPECT_TRUE(overlayOf(source()).progress.empty());
  state.refines = true;
  state.refinementFraction = 0.25;
  EXPECT_EQ(overlayOf(source()).progress, std::vector<double>{0.25});
  state = {};
  state.sides.resize(2);
  state.sides[0].fraction = 0.5;
  EXPECT_EQ(overlayOf(source()).progress, std::vector<double>{0.25}) << "the mean of both sides";
}

TEST_F(OverlayAbove, notesKeepClearOfEachOther) {
  state.limitation = QStringLiteral("The volume was down-sampled.");
  const Overlay overlay = overlayOf(source());
  ASSERT_EQ(overlay.notes.size(), 2u);
  EXPECT_EQ(overlay.notes[0].text, QStringLiteral("Not for diagnosis"));
  EXPECT_FALSE(overlay.notes[0].plate.intersects(overlay.notes[1].plate));
}

TEST_F(OverlayAbove, theCropBoxStandsOverEachPictureAndSaysWhatAHeldFaceCuts) {
  EXPECT_TRUE(overlayOf(source()).cropBoxes.empty());
  comparison.layout = CompareLayout::sideBySide;
  OverlaySource with = source();
  with.hasCropBox = true;
  EXPECT_EQ(overlayOf(with).cropBoxes.size(), 2u);
  EXPECT_FALSE(overlayOf(with).cropBoxes[0].note);
  with.heldFace = CropFace{2, true};
  EXPECT_TRUE(overlayOf(with).cropBoxes[0].note);
  EXPECT_EQ(overlayOf(with).cropBoxes[0].lively, with.heldFace);
}

} // namespace
} // namespace limn
