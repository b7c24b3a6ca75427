// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/CompareView.h"

#include "widgets/ValueText.h"
#include "widgets/scene/AxisNames.h"
#include "widgets/view/CropBoxPainting.h"

#include <QMouseEvent>
#include <QPainter>

// The crop box over the pictures of the compare view.

namespace limn {
namespace {

QString faceName(const Volume& volume, CropFace face) {
  const AxisName name =
      axisNames(volume.grid(), volume.info().orientationKnown)[static_cast<std::size_t>(face.axis)];
  const QString end = face.isUpper ? name.highEnd : name.lowEnd;
  return volume.info().orientationKnown ? end : name.axis + QLatin1Char(' ') + end;
}

} // namespace

void CompareView::setCropBoxVisible(bool visible) {
  if (visible == m_cropBoxVisible)
    return;
  m_cropBoxVisible = visible;
  m_hoveredFace.reset();
  update();
}

std::optional<QPointF> CompareView::cropHandle(CropFace face, int position) const {
  if (!m_cropBoxVisible || !m_scene.volume)
    return std::nullopt;
  for (const CropHandle& handle : cropShape(position).handles)
    if (handle.face == face && handle.canMove)
      return handle.centre;
  return std::nullopt;
}

int CompareView::pictureUnder(const QPointF& point) const {
  return m_layout == CompareLayout::sideBySide ? positionAt(point) : 0;
}

CropBoxShape CompareView::cropShape(int position) const {
  return cropBoxShape(m_scene.crop, m_scene.volume->grid(),
                      viewProjection(m_scene.camera, logicalRect(position)));
}

std::optional<CropHandle> CompareView::cropHandleAt(const QPointF& point) const {
  if (!m_cropBoxVisible || !m_scene.volume)
    return std::nullopt;
  return handleAt(cropShape(pictureUnder(point)), point);
}

bool CompareView::beginCropDrag(const QMouseEvent& event) {
  const std::optional<CropHandle> handle = cropHandleAt(event.position());
  if (!handle)
    return false;
  Drag drag;
  drag.button = event.button();
  drag.first = drag.last = event.position();
  drag.side = logicalRect(pictureUnder(drag.first));
  drag.crop = m_scene.crop;
  drag.face = handle->face;
  drag.grip = drag.first - handle->centre;
  drag.gesture = {nextGestureId(), tr("move crop face: %1").arg(faceName(*m_scene.volume, handle->face))};
  m_drag = drag;
  m_hoveredFace = handle->face;
  update();
  return true;
}

void CompareView::dragCrop(const QPointF& to) {
  const Drag& drag = *m_drag;
  const Grid& grid = m_scene.volume->grid();
  const ViewProjection projection = viewProjection(m_scene.camera, drag.side);
  const double place = placeUnder(drag.crop, grid, *drag.face, projection, to - drag.grip);
  const CropBox crop = withFaceAt(drag.crop, grid, *drag.face, place);
  if (crop != m_scene.crop)
    emit cropEdited(crop, drag.gesture);
}

void CompareView::resetFace(CropFace face) {
  const CropBox crop = withFaceAt(m_scene.crop, m_scene.volume->grid(), face, face.isUpper ? 1.0 : 0.0);
  if (crop != m_scene.crop)
    emit cropEdited(crop, {nextGestureId(), tr("reset crop face: %1").arg(faceName(*m_scene.volume, face))});
}

void CompareView::paintCropBoxes(QPainter& painter) const {
  if (!m_cropBoxVisible)
    return;
  const int pictures = m_layout == CompareLayout::sideBySide ? 2 : 1;
  const std::optional<CropFace> held = m_drag && m_drag->face ? m_drag->face : std::nullopt;
  for (int position = 0; position < pictures; ++position) {
    painter.save();
    painter.setClipRect(logicalRect(position));
    const CropBoxShape shape = cropShape(position);
    paintCropBox(painter, shape, held ? held : m_hoveredFace);
    for (const CropHandle& handle : shape.handles)
      if (held == handle.face)
        paintNote(painter, cropNote(handle));
    painter.restore();
  }
}

// What a held face cuts off, beside its handle.
Note CompareView::cropNote(const CropHandle& handle) const {
  const Volume& volume = *m_scene.volume;
  const CropFace face = handle.face;
  const double place = placeOf(m_scene.crop, face);
  const double cut = face.isUpper ? 1.0 - place : place;
  QString text = tr("%1: %2 % cut").arg(faceName(volume, face), plainNumber(100.0 * cut, 1));
  if (volume.info().spacingKnown)
    text += tr(" · %1 mm").arg(plainNumber(cut * boxSizeMm(volume.grid())[face.axis], 1));
  Note note = noteAt(font(), text, {0.0, 0.0}, Qt::AlignLeft, width());
  note.plate.moveCenter(handle.centre + QPointF(0.0, -28.0));
  const QRectF room = QRectF(rect()).adjusted(4.0, 4.0, -4.0, -4.0);
  note.plate.moveLeft(std::max(room.left(), std::min(note.plate.left(), room.right() - note.plate.width())));
  note.plate.moveTop(std::max(room.top(), note.plate.top()));
  return note;
}

} // namespace limn
