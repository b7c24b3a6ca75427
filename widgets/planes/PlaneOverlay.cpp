// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/planes/PlaneOverlay.h"

#include "planes/PlaneGrid.h"
#include "widgets/MeasureText.h"
#include "widgets/planes/PlaneContent.h"
#include "widgets/planes/PlaneMeasures.h"
#include "widgets/view/overlay/OverlayParts.h"

#include <QObject>
#include <QPainter>

#include <algorithm>

namespace limn {
namespace {

const QColor shadowColor(0, 0, 0, 160);
const QColor lineColor(77, 163, 255);
const QColor cropColor(255, 255, 255);

// Free of lines around the crosshair, so that the tissue there is seen, logical pixels.
constexpr double openPixels = 8.0;

Note noteBelow(const QFont& font, const QString& text, double left, double top, double room) {
  Note note = noteAt(font, text, {left, 0.0}, Qt::AlignLeft, room);
  note.plate.moveTop(top);
  return note;
}

// Title, place and value at the upper left, the window at the lower right.
std::vector<Note> notesOf(const PlaneContent& content, PatientPlane plane, bool isOutsideCrop,
                          const QRectF& view, const QFont& font) {
  const double room = view.width() - 2.0 * overlayMargin;
  QString title =
      QStringLiteral("%1 · %2").arg(planeTitle(*content.volume, plane), slicePlaceText(content, plane));
  if (isOutsideCrop)
    title = QObject::tr("%1 · outside the crop").arg(title);
  std::vector<Note> notes{noteBelow(font, title, overlayMargin, overlayMargin, room)};
  if (view.height() < leastHeightForNotes)
    return notes;
  const QString value = crosshairText(content);
  notes.push_back(noteBelow(font, value.isEmpty() ? QObject::tr("Crosshair outside the volume") : value,
                            overlayMargin, notes.front().plate.bottom() + overlayMargin / 3, room));
  notes.push_back(noteAt(font, windowText(content),
                         view.bottomRight() - QPointF(overlayMargin, overlayMargin), Qt::AlignRight, room));
  return notes;
}

std::optional<ScaleMark> scaleOf(const PlaneContent& content, const PlaneFrame& frame, const QRectF& view,
                                 const QFont& font) {
  if (!content.volume->info().spacingKnown || view.height() < leastHeightForNotes)
    return std::nullopt;
  const ScaleBar bar = scaleBar(mmPerLogicalPixel(frame), std::min(120.0, view.width() / 4));
  if (bar.pixels < 8.0)
    return std::nullopt;
  const QString text = QObject::tr("%1 mm").arg(bar.lengthMm);
  return ScaleMark{bar, text, scaleBarPlate(font, bar, text, view)};
}

// In the middle of an edge, but beside a line of the crosshair and not under it.
double besideLine(double middle, double line) {
  return std::abs(line - middle) < 1.5 * overlayMargin ? line + 2.0 * overlayMargin : middle;
}

void addLetters(PlaneOverlay& overlay, const PlaneContent& content, const PlaneAxes& axes) {
  std::vector<QRectF> plates;
  for (const Note& note : overlay.notes)
    plates.push_back(note.plate);
  if (overlay.scale)
    plates.push_back(overlay.scale->plate);
  const QRectF& view = overlay.view;
  const std::vector<double> column{besideLine(view.center().x(), overlay.crosshair.x())};
  const double lowest = view.bottom() - overlayMargin;
  if (!content.volume->info().orientationKnown) {
    Note note = noteAt(overlay.font, QObject::tr("Orientation unknown"), {column.front(), lowest},
                       Qt::AlignHCenter, view.width());
    note.plate.moveBottom(clearRowAbove(lowest, note.plate.size(), column, plates));
    overlay.notes.push_back(note);
    return;
  }
  overlay.letters = letterMarks(
      {lettersOf(-axes.right), lettersOf(axes.right), lettersOf(-axes.down), lettersOf(axes.down)},
      {view, column.front(), besideLine(view.center().y(), overlay.crosshair.y())}, overlay.font, plates);
}

// What texts beside measurements keep clear of.
std::vector<QRectF> platesOf(const PlaneOverlay& overlay) {
  std::vector<QRectF> plates;
  for (const Note& note : overlay.notes)
    plates.push_back(note.plate);
  if (overlay.scale)
    plates.push_back(overlay.scale->plate);
  if (overlay.letters)
    for (const std::optional<QRectF>& place : overlay.letters->places)
      if (place)
        plates.push_back(*place);
  return plates;
}

// A line that shows on any picture.
void paintLine(QPainter& painter, const QPointF& from, const QPointF& to, const QColor& color) {
  for (const auto& [ink, width] : {std::pair(shadowColor, 3.0), std::pair(color, 1.0)}) {
    painter.setPen(QPen(ink, width));
    painter.drawLine(from, to);
  }
}

void paintCrosshair(QPainter& painter, const QPointF& at, const QRectF& view) {
  const auto line = [&](const QPointF& from, const QPointF& to) { paintLine(painter, from, to, lineColor); };
  line({view.left(), at.y()}, {at.x() - openPixels, at.y()});
  line({at.x() + openPixels, at.y()}, {view.right(), at.y()});
  line({at.x(), view.top()}, {at.x(), at.y() - openPixels});
  line({at.x(), at.y() + openPixels}, {at.x(), view.bottom()});
}

void paintCrop(QPainter& painter, const QPolygonF& outline) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(shadowColor, 3.0));
  painter.drawPolygon(outline);
  painter.setPen(QPen(cropColor, 1.5, Qt::DashLine));
  painter.drawPolygon(outline);
  painter.restore();
}

} // namespace

PlaneOverlay planeOverlay(const PlaneContent& content, PatientPlane plane, const PlaneFrame& frame,
                          const QSizeF& size, const QFont& font) {
  PlaneOverlay overlay;
  overlay.view = QRectF({0.0, 0.0}, size);
  overlay.font = font;
  overlay.crosshair = pointOf(frame, crosshairOf(content));
  if (content.settings.outlinesRegion)
    for (const glm::dvec3& corner : cropOutline(content.volume->grid(), content.crop, frame.grid))
      overlay.crop << pointOf(frame, corner);
  const bool isOutsideCrop =
      content.settings.outlinesRegion && content.crop != CropBox{} && overlay.crop.empty();
  overlay.notes = notesOf(content, plane, isOutsideCrop, overlay.view, font);
  overlay.title = overlay.notes.front().text;
  if (overlay.notes.size() > 1)
    overlay.window = overlay.notes.back().text;
  overlay.scale = scaleOf(content, frame, overlay.view, font);
  if (overlay.scale && overlay.scale->plate.intersects(overlay.notes.back().plate))
    overlay.scale.reset();
  addLetters(overlay, content, frame.grid.axes);
  overlay.measures =
      placedMeasures(measureShapes(content, plane, frame), font, overlay.view, platesOf(overlay));
  return overlay;
}

QString planeToolTip(const PlaneOverlay& overlay, const PlaneContent& content, const QPointF& point) {
  QString tip;
  for (const Note& note : overlay.notes)
    if (note.plate.contains(point) && note.text != note.whole)
      tip = note.whole;
  for (const MeasureMark& mark : overlay.measures)
    if (mark.note && mark.note->plate.contains(point))
      tip = measureDetails(content.measured[mark.shape.number], *content.volume);
  return tip.isEmpty() ? tip
                       : QStringLiteral("<p style='white-space:pre-wrap'>%1</p>").arg(tip.toHtmlEscaped());
}

void paintPlaneOverlay(QPainter& painter, const PlaneOverlay& overlay) {
  painter.setFont(overlay.font);
  painter.setRenderHint(QPainter::TextAntialiasing);
  if (!overlay.crop.empty())
    paintCrop(painter, overlay.crop);
  if (overlay.hasCrosshair)
    paintCrosshair(painter, overlay.crosshair, overlay.view);
  paintMeasures(painter, overlay.measures);
  for (const Note& note : overlay.notes)
    paintNote(painter, note);
  if (overlay.scale)
    paintScaleBar(painter, *overlay.scale);
  if (overlay.letters)
    paintLetters(painter, *overlay.letters);
}

} // namespace limn
