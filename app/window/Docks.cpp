// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/Docks.h"

#include "widgets/accuracy/AccuracyPanel.h"
#include "widgets/curve/CurvePanel.h"
#include "widgets/effects/EffectsPanel.h"
#include "widgets/presets/PresetBrowser.h"
#include "widgets/properties/PropertiesPanel.h"

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>

#include <algorithm>

namespace limn {
namespace {

// A widget without height stands for the title where none is shown; View hides such a dock, too.
void setTitled(QDockWidget& dock, bool titled) {
  QWidget* placeholder = dock.titleBarWidget();
  if (titled == (placeholder == nullptr))
    return;
  dock.setTitleBarWidget(titled ? nullptr : new QWidget(&dock));
  delete placeholder;
}

} // namespace

Docks::Docks(QMainWindow& window, Panels& panels) : m_window(window) {
  panels.curves = new CurvePanel(&window);
  panels.properties = new PropertiesPanel(&window);
  panels.presets = new PresetBrowser(&window);
  window.setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
  window.setCorner(Qt::BottomRightCorner, Qt::BottomDockWidgetArea);
  window.setTabPosition(Qt::RightDockWidgetArea, QTabWidget::North);
  m_presets = add(tr("Presets"), "presetDock", panels.presets, Qt::LeftDockWidgetArea);
  m_right[0] = add(tr("Properties"), "shadingDock", panels.properties, Qt::RightDockWidgetArea);
  panels.effects = new EffectsPanel(&window);
  m_right[1] = add(tr("Effects"), "effectsDock", panels.effects, Qt::RightDockWidgetArea);
  window.tabifyDockWidget(m_right[0], m_right[1]);
  panels.accuracy = new AccuracyPanel(&window);
  m_right[2] = add(tr("Accuracy"), "accuracyDock", panels.accuracy, Qt::RightDockWidgetArea);
  window.tabifyDockWidget(m_right[1], m_right[2]);
  m_right[0]->raise();
  m_curve = add(tr("Transfer function"), "curveDock", panels.curves, Qt::BottomDockWidgetArea);
  window.resizeDocks({m_presets, m_right[0]}, {220, 300}, Qt::Horizontal);
  window.resizeDocks({m_curve}, {296}, Qt::Vertical);
  for (QDockWidget* dock : m_right)
    connect(dock, &QDockWidget::visibilityChanged, this, [this, dock](bool visible) {
      if (visible)
        m_seenLast = dock;
      emit panelChanged();
    });
  for (QDockWidget* dock : {m_presets, m_right[0], m_right[1], m_right[2], m_curve}) {
    connect(dock, &QDockWidget::topLevelChanged, this, &Docks::showTitles, Qt::QueuedConnection);
    // Of a dock behind another one that is hidden, its visibility tells nothing.
    connect(dock->toggleViewAction(), &QAction::toggled, this, &Docks::showTitles, Qt::QueuedConnection);
  }
  showTitles();
}

QDockWidget* Docks::add(const QString& title, const char* name, QWidget* content, Qt::DockWidgetArea area) {
  auto* dock = new QDockWidget(title, &m_window);
  dock->setObjectName(QLatin1String(name));
  dock->setWidget(content);
  m_window.addDockWidget(area, dock);
  return dock;
}

void Docks::showTitles() {
  const auto isDocked = [](const QDockWidget* dock) { return !dock->isHidden() && !dock->isFloating(); };
  const auto tabs = std::ranges::count_if(m_right, isDocked);
  for (QDockWidget* dock : m_right)
    setTitled(*dock, tabs < 2 || dock->isFloating());
  for (QDockWidget* dock : {m_presets, m_curve})
    setTitled(*dock, dock->isFloating());
}

QList<QAction*> Docks::toggleActions() const {
  QList<QAction*> actions;
  for (const QDockWidget* dock : {m_presets, m_right[0], m_right[1], m_right[2], m_curve})
    actions << dock->toggleViewAction();
  return actions;
}

SessionDocument::Panel Docks::panel() const {
  if (!m_seenLast || m_seenLast->isHidden())
    return SessionDocument::Panel::none;
  const auto place = std::find(m_right.begin(), m_right.end(), m_seenLast) - m_right.begin();
  return static_cast<SessionDocument::Panel>(place + 1);
}

void Docks::show(SessionDocument::Panel panel) {
  if (panel == SessionDocument::Panel::none)
    return;
  QDockWidget* dock = m_right[static_cast<std::size_t>(panel) - 1];
  dock->show();
  dock->raise();
}

void Docks::showPresets() {
  m_presets->show();
}

void Docks::setAllVisible(bool visible) {
  m_presets->setVisible(visible);
  if (!visible)
    for (QDockWidget* dock : m_right)
      if (!dock->widget()->visibleRegion().isEmpty())
        m_onTop = dock;
  for (QDockWidget* dock : m_right)
    dock->setVisible(visible);
  if (visible && m_onTop)
    m_onTop->raise();
}

} // namespace limn
