// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/MainWindow.h"

#include "widgets/effects/EffectsPanel.h"

#include <QDockWidget>

#include <array>

// What the picture calls for, and what that costs.

namespace limn {

void MainWindow::makeEffectsDock() {
  m_effects = new EffectsPanel(this);
  m_effectsDock = addDock(tr("Effects"), QStringLiteral("effectsDock"), m_effects, Qt::RightDockWidgetArea);
  setTabPosition(Qt::RightDockWidgetArea, QTabWidget::North);
  tabifyDockWidget(m_shadingDock, m_effectsDock);
}

void MainWindow::connectEffects() {
  connect(m_view, &CompareView::effectsChanged, m_effects, &EffectsPanel::setRows);
  connect(m_view, &CompareView::effectTimesChanged, m_effects, &EffectsPanel::setTimes);
  connect(m_effects, &EffectsPanel::measureRequested, m_view, &CompareView::measureEffects);
}

// They lie in one place; what lay on top does so again.
void MainWindow::showRightDocks(bool shown) {
  const std::array docks{m_shadingDock, m_effectsDock, m_accuracyDock};
  if (!shown)
    for (QDockWidget* dock : docks)
      if (!dock->widget()->visibleRegion().isEmpty())
        m_rightDockOnTop = dock;
  for (QDockWidget* dock : docks)
    dock->setVisible(shown);
  if (shown && m_rightDockOnTop)
    m_rightDockOnTop->raise();
}

} // namespace limn
