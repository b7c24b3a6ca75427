// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/drawing/ViewDrawing.h"

#include "widgets/view/overlay/Titles.h"

namespace limn {

PictureOrder pictureOrderOf(const ViewOrder& order) {
  const Comparison& comparison = order.comparison;
  PictureOrder pictures;
  pictures.isSeen = order.isSeen;
  pictures.attempt = order.attempt;
  pictures.scenes = scenesOfSides(comparison);
  for (Scene& scene : pictures.scenes) { // what saved pictures alone have begins none on screen anew
    scene.shading.physical.until = {};
    scene.shading.physical.filtersNoise = false;
  }
  pictures.layout = comparison.layout;
  pictures.places = pictureRects(order.geometry);
  if (!pictures.places.empty())
    pictures.size = pictures.places[0].size;
  pictures.screen = deviceSize(order.geometry);
  pictures.wipeColumn = wipeColumn(order.geometry);
  pictures.isSwapped = comparison.isSwapped;
  if (comparison.layout == CompareLayout::wipe) { // of its two pictures each shows one part
    pictures.seen[static_cast<std::size_t>(sideShownAt(comparison, 0))].to = comparison.wipe;
    pictures.seen[static_cast<std::size_t>(sideShownAt(comparison, 1))].from = comparison.wipe;
    pictures.seenShare = 0.5;
  }
  const QString title = sideTitle(comparison, pictureCount(comparison.layout) - 1);
  pictures.lastName = pictures.scenes.size() == 1 ? title : QObject::tr("%1 (right)").arg(title);
  pictures.refines = order.refines;
  pictures.movingMs = order.movingMs;
  return pictures;
}

RestingPicture restingPicture(const SidePicture& side) {
  return {side.picture().image, side.picture().bytes, side.finishedQuality()};
}

void ViewDrawing::show(const ViewOrder& order) {
  if (order == m_order)
    return;
  m_order = order;
  drawOrder(pictureOrderOf(order));
  canvas().update();
}

ViewNews ViewDrawing::news() const {
  ViewNews news = drawn();
  news.state = stateTold(std::move(news.state), m_order);
  return news;
}

} // namespace limn
