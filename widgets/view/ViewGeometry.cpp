// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/ViewGeometry.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr double pictureGap = 2.0; // between pictures side by side, logical pixels
constexpr double wipeGrip = 12.0;  // to each side of the border

} // namespace

glm::ivec2 deviceSize(const ViewGeometry& geometry) {
  return {static_cast<int>(std::lround(geometry.size.width() * geometry.pixelRatio)),
          static_cast<int>(std::lround(geometry.size.height() * geometry.pixelRatio))};
}

std::vector<PixelRect> pictureRects(const ViewGeometry& geometry) {
  const glm::ivec2 size = deviceSize(geometry);
  if (size.y < 1)
    return {};
  if (geometry.layout == CompareLayout::sideBySide) {
    const int width = (size.x - static_cast<int>(std::lround(pictureGap * geometry.pixelRatio))) / 2;
    if (width < 1)
      return {};
    return {{{0, 0}, {width, size.y}}, {{size.x - width, 0}, {width, size.y}}};
  }
  if (size.x < 1)
    return {};
  return std::vector<PixelRect>(pictureCount(geometry.layout), PixelRect{{0, 0}, size});
}

QRectF pictureRect(const ViewGeometry& geometry, int position) {
  const std::vector<PixelRect> places = pictureRects(geometry);
  if (position >= static_cast<int>(places.size()))
    return QRectF({0.0, 0.0}, QSizeF(geometry.size));
  const double ratio = geometry.pixelRatio;
  const PixelRect& place = places[static_cast<std::size_t>(position)];
  return {place.topLeft.x / ratio, place.topLeft.y / ratio, place.size.x / ratio, place.size.y / ratio};
}

double pictureAspect(const ViewGeometry& geometry) {
  const std::vector<PixelRect> places = pictureRects(geometry);
  return places.empty() ? 1.0 : static_cast<double>(places[0].size.x) / places[0].size.y;
}

int standingCount(const ViewGeometry& geometry) {
  return geometry.layout == CompareLayout::sideBySide ? 2 : 1;
}

int wipeColumn(const ViewGeometry& geometry) {
  return static_cast<int>(std::lround(std::clamp(geometry.wipe, 0.0, 1.0) * deviceSize(geometry).x));
}

double wipeX(const ViewGeometry& geometry) {
  return geometry.wipe * geometry.size.width();
}

bool isOnWipeBorder(const ViewGeometry& geometry, const QPointF& point) {
  return geometry.layout == CompareLayout::wipe && std::abs(point.x() - wipeX(geometry)) <= wipeGrip;
}

int positionAt(const ViewGeometry& geometry, const QPointF& point) {
  const double x = point.x() * geometry.pixelRatio;
  switch (geometry.layout) {
  case CompareLayout::sideBySide:
    return x < 0.5 * deviceSize(geometry).x ? 0 : 1;
  case CompareLayout::wipe:
    return x < wipeColumn(geometry) ? 0 : 1;
  case CompareLayout::single:
  case CompareLayout::difference:
    break;
  }
  return 0;
}

int standingAt(const ViewGeometry& geometry, const QPointF& point) {
  return geometry.layout == CompareLayout::sideBySide ? positionAt(geometry, point) : 0;
}

} // namespace limn
