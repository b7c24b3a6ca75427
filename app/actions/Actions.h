// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/actions/ThemedIcons.h"

#include <QAction>
#include <QActionGroup>
#include <QCoreApplication>

#include <array>

class QUndoStack;

namespace limn {

/// Everything that can be chosen from menus and tool bar, each with an object name of its own. What they do
/// is connected elsewhere.
class Actions {
  Q_DECLARE_TR_FUNCTIONS(limn::Actions)

public:
  /// Makes them children of `window`.
  Actions(QWidget& window, QUndoStack& history);

  /// Whether a volume is open; without one many mean nothing.
  void setVolumeOpen(bool isOpen) const;

  ThemedIcons icons;

  QAction* openFile = nullptr;
  QAction* openFolder = nullptr;
  QAction* openSample = nullptr;
  QAction* openLabels = nullptr;
  QAction* saveSession = nullptr;
  QAction* saveSessionAs = nullptr;
  QAction* saveScene = nullptr;
  QAction* savePicture = nullptr;
  QAction* saveFigure = nullptr;
  QAction* saveTurntable = nullptr;
  QAction* saveDicom = nullptr; ///< enabled while a DICOM series is open
  QAction* exportSurface = nullptr;
  QAction* closeVolume = nullptr;
  QAction* quit = nullptr;

  QAction* undo = nullptr;
  QAction* redo = nullptr;
  QAction* copyPicture = nullptr;

  QActionGroup* layouts = nullptr;      ///< data: CompareLayout as int
  QActionGroup* planeLayouts = nullptr; ///< slices beside the picture; data: PlaneLayout as int
  std::array<QActionGroup*, 2>
      models{};                  ///< of the sides, the first also of a single picture; data: ShadingModel
  QActionGroup* tools = nullptr; ///< data: ViewTool as int
  QActionGroup* views = nullptr; ///< data: StandardView as int
  QAction* resetCamera = nullptr;
  QAction* setOrientation = nullptr; ///< enabled where a file says nothing
  QAction* orthographic = nullptr;
  QAction* cropBox = nullptr;
  QAction* bodyOnly = nullptr;
  QAction* refineAtRest = nullptr;
  QAction* pictureAndCurveOnly = nullptr;
  QAction* nextPanel = nullptr;
  QAction* previousPanel = nullptr;
  QAction* patientInTitle = nullptr;
  QActionGroup* themes = nullptr;    ///< data: the word in the settings
  QActionGroup* languages = nullptr; ///< data: the word in the settings
  QActionGroup* engines = nullptr;   ///< data: EngineSetting as int

  QAction* findPreset = nullptr;
  QAction* savePreset = nullptr;
  QAction* importLooks = nullptr;
  QAction* exportLook = nullptr;
  QAction* suggest = nullptr;
  QAction* earlierLook = nullptr; ///< out of use until a second volume is open
  QAction* takeSnapshot = nullptr;
  QAction* compareSnapshot = nullptr; ///< checked while the snapshot is compared with what is shown
  QAction* compareModels = nullptr;   ///< enabled while looks are compared
  QAction* settings = nullptr;
  QAction* guide = nullptr;
  QAction* tour = nullptr;
  QAction* shortcuts = nullptr;
  QAction* stability = nullptr;
  QAction* about = nullptr;

private:
  struct Look;
  QAction* dressed(QAction* action, const QString& name, const Look& look);
  QAction* made(const char* name, const Look& look);
  void addChoice(QActionGroup& group, const QString& name, const QVariant& data, const Look& look);
  void makeFileActions();
  void makeEditActions(QUndoStack& history);
  void makeLayouts();
  void makePlaneLayouts();
  void makeModels();
  void makeTools();
  void makeViews();
  void makeViewActions();
  void makeThemes();
  void makeLanguages();
  void makeEngines();
  void makeOtherActions();

  QWidget& m_window;
};

/// Checks the action of a group that has this data, and no other.
void checkOnly(const QActionGroup& group, const QVariant& data);

} // namespace limn
