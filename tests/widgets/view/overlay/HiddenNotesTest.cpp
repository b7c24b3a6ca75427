// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/overlay/Titles.h"

#include "scene/volume/Phantom.h"
#include "widgets/view/overlay/Overlay.h"
#include "widgets/view/overlay/OverlayParts.h"
#include "widgets/view/overlay/SavedOverlay.h"

#include <QImage>
#include <QPainter>

#include <gtest/gtest.h>

#include <algorithm>

namespace limn {
namespace {

class HiddenNotes : public testing::Test {
protected:
  HiddenNotes() {
    comparison.scene.volume = phantomVolume({12.0, 0.0, 1});
    comparison.scene.camera = defaultCamera(comparison.scene.volume->grid());
    state.sides.resize(2);
  }

  OverlaySource source() const {
    OverlaySource source;
    source.comparison = comparison;
    source.geometry = {comparison.layout, comparison.wipe, {700, 400}, 1.0};
    source.state = state;
    return source;
  }

  void keepBody() {
    const glm::ivec3 dims = comparison.scene.volume->grid().dims;
    comparison.scene.keep =
        bodyRegion(dims, std::vector<std::uint8_t>(static_cast<std::size_t>(dims.x) * dims.y * dims.z, 1));
  }

  Comparison comparison;
  PictureState state;
};

TEST_F(HiddenNotes, areNotPrintedOverByTheTitleOfADifference) {
  keepBody();
  comparison.layout = CompareLayout::difference;
  for (const int width : {360, 420, 500, 700}) { // as narrow as beside slices, too
    OverlaySource narrow = source();
    narrow.geometry.size = {width, 400};
    const std::optional<DifferenceTitle> title = differenceTitleOf(narrow);
    ASSERT_TRUE(title);
    ASSERT_FALSE(hiddenNotesOf(narrow).empty());
    for (const HiddenNote& hidden : hiddenNotesOf(narrow)) {
      EXPECT_FALSE(hidden.note.plate.intersects(title->label.plate)) << width;
      EXPECT_FALSE(hidden.note.plate.intersects(title->note.plate)) << width;
    }
  }
}

TEST_F(HiddenNotes, areAbsentWhereNothingIsHidden) {
  EXPECT_TRUE(hiddenNotesOf(source()).empty());
  EXPECT_FALSE(hiddenNoteAt(source(), {30.0, 50.0}));
  EXPECT_TRUE(toolTipAt(source(), {30.0, 50.0}).isEmpty());
}

TEST_F(HiddenNotes, tellWhatIsHidden) {
  const auto labels = std::make_shared<const LabelMap>(
      glm::ivec3(1), std::vector<std::uint8_t>{0}, std::vector<Label>{{0, "", {}}, {1, "", {}}, {2, "", {}}});
  EXPECT_EQ(regionText({Region::Kind::labels, "s", labels, {1, 1, 1}}), QString());
  EXPECT_EQ(regionText({Region::Kind::labels, "s", labels, {1, 0, 1}}),
            QStringLiteral("1 label hidden or faded"));
  EXPECT_EQ(regionText({Region::Kind::labels, "s", labels, {0.5, 0, 1}}),
            QStringLiteral("2 labels hidden or faded"));
  const auto named = std::make_shared<const LabelMap>(
      glm::ivec3(1), std::vector<std::uint8_t>{0},
      std::vector<Label>{{0, "air", {}}, {1, "liver", {}}, {2, "", {}}, {3, "spleen", {}}, {4, "aorta", {}}});
  EXPECT_EQ(regionText({Region::Kind::labels, "s", named, {1, 0, 0.5, 1, 1}}, true),
            QStringLiteral("2 labels hidden or faded: liver, 2"));
  EXPECT_EQ(regionText({Region::Kind::labels, "s", named, {1, 0, 0.5, 0, 0}}, true),
            QStringLiteral("4 labels hidden or faded: liver, 2, spleen and 1 more"));
  EXPECT_EQ(regionText(bodyRegion(glm::ivec3(1), std::vector<std::uint8_t>{1})),
            QStringLiteral("Body only: table hidden"));
}

// What a line took and what was picked as a piece are brought back in different places.
TEST_F(HiddenNotes, tellHiddenPiecesBesideWhatWasCut) {
  const auto piece = [](ConnectedPiece::Fate fate) {
    ConnectedPiece one;
    one.fate = fate;
    return Cut{one};
  };
  const Cut hidden = piece(ConnectedPiece::Fate::hidden);
  Region region = bodyRegion(glm::ivec3(1), std::vector<std::uint8_t>{1});
  region.isCut = true;
  region.weights.push_back(0.0);
  const auto textOf = [&](const std::vector<Cut>& cuts) {
    region.cuts = cuts;
    return regionText(region);
  };
  EXPECT_EQ(textOf({Cut{Scissors{}}}), QStringLiteral("Only the body, cut by hand"));
  EXPECT_EQ(textOf({hidden}), QStringLiteral("Only the body, 1 piece hidden"));
  EXPECT_EQ(textOf({Cut{Scissors{}}, hidden, hidden}),
            QStringLiteral("Only the body, cut by hand, 2 pieces hidden"));
  EXPECT_EQ(textOf({Cut{Scissors{}}, Cut{hidden.how, false}}), QStringLiteral("Only the body, cut by hand"))
      << "one that is off hides nothing";
  EXPECT_EQ(textOf({piece(ConnectedPiece::Fate::alone)}), QStringLiteral("Only the body, only one piece"));
  region.kind = Region::Kind::all;
  EXPECT_EQ(textOf({Cut{Scissors{}}, hidden}), QStringLiteral("Cut by hand, 1 piece hidden"));
}

TEST_F(HiddenNotes, sayUnderThePointerWhatTheirClickShows) {
  keepBody();
  Region& kept = comparison.scene.keep;
  const auto words = [this] {
    OverlaySource pointedAt = source();
    pointedAt.hovered.hidden = HiddenPlace{0, HiddenBy::region};
    return hiddenNotesOf(pointedAt).front().note.text;
  };
  EXPECT_EQ(words(), QStringLiteral("Show everything"));
  kept.isCut = true;
  kept.uncut = kept.labels;
  kept.weights.push_back(0.0);
  kept.cuts = {Cut{Scissors{}}};
  EXPECT_EQ(words(), QStringLiteral("Show what was cut away")) << "the body stays alone";
  kept.kind = Region::Kind::all;
  kept.uncut.reset();
  EXPECT_EQ(words(), QStringLiteral("Show everything"));
}

// Whoever sees the file alone would take for the patient what is left of them.
TEST_F(HiddenNotes, goWithTheNamesIntoAFile) {
  keepBody();
  const auto told = [this](const SavedMarks& marks) {
    const Overlay overlay = savedOverlay(source(), marks);
    return std::ranges::any_of(overlay.notes, [](const Note& note) {
      return note.text == QStringLiteral("Body only: table hidden");
    });
  };
  EXPECT_TRUE(told({}));
  EXPECT_FALSE(told(noMarks));
  // On screen it has room for what it says under the pointer.
  const double onScreen = hiddenNotesOf(source())[0].note.plate.width();
  const Note alone =
      noteAt(source().font, QStringLiteral("Body only: table hidden"), {}, Qt::AlignLeft, 1000.0);
  for (const Note& note : savedOverlay(source(), {}).notes)
    if (note.text == alone.text) {
      EXPECT_EQ(note.plate.width(), alone.plate.width());
    }
  EXPECT_GE(onScreen, alone.plate.width());
}

TEST_F(HiddenNotes, keepClearOfEverythingElseInEveryLayout) {
  keepBody();
  comparison.scene.crop.upper.z = 0.5;
  for (const CompareLayout layout : compareLayouts) {
    comparison.layout = layout;
    const std::vector<HiddenNote> notes = hiddenNotesOf(source());
    ASSERT_EQ(notes.size(), 2u);
    EXPECT_FALSE(notes[0].note.plate.intersects(notes[1].note.plate));
    const Overlay overlay = overlayOf(source());
    for (const auto& [by, note] : notes) {
      for (const PlacedLabel& label : overlay.labels)
        EXPECT_FALSE(label.steadyPlate.intersects(note.plate)) << nameOf(layout);
      for (const LetterMarks& letters : overlay.letters)
        for (const std::optional<QRectF>& place : letters.places)
          EXPECT_FALSE(place && place->intersects(note.plate)) << nameOf(layout);
      if (overlay.difference) {
        EXPECT_FALSE(overlay.difference->label.plate.intersects(note.plate));
        EXPECT_FALSE(overlay.difference->note.plate.intersects(note.plate));
      }
      EXPECT_EQ(hiddenNoteAt(source(), note.plate.center()), (HiddenPlace{0, by}));
    }
    EXPECT_FALSE(hiddenNoteAt(source(), {350.0, 200.0}));
  }
}

// The window at its smallest, and two pictures beside each other in it.
TEST_F(HiddenNotes, leaveTheLettersOfASmallPictureTheirPlace) {
  keepBody();
  comparison.layout = CompareLayout::sideBySide;
  OverlaySource small = source();
  small.geometry.size = {354, 180};
  for (const LetterMarks& letters : overlayOf(small).letters)
    for (const std::optional<QRectF>& place : letters.places)
      EXPECT_TRUE(place);
}

TEST_F(HiddenNotes, leaveALowPictureToWhatItShows) {
  keepBody();
  OverlaySource low = source();
  low.geometry.size = {110, 125};
  EXPECT_TRUE(hiddenNotesOf(low).empty());
}

TEST_F(HiddenNotes, sayWhatAClickDoesUnderThePointer) {
  keepBody();
  comparison.scene.crop.upper.z = 0.5;
  OverlaySource under = source();
  under.hovered.hidden = {0, HiddenBy::region};
  EXPECT_EQ(hiddenNotesOf(under)[0].note.text, QStringLiteral("Show everything"));
  EXPECT_EQ(hiddenNotesOf(under)[1].note.text, QStringLiteral("Cropped"));
  const QString ofRegion = toolTipAt(under, {});
  under.hovered.hidden = {0, HiddenBy::crop};
  EXPECT_EQ(hiddenNotesOf(under)[0].note.text, QStringLiteral("Body only: table hidden"));
  EXPECT_EQ(hiddenNotesOf(under)[1].note.text, QStringLiteral("Reset crop"));
  EXPECT_FALSE(ofRegion.isEmpty());
  EXPECT_NE(toolTipAt(under, {}), ofRegion);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_EQ(hiddenNotesOf(under)[i].note.plate, hiddenNotesOf(source())[i].note.plate)
        << "and moves nothing";
}

TEST_F(HiddenNotes, tellACropWhetherOrNotItsBoxIsShown) {
  comparison.scene.crop.lower.x = 0.25;
  for (const bool hasBox : {false, true}) {
    OverlaySource cropped = source();
    cropped.hasCropBox = hasBox;
    ASSERT_EQ(hiddenNotesOf(cropped).size(), 1u);
    EXPECT_EQ(hiddenNotesOf(cropped)[0].note.text, QStringLiteral("Cropped"));
  }
}

TEST_F(HiddenNotes, standInEachOfTwoPicturesAndTellThemApart) {
  keepBody();
  comparison.layout = CompareLayout::sideBySide;
  const std::vector<HiddenNote> right = hiddenNotesOf(source(), 1);
  ASSERT_EQ(right.size(), 1u);
  EXPECT_TRUE(pictureRect(source().geometry, 1).contains(right[0].note.plate));
  EXPECT_EQ(hiddenNoteAt(source(), right[0].note.plate.center()), (HiddenPlace{1, HiddenBy::region}));
  OverlaySource under = source();
  under.hovered.hidden = {1, HiddenBy::region};
  EXPECT_EQ(hiddenNotesOf(under, 0)[0].note.text, QStringLiteral("Body only: table hidden"));
  EXPECT_EQ(hiddenNotesOf(under, 1)[0].note.text, QStringLiteral("Show everything"));
}

TEST_F(HiddenNotes, theBorderOfAWipeHasNoKnobInAFile) {
  comparison.layout = CompareLayout::wipe;
  ASSERT_TRUE(overlayOf(source()).border);
  EXPECT_TRUE(overlayOf(source()).border->hasKnob);
  const Overlay saved = savedOverlay(source(), {});
  ASSERT_TRUE(saved.border);
  EXPECT_FALSE(saved.border->hasKnob);
  // The line is one colour from end to end where a knob would stand.
  QImage image(source().geometry.size, QImage::Format_RGB32);
  image.fill(Qt::gray);
  QPainter painter(&image);
  paintOverlay(painter, savedOverlay(source(), noMarks));
  painter.end();
  const int beside = static_cast<int>(saved.border->x) + 6;
  for (int y = 0; y < image.height(); ++y)
    ASSERT_EQ(image.pixelColor(beside, y), QColor(Qt::gray)) << y;
}

} // namespace
} // namespace limn
