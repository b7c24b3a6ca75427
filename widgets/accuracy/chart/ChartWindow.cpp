// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/accuracy/chart/ChartWindow.h"

#include "widgets/controls/PopupPlacement.h"

#include <QScreen>
#include <QVBoxLayout>

namespace limn {

ChartWindow::ChartWindow(QWidget* parent) : QDialog(parent), m_room(new QVBoxLayout(this)) {
  setWindowTitle(tr("Error against time"));
  setAttribute(Qt::WA_ShowWithoutActivating);
  m_room->setContentsMargins(0, 0, 0, 0);
}

void ChartWindow::openBeside(QWidget& chart, const QWidget& panel) {
  m_room->addWidget(&chart);
  chart.show();
  const QRect room = panel.screen()->availableGeometry();
  // However far the panel is scrolled.
  const QRect window(panel.window()->mapToGlobal(QPoint(0, 0)), panel.window()->size());
  const QRect column(panel.mapToGlobal(QPoint(0, 0)).x(), window.top(), panel.width(), window.height());
  setGeometry(popupPlace(sizeHint().boundedTo(room.size()), column, room));
  show();
}

} // namespace limn
