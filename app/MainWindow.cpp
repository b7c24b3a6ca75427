// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/MainWindow.h"

#include "app/MessageBar.h"
#include "app/PrivateNames.h"
#include "app/ViewEngines.h"
#include "widgets/curve/CurvePanel.h"
#include "widgets/curve/TransferFunctionEditor.h"
#include "widgets/presets/PresetBrowser.h"
#include "widgets/scene/PropertiesPanel.h"

#include <QActionGroup>
#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QLabel>
#include <QMimeData>
#include <QStatusBar>
#include <QVBoxLayout>

namespace limn {

MainWindow::MainWindow(UserFolders folders, QWidget* parent)
    : QMainWindow(parent), m_folders(std::move(folders)), m_settings(m_folders.settings),
      m_presetStore(m_folders.presets) {
  setObjectName(QStringLiteral("limnWindow"));
  setAcceptDrops(true);
  setMinimumSize(800, 560);
  layOut();
  makeActions();
  connectView();
  connectPanels();
  connectEffects();
  connectAccuracy();
  connectMeasurer();
  connectSceneSections();
  connectGradientCurve();
  connectLoader();
  followPanels();
  refreshPresets();
  m_settings.setOnProblem([this](const QString& sentence) { showError(sentence); });
  connect(&m_session, &Session::sceneChanged, this, &MainWindow::showScene);
  connect(&m_session.undoStack(), &QUndoStack::cleanChanged, this,
          [this](bool clean) { setWindowModified(!clean); });
  resize(1440, 900);
  restoreGeometry(m_settings.windowGeometry());
  restoreState(m_settings.windowState());
  updateTitle();
  setCompareLayout(CompareLayout::sideBySide);
  showScene(m_session.scene());
}

MainWindow::~MainWindow() {
  // Last words must not reach a window half gone.
  m_view->disconnect(this);
  for (QDockWidget* dock : findChildren<QDockWidget*>())
    dock->disconnect(this);
  qApp->disconnect(this);
}

void MainWindow::layOut() {
  auto* centre = new QWidget(this);
  m_recovery = new MessageBar(centre);
  m_recovery->setObjectName(QStringLiteral("recoveryBar"));
  m_unsafe = new MessageBar(centre);
  m_unsafe->setObjectName(QStringLiteral("unsafeBar"));
  m_messages = new MessageBar(centre);
  m_view = new CompareView(viewEngines(), centre);
  auto* column = new QVBoxLayout(centre);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(m_recovery);
  column->addWidget(m_unsafe);
  column->addWidget(m_messages);
  column->addWidget(m_view, 1);
  setCentralWidget(centre);

  m_curves = new CurvePanel(this);
  m_editor = m_curves->valueEditor();
  m_properties = new PropertiesPanel(this);
  m_presets = new PresetBrowser(this);
  setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::BottomDockWidgetArea);
  m_presetDock = addDock(tr("Presets"), QStringLiteral("presetDock"), m_presets, Qt::LeftDockWidgetArea);
  m_shadingDock =
      addDock(tr("Properties"), QStringLiteral("shadingDock"), m_properties, Qt::RightDockWidgetArea);
  makeEffectsDock();
  makeAccuracyDock();
  m_curveDock =
      addDock(tr("Transfer function"), QStringLiteral("curveDock"), m_curves, Qt::BottomDockWidgetArea);
  resizeDocks({m_presetDock, m_shadingDock}, {220, 300}, Qt::Horizontal);
  resizeDocks({m_curveDock}, {280}, Qt::Vertical);

  makeStatusBar();
}

QDockWidget* MainWindow::addDock(const QString& title, const QString& name, QWidget* content,
                                 Qt::DockWidgetArea area) {
  auto* dock = new QDockWidget(title, this);
  dock->setObjectName(name);
  dock->setWidget(content);
  addDockWidget(area, dock);
  return dock;
}

void MainWindow::connectView() {
  connect(m_view, &CompareView::cameraEdited, &m_session, &Session::setCamera);
  connect(m_view, &CompareView::windowLevelEdited, &m_session, &Session::setTransferFunction);
  connect(m_view, &CompareView::probed, this, &MainWindow::showProbe);
  connect(m_view, &CompareView::pictureStateChanged, this, &MainWindow::showPictureState);
  connect(m_view, &CompareView::errorOccurred, this, &MainWindow::showError);
  prepareForDriverFailure();
  connect(m_view, &CompareView::modelChosen, this, &MainWindow::setSideModel);
  connect(m_view, &CompareView::windowPresetRequested, this, &MainWindow::applyWindowPreset);
  connect(m_view, &CompareView::shortcutListRequested, this, &MainWindow::showShortcuts);
  connect(m_view, &CompareView::maximiseRequested, m_focusAction, &QAction::trigger);
  connect(m_view, &CompareView::openFolderRequested, this, &MainWindow::openFolder);
  connect(m_view, &CompareView::openFileRequested, this, &MainWindow::openFile);
  connect(m_view, &CompareView::sampleRequested, this, [this] { openSource(QStringLiteral("sample")); });
  connect(m_view, &CompareView::loadingCancelled, &m_loader, &VolumeLoader::cancel);
  connect(m_view, &CompareView::wipeMoved, this, &MainWindow::noteChange);
  connect(m_view, &CompareView::pinRequested, m_editor, &TransferFunctionEditor::setPinnedValue);
}

void MainWindow::connectPanels() {
  connect(m_editor, &TransferFunctionEditor::transferFunctionEdited, &m_session,
          &Session::setTransferFunction);
  connect(m_properties, &PropertiesPanel::shadingEdited, &m_session, &Session::setShading);
  connect(m_properties, &PropertiesPanel::qualityEdited, &m_session, &Session::setQuality);
  connect(m_presets, &PresetBrowser::presetChosen, this, &MainWindow::applyPreset);
  connect(m_presets, &PresetBrowser::saveRequested, this, &MainWindow::savePreset);
  connect(m_presets, &PresetBrowser::deleteRequested, this, &MainWindow::deletePreset);
}

void MainWindow::showScene(const Scene& scene) {
  m_view->setScene(scene);
  m_editor->setTransferFunction(scene.transferFunction);
  showGradientCurve(scene);
  m_properties->setScene(scene);
  m_presets->setCurrent(showsPreset(scene) ? QString::fromStdString(m_preset.name) : QString());
  showModels();
  m_orthographicAction->setChecked(scene.camera.projection == Camera::Projection::orthographic);
  for (QAction* action : m_sceneActions)
    action->setEnabled(scene.volume != nullptr);
  noteChange();
}

bool MainWindow::showsPreset(const Scene& scene) const {
  return scene.volume && scene.transferFunction == m_preset.transferFunction &&
         scene.gradientOpacity == m_preset.gradientOpacity;
}

void MainWindow::showModels() {
  const ShadingModel single = m_session.scene().shading.model;
  m_view->setModels(m_leftModel, m_rightModel);
  const bool isSingle = m_view->compareLayout() == CompareLayout::single;
  if (isSingle)
    m_properties->setModelsShown({single});
  else
    m_properties->setModelsShown({m_leftModel, m_rightModel});
  // A comparison names its models on the pictures; the buttons then only offer to leave it.
  for (QAction* action : m_modelActions->actions())
    action->setChecked(isSingle && action->data().toInt() == static_cast<int>(single));
  showAccuracyScene();
  noteChange();
}

void MainWindow::setCompareLayout(CompareLayout layout) {
  m_view->setCompareLayout(layout);
  for (QAction* action : m_layoutActions->actions())
    if (action->data().toInt() == static_cast<int>(layout))
      action->setChecked(true);
  showModels();
}

void MainWindow::showProbe(const std::optional<Probe>& probe) {
  m_editor->setMarkedValue(probe ? std::optional(probe->value) : std::nullopt);
  if (!probe || !m_session.scene().volume) {
    m_probeLabel->clear();
    return;
  }
  const QString unit = QString::fromStdString(m_session.scene().volume->info().unit);
  m_probeLabel->setText(tr("%1 %2 at cursor · %3, %4, %5 mm")
                            .arg(probe->value, 0, 'f', unit.isEmpty() ? 2 : 0)
                            .arg(unit)
                            .arg(probe->positionMm.x, 0, 'f', 1)
                            .arg(probe->positionMm.y, 0, 'f', 1)
                            .arg(probe->positionMm.z, 0, 'f', 1));
}

void MainWindow::updateTitle() {
  const auto& volume = m_session.scene().volume;
  // Where [*] stands, unsaved changes are marked.
  QString title = tr("Limn · not for diagnosis") + QStringLiteral("[*]");
  if (volume) {
    const QString path = QString::fromStdString(m_session.volumePath());
    const bool showsPatient = m_patientAction->isChecked();
    QString what = m_shown.source == QStringLiteral("sample") ? tr("Sample head")
                   : showsPatient                             ? QFileInfo(path).fileName()
                                                              : shareableName(path, *volume);
    const PatientLabel& patient = volume->info().patient;
    const QString session = QFileInfo(m_sessionFile).fileName();
    if (!session.isEmpty() && (showsPatient || !mayNameThePatient(session, patient)))
      what.prepend(session + QStringLiteral(" · "));
    if (showsPatient)
      for (const std::string& part : {patient.name, patient.id, patient.studyDate})
        if (!part.empty())
          what += QStringLiteral(" · ") + QString::fromStdString(part);
    title = what.replace(QStringLiteral("[*]"), QStringLiteral("[*][*]")) + QStringLiteral("[*] — ") +
            tr("Limn · not for diagnosis");
  }
  setWindowTitle(title);
}

void MainWindow::showError(const QString& sentence) {
  m_messages->show(MessageBar::Kind::error, sentence);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!mayLeaveScene()) {
    event->ignore();
    return;
  }
  if (m_focusAction->isChecked())
    m_focusAction->trigger();
  m_settings.setWindow(saveGeometry(), saveState());
  m_loader.cancel();
  if (m_keeper)
    m_keeper->close();
  m_keeper.reset();
  event->accept();
}

void MainWindow::changeEvent(QEvent* event) {
  QMainWindow::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && m_focusAction)
    refreshIcons();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls() && event->mimeData()->urls().front().isLocalFile())
    event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  event->acceptProposedAction();
  openSource(event->mimeData()->urls().front().toLocalFile());
}

} // namespace limn
