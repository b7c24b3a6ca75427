// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/controls/LabelledRow.h"

#include <QWidget>

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

} // namespace limn
