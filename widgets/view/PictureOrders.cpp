// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/PictureOrders.h"

#include "widgets/view/overlay/SideText.h"

#include <QObject>

namespace limn {

PictureRequest requestOf(const Comparison& comparison, const ViewGeometry& geometry) {
  const std::vector<PixelRect> places = pictureRects(geometry);
  PictureRequest request;
  request.scenes = scenesOfSides(comparison);
  if (!places.empty())
    request.size = places[0].size;
  if (comparison.layout == CompareLayout::wipe) { // of its two pictures each shows one part
    request.seen[static_cast<std::size_t>(sideShownAt(comparison, 0))].to = comparison.wipe;
    request.seen[static_cast<std::size_t>(sideShownAt(comparison, 1))].from = comparison.wipe;
    request.seenShare = 0.5;
  }
  const QString title = sideTitle(comparison, pictureCount(comparison.layout) - 1);
  request.lastName = request.scenes.size() == 1 ? title : QObject::tr("%1 (right)").arg(title);
  return request;
}

Pictures::Arrangement arrangementOf(const Comparison& comparison, const ViewGeometry& geometry) {
  return {comparison.layout, pictureRects(geometry), deviceSize(geometry), wipeColumn(geometry),
          comparison.isSwapped};
}

} // namespace limn
