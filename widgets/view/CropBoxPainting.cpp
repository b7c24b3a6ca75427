// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/CropBoxPainting.h"

#include <QPainter>

#include <cmath>
#include <numbers>

namespace limn {
namespace {

const QColor lightColor(255, 255, 255);
const QColor darkColor(0, 0, 0);
const QColor accentColor(77, 163, 255);
constexpr double hiddenOpacity = 0.35;

void paintEdges(QPainter& painter, const CropBoxShape& shape, bool hidden) {
  painter.setOpacity(hidden ? hiddenOpacity : 0.9);
  for (const auto& [color, width] : {std::pair(darkColor, 3.0), std::pair(lightColor, 1.0)}) {
    QColor ink = color;
    ink.setAlpha(color == darkColor ? 120 : 255);
    QPen pen(ink, width, Qt::SolidLine, Qt::FlatCap);
    if (hidden)
      pen.setDashPattern({6.0 / width, 4.0 / width}); // counted in widths
    painter.setPen(pen);
    for (const CropEdge& edge : shape.edges)
      if (edge.isHidden == hidden)
        painter.drawLine(edge.line);
  }
}

void paintHandle(QPainter& painter, const CropHandle& handle, bool lively) {
  painter.setOpacity(handle.isHidden && !lively ? hiddenOpacity : 1.0);
  const double radius = lively ? cropHandleRadius + 1.5 : cropHandleRadius;
  painter.setPen(QPen(QColor(0, 0, 0, 200), 1.5));
  painter.setBrush(lively ? accentColor : lightColor);
  painter.drawEllipse(handle.centre, radius, radius);
}

void paintHandles(QPainter& painter, const CropBoxShape& shape, const std::optional<CropFace>& lively,
                  bool hidden) {
  for (const CropHandle& handle : shape.handles)
    if (handle.isHidden == hidden && handle.canMove)
      paintHandle(painter, handle, lively == handle.face);
}

} // namespace

void paintCropBox(QPainter& painter, const CropBoxShape& shape, const std::optional<CropFace>& lively) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  for (const bool hidden : {true, false}) {
    paintEdges(painter, shape, hidden);
    paintHandles(painter, shape, lively, hidden);
  }
  painter.restore();
}

Qt::CursorShape cursorFor(const CropHandle& handle) {
  // The angle of the way, y up, folded to a half turn and counted in eighths of a turn.
  const double angle = std::atan2(-handle.outward.y(), handle.outward.x()) / std::numbers::pi * 4.0;
  switch ((static_cast<int>(std::lround(angle)) + 8) % 4) {
  case 1:
    return Qt::SizeBDiagCursor;
  case 2:
    return Qt::SizeVerCursor;
  case 3:
    return Qt::SizeFDiagCursor;
  default:
    return Qt::SizeHorCursor;
  }
}

} // namespace limn
