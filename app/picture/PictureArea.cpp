// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/PictureArea.h"

#include "app/document/DocumentText.h"
#include "app/window/WindowContext.h"
#include "widgets/ValueText.h"
#include "widgets/controls/MessageBar.h"
#include "widgets/planes/PlaneDeck.h"
#include "widgets/view/CompareView.h"
#include "widgets/view/gestures/ViewInput.h"
#include "widgets/view/overlay/LabelReading.h"
#include "widgets/view/panels/PictureStatus.h"

#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QMenu>
#include <QStatusBar>

#include <array>
#include <cmath>

namespace limn {
namespace {

// "12.0 L" for x, y or z of world millimetres; without a letter where the sides are unknown.
QString placeText(double mm, int axis, bool isKnown) {
  constexpr std::array<std::array<char, 2>, 3> letters{{{'R', 'L'}, {'A', 'P'}, {'I', 'S'}}};
  if (!isKnown)
    return valueText(mm, {}, 1);
  const char letter = letters[static_cast<std::size_t>(axis)][mm < 0.0 ? 0 : 1];
  return valueText(std::abs(mm), QString(QLatin1Char(letter)), 1);
}

// "310 HU at cursor · 12 L, 3.5 A, 40.1 S mm"
QString probeText(const Probe& probe, const VolumeInfo& info) {
  const QString unit = QString::fromStdString(info.unit);
  QStringList places;
  for (int axis = 0; axis < 3; ++axis)
    places << placeText(probe.positionMm[axis], axis, info.orientationKnown);
  return QObject::tr("%1 at cursor · %2 mm")
      .arg(valueText(probe.value, unit, unit.isEmpty() ? 2 : 0), places.join(QStringLiteral(", ")));
}

// The tool that does the same in slices, or in the picture.
std::optional<PlaneTool> sharedTool(ViewTool tool) {
  if (const std::optional<Measurement::Kind> kind = kindOf(tool))
    return toolOf(*kind);
  return tool == ViewTool::scissors ? std::optional(PlaneTool::scissors)
         : tool == ViewTool::piece  ? std::optional(PlaneTool::piece)
                                    : std::nullopt;
}

std::optional<ViewTool> sharedTool(PlaneTool tool) {
  if (const std::optional<Measurement::Kind> kind = kindOf(tool))
    return viewToolOf(*kind);
  return tool == PlaneTool::scissors ? std::optional(ViewTool::scissors)
         : tool == PlaneTool::piece  ? std::optional(ViewTool::piece)
                                     : std::nullopt;
}

} // namespace

StatusTexts::StatusTexts(QStatusBar& bar)
    : m_volume(new QLabel(&bar)), m_probe(new QLabel(&bar)), m_picture(new PictureStatus(&bar)) {
  bar.addWidget(m_volume);
  bar.addWidget(m_probe, 1);
  bar.addPermanentWidget(m_picture);
  m_probe->setAlignment(Qt::AlignCenter);
}

void StatusTexts::showVolume(const Volume* volume) {
  const bool isOnDisk = volume && volume->room();
  m_volume->setText(isOnDisk ? QObject::tr("%1 · on the disk").arg(volumeText(*volume).trimmed())
                    : volume ? volumeText(*volume)
                             : QString());
  m_volume->setToolTip(isOnDisk
                           ? QObject::tr("<p>The voxels stay on the disk, because they would take more than "
                                         "a third of the memory that Limn may use (--memory). The processor "
                                         "draws them, and reads what the curve shows.</p>")
                           : QString());
}

void StatusTexts::showProbe(const std::optional<Probe>& probe, const Scene& scene) {
  m_probe->setText(probe && scene.volume ? withLabelReading(probeText(*probe, scene.volume->info()),
                                                            labelReading(scene.keep, scene.transferFunction,
                                                                         probe->index, probe->value))
                                         : QString());
}

void StatusTexts::showPicture(const PictureState& state, const Scene& scene) {
  m_picture->setText(pictureStatusText(state, scene));
}

PictureArea::PictureArea(WindowContext& context)
    : QObject(&context.window), m_context(context), m_tools(context.actions.addGroup()),
      m_status(*context.window.statusBar()), m_camera(context), m_comparison(context), m_engines(context),
      m_regions(context), m_cuts(context), m_orientation(context), m_views(context, m_orientation.menu()),
      m_crosshair(context), m_turnedBox(context), m_planes(context), m_measures(context), m_menu(context) {
  addTools();
  shareTools();
  addCopying();
  const CompareView* view = &context.view;
  connect(&view->input(), &ViewInput::functionEdited, &context.session, &Session::setTransferFunction);
  connect(&view->input(), &ViewInput::cropEdited, &context.session, &Session::setCrop);
  connect(view, &CompareView::told, this, [this](const ViewNews& news) { showState(news.state); });
  connect(view, &CompareView::errorOccurred, this,
          [this](const QString& sentence) { m_context.showError(sentence); });
  connect(view, &CompareView::graphicsRestored, this,
          [this](const QString& sentence) { m_context.messages.show(MessageBar::Kind::note, sentence); });
  connect(&m_planes, &PlaneController::probed, this, [this](const std::optional<Probe>& probe) {
    m_status.showProbe(probe, m_context.session.scene());
  });
  connect(&m_measures, &MeasureController::shown, &m_planes, &PlaneController::setMeasured);
  connect(&m_views, &ViewsController::viewChosen, &m_camera, &CameraController::lookAs);
  connect(&m_crosshair, &CrosshairController::cutsWanted, &m_regions, &RegionController::setCutsOf);
  connect(&m_turnedBox, &TurnedBoxController::cutsWanted, &m_regions, &RegionController::setCutsOf);
  connect(&m_menu, &PictureMenu::turnAboutChosen, &m_camera, &CameraController::turnAbout);
  connect(&m_menu, &PictureMenu::placeChosen, &m_planes, &PlaneController::goTo);
  connect(&m_menu, &PictureMenu::pieceChosen, &m_cuts, &CutController::pick);
  connect(&m_menu, &PictureMenu::pieceInSliceChosen, &m_cuts, &CutController::pickAt);
  connect(&m_menu, &PictureMenu::labelChosen, this, &PictureArea::labelChosen);
  connect(&m_menu, &PictureMenu::sliceCopyChosen, this, &PictureArea::sliceCopyChosen);
  connect(&m_menu, &PictureMenu::sliceSaveChosen, this, &PictureArea::sliceSaveChosen);
  connect(&m_cuts, &CutController::stoodOut, &m_planes, &PlaneController::setLit);
  connect(&m_cuts, &CutController::cutWanted, &m_regions, &RegionController::addCut);
  context.followers.add(SceneFollowers::Stage::view, [this](const Scene& scene) {
    m_context.view.setScene(scene); // ends a preview
    m_context.view.setPreview({});
  });
  context.followers.add(SceneFollowers::Stage::after, [this](const Scene& scene) { showScene(scene); });
}

// The keys belong to the picture (ViewInput), which is why these only name them.
void PictureArea::addTools() {
  int row = 0;
  QStringList measuring;
  QMenu* menu = m_context.actions.addMenu(tr("Left dra&g"), {Menu::view, 2, 4});
  const auto add = [&](ViewTool tool, const char* name, const QString& text, const QString& key,
                       const QString& tip) {
    const QString own = QStringLiteral("tool-") + QLatin1String(name);
    // Those that measure share the button of the first.
    const bool measures = kindOf(tool).has_value();
    if (measures)
      measuring << own;
    menu->addAction(m_context.actions.addChoice(
        *m_tools, own, static_cast<int>(tool),
        {.text = QStringLiteral("%1\t%2").arg(text, key),
         .toolTip = tr("Left drag: %1 (%2)").arg(tip, key),
         .icon = measures ? QString::fromLatin1(name) : own,
         .iconText = text,
         .tool = measures && tool != ViewTool::distance ? ToolPlace{} : ToolPlace{3, ++row},
         .needsVolume = true}));
  };
  add(ViewTool::rotate, "rotate", tr("Rotate"), tr("[ or Esc"), tr("rotate the picture"));
  add(ViewTool::pan, "pan", tr("Pan"), tr("M"), tr("move the picture"));
  add(ViewTool::zoom, "zoom", tr("Zoom"), tr("Z"), tr("up is nearer"));
  add(ViewTool::windowLevel, "window-level", tr("Window/level"), tr("W"),
      tr("right widens the window, up raises its level"));
  add(ViewTool::scissors, "scissors", tr("Scissors"), tr("X"), tr("draw around what shall be cut away"));
  add(ViewTool::piece, "piece", tr("Piece"), tr("K"),
      tr("a click picks what hangs together, a drag rotates"));
  add(ViewTool::distance, "distance", tr("Distance"), tr("D"),
      tr("clicks set both ends, or a drag over tissue does; beside it a drag rotates"));
  add(ViewTool::angle, "angle", tr("Angle"), tr("G"),
      tr("clicks set an end, the corner and the other end; a drag over tissue draws the first leg"));
  add(ViewTool::ellipse, "ellipse", tr("Ellipse"), tr("E"), tr("drawn in a slice; a drag rotates"));
  add(ViewTool::mark, "mark", tr("Mark"), tr("N"), tr("a click marks a place, a drag rotates"));
  m_context.actions.addToolMenu(measuring.front(), measuring);
  checkOnly(*m_tools, static_cast<int>(ViewTool::rotate));
  connect(m_tools, &QActionGroup::triggered, this, [this](const QAction* chosen) {
    m_context.view.setTool(static_cast<ViewTool>(chosen->data().toInt()));
  });
  connect(&m_context.view, &CompareView::toolChanged, this,
          [this](ViewTool tool) { checkOnly(*m_tools, static_cast<int>(tool)); });
}

// One tool that cuts or measures is in hand everywhere, or nowhere: a click in the other place would be lost.
void PictureArea::shareTools() {
  CompareView* view = &m_context.view;
  PlaneDeck* planes = &m_context.planes;
  connect(view, &CompareView::toolChanged, planes, [planes](ViewTool tool) {
    if (const std::optional<PlaneTool> same = sharedTool(tool))
      planes->setTool(*same);
    else if (sharedTool(planes->tool()))
      planes->setTool(PlaneTool::crosshair);
  });
  connect(planes, &PlaneDeck::toolChanged, view, [view](PlaneTool tool) {
    if (const std::optional<ViewTool> same = sharedTool(tool))
      view->setTool(*same);
    else if (sharedTool(view->tool()))
      view->setTool(ViewTool::rotate);
  });
}

void PictureArea::addCopying() {
  const QAction* copy = m_context.actions.add(QStringLiteral("copyPicture"), {.text = tr("&Copy picture"),
                                                                              .place = {Menu::edit, 2, 1},
                                                                              .shortcut = tr("Ctrl+Shift+C"),
                                                                              .needsVolume = true});
  connect(copy, &QAction::triggered, this, &PictureArea::copyPicture);
}

void PictureArea::copyPicture() {
  if (const QImage picture = m_context.view.currentPicture(0); !picture.isNull())
    QApplication::clipboard()->setImage(picture);
  else
    m_context.window.statusBar()->showMessage(tr("The picture is still being drawn; copy it in a moment."),
                                              4000);
}

void PictureArea::showScene(const Scene& scene) {
  m_comparison.show();
  m_context.actions.setVolumeOpen(scene.volume != nullptr);
}

void PictureArea::showState(const PictureState& state) {
  m_status.showPicture(state, m_context.session.scene());
  if (!state.limitation.isEmpty() && m_context.messages.sentence() != state.limitation)
    m_context.messages.show(MessageBar::Kind::warning, state.limitation);
}

void PictureArea::describe(SessionDocument& session) const {
  m_comparison.describe(session);
  m_planes.describe(session);
  m_crosshair.describe(session);
}

void PictureArea::restore(const SessionDocument& session) {
  m_planes.restore(session); // first: slices that come decide how many pictures there are
  m_comparison.restore(session);
  m_crosshair.restore(session);
}

bool PictureArea::isDrawing() const {
  return m_context.view.input().cutLine() || m_context.planes.isDrawing() || m_measures.isDrawing() ||
         m_cuts.hasPiece();
}

PictureArea::Memory PictureArea::memory() const {
  const RegionOffers& offers = m_regions.offers();
  return {m_camera.memory(), m_comparison.memory(), m_context.view.tool(),
          offers.isOffering() || offers.isAsking()};
}

void PictureArea::takeOver(const Memory& memory) {
  m_camera.takeOver(memory.camera);
  m_comparison.takeOver(memory.comparison);
  m_context.view.setTool(memory.tool);
  if (memory.offersBody)
    m_regions.offers().offerBody();
}

} // namespace limn
