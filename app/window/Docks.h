// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/scenefile/SessionFile.h"

#include <QObject>

#include <array>

class QAction;
class QDockWidget;
class QMainWindow;

namespace limn {

class AccuracyPanel;
class CurvePanel;
class EffectsPanel;
class PresetBrowser;
class PropertiesPanel;

/// The panels of the window.
struct Panels {
  CurvePanel* curves = nullptr;
  PropertiesPanel* properties = nullptr;
  PresetBrowser* presets = nullptr;
  EffectsPanel* effects = nullptr;
  AccuracyPanel* accuracy = nullptr;
};

/// The docks around the picture, one for each panel: presets left, properties, effects and accuracy in one
/// place at the right, curves below.
class Docks : public QObject {
  Q_OBJECT

public:
  /// Makes the panels, too.
  Docks(QMainWindow& window, Panels& panels);

  /// Show and hide each dock.
  QList<QAction*> toggleActions() const;

  /// The panel at the right that was seen last; none where it is closed.
  SessionDocument::Panel panel() const;
  void show(SessionDocument::Panel panel);
  void showPresets();

  /// Shows or hides all but the curve; what lay on top at the right does so again.
  void setAllVisible(bool visible);

signals:
  void panelChanged();

private:
  /// A title stands where nothing else says what a dock is: not above the presets and
  /// the curve, nor below a tab.
  void showTitles();
  QDockWidget* add(const QString& title, const char* name, QWidget* content, Qt::DockWidgetArea area);

  QMainWindow& m_window;
  QDockWidget* m_presets = nullptr;
  std::array<QDockWidget*, 3> m_right{}; ///< in the order of SessionDocument::Panel, without none
  QDockWidget* m_curve = nullptr;
  QDockWidget* m_seenLast = nullptr; ///< of those at the right
  QDockWidget* m_onTop = nullptr;    ///< of those at the right, when they were hidden
};

} // namespace limn
