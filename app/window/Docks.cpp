// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/Docks.h"

#include "app/window/FirstSize.h"
#include "app/window/KeyboardEntry.h"
#include "app/window/SharedPlace.h"
#include "widgets/accuracy/AccuracyPanel.h"
#include "widgets/curve/CurvePanel.h"
#include "widgets/effects/EffectsPanel.h"
#include "widgets/presets/PresetBrowser.h"
#include "widgets/properties/PropertiesPanel.h"
#include "widgets/ray/RayPanel.h"

#include <QChildEvent>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QScreen>
#include <QStyledItemDelegate>
#include <QTabBar>
#include <QUndoView>

#include <algorithm>
#include <utility>

namespace limn {
namespace {

constexpr int widthOfFourTabs = 330;

// Takes no room. A plain widget has no size to go by, which docks warn of.
class NoTitle : public QWidget {
public:
  using QWidget::QWidget;
  QSize sizeHint() const override { return {0, 0}; }
  QSize minimumSizeHint() const override { return {0, 0}; }
};

// Edits are named as undo says them, "move point"; a list of them begins each with a capital.
class CapitalDelegate : public QStyledItemDelegate {
public:
  using QStyledItemDelegate::QStyledItemDelegate;
  QString displayText(const QVariant& value, const QLocale& locale) const override {
    QString text = QStyledItemDelegate::displayText(value, locale);
    if (!text.isEmpty())
      text[0] = text[0].toUpper();
    return text;
  }
};

void showTitle(QDockWidget& dock, bool isShown) {
  QWidget* hidden = dock.titleBarWidget();
  if (isShown == (hidden == nullptr))
    return;
  dock.setTitleBarWidget(isShown ? nullptr : new NoTitle(&dock));
  delete hidden;
}

} // namespace

Docks::Docks(QMainWindow& window, Panels& panels) : m_window(window) {
  panels.curves = new CurvePanel(&window);
  panels.properties = new PropertiesPanel(&window);
  panels.presets = new PresetBrowser(&window);
  window.setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
  window.setCorner(Qt::BottomRightCorner, Qt::BottomDockWidgetArea);
  window.setTabPosition(Qt::RightDockWidgetArea, QTabWidget::North);
  m_presets = add(tr("P&resets"), "presetDock", panels.presets, Qt::LeftDockWidgetArea);
  const auto sharers = std::make_shared<QList<const QWidget*>>();
  const auto addRight = [&](const QString& title, const char* name, QWidget* panel) {
    return add(title, name, new SharedPlace(*panel, sharers), Qt::RightDockWidgetArea);
  };
  m_right[0] = addRight(tr("Prop&erties"), "shadingDock", panels.properties);
  panels.history = new QUndoView(&window);
  panels.history->setEmptyLabel(tr("As opened"));
  panels.history->setAccessibleName(tr("History"));
  panels.history->setSpacing(2);
  panels.history->setItemDelegate(new CapitalDelegate(panels.history));
  // Where it lies on top the presets must not become narrower than they can be.
  panels.history->setMinimumWidth(panels.presets->minimumSizeHint().width());
  m_history = add(tr("&History"), "historyDock", panels.history, Qt::LeftDockWidgetArea);
  window.setTabPosition(Qt::LeftDockWidgetArea, QTabWidget::North);
  window.tabifyDockWidget(m_presets, m_history);
  m_presets->raise();
  panels.effects = new EffectsPanel(&window);
  m_right[1] = addRight(tr("Effec&ts"), "effectsDock", panels.effects);
  window.tabifyDockWidget(m_right[0], m_right[1]);
  panels.accuracy = new AccuracyPanel(&window);
  m_right[2] = addRight(tr("&Accuracy"), "accuracyDock", panels.accuracy);
  window.tabifyDockWidget(m_right[1], m_right[2]);
  panels.ray = new RayPanel(&window);
  m_ray = addRight(tr("Ra&y"), "rayDock", panels.ray);
  window.tabifyDockWidget(m_right[2], m_ray);
  m_ray->hide();
  connect(m_ray->toggleViewAction(), &QAction::triggered, m_ray, [this](bool isShown) {
    if (!isShown)
      return;
    if (!m_ray->isFloating()) // four tabs need more room than three
      m_window.resizeDocks({m_ray}, {std::max(m_ray->width(), widthOfFourTabs)}, Qt::Horizontal);
    m_ray->raise();
  });
  m_right[0]->raise();
  m_curve = add(tr("Transfer f&unction"), "curveDock", panels.curves, Qt::BottomDockWidgetArea);
  makeFloatingMenu();
  for (QDockWidget* dock : m_right)
    connect(dock, &QDockWidget::visibilityChanged, this, [this, dock](bool visible) {
      if (visible)
        m_seenLast = dock;
      emit panelChanged();
    });
  // Behind another's tab Qt moves a panel aside, where Tab would still walk through it unseen.
  // Hidden it must keep its place in the layout: an empty dock cannot grow, nor can those before it.
  for (QDockWidget* dock : all())
    if (dock != m_curve) {
      QSizePolicy policy = dock->widget()->sizePolicy();
      policy.setRetainSizeWhenHidden(true);
      dock->widget()->setSizePolicy(policy);
      connect(dock, &QDockWidget::visibilityChanged, dock->widget(), &QWidget::setVisible);
    }
  showTitles();
  window.installEventFilter(this);
}

// The window makes its bars of tabs whenever it lays out its docks.
bool Docks::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Show)
    for (const QTabBar* tabs : m_window.findChildren<QTabBar*>(Qt::FindDirectChildrenOnly))
      connect(
          tabs, &QTabBar::tabBarClicked, this, &Docks::enterTab,
          static_cast<Qt::ConnectionType>(Qt::QueuedConnection | Qt::UniqueConnection)); // once it is shown
  return QObject::eventFilter(watched, event);
}

// A click on a tab leads the keyboard into what it shows, so that F1 and F6 go on from there.
void Docks::enterTab(int tab) {
  const auto* tabs = qobject_cast<QTabBar*>(sender());
  for (QDockWidget* dock : all())
    if (tabs && dock->windowTitle() == tabs->tabText(tab) && !dock->isFloating()) {
      QWidget* entry = keyboardEntryOf(*dock->widget());
      (entry ? entry : dock->widget())->setFocus(Qt::MouseFocusReason);
    }
}

void Docks::showTitles() {
  const auto isDocked = [](const QDockWidget* dock) { return !dock->isHidden() && !dock->isFloating(); };
  const QList<QDockWidget*> right = atRight();
  const auto tabs = std::ranges::count_if(right, isDocked);
  for (QDockWidget* dock : all()) {
    const bool isLone = tabs < 2 && right.contains(dock);
    showTitle(*dock, isLone || dock->isFloating());
  }
}

QDockWidget* Docks::add(const QString& title, const char* name, QWidget* content, Qt::DockWidgetArea area) {
  auto* dock = new QDockWidget(QString(title).remove(QLatin1Char('&')), &m_window);
  dock->setObjectName(QLatin1String(name));
  dock->setWidget(content);
  dock->toggleViewAction()->setText(title); // with its letter, which a tab has no use for
  m_window.addDockWidget(area, dock);
  connect(dock, &QDockWidget::topLevelChanged, this, &Docks::showTitles);
  // Of a dock behind another one that is hidden, its visibility tells nothing.
  connect(dock->toggleViewAction(), &QAction::toggled, this, &Docks::showTitles, Qt::QueuedConnection);
  return dock;
}

QList<QDockWidget*> Docks::all() const {
  return QList<QDockWidget*>{m_presets, m_history} + atRight() + QList<QDockWidget*>{m_curve};
}

QList<QDockWidget*> Docks::atRight() const {
  return {m_right[0], m_right[1], m_right[2], m_ray};
}

QList<QAction*> Docks::toggleActions() const {
  QList<QAction*> actions;
  for (const QDockWidget* dock : all())
    actions << dock->toggleViewAction();
  return actions << m_floating->menuAction();
}

// Docks without a title cannot be torn off by it.
void Docks::makeFloatingMenu() {
  m_floating = new QMenu(tr("Se&parate windows"), &m_window);
  for (QDockWidget* dock : all()) {
    QAction* action = m_floating->addAction(dock->windowTitle());
    action->setObjectName(QStringLiteral("float-") + dock->objectName());
    action->setCheckable(true);
    connect(dock, &QDockWidget::topLevelChanged, action, &QAction::setChecked);
    connect(action, &QAction::triggered, dock, [dock](bool floats) {
      dock->setFloating(floats);
      dock->show();
      dock->raise();
    });
  }
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

void Docks::takeFirstSizes() {
  const QSize size = firstWindowSize(m_window.screen()->availableSize());
  const FirstDockSizes sizes = firstDockSizes(size);
  m_window.resize(size); // first: in a small window the panels would share what there is
  m_window.resizeDocks({m_presets, m_right[0]}, {sizes.presetsWidth, sizes.propertiesWidth}, Qt::Horizontal);
  m_window.resizeDocks({m_curve}, {sizes.curveHeight}, Qt::Vertical);
}

void Docks::restore(const QByteArray& geometry, const QByteArray& state) {
  m_window.restoreGeometry(geometry);
  if (!m_window.isMaximized() && !m_window.isFullScreen())
    m_window.setGeometry(withinScreen(m_window.geometry(), m_window.screen()->availableGeometry()));
  m_window.restoreState(state);
}

void Docks::showPresets() {
  m_presets->show();
  m_presets->raise();
}

void Docks::hideAllButCurve() {
  for (QDockWidget* dock : all())
    if (dock != m_curve && !dock->isHidden())
      m_hidden << dock;
  for (QDockWidget* dock : m_hidden)
    if (!dock->widget()->visibleRegion().isEmpty())
      m_onTop << dock;
  for (QDockWidget* dock : m_hidden)
    dock->hide();
}

void Docks::showAgain() {
  for (QDockWidget* dock : std::exchange(m_hidden, {}))
    dock->show();
  for (QDockWidget* dock : std::exchange(m_onTop, {}))
    dock->raise();
}

} // namespace limn
