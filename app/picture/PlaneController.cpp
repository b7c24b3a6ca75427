// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/PlaneController.h"

#include "app/window/WindowContext.h"
#include "planes/GreyWindows.h"
#include "widgets/curve/TransferFunctionEditor.h"
#include "widgets/planes/PlaneDeck.h"
#include "widgets/view/CompareView.h"
#include "widgets/view/gestures/ViewInput.h"

#include <QMenu>

namespace limn {
namespace {

// Of another volume, or of one that lies elsewhere: places mean nothing there, nor does the window of other
// values.
PlaneSettings forOtherVolume(PlaneSettings settings, bool hasSameVoxels) {
  settings.crosshairMm.reset();
  if (!hasSameVoxels)
    settings.window.reset();
  return settings;
}

} // namespace

PlaneController::PlaneController(WindowContext& context)
    : QObject(&context.window), m_context(context), m_layouts(context.actions.addGroup()) {
  addLayouts();
  connect(&context.planes, &PlaneDeck::settingsEdited, &context.session, &Session::setPlanes);
  connect(&context.session, &Session::planesChanged, this, &PlaneController::show);
  context.followers.add(SceneFollowers::Stage::before, [this](const Scene& scene) { showScene(scene); });
  connect(&context.view.input(), &ViewInput::probed, this, &PlaneController::showProbe);
  connect(&context.view.input(), &ViewInput::pinRequested, this, &PlaneController::valuePinned);
  connect(&context.view.input(), &ViewInput::placePinned, this, &PlaneController::showInSlices);
}

void PlaneController::addLayouts() {
  int row = 0;
  QMenu* menu = m_context.actions.addMenu(tr("&Slices"), {Menu::view, 2, 1});
  const auto add = [&](PlaneLayout layout, const QString& text, const QString& tip) {
    const QString name = QStringLiteral("planes-") + QLatin1String(nameOf(layout));
    menu->addAction(m_context.actions.addChoice(
        *m_layouts, name, static_cast<int>(layout),
        {.text = text, .toolTip = tip, .icon = name, .tool = {5, ++row}, .needsVolume = true}));
  };
  add(PlaneLayout::pictureOnly, tr("&3D only"), tr("The picture without slices."));
  add(PlaneLayout::pictureAndThree, tr("3D &and slices"),
      tr("Axial, coronal and sagittal slices beside the picture."));
  add(PlaneLayout::oneLarge, tr("&One slice large"),
      tr("One slice large, the picture and the other slices beside it; a double click on a slice chooses "
         "it."));
  menu->addSeparator();
  menu->addActions({&m_context.actions.find("cutOpen"), &m_context.actions.find("cutOpenCorner")});
  connect(m_layouts, &QActionGroup::triggered, this,
          [this](const QAction* chosen) { setLayout(static_cast<PlaneLayout>(chosen->data().toInt())); });
}

void PlaneController::goTo(const glm::dvec3& worldMm) {
  if (!m_content.volume)
    return;
  const Volume& volume = *m_content.volume;
  emit valuePinned(valueAt(volume, worldToIndex(volume.grid(), worldMm)));
  showInSlices(worldMm);
}

void PlaneController::setEmphasised(std::optional<std::size_t> point, std::optional<std::size_t> label) {
  m_content.emphasisedPoint = point;
  m_content.emphasisedLabel = label;
  m_context.planes.setContent(m_content);
}

void PlaneController::setMeasured(const std::vector<Measured>& measured, const std::shared_ptr<const Volume>&,
                                  std::optional<std::size_t> inHand) {
  m_content.measured = measured;
  m_content.inHand = inHand;
  m_context.planes.setContent(m_content);
}

void PlaneController::setLit(const PlaneLit& lit) {
  m_content.lit = lit;
  m_context.planes.setContent(m_content);
}

void PlaneController::showInSlices(const glm::dvec3& worldMm) {
  if (m_content.settings.layout != PlaneLayout::pictureOnly)
    m_context.session.setPlanes(withCrosshair(m_content, worldMm));
}

void PlaneController::setLayout(PlaneLayout layout) {
  PlaneSettings settings = m_context.session.planes();
  settings.layout = layout;
  m_context.session.setPlanes(settings);
}

void PlaneController::showScene(const Scene& scene) {
  const std::shared_ptr<const Volume> before = m_content.volume;
  m_content.volume = scene.volume;
  m_content.function = scene.transferFunction;
  m_content.emphasisedPoint.reset();
  m_content.emphasisedLabel.reset();
  m_content.keep = scene.keep;
  m_content.crop = scene.crop;
  if (scene.volume != before) {
    const bool hasSameVoxels = scene.volume && before && scene.volume->sharesVoxelsWith(*before);
    if (scene.volume && !hasSameVoxels)
      m_content.firstWindow = firstWindow(*scene.volume, m_context.document.histogram());
    m_context.session.setPlanes(forOtherVolume(m_context.session.planes(), hasSameVoxels));
  }
  show();
}

void PlaneController::show() {
  m_content.settings = m_context.session.planes();
  m_context.planes.setContent(m_content);
  checkOnly(*m_layouts, static_cast<int>(m_content.settings.layout));
  showProbe(m_probe);
}

void PlaneController::showProbe(const std::optional<Probe>& probe) {
  m_probe = probe;
  const bool hasCrosshair = m_content.volume && m_content.settings.layout != PlaneLayout::pictureOnly;
  std::optional<ValueMark> mark;
  if (probe)
    mark = {probe->value, true};
  else if (const auto value = hasCrosshair ? valueUnderCrosshair(m_content) : std::nullopt)
    mark = {*value, false};
  emit valueMarked(mark);
  emit probed(probe);
}

void PlaneController::describe(SessionDocument& session) const {
  session.planes = m_context.session.planes();
}

void PlaneController::restore(const SessionDocument& session) {
  m_context.session.setPlanes(session.planes);
}

} // namespace limn
