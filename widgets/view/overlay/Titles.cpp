// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/overlay/Titles.h"

#include "widgets/properties/ProjectionSection.h"
#include "widgets/view/overlay/OverlayRows.h"
#include "widgets/view/overlay/SideText.h"

#include <QObject>

#include <algorithm>

namespace limn {
namespace {

// Without the numbers of the last picture at rest, which is not the one that is seen.
SideState whileMoving(SideState state) {
  state.completeMs.reset();
  state.contrast.reset();
  state.overflow.reset();
  return state;
}

SideLabel labelOf(const OverlaySource& source, int position) {
  const int side = sideShownAt(source.comparison, position);
  const Scene scene = sceneOfSide(source.comparison, side);
  const bool isDrawn = side < static_cast<int>(source.state.sides.size());
  SideLabel label;
  label.title = sideTitle(source.comparison, side);
  label.leadsToMenu = usesLight(scene.projection);
  const SideState state = isDrawn ? source.state.sides[static_cast<std::size_t>(side)] : SideState{};
  label.details = sideDetails(scene, source.state.resting ? state : whileMoving(state));
  label.hovered = position == source.hovered.label;
  label.detailsOpacity = label.hovered ? 1.0 : source.labelOpacity;
  return label;
}

// Where two labels over one picture part: at the border of the wipe, unless that leaves one of them no room.
double partingOf(const OverlaySource& source, const QRectF& picture) {
  constexpr double least = 160.0;
  const bool isWipe = source.geometry.layout == CompareLayout::wipe;
  return isWipe && picture.width() > 2 * least
             ? std::clamp(wipeX(source.geometry), picture.left() + least, picture.right() - least)
             : picture.center().x();
}

QRectF plateOf(const OverlaySource& source, int position, const SideLabel& label) {
  QRectF side = pictureRect(source.geometry, position);
  const CompareLayout layout = source.geometry.layout;
  const bool isShared = layout == CompareLayout::wipe || layout == CompareLayout::difference;
  if (isShared) { // two labels share one picture: each has its part
    const double parting = partingOf(source, side);
    position == 0 ? side.setRight(parting) : side.setLeft(parting);
  }
  return labelPlate(source.font, label, side, isShared && position == 1 ? Qt::AlignRight : Qt::AlignLeft);
}

} // namespace

std::vector<PlacedLabel> labelsOf(const OverlaySource& source) {
  std::vector<PlacedLabel> labels;
  for (int position = 0; position < pictureCount(source.geometry.layout); ++position) {
    const SideLabel label = labelOf(source, position);
    SideLabel steady = label;
    steady.detailsOpacity = 1.0;
    labels.push_back({label, plateOf(source, position, label), plateOf(source, position, steady)});
  }
  return labels;
}

std::optional<DifferenceTitle> differenceTitleOf(const OverlaySource& source) {
  if (source.geometry.layout != CompareLayout::difference)
    return std::nullopt;
  const std::vector<PlacedLabel> labels = labelsOf(source);
  const std::vector<QRectF> plates{labels[0].steadyPlate, labels[1].steadyPlate};
  DifferenceTitle title;
  title.label.label.title = QObject::tr("%2 minus %1, ×%3")
                                .arg(sideTitle(source.comparison, 0), sideTitle(source.comparison, 1))
                                .arg(differenceGain);
  title.label.label.leadsToMenu = false;
  QRectF plate = labelPlate(source.font, title.label.label, source.view(), Qt::AlignHCenter);
  plate.moveTop(clearRowBelow(plate.top(), plate.size(), {plate.center().x()}, plates));
  title.label.plate = title.label.steadyPlate = plate;
  title.note =
      noteAt(source.font, QObject::tr("Black where both are equal, brighter the more they differ"),
             {plate.center().x(), 0.0}, Qt::AlignHCenter, source.geometry.size.width() - 2 * overlayMargin);
  title.note.plate.moveTop(clearRowBelow(plate.bottom() + overlayMargin / 3, title.note.plate.size(),
                                         {plate.center().x()}, plates));
  return title;
}

int labelAt(const OverlaySource& source, const QPointF& point) {
  const std::vector<PlacedLabel> labels = labelsOf(source);
  for (std::size_t position = 0; position < labels.size(); ++position)
    if (labels[position].label.leadsToMenu && labels[position].plate.contains(point))
      return static_cast<int>(position);
  return -1;
}

// Only over titles and notes: a tool tip anywhere else would cover the picture.
QString toolTipAt(const OverlaySource& source, const QPointF& point) {
  if (source.hovered.hidden)
    return source.hovered.hidden->by == HiddenBy::crop
               ? QObject::tr(
                     "The crop box cuts a part of the volume off. A click shows all of it again; B shows "
                     "the box.")
               : QObject::tr(
                     "A part of the volume is hidden. A click shows everything again; View ▸ Body only "
                     "hides the table and what else lies beside the body.");
  const std::optional<DifferenceTitle> title = differenceTitleOf(source);
  if (!title || !(title->label.plate.contains(point) || title->note.plate.contains(point)))
    return {};
  return QObject::
      tr("<p>Black where both sides show the same; blue where the left side is brighter, orange where the "
         "right side is, by the part of the colour that differs most. Differences are shown %1 times as "
         "large as they are.</p>")
          .arg(differenceGain);
}

} // namespace limn
