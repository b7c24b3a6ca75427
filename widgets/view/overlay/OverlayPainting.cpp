// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/overlay/Overlay.h"

#include "widgets/view/overlay/CropBoxOverlay.h"

#include <QOpenGLPaintDevice>
#include <QPainter>
#include <QRegion>

namespace limn {
namespace {

// Lines of the box would strike through what is written there.
QRegion besideTexts(const Overlay& overlay, const QRectF& picture) {
  QRegion region(picture.toAlignedRect());
  for (const PlacedLabel& label : overlay.labels)
    region -= label.plate.toAlignedRect();
  for (const Note& note : overlay.notes)
    region -= note.plate.toAlignedRect();
  if (overlay.scale)
    region -= overlay.scale->plate.toAlignedRect();
  return region;
}

void paintCropBoxes(QPainter& painter, const Overlay& overlay) {
  for (const CropBoxOverlay& box : overlay.cropBoxes) {
    painter.save();
    painter.setClipRegion(besideTexts(overlay, box.picture));
    paintCropBox(painter, box.shape, box.lively);
    if (box.note)
      paintNote(painter, *box.note);
    painter.restore();
  }
}

void paintTitles(QPainter& painter, const Overlay& overlay) {
  for (const PlacedLabel& label : overlay.labels)
    paintLabel(painter, label.label, label.plate);
  if (!overlay.difference)
    return;
  paintLabel(painter, overlay.difference->label.label, overlay.difference->label.plate);
  painter.setOpacity(overlay.explanationOpacity);
  paintNote(painter, overlay.difference->note);
  painter.setOpacity(1.0);
}

} // namespace

void paintOverlay(QPainter& painter, const Overlay& overlay) {
  painter.setFont(overlay.font);
  painter.setRenderHint(QPainter::TextAntialiasing);
  if (overlay.gap)
    painter.fillRect(*overlay.gap, QColor(70, 76, 88));
  paintCropBoxes(painter, overlay);
  for (const QPointF& mark : overlay.marks)
    paintMark(painter, mark);
  for (const QPointF& half : overlay.halves)
    paintHalfMark(painter, half);
  if (overlay.border)
    paintWipeBorder(painter, overlay.border->x, overlay.view, overlay.border->isHovered);
  paintTitles(painter, overlay);
  for (const Note& note : overlay.notes)
    paintNote(painter, note);
  if (overlay.differenceBar)
    paintDifferenceBar(painter, *overlay.differenceBar);
  if (overlay.scale)
    paintScaleBar(painter, *overlay.scale);
  for (const LetterMarks& letters : overlay.letters)
    paintLetters(painter, letters);
  if (overlay.reading)
    paintProbe(painter, overlay.reading->at, overlay.reading->text, overlay.view);
  for (const double fraction : overlay.progress)
    paintProgress(painter, fraction, overlay.view);
}

// Not on the widget itself: while a window is grabbed, Qt would lead its painters elsewhere.
void paintOverlayInContext(const Overlay& overlay, const ViewGeometry& geometry) {
  const glm::ivec2 size = deviceSize(geometry);
  QOpenGLPaintDevice device(size.x, size.y);
  device.setDevicePixelRatio(geometry.pixelRatio);
  QPainter painter(&device);
  paintOverlay(painter, overlay);
}

} // namespace limn
