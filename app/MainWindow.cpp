// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/MainWindow.h"

#include "scene/framing/Framing.h"
#include "widgets/controls/MessageBar.h"
#include "widgets/curve/CurvePanel.h"
#include "widgets/curve/TransferFunctionEditor.h"
#include "widgets/curve/canvas/TransferFunctionCanvas.h"
#include "widgets/properties/CropSection.h"
#include "widgets/properties/CutSection.h"
#include "widgets/properties/LabelSection.h"
#include "widgets/properties/MeasureSection.h"
#include "widgets/properties/PropertiesPanel.h"
#include "widgets/view/CompareView.h"
#include "widgets/view/gestures/ViewDrag.h"
#include "widgets/view/panels/ViewPanels.h"

#include <QAction>
#include <QApplication>
#include <QCloseEvent>
#include <QKeyEvent>
#include <QMenu>

#include <algorithm>

namespace limn {
namespace {

void connectMeasures(MeasureController& controller, MeasureSection& section) {
  QObject::connect(&section, &MeasureSection::measurementsEdited, &controller,
                   &MeasureController::editListed);
  QObject::connect(&section, &MeasureSection::chosen, &controller, &MeasureController::goTo);
  QObject::connect(&section, &MeasureSection::toolRequested, &controller, &MeasureController::useTool);
  QObject::connect(&controller, &MeasureController::shown, &section, &MeasureSection::setMeasured);
}

} // namespace

MainWindow::MainWindow(UserFolders folders, const std::optional<MemoryBudget>& memory, QWidget* parent,
                       std::unique_ptr<OpenWork> open)
    : QMainWindow(parent), m_context(*this, std::move(folders), memory, std::move(open)),
      m_picture(m_context), m_panels(m_context), m_files(m_context, fileSources()), m_frame(m_context) {
  setObjectName(QStringLiteral("limnWindow"));
  setMinimumSize(800, 560);
  connectPictureAndPanels();
  connectFiles();
  m_frame.title().show();
  m_picture.comparison().begin();
  connect(&m_frame, &Frame::languageChosen, this, &MainWindow::languageChosen);
  if (!m_context.session.scene().volume)
    m_context.followers.tell(m_context.session.scene());
  view().emptyPanel().takeFocus();
}

// Last words of children must not reach a window half gone.
MainWindow::~MainWindow() {
  view().disconnect(this);
}

FileSources MainWindow::fileSources() {
  return {[this] { return sessionDocument(); },
          [this] {
            return FigureLooks{m_picture.comparison().comparedLook(), m_picture.comparison().remembered(),
                               m_panels.presets().fittedPresets(), m_panels.presets().namesOfFitted()};
          },
          [this] {
            const TransferFunctionCanvas& canvas = *m_panels.curve().valueEditor()->canvas();
            const PointIndices& selected = canvas.selected();
            return CurveChoice{canvas.pinnedValue(),
                               selected.size() == 1 ? std::optional(selected.front()) : std::nullopt};
          }};
}

void MainWindow::connectPictureAndPanels() {
  ComparisonController* comparison = &m_picture.comparison();
  PlaneController* planes = &m_picture.planes();
  const PropertiesPanel* properties = &m_panels.properties();
  const TransferFunctionEditor* curve = m_panels.curve().valueEditor();
  connect(properties, &PropertiesPanel::modelChosen, comparison, &ComparisonController::setSideModel);
  connect(properties, &PropertiesPanel::lightChosen, comparison, &ComparisonController::followLight);
  connect(comparison, &ComparisonController::modelsShown, properties, &PropertiesPanel::setModelsShown);
  connect(comparison, &ComparisonController::shown, &m_panels.accuracy(), &AccuracyController::showScene);
  connect(comparison, &ComparisonController::shown, &m_panels.ray(), &RayController::show);
  connect(&m_panels.presets(), &PresetController::compareRequested, comparison,
          &ComparisonController::compareWith);
  connect(&m_panels.presets(), &PresetController::ownCompareRequested, comparison,
          &ComparisonController::compareOwn);
  connect(&m_panels.presets(), &PresetController::inUseNamed, comparison, &ComparisonController::show);
  comparison->setIsFitted([this](const Preset& look) { return m_panels.presets().isFitted(look); });
  const auto fillPresets = [this](QMenu* menu, int side) { m_panels.presets().fillMenu(*menu, side); };
  connect(comparison, &ComparisonController::presetMenuAsked, this, fillPresets);
  connect(&m_context.view, &CompareView::presetMenuAsked, this, fillPresets);
  connect(properties->labelSection(), &LabelSection::openRequested, &m_picture.regions(),
          &RegionController::askForLabels);
  connect(properties->labelSection(), &LabelSection::keepEdited, &m_picture.regions(),
          &RegionController::setKeep);
  connect(properties->labelSection(), &LabelSection::curveRequested, &m_panels.curves(),
          &CurveController::takeInHand);
  connect(&m_picture.regions(), &RegionController::volumeMeant, this,
          [this](const QString& path) { openSource(path); });
  connect(&m_picture, &PictureArea::labelChosen, &m_panels, &Panels::takeLabel);
  connect(properties->labelSection(), &LabelSection::refused, this,
          [this](const QString& sentence) { m_context.showError(sentence); });
  connect(properties->cutSection(), &CutSection::curveRequested, &m_panels.curves(),
          &CurveController::takeInHand);
  connect(&m_picture.regions(), &RegionController::curveGiven, &m_panels.curves(),
          &CurveController::takeInHand);
  connect(&m_picture.regions(), &RegionController::labelsMeasured, properties->labelSection(),
          &LabelSection::setFigures);
  connect(properties->cutSection(), &CutSection::cutsEdited, &m_picture.regions(),
          &RegionController::setCuts);
  connect(properties->cutSection(), &CutSection::scissorsRequested, &m_context.view,
          [this] { m_context.view.setTool(ViewTool::scissors); });
  connect(properties->cutSection(), &CutSection::pieceRequested, &m_context.view,
          [this] { m_context.view.setTool(ViewTool::piece); });
  connectMeasures(m_picture.measures(), *properties->measureSection());
  connect(&m_context.actions.find("cropBox"), &QAction::toggled, &m_picture.turnedBox(),
          &TurnedBoxController::showBox);
  connect(&m_context.actions.find("cropBox"), &QAction::triggered, &m_picture.turnedBox(),
          &TurnedBoxController::tellWhatStaysCut);
  connect(properties->cropSection(), &CropSection::turnRequested, &m_context.actions.find("turnCropBox"),
          &QAction::trigger);
  connect(planes, &PlaneController::valueMarked, curve, &TransferFunctionEditor::setMark);
  connect(planes, &PlaneController::valuePinned, curve, &TransferFunctionEditor::setPinnedValue);
  connect(&m_panels.ray(), &RayController::placeChosen, planes, &PlaneController::goTo);
  connect(&m_panels.emphasis(), &EmphasisController::lit, planes, &PlaneController::setEmphasised);
}

void MainWindow::connectFiles() {
  OpeningController* opening = &m_files.opening();
  connect(opening, &OpeningController::loaded, this, &MainWindow::showLoaded);
  connect(opening, &OpeningController::looksChosen, &m_panels.looks(), &LookController::importFiles);
  connect(&m_files.drops(), &DropController::looksDropped, &m_panels.looks(), &LookController::importFiles);
  connect(&m_files.drops(), &DropController::sourcesDropped, this, [this](const QStringList& paths) {
    QStringList labels;
    std::ranges::copy_if(paths, std::back_inserter(labels), opensAsLabels);
    if (m_context.session.scene().volume && !labels.isEmpty())
      m_picture.regions().openLabelFiles(labels);
    else
      openSource(paths.front());
  });
  connect(&m_picture, &PictureArea::sliceCopyChosen, &m_files.slices(), &SliceSaving::copy);
  connect(&m_picture, &PictureArea::sliceSaveChosen, &m_files.slices(), &SliceSaving::save);
  connect(&m_picture.comparison(), &ComparisonController::shown, &m_files.safety(),
          &SessionSafety::noteChange);
  connect(&m_picture.comparison(), &ComparisonController::layoutChosen, opening,
          &OpeningController::leaveFailure);
  connect(&m_files.saving(), &SavingController::sessionSaved, &m_frame.title(), &TitleController::show);
  connect(&m_files, &Files::savedPathsWanted, &m_panels, &Panels::showSavedPaths);
  connect(&m_files, &Files::closeRequested, this, &MainWindow::closeVolume);
}

SessionDocument MainWindow::sessionDocument() const {
  SessionDocument session = m_context.document.described();
  m_picture.describe(session);
  m_panels.describe(session);
  return session;
}

void MainWindow::showLoaded(const LoadedScene& loaded, const Histogram& histogram, const Request& request) {
  if (!m_files.safety().mayLeave())
    return;
  LoadedScene shown = loaded;
  if (!loaded.hasOwnCamera)
    shown.scene.camera = framedCamera(loaded.scene, view().pictureAspect());
  view().setFocus(); // or the keys would go to whatever is next to the page's hidden button
  m_context.document.open(shown, request, histogram);
  m_panels.showVolume(loaded.scene.volume, histogram);
  m_panels.presets().recognise();
  m_picture.showVolume(loaded.scene.volume.get());
  if (const auto& beside = loaded.session ? loaded.session : loaded.beside) {
    m_picture.restore(*beside);
    m_panels.restore(*beside);
  } else {
    m_picture.comparison().showOpened(loaded.sides);
  }
  m_files.noteOpened(loaded, request);
  m_files.safety().sayWhatIsKept();
  if (!loaded.session && !loaded.beside)
    m_picture.regions().offers().offerBody();
  m_frame.title().show();
}

void MainWindow::closeVolume() {
  if (!m_files.safety().mayLeave())
    return;
  m_context.messages.hide();
  m_context.document.close();
  m_panels.showVolume(nullptr, {});
  m_picture.showVolume(nullptr);
  m_files.safety().sayWhatIsKept();
  m_frame.title().show();
}

bool MainWindow::isBusy() const {
  const bool isInHand = QApplication::activeModalWidget() || QApplication::activePopupWidget() ||
                        QApplication::mouseButtons() != Qt::NoButton;
  return isInHand || m_files.isBusy() || m_picture.isBusy() || m_panels.isBusy() ||
         m_frame.dialogs().isBusy();
}

WindowHandover MainWindow::handOver() {
  WindowHandover handed;
  handed.session = sessionDocument();
  handed.picture = m_picture.memory();
  handed.panels = m_panels.memory();
  handed.remarks = m_files.remarks().memory();
  handed.said = m_context.said();
  handed.kept = m_files.safety().told();
  if (handed.remarks.isSaid || m_picture.regions().offers().isAsking())
    handed.said.message.reset(); // it is said anew
  handed.frame = m_frame.memory();
  handed.keepsSessions = m_files.safety().keeps();
  end();
  handed.keeper = m_files.safety().giveKeeper();
  handed.open = m_context.giveOpen();
  return handed;
}

void MainWindow::takeOver(WindowHandover before) {
  const Scene& scene = m_context.session.scene();
  m_context.followers.tell(scene);
  m_panels.showVolume(scene.volume, m_context.document.histogram());
  m_picture.showVolume(scene.volume.get());
  m_context.session.tellBeside();
  m_picture.restore(before.session);
  m_panels.restore(before.session);
  m_picture.takeOver(before.picture);
  m_panels.takeOver(before.panels);
  m_files.remarks().takeOver(before.remarks);
  m_context.takeOver(before.said);
  m_frame.title().show();
  if (before.keepsSessions) {
    m_files.safety().begin(std::move(before.keeper));
    m_files.safety().noteChange();
  }
  if (before.kept)
    m_files.safety().tellAgain(*before.kept);
  if (scene.volume)
    view().setFocus();
  m_frame.takeOver(before.frame);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  const bool mayEnd = !m_asks || (m_files.mayQuit() && m_files.safety().mayLeave());
  if (!m_asks) // or no longer: the system ended it while it was asked
    return;
  if (!mayEnd) {
    event->ignore();
    return;
  }
  end();
  m_files.safety().end();
  event->accept();
}

void MainWindow::endUnasked() {
  const bool isKept = !m_files.safety().keepUnsaved();
  m_asks = false;
  end();
  close(); // does nothing within a question of closing, which then closes
  if (isKept)
    m_files.safety().end();
}

void MainWindow::end() {
  m_frame.focusMode().leave();
  m_context.docks.endFolding();
  m_context.settings.setWindow(saveGeometry(), saveState());
  m_files.opening().cancel();
}

// Esc that nothing nearer to the keyboard has a use for.
void MainWindow::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Escape)
    return QMainWindow::keyPressEvent(event);
  if (view().tool() == ViewTool::rotate && !m_picture.crosshair().close())
    m_frame.focusMode().leave();
  view().setTool(ViewTool::rotate);
}

} // namespace limn
