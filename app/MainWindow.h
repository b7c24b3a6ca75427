// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/Settings.h"
#include "app/UserFolders.h"
#include "app/actions/Actions.h"
#include "app/actions/Menus.h"
#include "app/dicom/DicomDesk.h"
#include "app/document/OpenDocument.h"
#include "app/figure/FigureDesk.h"
#include "app/opening/DropDesk.h"
#include "app/opening/OpeningDesk.h"
#include "app/presets/EarlierLook.h"
#include "app/presets/LookDesk.h"
#include "app/presets/PresetDesk.h"
#include "app/presets/ProjectionCurves.h"
#include "app/presets/ThumbnailDesk.h"
#include "app/recovery/SessionSafety.h"
#include "app/saving/PictureSaving.h"
#include "app/saving/SaveNotes.h"
#include "app/saving/SavingDesk.h"
#include "app/suggestions/SuggestionDesk.h"
#include "app/surface/SurfaceDesk.h"
#include "app/tour/TourDesk.h"
#include "app/turntable/TurntableDesk.h"
#include "app/window/AppearanceDesk.h"
#include "app/window/Centre.h"
#include "app/window/Docks.h"
#include "app/window/FocusMode.h"
#include "app/window/PanelCycle.h"
#include "app/window/StatusTexts.h"
#include "app/window/TitleDesk.h"
#include "app/window/accuracy/AccuracyDesk.h"
#include "app/window/curve/CurveDesk.h"
#include "app/window/curve/EmphasisDesk.h"
#include "app/window/dialogs/DialogDesk.h"
#include "app/window/picture/ComparisonDesk.h"
#include "app/window/picture/EngineDesk.h"
#include "app/window/picture/PlaneDesk.h"
#include "app/window/picture/RayDesk.h"
#include "app/window/volume/CropBoxDesk.h"
#include "app/window/volume/OrientationDesk.h"
#include "app/window/volume/RegionDesk.h"
#include "app/window/volume/RemarksDesk.h"

#include <QMainWindow>

namespace limn {

/// The window: the picture in the middle, presets left, properties right, the curve below. Lays out its parts
/// and holds every connection between them, and nothing that a part could hold.
class MainWindow : public QMainWindow {
  Q_OBJECT

public:
  /// `folders` is where settings, presets and unsaved sessions are kept, `memory` how much it may take for
  /// volumes and what engines make of them (default: MemoryBudget's, each time).
  explicit MainWindow(UserFolders folders = UserFolders::ofThisUser(),
                      const std::optional<MemoryBudget>& memory = {}, QWidget* parent = nullptr);
  ~MainWindow() override;

  /// Starts loading a volume, DICOM folder, scene, session or Limn picture.
  void openSource(const QString& source, const SourceOptions& options = {}) {
    m_opening.open(source, options);
  }

  /// From now on the session is autosaved, and what an earlier window left behind is offered.
  void keepSessions() { m_safety.begin(m_folders.sessions); }

  /// Offers a tour of the window to who has not seen it.
  void offerTour() { m_tour.offer(); }

  /// What a session file of this moment says, but for where its volume is and its own place.
  SessionDocument sessionDocument() const;

  ThumbnailDesk& thumbnails() { return m_thumbnails; }
  CompareView& view() { return *m_centre.view; }
  const VolumeLoader& loader() const { return m_opening.loader(); }

protected:
  void closeEvent(QCloseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

private:
  void connectView();
  void connectPanels();
  void connectScene();
  void connectOpening();
  void connectSaving();
  void connectActions();
  void connectSettings();
  void showScene(const Scene& scene);
  void showPreview(const Scene& scene, const std::string& preset);
  void showLoaded(const LoadedScene& loaded, const Histogram& histogram, const Request& request);
  void restoreSession(const SessionDocument& session);
  void closeVolume();
  void copyPicture();
  void showError(const QString& sentence);

  UserFolders m_folders;
  Settings m_settings;
  Session m_session;
  OpenDocument m_document;
  OpenGlOffer m_openGl = openGlOffer();
  Centre m_centre;
  Panels m_panels;
  Docks m_docks;
  SaveNotes m_notes;
  PictureSaving m_pictures;
  StatusTexts m_status;
  Actions m_actions;
  ChangingMenus m_menus;
  AppearanceDesk m_appearance;
  FocusMode m_focus;
  PanelCycle m_panelCycle;
  TitleDesk m_title;
  ComparisonDesk m_comparison;
  EngineDesk m_engines;
  CropBoxDesk m_cropBox;
  RegionDesk m_regions;
  OrientationDesk m_orientation;
  DialogDesk m_dialogs;
  CurveDesk m_curves;
  SuggestionDesk m_suggestions;
  PlaneDesk m_planes;
  RayDesk m_ray;
  EmphasisDesk m_emphasis;
  PresetDesk m_presets;
  EarlierLook m_earlier;
  LookDesk m_looks;
  ThumbnailDesk m_thumbnails;
  ProjectionCurves m_projections;
  AccuracyDesk m_accuracy;
  SavingDesk m_saving;
  FigureDesk m_figures;
  TurntableDesk m_turntables;
  SurfaceDesk m_surfaces;
  SessionSafety m_safety;
  OpeningDesk m_opening;
  RemarksDesk m_remarks;
  DicomDesk m_dicom;
  DropDesk m_drops;
  TourDesk m_tour;
};

} // namespace limn
