// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/overlay/HiddenNotes.h"

#include "widgets/view/overlay/Titles.h"

#include <QObject>

#include <algorithm>

namespace limn {
namespace {

// What it tells, and what a click on it does.
struct HiddenWords {
  HiddenBy by;
  QString atRest;
  QString underPointer;
};

std::vector<HiddenWords> hiddenWords(const Scene& scene) {
  std::vector<HiddenWords> words;
  if (const QString region = regionText(scene.keep); !region.isEmpty())
    words.push_back({HiddenBy::region, region, QObject::tr("Show everything")});
  if (scene.crop != CropBox{})
    words.push_back({HiddenBy::crop, QObject::tr("Cropped"), QObject::tr("Reset crop")});
  return words;
}

} // namespace

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

std::vector<HiddenNote> hiddenNotesOf(const OverlaySource& source, int position) {
  if (source.geometry.size.height() < leastHeightForNotes)
    return {};
  QRectF above = labelsOf(source)[static_cast<std::size_t>(position)].steadyPlate;
  const double room = pictureRect(source.geometry, position).width() - 2 * overlayMargin;
  const auto noteWith = [&](const QString& words) {
    return noteAt(source.font, words, {above.left(), 0.0}, Qt::AlignLeft, room);
  };
  std::vector<HiddenNote> notes;
  for (const HiddenWords& words : hiddenWords(source.comparison.scene)) {
    const Note atRest = noteWith(words.atRest);
    const Note underPointer = noteWith(words.underPointer);
    Note note = source.hovered.hidden == HiddenPlace{position, words.by} ? underPointer : atRest;
    note.plate.setWidth(std::max(atRest.plate.width(), underPointer.plate.width()));
    note.plate.moveTop(above.bottom() + overlayMargin / 2);
    above = note.plate;
    notes.push_back({words.by, note});
  }
  return notes;
}

std::optional<HiddenPlace> hiddenNoteAt(const OverlaySource& source, const QPointF& point) {
  for (int position = 0; position < standingCount(source.geometry); ++position)
    for (const HiddenNote& hidden : hiddenNotesOf(source, position))
      if (hidden.note.plate.contains(point))
        return HiddenPlace{position, hidden.by};
  return std::nullopt;
}

} // namespace limn
