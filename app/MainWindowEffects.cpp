// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/MainWindow.h"

#include "widgets/effects/EffectsPanel.h"

#include <QDockWidget>

// What the picture calls for, and what that costs.

namespace limn {

void MainWindow::makeEffectsDock() {
  m_effects = new EffectsPanel(this);
  m_effectsDock = addDock(tr("Effects"), QStringLiteral("effectsDock"), m_effects, Qt::RightDockWidgetArea);
  setTabPosition(Qt::RightDockWidgetArea, QTabWidget::North);
  tabifyDockWidget(m_shadingDock, m_effectsDock);
  m_shadingDock->raise();
}

void MainWindow::connectEffects() {
  connect(m_view, &CompareView::effectsChanged, m_effects, &EffectsPanel::setRows);
  connect(m_view, &CompareView::effectTimesChanged, m_effects, &EffectsPanel::setTimes);
  connect(m_effects, &EffectsPanel::measureRequested, m_view, &CompareView::measureEffects);
}

// Both lie in one place; what lay on top does so again.
void MainWindow::showRightDocks(bool shown) {
  if (!shown)
    m_effectsWereOnTop = !m_effects->visibleRegion().isEmpty();
  m_shadingDock->setVisible(shown);
  m_effectsDock->setVisible(shown);
  if (shown)
    (m_effectsWereOnTop ? m_effectsDock : m_shadingDock)->raise();
}

} // namespace limn
