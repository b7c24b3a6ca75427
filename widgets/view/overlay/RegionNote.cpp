// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/overlay/RegionNote.h"

#include "widgets/view/overlay/Titles.h"

#include <QObject>

#include <algorithm>

namespace limn {

QString regionText(const Region& region) {
  if (!isRestricting(region))
    return {};
  if (region.kind == Region::Kind::body)
    return QObject::tr("Body only: table hidden");
  const auto weighed = std::count_if(region.weights.begin(), region.weights.end(),
                                     [](double weight) { return weight != 1.0; });
  return weighed == 1 ? QObject::tr("1 label hidden or faded")
                      : QObject::tr("%1 labels hidden or faded").arg(weighed);
}

QString hiddenText(const Scene& scene) {
  const QString region = regionText(scene.keep);
  if (scene.crop == CropBox{})
    return region;
  return region.isEmpty() ? QObject::tr("Cropped") : QObject::tr("%1 · cropped").arg(region);
}

std::optional<Note> regionNoteOf(const OverlaySource& source, int position) {
  const QString text = hiddenText(source.comparison.scene);
  if (text.isEmpty() || source.geometry.size.height() < leastHeightForNotes)
    return std::nullopt;
  const QRectF above = labelsOf(source)[static_cast<std::size_t>(position)].steadyPlate;
  const double room = pictureRect(source.geometry, position).width() - 2 * overlayMargin;
  const auto noteWith = [&](const QString& words) {
    return noteAt(source.font, words, {above.left(), 0.0}, Qt::AlignLeft, room);
  };
  const Note atRest = noteWith(text);
  const Note underPointer = noteWith(QObject::tr("Show everything"));
  Note note = source.hovered.region == position ? underPointer : atRest;
  note.plate.setWidth(std::max(atRest.plate.width(), underPointer.plate.width()));
  note.plate.moveTop(above.bottom() + overlayMargin / 2);
  return note;
}

int regionNoteAt(const OverlaySource& source, const QPointF& point) {
  for (int position = 0; position < standingCount(source.geometry); ++position)
    if (const std::optional<Note> note = regionNoteOf(source, position); note && note->plate.contains(point))
      return position;
  return -1;
}

} // namespace limn
