// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/controls/ResetLabel.h"

#include <QMouseEvent>

namespace limn {

void ResetLabel::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton)
    emit resetRequested();
}

} // namespace limn
