// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/overlay/CropBoxOverlay.h"

#include "widgets/ValueText.h"
#include "widgets/properties/AxisNames.h"

#include <QObject>

#include <algorithm>

namespace limn {
namespace {

// What the face of a handle is called and cuts off, beside the handle and within its picture.
Note cropNote(const OverlaySource& source, const QRectF& picture, const CropHandle& handle) {
  const Volume& volume = source.volume();
  const CropFace face = handle.face;
  const double place = placeOf(source.comparison.scene.crop, face);
  const double cut = face.isUpper ? 1.0 - place : place;
  QString text = cropFaceName(volume, face);
  if (cut > 0.0)
    text = QObject::tr("%1: %2 % cut").arg(text, plainNumber(100.0 * cut, 1));
  if (cut > 0.0 && volume.info().spacingKnown)
    text += QObject::tr(" · %1 mm").arg(plainNumber(cut * boxSizeMm(volume.grid())[face.axis], 1));
  Note note = noteAt(source.font, text, {0.0, 0.0}, Qt::AlignLeft, source.geometry.size.width());
  note.plate.moveCenter(handle.centre + QPointF(0.0, -28.0));
  const QRectF room = picture.adjusted(4.0, 4.0, -4.0, -4.0);
  note.plate.moveLeft(std::max(room.left(), std::min(note.plate.left(), room.right() - note.plate.width())));
  note.plate.moveTop(std::max(room.top(), note.plate.top()));
  return note;
}

} // namespace

std::vector<CropBoxOverlay> cropBoxesOf(const OverlaySource& source) {
  std::vector<CropBoxOverlay> boxes;
  if (!source.hasCropBox)
    return boxes;
  for (int position = 0; position < standingCount(source.geometry); ++position) {
    CropBoxOverlay box{pictureRect(source.geometry, position),
                       cropShapeAt(source.comparison, source.geometry, position),
                       source.heldFace ? source.heldFace : source.hovered.face,
                       {}};
    for (const CropHandle& handle : box.shape.handles)
      if (box.lively == handle.face)
        box.note = cropNote(source, box.picture, handle);
    boxes.push_back(box);
  }
  return boxes;
}

CropBoxShape cropShapeAt(const Comparison& comparison, const ViewGeometry& geometry, int position) {
  return cropBoxShape(comparison.scene.crop, comparison.scene.volume->grid(),
                      viewProjection(comparison.scene.camera, pictureRect(geometry, position)));
}

std::optional<CropHandle> cropHandleAt(const OverlaySource& source, const QPointF& point) {
  if (!source.hasCropBox)
    return std::nullopt;
  const int position = standingAt(source.geometry, point);
  return handleAt(cropShapeAt(source.comparison, source.geometry, position), point);
}

} // namespace limn
