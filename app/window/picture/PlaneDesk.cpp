// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/picture/PlaneDesk.h"

#include "app/actions/Actions.h"
#include "app/document/OpenDocument.h"
#include "app/window/StatusTexts.h"
#include "planes/GreyWindows.h"
#include "widgets/curve/TransferFunctionEditor.h"
#include "widgets/planes/PlaneDeck.h"
#include "widgets/view/CompareView.h"

namespace limn {
namespace {

// Of another volume, or of one that lies elsewhere: places mean nothing there, nor does the window of other
// values.
PlaneSettings forOtherVolume(PlaneSettings settings, bool hasSameVoxels) {
  settings.crosshairMm.reset();
  settings.distance.reset();
  if (!hasSameVoxels)
    settings.window.reset();
  return settings;
}

} // namespace

PlaneDesk::PlaneDesk(const Parts& parts, QObject* parent) : QObject(parent), m_parts(parts) {
  connect(&parts.deck, &PlaneDeck::settingsEdited, &parts.session, &Session::setPlanes);
  connect(&parts.deck, &PlaneDeck::distanceEdited, &parts.session, &Session::noteDistance);
  connect(&parts.session, &Session::planesChanged, this, &PlaneDesk::show);
  connect(&parts.session, &Session::sceneChanged, this, &PlaneDesk::showScene);
  connect(&parts.view, &CompareView::probed, this, &PlaneDesk::showProbe);
  connect(&parts.view, &CompareView::pinRequested, &parts.curve, &TransferFunctionEditor::setPinnedValue);
  connect(&parts.view, &CompareView::placePinned, this, &PlaneDesk::showInSlices);
  connect(parts.actions.planeLayouts, &QActionGroup::triggered, this,
          [this](const QAction* chosen) { setLayout(static_cast<PlaneLayout>(chosen->data().toInt())); });
  show();
}

void PlaneDesk::goTo(const glm::dvec3& worldMm) {
  if (!m_content.volume)
    return;
  const Volume& volume = *m_content.volume;
  m_parts.curve.setPinnedValue(valueAt(volume, worldToIndex(volume.grid(), worldMm)));
  showInSlices(worldMm);
}

void PlaneDesk::setEmphasised(std::optional<std::size_t> point) {
  m_content.emphasisedPoint = point;
  m_parts.deck.setContent(m_content);
}

void PlaneDesk::showInSlices(const glm::dvec3& worldMm) {
  if (m_content.settings.layout != PlaneLayout::pictureOnly)
    m_parts.session.setPlanes(withCrosshair(m_content, worldMm));
}

void PlaneDesk::setLayout(PlaneLayout layout) {
  PlaneSettings settings = m_parts.session.planes();
  settings.layout = layout;
  m_parts.session.setPlanes(settings);
}

void PlaneDesk::showScene(const Scene& scene) {
  const std::shared_ptr<const Volume> before = m_content.volume;
  m_content.volume = scene.volume;
  m_content.function = scene.transferFunction;
  m_content.emphasisedPoint.reset();
  m_content.keep = scene.keep;
  m_content.crop = scene.crop;
  if (scene.volume != before) {
    const bool hasSameVoxels = scene.volume && before && scene.volume->sharesVoxelsWith(*before);
    if (scene.volume && !hasSameVoxels)
      m_content.firstWindow = firstWindow(*scene.volume, m_parts.document.histogram());
    m_parts.session.setPlanes(forOtherVolume(m_parts.session.planes(), hasSameVoxels));
  }
  show();
}

void PlaneDesk::show() {
  m_content.settings = m_parts.session.planes();
  m_parts.deck.setContent(m_content);
  checkOnly(*m_parts.actions.planeLayouts, static_cast<int>(m_content.settings.layout));
  const bool isShown = m_content.volume && m_content.settings.layout != PlaneLayout::pictureOnly;
  m_parts.view.setMark(isShown ? std::optional(crosshairOf(m_content)) : std::nullopt);
  showProbe(m_probe);
}

void PlaneDesk::showProbe(const std::optional<Probe>& probe) {
  m_probe = probe;
  const bool hasCrosshair = m_content.volume && m_content.settings.layout != PlaneLayout::pictureOnly;
  std::optional<ValueMark> mark;
  if (probe)
    mark = {probe->value, true};
  else if (const auto value = hasCrosshair ? valueUnderCrosshair(m_content) : std::nullopt)
    mark = {*value, false};
  m_parts.curve.setMark(mark);
  m_parts.status.showProbe(probe, m_content.volume.get());
}

void PlaneDesk::describe(SessionDocument& session) const {
  session.planes = m_parts.session.planes();
}

void PlaneDesk::restore(const SessionDocument& session) {
  m_parts.session.setPlanes(session.planes);
}

} // namespace limn
