// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/Docks.h"

#include "app/window/ActionList.h"

#include <QChildEvent>
#include <QDockWidget>
#include <QHBoxLayout>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QScreen>
#include <QTabBar>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace limn {
namespace {

constexpr int widthOfFourTabs = 330;
// The platform puts them around the window, and only once it is shown.
constexpr int titleBar = 40;
constexpr int sideFrame = 8;

// A window narrower than this folds the panels at its right, which leave the picture too little; as it grows
// they come back a little later, so that no drag of its edge makes them flicker.
constexpr int foldingWidth = 880;
constexpr int unfoldingWidth = 940;

// Takes no room. A plain widget has no size to go by, which docks warn of.
class NoTitle : public QWidget {
public:
  using QWidget::QWidget;
  QSize sizeHint() const override { return {0, 0}; }
  QSize minimumSizeHint() const override { return {0, 0}; }
};

// A panel in a place that it shares with others, which take turns behind tabs. Each asks for as much width as
// the widest of them needs, so that the picture beside them stays as it is when the tab changes.
class SharedPlace : public QWidget {
public:
  SharedPlace(QWidget& panel, const std::shared_ptr<QList<const QWidget*>>& sharers) : m_sharers(sharers) {
    m_sharers->append(&panel);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(&panel);
  }

  // Not a minimum that is set once: panels are measured before they have their font and style.
  QSize minimumSizeHint() const override {
    QSize size = QWidget::minimumSizeHint();
    for (const QWidget* panel : *m_sharers)
      size.setWidth(std::max({size.width(), panel->minimumSizeHint().width(), panel->minimumWidth()}));
    return size;
  }

private:
  std::shared_ptr<QList<const QWidget*>> m_sharers; // outlive Docks
};

void showTitle(QDockWidget& dock, bool isShown) {
  QWidget* hidden = dock.titleBarWidget();
  if (isShown == (hidden == nullptr))
    return;
  dock.setTitleBarWidget(isShown ? nullptr : new NoTitle(&dock));
  delete hidden;
}

} // namespace

QSize firstWindowSize(const QSize& available) {
  constexpr QSize usual(1440, 900);
  return (available * 0.8).expandedTo(usual).boundedTo(available - QSize(2 * sideFrame, titleBar));
}

QRect firstWindowPlace(const QRect& available) {
  const QSize size = firstWindowSize(available.size());
  const QSize free = available.size() - size;
  // The title bar is above; a frame below it is thinner.
  return {available.topLeft() + QPoint(free.width() / 2, std::max(free.height() / 2, titleBar * 3 / 4)),
          size};
}

FirstDockSizes firstDockSizes(const QSize& window) {
  return {std::min(window.width() / 8, 340), std::clamp(window.width() / 5, 300, 380),
          std::clamp(window.height() * 22 / 100, 180, 296)};
}

QRect withinScreen(QRect window, const QRect& available) {
  if (window.width() > available.width())
    window.setWidth(available.width());
  if (window.height() > available.height())
    window.setHeight(available.height() - titleBar);
  window.moveRight(std::min(window.right(), available.right()));
  window.moveBottom(std::min(window.bottom(), available.bottom()));
  window.moveLeft(std::max(window.left(), available.left()));
  window.moveTop(std::max(window.top(), available.top()));
  return window;
}

bool takesKeys(const QWidget& widget) {
  return widget.isVisible() && widget.isEnabled() && (widget.focusPolicy() & Qt::TabFocus) != 0;
}

QWidget* keyboardEntryOf(QWidget& area) {
  QWidget* proxy = area.focusProxy();
  while (proxy && proxy->focusProxy())
    proxy = proxy->focusProxy();
  if (proxy && takesKeys(*proxy))
    return proxy;
  QWidget* next = &area;
  do {
    if ((next == &area || area.isAncestorOf(next)) && takesKeys(*next))
      return next;
    next = next->nextInFocusChain();
  } while (next != &area);
  return nullptr;
}

Docks::Docks(QMainWindow& window) : QObject(&window), m_window(window) {
  window.setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
  window.setCorner(Qt::BottomRightCorner, Qt::BottomDockWidgetArea);
  for (const Qt::DockWidgetArea area : {Qt::LeftDockWidgetArea, Qt::RightDockWidgetArea})
    window.setTabPosition(area, QTabWidget::North);
}

QDockWidget* Docks::add(const DockLook& look) {
  auto* dock = new QDockWidget(QString(look.title).remove(QLatin1Char('&')), &m_window);
  dock->setObjectName(QLatin1String(look.name));
  dock->setWidget(look.area == Qt::RightDockWidgetArea ? new SharedPlace(*look.content, m_sharers)
                                                       : look.content);
  dock->toggleViewAction()->setText(look.title); // with its letter, which a tab has no use for
  const QList<QDockWidget*> beside = at(look.area);
  m_window.addDockWidget(look.area, dock);
  if (!beside.isEmpty())
    m_window.tabifyDockWidget(beside.back(), dock);
  m_docks.push_back({dock, look.content, look.area, look.panel});
  connect(dock, &QDockWidget::topLevelChanged, this, &Docks::showTitles);
  // Of a dock behind another one that is hidden, its visibility tells nothing.
  connect(dock->toggleViewAction(), &QAction::toggled, this, &Docks::showTitles, Qt::QueuedConnection);
  if (look.area != Qt::BottomDockWidgetArea) {
    // Behind another's tab Qt moves a panel aside, where Tab would still walk through it unseen.
    // Hidden it must keep its place in the layout: an empty dock cannot grow, nor can those before it.
    QSizePolicy policy = dock->widget()->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    dock->widget()->setSizePolicy(policy);
    connect(dock, &QDockWidget::visibilityChanged, dock->widget(), &QWidget::setVisible);
  }
  if (look.panel != SessionDocument::Panel::none)
    connect(dock, &QDockWidget::visibilityChanged, this, [this, dock](bool visible) {
      if (visible)
        m_seenLast = dock;
      emit panelChanged();
    });
  if (look.isHiddenAtFirst) {
    dock->hide();
    connect(dock->toggleViewAction(), &QAction::triggered, dock, [this, dock](bool isShown) {
      if (!isShown)
        return;
      if (!dock->isFloating()) // its tab is one more than there is room for
        m_window.resizeDocks({dock}, {std::max(dock->width(), widthOfFourTabs)}, Qt::Horizontal);
      dock->raise();
    });
  }
  return dock;
}

void Docks::arrange(ActionList& actions) {
  for (const Qt::DockWidgetArea area : {Qt::LeftDockWidgetArea, Qt::RightDockWidgetArea})
    at(area).front()->raise();
  int row = 0;
  for (QDockWidget* dock : all())
    actions.add(dock->toggleViewAction(), QStringLiteral("show-") + dock->objectName(),
                {.text = {}, .place = {Menu::view, 3, ++row}, .isCheckable = true});
  makeFloatingMenu(*actions.addMenu(tr("Se&parate windows"), {Menu::view, 3, ++row}));
  addFolds(actions);
  showTitles();
  m_window.installEventFilter(this);
  takeFirstSizes();
}

// At the end of the menu bar, where they take no room from tools.
void Docks::addFolds(ActionList& actions) {
  auto* folds = new QWidget(m_window.menuBar());
  folds->setObjectName(QStringLiteral("panelFolds")); // its buttons are as low as the menus (theme.qss)
  auto* row = new QHBoxLayout(folds);
  row->setContentsMargins(0, 0, 6, 0);
  row->setSpacing(2);
  const auto add = [&](Qt::DockWidgetArea area, const char* name, const QString& text, const QString& tip) {
    QAction* action =
        actions.add(QLatin1String(name),
                    {.text = text, .toolTip = tip, .icon = QLatin1String(name), .isCheckable = true});
    auto* button = new QToolButton(folds);
    button->setDefaultAction(action);
    button->setIconSize({16, 16});
    button->setFocusPolicy(Qt::NoFocus); // the menu View has all panels for the keyboard
    row->addWidget(button);
    connect(action, &QAction::triggered, this, [this, area](bool isShown) {
      m_foldedItself = false;
      setFolded(area, !isShown);
    });
    for (const QDockWidget* dock : at(area))
      connect(dock->toggleViewAction(), &QAction::toggled, this,
              [this, action, area] { action->setChecked(!isFolded(area)); });
    action->setChecked(!isFolded(area));
  };
  add(Qt::LeftDockWidgetArea, "panels-left", tr("Panels at the left"),
      tr("Shows or folds the panels at the left."));
  add(Qt::BottomDockWidgetArea, "panels-below", tr("Curve below"), tr("Shows or folds the curve."));
  add(Qt::RightDockWidgetArea, "panels-right", tr("Panels at the right"),
      tr("Shows or folds the panels at the right."));
  m_window.menuBar()->setCornerWidget(folds);
}

bool Docks::isFolded(Qt::DockWidgetArea area) const {
  return std::ranges::all_of(at(area), [](const QDockWidget* dock) { return dock->isHidden(); });
}

void Docks::setFolded(Qt::DockWidgetArea area, bool isFolded) {
  if (isFolded == this->isFolded(area))
    return;
  Folded& its = m_folded[area];
  if (isFolded) {
    its = {};
    return fold(area, its);
  }
  if (its.hidden.isEmpty()) // closed one by one, or by an earlier run
    its = {at(area), {at(area).front()}};
  unfold(its);
}

void Docks::fold(Qt::DockWidgetArea area, Folded& folded) {
  for (QDockWidget* dock : at(area))
    if (!dock->isHidden())
      folded.hidden << dock;
  for (QDockWidget* dock : folded.hidden)
    if (!dock->widget()->visibleRegion().isEmpty())
      folded.onTop << dock;
  for (QDockWidget* dock : folded.hidden)
    dock->hide();
}

void Docks::unfold(Folded& folded) {
  for (QDockWidget* dock : std::exchange(folded.hidden, {}))
    dock->show();
  for (QDockWidget* dock : std::exchange(folded.onTop, {}))
    dock->raise();
}

void Docks::foldWhereNarrow() {
  if (!m_aside.hidden.isEmpty()) // the picture alone is shown
    return;
  if (m_window.width() < foldingWidth && !m_foldedItself && !isFolded(Qt::RightDockWidgetArea)) {
    setFolded(Qt::RightDockWidgetArea, true);
    m_foldedItself = true;
  } else if (m_window.width() >= unfoldingWidth) {
    endFolding();
  }
}

void Docks::endFolding() {
  if (std::exchange(m_foldedItself, false))
    setFolded(Qt::RightDockWidgetArea, false);
}

// The window makes its bars of tabs whenever it lays out its docks.
bool Docks::eventFilter(QObject* watched, QEvent* event) {
  // Once it has the size that it will keep: docks that go meanwhile would be laid out twice.
  if (event->type() == QEvent::Resize)
    QMetaObject::invokeMethod(this, &Docks::foldWhereNarrow, Qt::QueuedConnection);
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
  const QList<QDockWidget*> right = at(Qt::RightDockWidgetArea);
  const auto tabs = std::ranges::count_if(right, isDocked);
  for (QDockWidget* dock : all()) {
    const bool isLone = tabs < 2 && right.contains(dock);
    showTitle(*dock, isLone || dock->isFloating());
  }
}

QList<QDockWidget*> Docks::at(Qt::DockWidgetArea area) const {
  QList<QDockWidget*> found;
  for (const Registered& one : m_docks)
    if (one.area == area)
      found << one.dock;
  return found;
}

QList<QWidget*> Docks::contentsAt(Qt::DockWidgetArea area) const {
  QList<QWidget*> found;
  for (const Registered& one : m_docks)
    if (one.area == area)
      found << one.content;
  return found;
}

QList<QDockWidget*> Docks::all() const {
  return at(Qt::LeftDockWidgetArea) + at(Qt::RightDockWidgetArea) + at(Qt::BottomDockWidgetArea);
}

// Docks without a title cannot be torn off by it.
void Docks::makeFloatingMenu(QMenu& menu) {
  for (QDockWidget* dock : all()) {
    QAction* action = menu.addAction(dock->windowTitle());
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
  const auto seen = std::ranges::find(m_docks, m_seenLast, &Registered::dock);
  return seen == m_docks.end() || m_seenLast->isHidden() ? SessionDocument::Panel::none : seen->panel;
}

void Docks::show(SessionDocument::Panel panel) {
  const auto its = std::ranges::find(m_docks, panel, &Registered::panel);
  if (panel == SessionDocument::Panel::none || its == m_docks.end())
    return;
  its->dock->show();
  its->dock->raise();
}

void Docks::takeFirstSizes() {
  const QRect place = firstWindowPlace(m_window.screen()->availableGeometry());
  const FirstDockSizes sizes = firstDockSizes(place.size());
  m_window.setGeometry(place); // first: in a small window the panels would share what there is
  m_window.resizeDocks({at(Qt::LeftDockWidgetArea).front(), at(Qt::RightDockWidgetArea).front()},
                       {sizes.presetsWidth, sizes.propertiesWidth}, Qt::Horizontal);
  m_window.resizeDocks({at(Qt::BottomDockWidgetArea).front()}, {sizes.curveHeight}, Qt::Vertical);
}

void Docks::restore(const QByteArray& geometry, const QByteArray& state) {
  m_window.restoreGeometry(geometry);
  if (!m_window.isMaximized() && !m_window.isFullScreen())
    m_window.setGeometry(withinScreen(m_window.geometry(), m_window.screen()->availableGeometry()));
  m_window.restoreState(state);
}

void Docks::hideAll() {
  for (const Qt::DockWidgetArea area :
       {Qt::LeftDockWidgetArea, Qt::RightDockWidgetArea, Qt::BottomDockWidgetArea})
    fold(area, m_aside);
}

void Docks::showAgain() {
  unfold(m_aside);
}

} // namespace limn
