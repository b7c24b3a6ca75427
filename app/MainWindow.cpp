// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/MainWindow.h"

#include "app/actions/ModelMenus.h"
#include "app/document/DocumentText.h"
#include "app/document/SceneEdits.h"
#include "app/window/MessageBar.h"
#include "scene/framing/Framing.h"
#include "widgets/accuracy/AccuracyPanel.h"
#include "widgets/curve/CurvePanel.h"
#include "widgets/curve/GradientOpacityEditor.h"
#include "widgets/curve/TransferFunctionEditor.h"
#include "widgets/curve/canvas/TransferFunctionCanvas.h"
#include "widgets/effects/EffectsPanel.h"
#include "widgets/labels/LabelSection.h"
#include "widgets/planes/PlaneDeck.h"
#include "widgets/presets/PresetBrowser.h"
#include "widgets/properties/PropertiesPanel.h"
#include "widgets/ray/RayPanel.h"
#include "widgets/view/CompareView.h"
#include "widgets/view/gestures/CameraGesture.h"
#include "widgets/view/panels/ViewPanels.h"
#include "widgets/view/pictures/PictureState.h"

#include <QApplication>
#include <QClipboard>
#include <QCloseEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QStatusBar>
#include <QToolBar>
#include <QUndoView>

namespace limn {

MainWindow::MainWindow(UserFolders folders, const std::optional<MemoryBudget>& memory, QWidget* parent)
    : QMainWindow(parent), m_folders(std::move(folders)), m_settings(m_folders.settings), m_session(this),
      m_document(m_session),
      m_centre(*this, m_openGl,
               firstEngine(m_settings, m_openGl).isProcessor ? ViewEngine::processor : ViewEngine::driver,
               memory),
      m_docks(*this, m_panels), m_notes(*statusBar(), *m_centre.messages),
      m_pictures(*m_centre.view, m_settings, *statusBar(), this), m_status(*statusBar()),
      m_actions(*this, m_session.undoStack()), m_menus(makeMenus(*this, m_actions, m_docks.toggleActions())),
      m_appearance(m_settings, m_actions, *statusBar(), this),
      m_focus(*this, m_docks, *m_actions.pictureAndCurveOnly),
      m_panelCycle({m_panels.presets, m_panels.history, m_centre.view, m_centre.planes, m_panels.curves,
                    m_panels.properties, m_panels.effects, m_panels.accuracy},
                   *m_actions.nextPanel, *m_actions.previousPanel),
      m_title({m_document, m_settings, *m_actions.patientInTitle, *m_centre.patient, *this}),
      m_comparison(m_session, m_document, *m_centre.view, m_actions, this),
      m_engines({*m_centre.view, m_settings, *m_actions.engines, m_openGl}, this),
      m_cropBox(*m_centre.view, *m_panels.properties->cropSection(), *m_actions.cropBox),
      m_regions({m_session, *m_actions.bodyOnly, *m_centre.messages, m_settings, *this}),
      m_orientation({m_session, *m_actions.setOrientation, *m_actions.views, *this}),
      m_dialogs(m_actions, QString::fromStdString(m_folders.reports.string()), *this),
      m_curves(*m_panels.curves, m_settings), m_suggestions(m_session, *m_actions.suggest, *this),
      m_planes({m_session, m_document, *m_centre.planes, *m_centre.view, *m_panels.curves->valueEditor(),
                m_status, m_actions},
               this),
      m_ray({m_session, *m_centre.view, *m_panels.ray}, this),
      m_emphasis(m_session, *m_panels.curves->valueEditor()->canvas(), m_planes, this),
      m_presets(PresetStore(m_folders.presets),
                {m_session, m_document, *m_panels.presets, *m_centre.messages, m_notes, m_settings, *this}),
      m_earlier({m_session, m_document, *m_centre.messages, *m_actions.earlierLook}),
      m_looks(PresetStore(m_folders.presets),
              {m_session, m_presets, *m_centre.messages, m_notes, m_settings, *statusBar(), *this}),
      m_thumbnails({m_session, *m_panels.presets, [this] { return m_presets.fittedPresets(); },
                    [this] { return m_centre.view->pictureAspect(); }},
                   this),
      m_accuracy({m_session, m_document, *m_centre.view, *m_panels.accuracy, m_settings, *m_centre.messages,
                  m_notes},
                 this),
      m_saving(
          m_document, *m_centre.view, m_settings, m_notes, [this] { return sessionDocument(); }, *this),
      m_figures({m_session, m_document, m_presets, *m_centre.view, m_comparison, m_saving, m_settings,
                 m_notes, *m_actions.saveFigure, *this}),
      m_turntables(
          {m_document, *m_centre.view, m_saving, m_settings, m_notes, *m_actions.saveTurntable, *this}),
      m_surfaces({m_session, m_document, *m_panels.curves->valueEditor()->canvas(), m_settings, m_notes,
                  *m_actions.exportSurface, *this}),
      m_safety(m_document, [this] { return sessionDocument(); },
               {*m_centre.recovery, *m_centre.unsafe, *m_menus.unsavedSessions, *this}),
      m_opening(
          m_settings, *m_actions.patientInTitle, *m_menus.recentSources, *m_centre.messages,
          [this] { return m_safety.savingOfNow(); }, memory, *this),
      m_remarks({m_session, m_document, *m_centre.messages, m_opening, m_orientation}, this),
      m_dicom({m_session, m_document, *m_centre.view, m_opening, m_settings, m_notes, *m_centre.messages,
               *m_actions.saveDicom, *this}),
      m_drops(*this),
      m_tour({m_session, m_settings, *m_actions.tour, *m_actions.openSample, *m_centre.tour, *this}) {
  setObjectName(QStringLiteral("limnWindow"));
  setMinimumSize(800, 560);
  connectSettings();
  connectView();
  connectPanels();
  connectScene();
  connectOpening();
  connectSaving();
  connectActions();
  m_panels.history->setStack(&m_session.undoStack());
  m_presets.refresh();
  m_docks.takeFirstSizes();
  m_docks.restore(m_settings.windowGeometry(), m_settings.windowState());
  m_title.show();
  m_comparison.setLayout(CompareLayout::sideBySide);
  showScene(m_session.scene());
  m_centre.view->emptyPanel().takeFocus();
}

// Last words of children must not reach a window half gone.
MainWindow::~MainWindow() {
  m_centre.view->disconnect(this);
}

void MainWindow::connectView() {
  CompareView* view = m_centre.view;
  connect(view, &CompareView::cameraEdited, &m_session, &Session::setCamera);
  connect(view, &CompareView::cameraFitted, this,
          [this](const Camera& camera) { m_document.fitCamera(camera); });
  connect(view, &CompareView::windowLevelEdited, &m_session, &Session::setTransferFunction);
  connect(view, &CompareView::cropEdited, &m_session, &Session::setCrop);
  connect(view, &CompareView::pictureStateChanged, this, [this](const PictureState& state) {
    m_status.showPicture(state, m_session.scene());
    if (!state.limitation.isEmpty() && m_centre.messages->sentence() != state.limitation)
      m_centre.messages->show(MessageBar::Kind::warning, state.limitation);
    m_pictures.lookSoon();
  });
  connect(view, &CompareView::pictureStateChanged, &m_thumbnails, &ThumbnailDesk::noteState);
  connect(view, &CompareView::errorOccurred, this, &MainWindow::showError);
  connect(view, &CompareView::graphicsRestored, this,
          [this](const QString& sentence) { m_centre.messages->show(MessageBar::Kind::warning, sentence); });
  connect(view, &CompareView::windowPresetRequested, &m_presets, &PresetDesk::useNumber);
  connect(view, &CompareView::shortcutListRequested, m_actions.shortcuts, &QAction::trigger);
  connect(view, &CompareView::everythingRequested, &m_regions, &RegionDesk::showEverything);
  connect(view, &CompareView::maximiseRequested, m_actions.pictureAndCurveOnly, &QAction::trigger);
  connect(view, &CompareView::loadingCancelled, &m_opening, &OpeningDesk::cancel);
  connect(view, &CompareView::loadingCancelled, &m_regions, &RegionDesk::cancel);
  connect(view, &CompareView::toolChanged, this,
          [this](ViewTool tool) { checkOnly(*m_actions.tools, static_cast<int>(tool)); });
  connect(view, &CompareView::wipeMoved, &m_safety, &SessionSafety::noteChange);
}

void MainWindow::connectPanels() {
  connect(m_panels.curves->valueEditor(), &TransferFunctionEditor::transferFunctionEdited, &m_session,
          &Session::setTransferFunction);
  connect(m_panels.curves->gradientEditor(), &GradientOpacityEditor::gradientOpacityEdited, &m_session,
          &Session::setGradientOpacity);
  PropertiesPanel* properties = m_panels.properties;
  connect(properties, &PropertiesPanel::shadingEdited, &m_session, &Session::setShading);
  connect(properties, &PropertiesPanel::modelChosen, &m_comparison, &ComparisonDesk::setSideModel);
  connect(properties, &PropertiesPanel::qualityEdited, &m_session, &Session::setQuality);
  connect(properties, &PropertiesPanel::isovalueEdited, &m_session, &Session::setIsovalue);
  connect(properties, &PropertiesPanel::fogEdited, &m_session, &Session::setFog);
  connect(properties, &PropertiesPanel::cropEdited, &m_session, &Session::setCrop);
  connect(properties->labelSection(), &LabelSection::keepEdited, &m_session, &Session::setKeep);
  connect(properties->labelSection(), &LabelSection::openRequested, &m_regions, &RegionDesk::askForLabels);
  connect(properties, &PropertiesPanel::projectionEdited, this,
          [this](Projection projection, const Gesture& gesture) {
            m_session.edit(m_projections.changed(m_session.scene(), projection, m_document.histogram()),
                           gesture);
          });
  connect(m_panels.presets, &PresetBrowser::presetChosen, &m_presets, &PresetDesk::use);
  connect(m_panels.presets, &PresetBrowser::previewRequested, &m_presets, &PresetDesk::preview);
  connect(m_panels.presets, &PresetBrowser::compareRequested, &m_presets, &PresetDesk::compare);
  connect(m_panels.presets, &PresetBrowser::searchEnded, m_centre.view, qOverload<>(&QWidget::setFocus));
  connect(m_panels.presets, &PresetBrowser::saveRequested, &m_presets, &PresetDesk::askForName);
  connect(m_panels.presets, &PresetBrowser::deleteRequested, &m_presets, &PresetDesk::remove);
  connect(m_panels.presets, &PresetBrowser::renameRequested, &m_presets, &PresetDesk::rename);
  connect(m_panels.presets, &PresetBrowser::favouriteRequested, &m_presets, &PresetDesk::setFavourite);
  connect(m_panels.presets, &PresetBrowser::noteRequested, &m_presets, &PresetDesk::editNote);
  connect(m_panels.presets, &PresetBrowser::folderRequested, &m_presets, &PresetDesk::moveTo);
  connect(m_panels.presets, &PresetBrowser::newFolderRequested, &m_presets, &PresetDesk::moveToNewFolder);
  connect(m_panels.presets, &PresetBrowser::duplicateRequested, &m_presets, &PresetDesk::duplicate);
  connect(m_panels.presets, &PresetBrowser::exportRequested, &m_looks, &LookDesk::exportPreset);
  connect(m_centre.view, &CompareView::effectsChanged, m_panels.effects, &EffectsPanel::setRows);
  connect(m_centre.view, &CompareView::effectTimesChanged, m_panels.effects, &EffectsPanel::setTimes);
  connect(m_panels.effects, &EffectsPanel::measureRequested, m_centre.view, &CompareView::measureEffects);
  connect(m_panels.ray, &RayPanel::placeChosen, &m_planes, &PlaneDesk::goTo);
  connect(&m_docks, &Docks::panelChanged, &m_safety, &SessionSafety::noteChange);
}

void MainWindow::connectScene() {
  connect(&m_session, &Session::sceneChanged, this, &MainWindow::showScene);
  connect(&m_session, &Session::sceneChanged, &m_regions, &RegionDesk::showScene);
  connect(&m_session, &Session::sceneChanged, &m_ray, &RayDesk::showScene);
  connect(&m_session, &Session::planesChanged, &m_safety, &SessionSafety::noteChange);
  connect(&m_regions, &RegionDesk::progressed, m_centre.view, &CompareView::setLoading);
  connect(&m_regions, &RegionDesk::ended, m_centre.view, &CompareView::clearLoading);
  connect(&m_session.undoStack(), &QUndoStack::cleanChanged, this,
          [this](bool clean) { setWindowModified(!clean); });
  connect(&m_comparison, &ComparisonDesk::modelsShown, m_panels.properties, &PropertiesPanel::setModelsShown);
  connect(&m_comparison, &ComparisonDesk::modelsShown, m_menus.models, &ModelMenus::show);
  connect(&m_comparison, &ComparisonDesk::shown, &m_accuracy, &AccuracyDesk::showScene);
  connect(&m_comparison, &ComparisonDesk::shown, &m_ray, &RayDesk::show);
  connect(&m_comparison, &ComparisonDesk::shown, &m_safety, &SessionSafety::noteChange);
  connect(&m_curves, &CurveDesk::failed, this, &MainWindow::showError);
  connect(&m_session, &Session::sceneChanged, &m_suggestions, &SuggestionDesk::showScene);
  connect(&m_emphasis, &EmphasisDesk::previewed, m_centre.view, &CompareView::setScene);
  connect(&m_suggestions, &SuggestionDesk::previewed, this,
          [this](const Scene& scene) { showPreview(scene, {}); });
  connect(&m_session, &Session::sceneChanged, &m_thumbnails, &ThumbnailDesk::showScene);
  connect(&m_presets, &PresetDesk::compareRequested, &m_comparison, &ComparisonDesk::compareWith);
  connect(&m_presets, &PresetDesk::listed, &m_thumbnails, &ThumbnailDesk::notePresets);
  connect(&m_presets, &PresetDesk::previewed, this, &MainWindow::showPreview);
}

void MainWindow::connectOpening() {
  connect(&m_opening, &OpeningDesk::progressed, m_centre.view, &CompareView::setLoading);
  connect(&m_opening, &OpeningDesk::ended, m_centre.view, &CompareView::clearLoading);
  connect(&m_opening, &OpeningDesk::loaded, this, &MainWindow::showLoaded);
  connect(&m_opening, &OpeningDesk::looksChosen, &m_looks, &LookDesk::importFiles);
  connect(&m_drops, &DropDesk::looksDropped, &m_looks, &LookDesk::importFiles);
  connect(&m_drops, &DropDesk::sourceDropped, this, [this](const QString& path) {
    if (m_session.scene().volume && isNamedLikeLabels(path))
      m_regions.openLabels(path);
    else
      openSource(path);
  });
  connect(&m_dialogs, &DialogDesk::clearRecentRequested, &m_opening, &OpeningDesk::clearRecent);
  EmptyPanel& empty = m_centre.view->emptyPanel();
  connect(&empty, &EmptyPanel::openFolderRequested, &m_opening, &OpeningDesk::askForFolder);
  connect(&empty, &EmptyPanel::openFileRequested, &m_opening, &OpeningDesk::askForFile);
  connect(&empty, &EmptyPanel::sampleRequested, &m_opening, &OpeningDesk::openSample);
  connect(&empty, &EmptyPanel::recentRequested, &m_opening, &OpeningDesk::openRecent);
  connect(&empty, &EmptyPanel::continueRequested, &m_safety, &SessionSafety::continueLast);
  connect(&m_safety, &SessionSafety::unfinishedChanged, &empty, &EmptyPanel::setUnfinished);
  connect(&m_opening, &OpeningDesk::recentChanged, &empty, &EmptyPanel::setRecentSources);
  empty.setRecentSources(m_opening.recentTexts());
  connect(&m_session.undoStack(), &QUndoStack::indexChanged, &m_opening, &OpeningDesk::leaveFailure);
  connect(m_actions.layouts, &QActionGroup::triggered, &m_opening, &OpeningDesk::leaveFailure);
  connect(&m_safety, &SessionSafety::restoreRequested, &m_opening, &OpeningDesk::restore);
  connect(m_menus.file, &QMenu::aboutToShow, &m_safety, &SessionSafety::refreshMenu);
}

void MainWindow::connectSaving() {
  connect(&m_pictures, &PictureSaving::complete, &m_saving, &SavingDesk::writePicture);
  connect(&m_pictures, &PictureSaving::failed, this,
          [this](const QString& sentence) { m_notes.sayFailure(sentence); });
  connect(&m_safety, &SessionSafety::saveRequested, &m_saving, &SavingDesk::saveSession);
  connect(&m_saving, &SavingDesk::sessionSaved, &m_safety, &SessionSafety::noteChange);
  connect(&m_saving, &SavingDesk::sessionSaved, &m_title, &TitleDesk::show);
}

void MainWindow::connectActions() {
  const auto run = [](const QAction* action, auto* receiver, auto slot) {
    connect(action, &QAction::triggered, receiver, slot);
  };
  run(m_actions.openFile, &m_opening, &OpeningDesk::askForFile);
  run(m_actions.openFolder, &m_opening, &OpeningDesk::askForFolder);
  run(m_actions.openLabels, &m_regions, &RegionDesk::askForLabels);
  run(m_actions.openSample, &m_opening, &OpeningDesk::openSample);
  run(m_actions.saveSession, &m_saving, &SavingDesk::saveSession);
  run(m_actions.saveSessionAs, &m_saving, &SavingDesk::saveSessionAs);
  run(m_actions.saveScene, &m_saving, &SavingDesk::saveScene);
  run(m_actions.savePicture, this, [this] { m_pictures.ask(suggestedName(m_document)); });
  run(m_actions.closeVolume, this, &MainWindow::closeVolume);
  run(m_actions.quit, this, &QWidget::close);
  run(m_actions.copyPicture, this, &MainWindow::copyPicture);
  run(m_actions.resetCamera, m_centre.view, &CompareView::resetCamera);
  run(m_actions.orthographic, this, [this](bool isChosen) {
    const Camera& camera = m_session.scene().camera;
    m_session.setCamera(withProjection(camera, isChosen ? Camera::Projection::orthographic
                                                        : Camera::Projection::perspective));
  });
  connect(m_actions.tools, &QActionGroup::triggered, m_centre.view, [this](const QAction* chosen) {
    m_centre.view->setTool(static_cast<ViewTool>(chosen->data().toInt()));
  });
  connect(m_actions.views, &QActionGroup::triggered, m_centre.view, [this](const QAction* chosen) {
    m_centre.view->lookFrom(static_cast<StandardView>(chosen->data().toInt()));
  });
  run(m_actions.findPreset, this, [this] {
    m_docks.showPresets();
    m_panels.presets->focusSearch();
  });
  run(m_actions.savePreset, &m_presets, &PresetDesk::askForName);
  run(m_actions.importLooks, &m_looks, &LookDesk::askForLooks);
  run(m_actions.exportLook, &m_looks, &LookDesk::exportShown);
}

// Actions that show settings and change them.
void MainWindow::connectSettings() {
  m_settings.setOnProblem([this](const QString& sentence) { showError(sentence); });
  m_actions.refineAtRest->setChecked(m_settings.refinesAtRest());
  connect(m_actions.refineAtRest, &QAction::toggled, &m_accuracy, &AccuracyDesk::setRefinesAtRest);
  m_panels.presets->setGallery(m_settings.presetsAreGallery());
  connect(m_panels.presets, &PresetBrowser::galleryChosen, this,
          [this](bool isGallery) { m_settings.setPresetsAreGallery(isGallery); });
}

SessionDocument MainWindow::sessionDocument() const {
  SessionDocument session = m_document.described();
  m_comparison.describe(session);
  m_planes.describe(session);
  session.panel = m_docks.panel();
  session.cropBoxIsShown = m_actions.cropBox->isChecked();
  session.gradientCurveIsShown = m_panels.curves->gradientIsShown();
  return session;
}

// Brings back what a session says beside its scene.
void MainWindow::restoreSession(const SessionDocument& session) {
  m_comparison.restore(session);
  m_planes.restore(session);
  m_actions.cropBox->setChecked(session.cropBoxIsShown);
  m_panels.curves->showGradient(session.gradientCurveIsShown);
  m_docks.show(session.panel);
}

void MainWindow::showScene(const Scene& scene) {
  m_projections.note(scene);
  showPreview(scene, {});
  m_panels.properties->setScene(scene);
  m_presets.markShown();
  m_comparison.show();
  m_actions.orthographic->setChecked(scene.camera.projection == Camera::Projection::orthographic);
  m_actions.setVolumeOpen(scene.volume != nullptr);
  m_panels.presets->setVolumeOpen(scene.volume != nullptr);
}

// The session's own scene ends it.
void MainWindow::showPreview(const Scene& scene, const std::string& preset) {
  m_centre.view->setScene(scene);
  m_centre.view->setPreview(preset);
  m_curves.showScene(scene);
}

void MainWindow::showLoaded(const LoadedScene& loaded, const Histogram& histogram, const Request& request) {
  if (!m_safety.mayLeave())
    return;
  LoadedScene shown = loaded;
  if (!loaded.hasOwnCamera)
    shown.scene.camera = framedCamera(loaded.scene, m_centre.view->pictureAspect());
  m_centre.view->setFocus(); // or the keys would go to whatever is next to the page's hidden button
  m_document.open(shown, request, histogram);
  m_curves.showVolume(loaded.scene.volume, histogram);
  m_panels.properties->foldUnused();
  m_status.showVolume(loaded.scene.volume.get());
  m_remarks.show(loaded.notes);
  if (const auto& beside = loaded.session ? loaded.session : loaded.beside)
    restoreSession(*beside);
  else
    m_comparison.showOpened();
  if (request.isUnsavedSession) {
    m_safety.takeOver(request.source);
  } else {
    m_document.settle(sessionDocument());
    m_safety.noteChange();
  }
  m_opening.remember(m_document.request().source, labelOf(m_document), m_document.volumePath());
  m_title.show();
}

void MainWindow::closeVolume() {
  if (!m_safety.mayLeave())
    return;
  m_centre.messages->hide();
  m_document.close();
  m_curves.showVolume(nullptr, {});
  m_status.showVolume(nullptr);
  m_title.show();
}

void MainWindow::copyPicture() {
  if (const QImage picture = m_centre.view->currentPicture(0); !picture.isNull())
    QApplication::clipboard()->setImage(picture);
  else
    statusBar()->showMessage(tr("The picture is still being drawn; copy it in a moment."), 4000);
}

void MainWindow::showError(const QString& sentence) {
  m_centre.messages->show(MessageBar::Kind::error, sentence);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!m_safety.mayLeave()) {
    event->ignore();
    return;
  }
  m_focus.leave();
  m_settings.setWindow(saveGeometry(), saveState());
  m_opening.cancel();
  m_safety.end();
  event->accept();
}

// Esc that nothing nearer to the keyboard has a use for.
void MainWindow::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Escape)
    return QMainWindow::keyPressEvent(event);
  if (m_centre.view->tool() == ViewTool::rotate)
    m_focus.leave();
  m_centre.view->setTool(ViewTool::rotate);
}

} // namespace limn
