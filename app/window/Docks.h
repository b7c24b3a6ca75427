// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/scenefile/SessionFile.h"

#include <QList>
#include <QObject>
#include <QRect>

#include <map>
#include <memory>
#include <vector>

class QDockWidget;
class QMainWindow;
class QMenu;

namespace limn {

class ActionList;

/// A dock and where it stands: left, right (behind tabs with those that are there) or below.
struct DockLook {
  QString title;    ///< with the letter that chooses it in the menu
  const char* name; ///< object name
  QWidget* content;
  Qt::DockWidgetArea area;
  SessionDocument::Panel panel = SessionDocument::Panel::none; ///< what sessions call it, where they do
  bool isHiddenAtFirst = false;
};

/// The docks around the picture. A feature registers its own; `arrange` gives all of them their places.
class Docks : public QObject {
  Q_OBJECT

public:
  explicit Docks(QMainWindow& window);

  /// Those of one place stand in the order in which they are added.
  QDockWidget* add(const DockLook& look);

  /// Gives the window and its docks the sizes of a first start, and each dock its entries in the menu: shown,
  /// and in a window of its own. Once, after all are added.
  void arrange(ActionList& actions);

  /// Those that it was left with, as Qt saves them, whole on the screen of now; where there are none, no
  /// change.
  void restore(const QByteArray& geometry, const QByteArray& state);

  /// The panel of sessions that was seen last; none where it is closed.
  SessionDocument::Panel panel() const;
  void show(SessionDocument::Panel panel);

  /// What the docks of a place hold, in their order.
  QList<QWidget*> contentsAt(Qt::DockWidgetArea area) const;

  /// Whether no dock of a place is shown; folded together they come back as they were.
  bool isFolded(Qt::DockWidgetArea area) const;
  void setFolded(Qt::DockWidgetArea area, bool isFolded);

  /// Shows again what a narrow window has folded by itself: it is remembered without.
  void endFolding();

  /// Hides all that stand around the picture.
  void hideAll();
  /// Shows again what that hid; what lay on top of others does so again.
  void showAgain();

signals:
  void panelChanged();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  struct Registered {
    QDockWidget* dock;
    QWidget* content;
    Qt::DockWidgetArea area;
    SessionDocument::Panel panel;
  };
  /// Docks that went together, and which of them were seen.
  struct Folded {
    QList<QDockWidget*> hidden;
    QList<QDockWidget*> onTop;
  };
  void addFolds(ActionList& actions);
  void fold(Qt::DockWidgetArea area, Folded& folded);
  static void unfold(Folded& folded);
  void foldWhereNarrow();
  void enterTab(int tab);
  /// Tabs and contents name docks; a title below or above them would say it again. A dock of the right side
  /// without tabs has one, and so has a dock in a window of its own.
  void showTitles();
  void takeFirstSizes();
  QList<QDockWidget*> all() const;
  QList<QDockWidget*> at(Qt::DockWidgetArea area) const;
  void makeFloatingMenu(QMenu& menu);

  QMainWindow& m_window;
  std::shared_ptr<QList<const QWidget*>> m_sharers =
      std::make_shared<QList<const QWidget*>>(); ///< of the right
  std::vector<Registered> m_docks;
  QDockWidget* m_seenLast = nullptr; ///< of those that sessions know
  Folded m_aside;                    ///< by hideAll
  std::map<Qt::DockWidgetArea, Folded> m_folded;
  bool m_foldedItself = false; ///< the right side, because the window is narrow
};

/// How large the window is at its first start, in points: four fifths of a large screen, 1440 × 900 where it
/// has room for that, and on a small one all of it but for its frame. `available` is what the screen leaves
/// beside its own bars.
QSize firstWindowSize(const QSize& available);

/// Where such a window lies, without its frame, so that the frame lies inside `available`, too.
QRect firstWindowPlace(const QRect& available);

/// How much of such a window its docks take at the first start, in points.
struct FirstDockSizes {
  int presetsWidth;
  int propertiesWidth;
  int curveHeight;
};

/// The curve takes little more than a fifth of the height, so that two pictures have two fifths of the
/// window. The panels beside the picture are as narrow as they can be (presets, which ask for more than they
/// are given here) until a wide window has room for lines that are read with ease.
FirstDockSizes firstDockSizes(const QSize& window);

/// A window as it was left on another screen, whole on this one: cut to what the screen has free, with room
/// for a title bar, and moved inside.
QRect withinScreen(QRect window, const QRect& available);

/// Whether a widget takes the keyboard from Tab at the moment.
bool takesKeys(const QWidget& widget);

/// Where the keyboard enters an area that it was never in: its focus proxy, or the first in it that takes the
/// keyboard from Tab; null where nothing does.
QWidget* keyboardEntryOf(QWidget& area);

} // namespace limn
