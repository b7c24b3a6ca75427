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

std::optional<Note> regionNoteOf(const OverlaySource& source) {
  const QString text = regionText(source.comparison.scene.keep);
  if (text.isEmpty() || source.geometry.size.height() < leastHeightForNotes)
    return std::nullopt;
  const QRectF above = labelsOf(source).front().steadyPlate;
  Note note =
      noteAt(source.font, source.hovered.region ? QObject::tr("%1 – show everything").arg(text) : text,
             {above.left(), 0.0}, Qt::AlignLeft, pictureRect(source.geometry, 0).width() - 2 * overlayMargin);
  note.plate.moveTop(above.bottom() + overlayMargin / 2);
  return note;
}

bool isOnRegionNote(const OverlaySource& source, const QPointF& point) {
  const std::optional<Note> note = regionNoteOf(source);
  return note && note->plate.contains(point);
}

} // namespace limn
