// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/overlay/RegionNote.h"

#include "scene/volume/Phantom.h"
#include "widgets/view/overlay/Overlay.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

class RegionNote : public testing::Test {
protected:
  RegionNote() {
    comparison.scene.volume = phantomVolume({12.0, 0.0, 1});
    comparison.scene.camera = defaultCamera(comparison.scene.volume->grid());
    state.sides.resize(2);
  }

  OverlaySource source() const {
    return {comparison, {comparison.layout, 0.5, {700, 400}, 1.0}, state, QFont(), 1.0, {}, false, {}, {}};
  }

  void keepBody() {
    const glm::ivec3 dims = comparison.scene.volume->grid().dims;
    comparison.scene.keep =
        bodyRegion(dims, std::vector<std::uint8_t>(static_cast<std::size_t>(dims.x) * dims.y * dims.z, 1));
  }

  Comparison comparison;
  PictureState state;
};

TEST_F(RegionNote, isAbsentWhereNothingIsHidden) {
  EXPECT_FALSE(regionNoteOf(source()));
  EXPECT_EQ(regionNoteAt(source(), {30.0, 50.0}), -1);
  EXPECT_TRUE(toolTipAt(source(), {30.0, 50.0}).isEmpty());
}

TEST_F(RegionNote, tellsWhatIsHidden) {
  const auto labels = std::make_shared<const LabelMap>(
      glm::ivec3(1), std::vector<std::uint8_t>{0}, std::vector<Label>{{0, "", {}}, {1, "", {}}, {2, "", {}}});
  EXPECT_EQ(regionText({Region::Kind::labels, "s", labels, {1, 1, 1}}), QString());
  EXPECT_EQ(regionText({Region::Kind::labels, "s", labels, {1, 0, 1}}),
            QStringLiteral("1 label hidden or faded"));
  EXPECT_EQ(regionText({Region::Kind::labels, "s", labels, {0.5, 0, 1}}),
            QStringLiteral("2 labels hidden or faded"));
  EXPECT_EQ(regionText(bodyRegion(glm::ivec3(1), std::vector<std::uint8_t>{1})),
            QStringLiteral("Body only: table hidden"));
}

TEST_F(RegionNote, keepsClearOfEverythingElseInEveryLayout) {
  keepBody();
  for (const CompareLayout layout : compareLayouts) {
    comparison.layout = layout;
    const std::optional<Note> note = regionNoteOf(source());
    ASSERT_TRUE(note);
    const Overlay overlay = overlayOf(source());
    for (const PlacedLabel& label : overlay.labels)
      EXPECT_FALSE(label.steadyPlate.intersects(note->plate)) << nameOf(layout);
    for (const LetterMarks& letters : overlay.letters)
      for (const std::optional<QRectF>& place : letters.places)
        EXPECT_FALSE(place && place->intersects(note->plate)) << nameOf(layout);
    if (overlay.difference) {
      EXPECT_FALSE(overlay.difference->label.plate.intersects(note->plate));
      EXPECT_FALSE(overlay.difference->note.plate.intersects(note->plate));
    }
    EXPECT_EQ(regionNoteAt(source(), note->plate.center()), 0);
    EXPECT_EQ(regionNoteAt(source(), {350.0, 200.0}), -1);
  }
}

// The window at its smallest, and two pictures beside each other in it.
TEST_F(RegionNote, leavesTheLettersOfASmallPictureTheirPlace) {
  keepBody();
  comparison.layout = CompareLayout::sideBySide;
  OverlaySource small = source();
  small.geometry.size = {354, 180};
  for (const LetterMarks& letters : overlayOf(small).letters)
    for (const std::optional<QRectF>& place : letters.places)
      EXPECT_TRUE(place);
}

TEST_F(RegionNote, leavesALowPictureToWhatItShows) {
  keepBody();
  OverlaySource low = source();
  low.geometry.size = {110, 125};
  EXPECT_FALSE(regionNoteOf(low));
}

TEST_F(RegionNote, saysWhatAClickDoesUnderThePointer) {
  keepBody();
  OverlaySource under = source();
  under.hovered.region = 0;
  EXPECT_EQ(regionNoteOf(under)->text, QStringLiteral("Show everything"));
  EXPECT_FALSE(toolTipAt(under, {}).isEmpty());
  EXPECT_EQ(regionNoteOf(under)->plate, regionNoteOf(source())->plate) << "and moves nothing";
  comparison.scene.keep = {};
  comparison.scene.crop.upper.z = 0.5;
  EXPECT_EQ(regionNoteOf(under)->plate, regionNoteOf(source())->plate);
}

TEST_F(RegionNote, tellsACropWhetherOrNotItsBoxIsShown) {
  comparison.scene.crop.lower.x = 0.25;
  EXPECT_EQ(regionNoteOf(source())->text, QStringLiteral("Cropped"));
  OverlaySource withBox = source();
  withBox.hasCropBox = true;
  EXPECT_EQ(regionNoteOf(withBox)->text, QStringLiteral("Cropped"));
  keepBody();
  EXPECT_EQ(regionNoteOf(source())->text, QStringLiteral("Body only: table hidden · cropped"));
}

TEST_F(RegionNote, standsInEachOfTwoPicturesAndTellsThemApart) {
  keepBody();
  comparison.layout = CompareLayout::sideBySide;
  const std::optional<Note> right = regionNoteOf(source(), 1);
  ASSERT_TRUE(right);
  EXPECT_TRUE(pictureRect(source().geometry, 1).contains(right->plate));
  EXPECT_EQ(regionNoteAt(source(), right->plate.center()), 1);
  OverlaySource under = source();
  under.hovered.region = 1;
  EXPECT_EQ(regionNoteOf(under, 0)->text, QStringLiteral("Body only: table hidden"));
  EXPECT_EQ(regionNoteOf(under, 1)->text, QStringLiteral("Show everything"));
}

} // namespace
} // namespace limn
