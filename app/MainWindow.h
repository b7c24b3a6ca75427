// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/AccuracyMeasurer.h"
#include "app/GradientMeasurer.h"
#include "app/PresetStore.h"
#include "app/Session.h"
#include "app/Settings.h"
#include "app/UserFolders.h"
#include "app/VolumeLoader.h"
#include "app/recovery/SessionKeeper.h"
#include "widgets/accuracy/AccuracyPanel.h"
#include "widgets/view/CompareView.h"

#include <QMainWindow>

class QActionGroup;
class QDockWidget;
class QLabel;
class QMenu;
class QToolButton;

namespace limn {

class CurvePanel;
class EffectsPanel;
class ErrorMapOverlay;
class MessageBar;
class PictureStatus;
class PresetBrowser;
class PropertiesPanel;
class TransferFunctionEditor;

/// The window: the picture in the middle, presets left, properties right, the curve below. Holds every
/// connection between components and no state of its own that a component could hold.
class MainWindow : public QMainWindow {
  Q_OBJECT

public:
  /// `folders` is where settings, presets and unsaved sessions are kept.
  explicit MainWindow(UserFolders folders = UserFolders::ofThisUser(), QWidget* parent = nullptr);
  ~MainWindow() override;

  /// Starts loading a volume, DICOM folder, scene, session or Limn picture.
  void openSource(const QString& source, const SourceOptions& options = {});

  const Session& session() const { return m_session; }
  Session& session() { return m_session; }
  CompareView& view() { return *m_view; }
  TransferFunctionEditor& editor() { return *m_editor; }
  CurvePanel& curves() { return *m_curves; }
  const VolumeLoader& loader() const { return m_loader; }

  void setCompareLayout(CompareLayout layout);

  /// What the file menu does once a name is chosen; a failure is said in the message bar. The picture is the
  /// one at rest.
  void writeScene(const QString& path);
  void writePicture(const QString& path);
  void writeSession(const QString& path);

  /// From now on the session is autosaved, and what an earlier window left behind is offered.
  void keepSessions();

  /// What a session file of this moment says, but for where its volume is and its own place.
  SessionDocument sessionDocument() const;

  /// Writes what was measured: a chart (.png), a table (.csv) or a page with both (.html), by the name.
  void writeAccuracy(const QString& path);

protected:
  void closeEvent(QCloseEvent* event) override;
  void changeEvent(QEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

private:
  /// A source as it was asked for, to read it again with other options.
  struct Request {
    QString source;
    SourceOptions options;
    bool isUnsavedSession = false; ///< one that Limn kept, not a file of the user's
  };

  /// A picture that is saved once it is complete, if it is still this one.
  struct AwaitedPicture {
    QString path;
    std::vector<Scene> scenes; ///< of its sides
    CompareLayout layout = CompareLayout::single;
  };

  // MainWindow.cpp
  void layOut();
  void connectView();
  void connectPanels();
  void showScene(const Scene& scene);
  bool showsPreset(const Scene& scene) const;
  void showModels();
  void showProbe(const std::optional<Probe>& probe);
  void updateTitle();
  QDockWidget* addDock(const QString& title, const QString& name, QWidget* content, Qt::DockWidgetArea area);

  // MainWindowStatus.cpp
  void makeStatusBar();
  void makeWaitingRow();
  void showPictureState(const PictureState& state);
  void prepareForDriverFailure();
  void addRefineAction(QMenu& menu);

  // MainWindowMenus.cpp
  void makeActions();
  void makeFileMenu();
  void makeEditMenu();
  void makeViewMenu();
  void makePresetMenu();
  void makeHelpMenu();
  void makeToolBar();
  void refreshIcons();
  void setModel(ShadingModel model);
  void setSideModel(int side, ShadingModel model);
  void setOrthographic(bool orthographic);
  void applyThemeChoice(const QString& choice);
  void setFocusMode(bool on);
  void showShortcuts();
  void showAbout();

  // MainWindowFiles.cpp
  void connectLoader();
  void startReading(const Request& request, const QString& what);
  void openFile();
  void openFolder();
  void closeVolume();
  void showLoaded(const LoadedScene& loaded, const Histogram& histogram);
  void chooseSeries(const QString& source, const std::vector<SeriesSummary>& series);
  void askForSpacing();
  void locateVolume(const QString& scene);
  void refreshRecentMenu();
  QString suggestedName() const;
  QString labelOfShown() const;
  std::string volumeSeenFrom(const std::filesystem::path& file);

  // MainWindowSaving.cpp
  void saveScene();
  void savePicture();
  void writeAwaitedPicture();
  void forgetAwaitedPicture();
  void noteSaved(const QString& path);
  void noteSaved();
  void showSaveError(const QString& sentence);

  // MainWindowSession.cpp
  void addSessionActions(QMenu& menu);
  void followPanels();
  SessionDocument::Panel panelOf(const QDockWidget* dock) const;
  void saveSession();
  void saveSessionAs();
  void showSession(const SessionDocument& session);
  void settleSession(const LoadedScene& loaded);
  void noteChange();
  void sayUnsafe(const QString& why);
  std::optional<SessionDocument> unsavedSession() const;
  bool mayLeaveScene();
  bool askBeforeLosing(const QString& why);
  void offerAbandoned();
  void restoreSession(const std::filesystem::path& file);
  void refreshUnsavedMenu();

  // MainWindowEffects.cpp
  void makeEffectsDock();
  void connectEffects();
  void showRightDocks(bool shown);

  // MainWindowAccuracy.cpp
  void makeAccuracyDock();
  void connectAccuracy();
  void connectMeasurer();
  void measureAccuracy();
  void findSteps(const Quality& quality, const Gesture& gesture);
  void useSteps(const WithinTolerance& found);
  void showErrorMap(bool shown);
  void takeErrorMapBack();
  void showCompared(const ComparedPicture& picture);
  void showAccuracyScene();
  void setAccuracyWork(AccuracyWork work);
  void saveAccuracy();
  int sideMeasured() const;
  glm::ivec2 shownSize() const;
  glm::ivec2 measuredSize() const;

  // MainWindowPresets.cpp
  void refreshPresets();
  void applyPreset(const QString& name);
  void applyWindowPreset(int number);
  void savePreset();
  void deletePreset(const QString& name);

  // MainWindowScene.cpp
  void connectSceneSections();
  void connectGradientCurve();
  void showGradientCurve(const Scene& scene);
  void measureGradients();
  QAction* makeCropBoxAction();
  void showCropBox();
  void followFocus(QWidget* now);
  void setProjection(Projection projection, const Gesture& gesture);
  template <class Change>
  void editScene(const Gesture& gesture, Change&& change);

  void showError(const QString& sentence);

  UserFolders m_folders;
  Settings m_settings;
  PresetStore m_presetStore;
  Session m_session;
  VolumeLoader m_loader;
  GradientMeasurer m_gradients;
  AccuracyMeasurer m_accuracyMeasurer;
  Histogram m_histogram;
  Preset m_preset; ///< the one last used, marked in the list while its curves are on screen
  ShadingModel m_leftModel = ShadingModel::classic;
  ShadingModel m_rightModel = ShadingModel::enhanced;
  bool m_cropIsEdited = false; ///< in its section, or in the view since
  Request m_requested;         ///< last; it may still load, or have failed
  Request m_shown;             ///< of the volume on screen

  QString m_sessionFile;                   ///< to which the session was saved, empty where it was not
  QDockWidget* m_panel = nullptr;          ///< of those at the right, the one seen last
  SessionDocument m_settled;               ///< the session when it was opened or saved
  std::unique_ptr<SessionKeeper> m_keeper; ///< null while sessions are not kept
  std::optional<AwaitedPicture> m_awaitedPicture;
  QString m_saveError; ///< last, until something was saved
  QString m_notKept;   ///< why they are not, though they should be

  CompareView* m_view = nullptr;
  MessageBar* m_recovery = nullptr; ///< offers what an earlier window left behind
  MessageBar* m_unsafe = nullptr;   ///< says so as long as the session cannot be kept
  MessageBar* m_messages = nullptr;
  CurvePanel* m_curves = nullptr;
  TransferFunctionEditor* m_editor = nullptr; ///< of the curve over the value
  PropertiesPanel* m_properties = nullptr;
  PresetBrowser* m_presets = nullptr;
  QDockWidget* m_presetDock = nullptr;
  QDockWidget* m_shadingDock = nullptr;
  EffectsPanel* m_effects = nullptr;
  QDockWidget* m_effectsDock = nullptr;
  AccuracyPanel* m_accuracy = nullptr;
  QDockWidget* m_accuracyDock = nullptr;
  QDockWidget* m_rightDockOnTop = nullptr; ///< when they were hidden
  ErrorMapOverlay* m_errorMap = nullptr;
  Gesture m_toleranceGesture; ///< for which steps are looked for
  Scene m_comparedScene;      ///< of which the map of errors is shown or under way
  QDockWidget* m_curveDock = nullptr;

  QLabel* m_volumeLabel = nullptr;
  QLabel* m_probeLabel = nullptr;
  QLabel* m_waiting = nullptr; ///< says which picture is saved once it is complete
  QToolButton* m_stopWaiting = nullptr;
  PictureStatus* m_pictureStatus = nullptr;

  QMenu* m_recentMenu = nullptr;
  QMenu* m_unsavedMenu = nullptr;
  QMenu* m_viewsMenu = nullptr;
  QActionGroup* m_layoutActions = nullptr;
  QActionGroup* m_modelActions = nullptr;
  QAction* m_orthographicAction = nullptr;
  QAction* m_cropBoxAction = nullptr;
  QAction* m_patientAction = nullptr;
  QAction* m_focusAction = nullptr;
  QList<QAction*> m_sceneActions; ///< enabled while a volume is open
};

} // namespace limn
