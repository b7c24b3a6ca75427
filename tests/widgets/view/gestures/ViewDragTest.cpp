// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/gestures/ViewDrag.h"

#include "scene/volume/Phantom.h"
#include "widgets/view/overlay/CropBoxOverlay.h"

#include <gtest/gtest.h>

#include <tuple>

// A drag as a value: what a press begins, what a move makes of it, what Esc puts back.

namespace limn {
namespace {

Comparison shown(CompareLayout layout = CompareLayout::single) {
  static const std::shared_ptr<const Volume> volume = phantomVolume({12.0, 0.0, 1});
  Comparison comparison;
  comparison.layout = layout;
  comparison.scene.volume = volume;
  comparison.scene.camera = orbited(defaultCamera(volume->grid()), 0.6, 0.4);
  comparison.scene.transferFunction.points = {{-50, {1, 1, 1}, 0.1}, {300, {1, 1, 1}, 0.4}};
  return comparison;
}

ViewGeometry geometryOf(const Comparison& comparison) {
  return {comparison.layout, comparison.wipe, {400, 240}, 1.0};
}

ViewDrag dragOf(const Comparison& comparison, const Press& press,
                const std::optional<CropHandle>& handle = {}) {
  return dragFrom(press, comparison, geometryOf(comparison), ViewTool::rotate, handle);
}

TEST(ViewDrag, turnsTheCameraFromMoveToMoveAndPutsItBack) {
  Comparison comparison = shown();
  const Camera before = comparison.scene.camera;
  ViewDrag drag = dragOf(comparison, {Qt::LeftButton, Qt::NoModifier, {200, 120}});
  EXPECT_EQ(drag.kind, DragKind::rotate);
  const QRectF picture(0, 0, 400, 240);
  for (const double x : {210.0, 240.0}) {
    const QPointF from = drag.last;
    const ViewEdit edit = editAt(drag, comparison.scene, {x, 120});
    ASSERT_TRUE(std::holds_alternative<Camera>(edit));
    EXPECT_EQ(std::get<Camera>(edit),
              dragged(comparison.scene.camera, DragKind::rotate, from, {x, 120}, picture));
    comparison.scene.camera = std::get<Camera>(edit);
  }
  EXPECT_EQ(undone(drag, comparison.scene), ViewEdit(before));
}

TEST(ViewDrag, thatChangesNothingAsksForNothing) {
  const Comparison comparison = shown();
  ViewDrag drag = dragOf(comparison, {Qt::LeftButton, Qt::AltModifier | Qt::ControlModifier, {200, 120}});
  EXPECT_EQ(editAt(drag, comparison.scene, {200, 120}), ViewEdit());
  EXPECT_EQ(undone(drag, comparison.scene), ViewEdit());
}

// Window and opacity follow from the function at the start, so that dragging back undoes.
TEST(ViewDrag, ofTheFunctionStartsFromTheFunctionAtThePress) {
  Comparison comparison = shown();
  const TransferFunction before = comparison.scene.transferFunction;
  const ValueRange range = comparison.scene.volume->range();
  ViewDrag window = dragOf(comparison, {Qt::LeftButton, Qt::AltModifier, {200, 120}});
  comparison.scene.transferFunction =
      std::get<TransferFunction>(editAt(window, comparison.scene, {240, 100}));
  EXPECT_EQ(comparison.scene.transferFunction, windowLevelDragged(before, range, {40, -20}));
  EXPECT_EQ(editAt(window, comparison.scene, {200, 120}),
            ViewEdit(windowLevelDragged(before, range, {0, 0})));
  EXPECT_EQ(undone(window, comparison.scene), ViewEdit(before));
  comparison.scene.transferFunction = before;
  ViewDrag opacity = dragOf(comparison, {Qt::LeftButton, Qt::AltModifier | Qt::ControlModifier, {200, 120}});
  EXPECT_EQ(editAt(opacity, comparison.scene, {200, 20}), ViewEdit(opacityDragged(before, {0, -100})));
  EXPECT_NE(opacity.gesture.id, window.gesture.id);
}

TEST(ViewDrag, ofTheBorderMovesTheWipe) {
  const Comparison comparison = shown(CompareLayout::wipe);
  ViewDrag drag = dragOf(comparison, {Qt::LeftButton, Qt::NoModifier, {207, 200}}); // seven pixels beside it
  EXPECT_EQ(drag.kind, DragKind::wipe);
  EXPECT_EQ(editAt(drag, comparison.scene, {100, 200}), ViewEdit(WipeTo{0.25}));
  EXPECT_EQ(undone(drag, comparison.scene), ViewEdit(WipeTo{207.0 / 400.0}));
  EXPECT_EQ(dragOf(comparison, {Qt::RightButton, Qt::NoModifier, {207, 200}}).kind, DragKind::zoom);
}

TEST(ViewDrag, ofAHandleMovesItsFaceUnderThePointerWithoutAJump) {
  Comparison comparison = shown();
  const CropFace face{2, true};
  const CropBoxShape shape = cropShapeAt(comparison, geometryOf(comparison), 0);
  const auto handle = std::find_if(shape.handles.begin(), shape.handles.end(),
                                   [&](const CropHandle& each) { return each.face == face; });
  ASSERT_NE(handle, shape.handles.end());
  const QPointF grip(3.0, -2.0); // the press is beside the centre
  ViewDrag drag = dragOf(comparison, {Qt::LeftButton, Qt::NoModifier, handle->centre + grip}, *handle);
  EXPECT_EQ(drag.kind, DragKind::cropFace);
  EXPECT_FALSE(drag.gesture.text.isEmpty());
  const QPointF to = handle->centre + QPointF(0.0, 40.0);
  comparison.scene.crop = std::get<CropBox>(editAt(drag, comparison.scene, to + grip));
  EXPECT_LT(comparison.scene.crop.upper.z, 1.0);
  CropBox others = comparison.scene.crop;
  others.upper.z = 1.0;
  EXPECT_EQ(others, CropBox{});
  EXPECT_EQ(undone(drag, comparison.scene), ViewEdit(CropBox{}));
}

// A Shift+click pins a value; one that moves pans.
TEST(ViewDrag, withShiftIsAClickUntilItMoves) {
  const Comparison comparison = shown();
  ViewDrag drag = dragOf(comparison, {Qt::LeftButton, Qt::ShiftModifier, {200, 120}});
  EXPECT_EQ(editAt(drag, comparison.scene, {202, 121}), ViewEdit());
  EXPECT_EQ(drag.click, ViewClick::pin);
  EXPECT_TRUE(std::holds_alternative<Camera>(editAt(drag, comparison.scene, {210, 120})));
  EXPECT_EQ(drag.click, ViewClick::none);
}

TEST(ViewDrag, theRightAndWithShiftTheMiddleButtonAreClicksUntilTheyMove) {
  Comparison comparison = shown();
  comparison.turnsAboutMm = glm::dvec3(1, 2, 3);
  for (const auto& [button, modifiers, click] :
       {std::tuple(Qt::RightButton, Qt::KeyboardModifiers(Qt::NoModifier), ViewClick::menu),
        std::tuple(Qt::MiddleButton, Qt::KeyboardModifiers(Qt::ShiftModifier), ViewClick::turnAbout)}) {
    ViewDrag drag = dragOf(comparison, {button, modifiers, {200, 120}});
    EXPECT_EQ(drag.turnsAbout, comparison.turnsAboutMm);
    EXPECT_EQ(editAt(drag, comparison.scene, {198, 121}), ViewEdit());
    EXPECT_EQ(drag.click, click);
    const ViewEdit edit = editAt(drag, comparison.scene, {200, 130});
    // What trembled is part of the drag that it became.
    EXPECT_EQ(edit,
              ViewEdit(dragged(comparison.scene.camera, drag.kind, {200, 120}, {200, 130}, drag.picture)));
    EXPECT_EQ(drag.click, ViewClick::none);
  }
  for (const Press& press : {Press{Qt::MiddleButton, Qt::NoModifier, {200, 120}},
                             Press{Qt::LeftButton, Qt::NoModifier, {200, 120}},
                             Press{Qt::RightButton, Qt::ShiftModifier, {200, 120}}})
    EXPECT_EQ(dragOf(comparison, press).click, ViewClick::none);
}

TEST(ViewDrag, knowsThePictureInWhichItBegan) {
  const Comparison comparison = shown(CompareLayout::sideBySide);
  EXPECT_EQ(dragOf(comparison, {Qt::LeftButton, Qt::NoModifier, {300, 120}}).picture,
            QRectF(201, 0, 199, 240));
}

} // namespace
} // namespace limn
