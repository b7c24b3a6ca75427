// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/SharedPlace.h"

#include <QVBoxLayout>

#include <algorithm>

namespace limn {

SharedPlace::SharedPlace(QWidget& panel, const Sharers& sharers) : m_sharers(sharers) {
  m_sharers->append(&panel);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(&panel);
}

// Not a minimum that is set once: panels are measured before they have their font and style.
QSize SharedPlace::minimumSizeHint() const {
  QSize size = QWidget::minimumSizeHint();
  for (const QWidget* panel : *m_sharers)
    size.setWidth(std::max({size.width(), panel->minimumSizeHint().width(), panel->minimumWidth()}));
  return size;
}

} // namespace limn
