// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/MenuButton.h"

#include "widgets/controls/MenuHover.h"

#include <QMenu>
#include <QToolBar>

namespace limn {

QToolButton* addMenuButton(QToolBar& bar, QMenu* menu, QToolButton::ToolButtonPopupMode mode) {
  auto* button = new QToolButton(&bar);
  button->setPopupMode(mode);
  button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  button->setMenu(menu);
  looksIdleAfterMenu(*button);
  return button;
}

} // namespace limn
