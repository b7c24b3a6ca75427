// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/gestures/DragCursor.h"

#include "widgets/Icons.h"
#include "widgets/Theme.h"

#include <QPainter>
#include <QPixmap>

namespace limn {
namespace {

constexpr int cursorSize = 24; // logical pixels

QPixmap iconIn(const QString& icon, bool isLight) {
  return themedIcon(icon, themePalette(isLight ? Look::dark : Look::light)).pixmap(cursorSize, cursorSize);
}

// A dark sign with a light edge.
QCursor cursorWith(const QString& icon) {
  QPixmap picture(cursorSize, cursorSize);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  const QPixmap edge = iconIn(icon, true);
  for (const QPoint offset : {QPoint(-1, 0), QPoint(1, 0), QPoint(0, -1), QPoint(0, 1)})
    painter.drawPixmap(offset, edge);
  painter.drawPixmap(0, 0, iconIn(icon, false));
  painter.end();
  return QCursor(picture);
}

} // namespace

QCursor cursorOf(DragKind kind) {
  switch (kind) {
  case DragKind::pan:
    return Qt::SizeAllCursor;
  case DragKind::zoom: {
    static const QCursor zoom = cursorWith(QStringLiteral("tool-zoom"));
    return zoom;
  }
  case DragKind::windowLevel: {
    static const QCursor windowLevel = cursorWith(QStringLiteral("tool-window-level"));
    return windowLevel;
  }
  default:
    return Qt::ArrowCursor;
  }
}

} // namespace limn
