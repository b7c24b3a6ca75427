// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/scenefile/SessionFile.h"

#include <QList>
#include <QObject>

#include <array>

class QAction;
class QDockWidget;
class QMainWindow;
class QMenu;
class QUndoView;

namespace limn {

class AccuracyPanel;
class CurvePanel;
class EffectsPanel;
class PresetBrowser;
class PropertiesPanel;
class RayPanel;

/// The panels of the window.
struct Panels {
  CurvePanel* curves = nullptr;
  PropertiesPanel* properties = nullptr;
  PresetBrowser* presets = nullptr;
  EffectsPanel* effects = nullptr;
  AccuracyPanel* accuracy = nullptr;
  RayPanel* ray = nullptr;
  QUndoView* history = nullptr; ///< what can be undone and redone, by name
};

/// The docks around the picture, one for each panel: presets and history left, properties, effects and
/// accuracy in one place at the right, where the ray joins them once it is asked for, curves below.
class Docks : public QObject {
  Q_OBJECT

public:
  /// Makes the panels, too.
  Docks(QMainWindow& window, Panels& panels);

  /// Gives the window and its docks the sizes of a first start.
  void takeFirstSizes();

  /// Those that it was left with, as Qt saves them, whole on the screen of now; where there are none, no
  /// change.
  void restore(const QByteArray& geometry, const QByteArray& state);

  /// Show and hide each dock, and put it into a window of its own.
  QList<QAction*> toggleActions() const;

  /// The panel at the right that was seen last; none where it is closed.
  SessionDocument::Panel panel() const;
  void show(SessionDocument::Panel panel);
  void showPresets();

  /// Hides all but the curve.
  void hideAllButCurve();
  /// Shows again what that hid; what lay on top of others does so again.
  void showAgain();

signals:
  void panelChanged();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void enterTab(int tab);
  /// Tabs and contents name docks; a title below or above them would say it again. A dock of the right side
  /// without tabs has one, and so has a dock in a window of its own.
  void showTitles();
  QList<QDockWidget*> all() const;
  QList<QDockWidget*> atRight() const;
  void makeFloatingMenu();
  QDockWidget* add(const QString& title, const char* name, QWidget* content, Qt::DockWidgetArea area);

  QMainWindow& m_window;
  QMenu* m_floating = nullptr;
  QDockWidget* m_presets = nullptr;
  QDockWidget* m_history = nullptr;
  std::array<QDockWidget*, 3> m_right{}; ///< in the order of SessionDocument::Panel, without none
  QDockWidget* m_ray = nullptr;          ///< at the right, too, but no part of sessions
  QDockWidget* m_curve = nullptr;
  QDockWidget* m_seenLast = nullptr; ///< of those at the right
  QList<QDockWidget*> m_hidden;      ///< by hideAllButCurve
  QList<QDockWidget*> m_onTop;       ///< of those, what was seen
};

} // namespace limn
