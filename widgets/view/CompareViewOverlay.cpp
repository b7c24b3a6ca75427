// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/CompareView.h"

#include "widgets/scene/ProjectionSection.h"
#include "widgets/view/OverlayRows.h"
#include "widgets/view/SideText.h"
#include "widgets/view/ViewOverlay.h"

#include <QOpenGLPaintDevice>
#include <QPainter>

#include <algorithm>
#include <cmath>

// What stands above the pictures of the compare view.

namespace limn {
namespace {

constexpr double margin = 12.0;

// A value with as many digits as its range makes sensible.
QString valueText(double value, const Volume& volume) {
  const double span = volume.range().highest - volume.range().lowest;
  const int digits = span > 0.0 ? std::clamp(static_cast<int>(3.0 - std::log10(span)), 0, 6) : 0;
  const QString number = QString::number(value, 'f', digits);
  const QString unit = QString::fromStdString(volume.info().unit);
  return unit.isEmpty() ? number : QStringLiteral("%1 %2").arg(number, unit);
}

} // namespace

QRectF CompareView::logicalRect(int position) const {
  const std::vector<PixelRect> places = rects();
  if (position >= static_cast<int>(places.size()))
    return rect();
  const double ratio = devicePixelRatioF();
  const PixelRect& place = places[position];
  return {place.topLeft.x / ratio, place.topLeft.y / ratio, place.size.x / ratio, place.size.y / ratio};
}

SideLabel CompareView::labelOf(int position) const {
  const int side = sideShownAt(position);
  const Scene scene = sceneOfSide(side);
  const bool isDrawn = side < static_cast<int>(m_state.sides.size());
  SideLabel label;
  label.title = sideTitle(scene);
  label.leadsToMenu = usesLight(scene.projection);
  label.details = sideDetails(scene, isDrawn ? m_state.sides[side] : SideState{});
  label.hovered = position == m_hoveredLabel;
  label.detailsOpacity = label.hovered ? 1.0 : m_labelFade.currentValue().toDouble();
  return label;
}

// With `label` in place of what is shown there at present.
QRectF CompareView::labelPlateOf(int position, const SideLabel& label) const {
  QRectF side = logicalRect(position);
  const bool over = m_layout == CompareLayout::wipe || m_layout == CompareLayout::difference;
  if (over) // two labels share one picture: each has its half
    position == 0 ? side.setRight(side.center().x()) : side.setLeft(side.center().x());
  return labelPlate(font(), label, side, over && position == 1 ? Qt::AlignRight : Qt::AlignLeft);
}

QRectF CompareView::labelRect(int position) const {
  return labelPlateOf(position, labelOf(position));
}

// The label's plate while its numbers show: what yields to a label must not jump when they fade.
QRectF CompareView::steadyLabelRect(int position) const {
  SideLabel label = labelOf(position);
  label.detailsOpacity = 1.0;
  return labelPlateOf(position, label);
}

SideLabel CompareView::differenceTitle() const {
  SideLabel title;
  title.title = tr("Difference of %1 and %2 ×%3")
                    .arg(sideTitle(sceneOfSide(0)), sideTitle(sceneOfSide(1)))
                    .arg(differenceGain);
  title.leadsToMenu = false;
  return title;
}

// In the middle, under the models' labels where it does not fit between them.
QRectF CompareView::differenceTitleRect() const {
  QRectF plate = labelPlate(font(), differenceTitle(), rect(), Qt::AlignHCenter);
  plate.moveTop(clearRowBelow(plate.top(), plate.size(), {plate.center().x()},
                              {steadyLabelRect(0), steadyLabelRect(1)}));
  return plate;
}

Note CompareView::differenceNote() const {
  const QRectF title = differenceTitleRect();
  Note note = noteAt(font(), tr("Black where both are equal, brighter the more they differ"),
                     {title.center().x(), 0.0}, Qt::AlignHCenter, width() - 2 * margin);
  note.plate.moveTop(clearRowBelow(title.bottom() + margin / 3, note.plate.size(), {title.center().x()},
                                   {steadyLabelRect(0), steadyLabelRect(1)}));
  return note;
}

void CompareView::paintOverlay() {
  // Not on the widget itself: while a window is grabbed, Qt would lead its painters elsewhere.
  const glm::ivec2 size = deviceSize();
  QOpenGLPaintDevice device(size.x, size.y);
  device.setDevicePixelRatio(devicePixelRatioF());
  QPainter painter(&device);
  painter.setFont(font());
  painter.setRenderHint(QPainter::TextAntialiasing);
  if (m_layout == CompareLayout::sideBySide) {
    const QRectF left = logicalRect(0);
    const QRectF right = logicalRect(1);
    painter.fillRect(QRectF(left.topRight(), right.bottomLeft()), QColor(70, 76, 88));
  }
  paintCropBoxes(painter);
  if (m_layout == CompareLayout::wipe)
    paintWipeBorder(painter, m_wipe * width(), rect(), m_wipeHovered || (m_drag && m_drag->wipe));
  std::vector<QRectF> plates = paintTitles(painter);
  const std::vector<QRectF> notes = paintNotes(painter);
  plates.insert(plates.end(), notes.begin(), notes.end());
  paintOrientation(painter, plates);
  if (m_probe)
    paintProbe(painter, m_probePoint, valueText(m_probe->value, *m_scene.volume), rect());
  if (m_state.refines)
    paintProgress(painter, m_state.refinementFraction, rect());
  if (!m_state.resting && !m_state.sides.empty()) {
    double fraction = 0.0;
    for (const SideState& side : m_state.sides)
      fraction += side.fraction / m_state.sides.size();
    paintProgress(painter, fraction, rect());
  }
}

// What the pictures are, at the upper edge; tells the plates.
std::vector<QRectF> CompareView::paintTitles(QPainter& painter) {
  std::vector<QRectF> plates;
  for (int position = 0; position < pictureCount(m_layout); ++position) {
    paintLabel(painter, labelOf(position), labelRect(position));
    plates.push_back(steadyLabelRect(position));
  }
  if (m_layout == CompareLayout::difference) {
    paintLabel(painter, differenceTitle(), differenceTitleRect());
    const Note note = differenceNote();
    painter.setOpacity(m_labelFade.currentValue().toDouble());
    paintNote(painter, note);
    painter.setOpacity(1.0);
    plates.insert(plates.end(), {differenceTitleRect(), note.plate});
  }
  return plates;
}

// Scale and notes at the lower edge; tells the plates. The notes never give way, the scale does.
std::vector<QRectF> CompareView::paintNotes(QPainter& painter) {
  const double room = width() - 2 * margin;
  const Note warning =
      noteAt(font(), tr("Not for diagnosis"), {width() - margin, height() - margin}, Qt::AlignRight, room);
  paintNote(painter, warning);
  std::vector<QRectF> plates{warning.plate};
  const std::optional<ScaleMark> scale = scaleMark();
  if (scale && !scale->plate.adjusted(0.0, 0.0, margin, 0.0).intersects(warning.plate)) {
    paintScaleBar(painter, *scale);
    plates.push_back(scale->plate);
  }
  if (!m_state.limitation.isEmpty()) {
    Note note =
        noteAt(font(), m_state.limitation, {width() / 2.0, height() - 3 * margin}, Qt::AlignHCenter, room);
    note.plate.moveBottom(
        clearRowAbove(note.plate.bottom(), note.plate.size(), {note.plate.center().x()}, plates));
    paintNote(painter, note);
    plates.push_back(note.plate);
  }
  return plates;
}

void CompareView::paintOrientation(QPainter& painter, const std::vector<QRectF>& plates) {
  const int pictures = m_layout == CompareLayout::sideBySide ? 2 : 1;
  std::vector<double> columns;
  for (int position = 0; position < pictures; ++position) {
    double column = logicalRect(position).center().x();
    if (m_layout == CompareLayout::wipe && std::abs(m_wipe * width() - column) < 2 * margin)
      column = m_wipe * width() + 2 * margin; // beside the border, not under it
    columns.push_back(column);
  }
  if (!m_scene.volume->info().orientationKnown) {
    Note note =
        noteAt(font(), tr("Orientation unknown"), {0.0, 0.0}, Qt::AlignHCenter, logicalRect(0).width());
    note.plate.moveBottom(clearRowAbove(height() - margin, note.plate.size(), columns, plates));
    for (const double column : columns) {
      note.plate.moveLeft(column - note.plate.width() / 2);
      paintNote(painter, note);
    }
    return;
  }
  const QSizeF letter = letterSize(font());
  const double top = clearRowBelow(margin, letter, columns, plates);
  const double bottom = clearRowAbove(height() - margin, letter, columns, plates);
  for (int position = 0; position < pictures; ++position)
    paintLetters(painter, orientationLetters(m_scene.camera), logicalRect(position), columns[position], top,
                 bottom);
}

std::optional<ScaleMark> CompareView::scaleMark() const {
  if (!m_scene.volume->info().spacingKnown)
    return std::nullopt;
  const QRectF side = logicalRect(0);
  const ScaleBar bar = scaleBar(mmPerPixel(m_scene.camera, side.height()), std::min(160.0, side.width() / 4));
  if (bar.pixels < 8.0)
    return std::nullopt;
  const QString length = tr("%1 mm").arg(bar.lengthMm);
  // In perspective a length holds at one distance only.
  const bool perspective = m_scene.camera.projection == Camera::Projection::perspective;
  const QString text = perspective ? tr("%1 at the centre").arg(length) : length;
  return ScaleMark{bar, text, scaleBarPlate(font(), bar, text, side)};
}

} // namespace limn
