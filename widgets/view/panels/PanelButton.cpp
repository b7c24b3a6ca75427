// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/panels/PanelButton.h"

namespace limn {

QPushButton* panelButton(const QString& text, const QString& name, QWidget* parent) {
  auto* made = new QPushButton(text, parent);
  made->setObjectName(name);
  made->setAccessibleName(text);
  made->setCursor(Qt::PointingHandCursor);
  return made;
}

} // namespace limn
