// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/controls/LabelledRow.h"

#include <QImage>
#include <QPixmap>
#include <QWidget>

#include <optional>

namespace limn {

/// The widget of a kind that assistive technology knows by this name; null where there is none.
template <class Widget>
Widget* widgetNamed(const QWidget& parent, const char* name) {
  for (Widget* widget : parent.findChildren<Widget*>())
    if (widget->accessibleName() == QString::fromUtf8(name))
      return widget;
  return nullptr;
}

/// The row of a kind (ValueSlider, RangeSlider, ChoiceRow) that says this; null where there is none.
template <class Row>
Row* rowNamed(const QWidget& parent, const char* name) {
  for (const ResetLabel* label : parent.findChildren<ResetLabel*>())
    if (auto* row = qobject_cast<Row*>(label->parentWidget());
        row && label->text() == QString::fromUtf8(name))
      return row;
  return nullptr;
}

/// The middle of the first run of pixels of a colour along the middle line of a part of a widget, in its
/// logical pixels; nothing where that has none.
inline std::optional<QPoint> placeOfColor(QWidget& widget, const QRect& part, const QColor& color) {
  const QImage shown = widget.grab(part).toImage();
  const int y = shown.height() / 2;
  int first = 0;
  while (first < shown.width() && shown.pixelColor(first, y).rgb() != color.rgb())
    ++first;
  int end = first;
  while (end < shown.width() && shown.pixelColor(end, y).rgb() == color.rgb())
    ++end;
  if (first == end)
    return std::nullopt;
  return part.topLeft() + (QPointF(first + end - 1, 2 * y) / (2.0 * shown.devicePixelRatio())).toPoint();
}

} // namespace limn
