// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/frame/PanelCycle.h"

#include "app/window/ActionList.h"
#include "app/window/Docks.h"

#include <QApplication>
#include <QMenu>
#include <QWidget>

namespace limn {
namespace {

// Not folded away to nothing. What lies over it is part of it: a child may show the whole picture.
bool isSeen(const QWidget& widget) {
  if (!widget.isVisible())
    return false;
  QRect seen = widget.rect();
  for (const QWidget* at = &widget; !at->isWindow(); at = at->parentWidget())
    seen = seen.translated(at->pos()) & at->parentWidget()->rect();
  return !seen.isEmpty();
}

} // namespace

PanelCycle::PanelCycle(ActionList& actions, const QList<QWidget*>& panels) {
  QAction* next =
      actions.add(QStringLiteral("nextPanel"), {.text = tr("&Next panel"), .shortcut = Qt::Key_F6});
  QAction* previous =
      actions.add(QStringLiteral("previousPanel"),
                  {.text = tr("&Previous panel"), .shortcut = QKeySequence(Qt::SHIFT | Qt::Key_F6)});
  actions.addMenu(tr("&Keyboard focus"), {Menu::view, 3, 21})->addActions({next, previous});
  for (QWidget* area : panels)
    m_panels.append({area, nullptr});
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) { note(now); });
  connect(next, &QAction::triggered, this, [this] { step(1); });
  connect(previous, &QAction::triggered, this, [this] { step(-1); });
}

// The innermost: the slices lie around the picture.
PanelCycle::Panel* PanelCycle::panelOf(const QWidget* widget) {
  for (Panel& panel : m_panels)
    if (widget && (panel.area == widget || panel.area->isAncestorOf(widget)))
      return &panel;
  return nullptr;
}

void PanelCycle::note(QWidget* now) {
  if (Panel* panel = panelOf(now))
    panel->last = now;
}

void PanelCycle::step(int direction) {
  const qsizetype count = m_panels.size();
  const Panel* here = panelOf(QApplication::focusWidget());
  // From nowhere the first step leads to the first panel, or the last.
  const qsizetype from = here ? here - m_panels.constData() : direction > 0 ? -1 : count;
  for (qsizetype steps = 1; steps <= count; ++steps) {
    Panel& panel = m_panels[((from + direction * steps) % count + count) % count];
    if (&panel == here || !isSeen(*panel.area))
      continue;
    QWidget* entry = panel.last && takesKeys(*panel.last) && isSeen(*panel.last)
                         ? panel.last.data()
                         : keyboardEntryOf(*panel.area);
    if (!entry || panelOf(entry) != &panel)
      continue;
    entry->window()->activateWindow(); // a dock may float
    entry->setFocus(Qt::TabFocusReason);
    return;
  }
}

} // namespace limn
