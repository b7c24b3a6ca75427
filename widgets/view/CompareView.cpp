// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/CompareView.h"

#include "widgets/view/PictureOrders.h"
#include "widgets/view/drawing/EngineSwitch.h"
#include "widgets/view/gestures/CameraFit.h"
#include "widgets/view/gestures/ViewInput.h"
#include "widgets/view/overlay/LabelFade.h"
#include "widgets/view/overlay/Overlay.h"
#include "widgets/view/panels/FocusRing.h"
#include "widgets/view/panels/ModelMenu.h"
#include "widgets/view/panels/PanelStack.h"

#include <QKeyEvent>

#include <algorithm>

namespace limn {

CompareView::CompareView(DrawingEngines engines, ViewEngine engine, QWidget* parent)
    : QWidget(parent), m_fit(new CameraFit(this)), m_panels(new PanelStack(this)),
      m_labels(new LabelFade(this)) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAccessibleName(tr("3D view"));
  setAccessibleDescription(
      tr("Drag to rotate, middle drag to pan, right drag or wheel to zoom; arrows rotate, + and − zoom"));
  m_engines = new EngineSwitch(std::move(engines), engine, orders(), *this);

  ViewInput::Facts facts;
  facts.shown = [this] { return overlaySource(); };
  facts.scaleOfSide = [this](int side) { return m_engines->drawing().gradientScaleOf(side); };
  facts.visibleBox = [this] { return m_fit->box(); };
  m_input = new ViewInput(this, facts);

  connectEngines();
  connectInput();
  connectFit();
  arrangeParts();
  new FocusRing(this);
}

ViewOrders CompareView::orders() {
  ViewOrders orders;
  orders.canDraw = [this] { return isVisible() && m_shown.scene.volume; };
  orders.request = [this] { return requestOf(m_shown, geometry()); };
  orders.arrangement = [this] { return arrangementOf(m_shown, geometry()); };
  orders.background = [this] { return m_shown.scene.image.background; };
  orders.geometry = [this] { return geometry(); };
  orders.overlay = [this] {
    return m_overlayVisible ? std::optional(overlayOf(overlaySource())) : std::nullopt;
  };
  return orders;
}

void CompareView::connectEngines() {
  connect(m_engines, &EngineSwitch::replaced, this, &CompareView::arrangeParts);
  connect(m_engines, &EngineSwitch::replaced, this, &CompareView::redraw);
  connect(m_engines, &EngineSwitch::redrawNeeded, this, &CompareView::redraw);
  connect(m_engines, &EngineSwitch::preparing, this, &CompareView::showPreparing);
  connect(m_engines, &EngineSwitch::replaced, this, [this] { showPreparing(1.0); });
  connect(m_engines, &EngineSwitch::stateChanged, this,
          [this](const PictureState& state) { emit pictureStateChanged(withMeasured(state)); });
  connect(m_engines, &EngineSwitch::effectsChanged, this, &CompareView::effectsChanged);
  connect(m_engines, &EngineSwitch::timesChanged, this, &CompareView::effectTimesChanged);
  connect(m_engines, &EngineSwitch::restored, this, &CompareView::graphicsRestored);
  connect(m_engines, &EngineSwitch::engineChanged, this, &CompareView::engineChanged);
  connect(m_engines, &EngineSwitch::errorOccurred, this, &CompareView::errorOccurred);
  // Slots are called in the order in which they were connected.
  connect(m_engines, &EngineSwitch::failed, this, &CompareView::updatePanels);
  connect(m_engines, &EngineSwitch::failed, this, &CompareView::errorOccurred);
  connect(m_panels, &PanelStack::retryRequested, m_engines, &EngineSwitch::retry);
  connect(m_panels, &PanelStack::retryRequested, this, &CompareView::redraw);
  connect(m_panels, &PanelStack::driverRetryRequested, m_engines, &EngineSwitch::retryDriver);
}

void CompareView::connectInput() {
  connect(m_input, &ViewInput::cameraEdited, this, &CompareView::cameraEdited);
  connect(m_input, &ViewInput::functionEdited, this, &CompareView::windowLevelEdited);
  connect(m_input, &ViewInput::cropEdited, this, &CompareView::cropEdited);
  connect(m_input, &ViewInput::wipeEdited, this, &CompareView::moveWipe);
  connect(m_input, &ViewInput::probed, this, &CompareView::probed);
  connect(m_input, &ViewInput::overlayChanged, this, &CompareView::repaintOverlay);
  connect(m_input, &ViewInput::pinRequested, this, &CompareView::pinRequested);
  connect(m_input, &ViewInput::placePinned, this, &CompareView::placePinned);
  connect(m_input, &ViewInput::modelsRequested, this, &CompareView::offerModels);
  connect(m_input, &ViewInput::everythingRequested, this, &CompareView::everythingRequested);
  connect(m_input, &ViewInput::maximiseRequested, this, &CompareView::maximiseRequested);
  connect(m_input, &ViewInput::windowPresetRequested, this, &CompareView::windowPresetRequested);
  connect(m_input, &ViewInput::shortcutListRequested, this, &CompareView::shortcutListRequested);
  connect(m_input, &ViewInput::swapRequested, this, [this] { setSwapped(true); });
  connect(m_input, &ViewInput::toolChanged, this, &CompareView::toolChanged);
  connect(m_labels, &LabelFade::changed, this, &CompareView::repaintOverlay);
  connect(m_panels, &PanelStack::loadingCancelled, this,
          [this] { m_isPreparing ? m_engines->cancelPreparing() : emit loadingCancelled(); });
}

void CompareView::connectFit() {
  connect(m_fit, &CameraFit::cameraEdited, this, &CompareView::cameraFitted);
  connect(this, &CompareView::pictureStateChanged, m_fit, [this] {
    // What is told may be of the scene before.
    if (pictureState().resting)
      m_fit->settle();
  });
  connect(this, &CompareView::pictureStateChanged, m_labels, &LabelFade::noteState);
}

// What draws asks this for what to show.
CompareView::~CompareView() {
  delete m_engines;
}

void CompareView::setScene(const Scene& scene) {
  const Scene before = m_shown.scene;
  if (scene == before)
    return;
  // What draws may ask for it from now on.
  m_shown.scene = scene;
  m_fit->setScene(scene);
  if (scene.volume != before.volume) {
    m_engines->forget();
    m_input->forget();
  }
  Scene asBefore = scene;
  asBefore.camera = before.camera;
  if (asBefore != before) // more than the camera: what failed may work now
    m_engines->retry();
  if (scene.projection != before.projection)
    m_engines->drawing().forgetSpeed();
  if (scene.shading != before.shading)
    m_labels->wake();
  redraw();
}

void CompareView::setCompareLayout(CompareLayout layout) {
  if (layout == m_shown.layout)
    return;
  m_shown.layout = layout;
  m_shown.isSwapped = false;
  m_fit->setAspect(pictureAspect());
  m_labels->wake();
  redraw();
}

void CompareView::setSides(const SideModels& models, const std::optional<ComparedLook>& look) {
  if (models == m_shown.models && look == m_shown.look)
    return;
  m_shown.models = models;
  m_shown.look = look;
  m_labels->wake();
  redraw();
}

void CompareView::setWipePosition(double fraction) {
  m_shown.wipe = std::clamp(fraction, 0.0, 1.0);
  showOtherParts();
}

void CompareView::setSwapped(bool swapped) {
  if (swapped == m_shown.isSwapped || (swapped && pictureCount(m_shown.layout) < 2))
    return;
  m_shown.isSwapped = swapped;
  m_labels->wake();
  showOtherParts();
}

void CompareView::setRefinesAtRest(bool refines) {
  m_engines->setRefines(refines);
}

void CompareView::setMovingMs(double ms) {
  m_engines->setMovingMs(ms);
}

void CompareView::measureEffects() {
  m_engines->drawing().measureEffects();
}

void CompareView::setOverlayVisible(bool visible) {
  m_overlayVisible = visible;
  repaintOverlay();
}

void CompareView::setCropBoxVisible(bool visible) {
  if (visible == m_cropBoxVisible)
    return;
  m_cropBoxVisible = visible;
  m_input->forgetFace();
  repaintOverlay();
}

void CompareView::showPreparing(double fraction) {
  const bool hasEnded = fraction >= 1.0;
  if (hasEnded && !m_isPreparing)
    return;
  m_isPreparing = !hasEnded;
  hasEnded ? clearLoading() : setLoading(fraction, tr("Getting the volume ready for drawing…"));
}

void CompareView::setTool(ViewTool tool) {
  m_input->setTool(tool);
}

ViewTool CompareView::tool() const {
  return m_input->tool();
}

EmptyPanel& CompareView::emptyPanel() const {
  return m_panels->emptyPanel();
}

void CompareView::setLoading(double fraction, const QString& text) {
  m_panels->setLoading(fraction, text);
  updatePanels();
}

void CompareView::clearLoading() {
  m_panels->clearLoading();
  updatePanels();
}

void CompareView::setEngine(ViewEngine engine, const QString& reason) {
  m_engines->choose(engine, reason);
}

ViewEngine CompareView::engine() const {
  return m_engines->engine();
}

PictureState CompareView::pictureState() const {
  return withMeasured(m_engines->state());
}

PictureState CompareView::withMeasured(PictureState state) const {
  for (std::size_t side = 0; m_measuredErrors && state.resting && side < state.sides.size(); ++side) {
    Scene scene = sceneOfSide(static_cast<int>(side));
    scene.quality = qualityShown(scene.quality, state.sides[side]);
    state.sides[side].measuredLevels = m_measuredErrors(scene);
  }
  return state;
}

void CompareView::setMeasuredErrors(MeasuredErrors errors) {
  m_measuredErrors = std::move(errors);
  emit pictureStateChanged(pictureState());
  repaintOverlay();
}

QImage CompareView::currentPicture(int side) {
  const std::optional<RestingPicture> resting = m_engines->drawing().resting(side);
  return resting ? resting->bytes : QImage();
}

std::optional<Image> CompareView::restingImage(int side) {
  const std::optional<RestingPicture> resting = m_engines->drawing().resting(side);
  return resting ? std::optional(*resting->image) : std::nullopt;
}

Scene CompareView::sceneOfRestingImage(int side) const {
  const std::optional<RestingPicture> resting = m_engines->drawing().resting(side);
  Scene scene = sceneOfSide(side);
  if (resting)
    scene.quality = resting->quality;
  return scene;
}

ViewGeometry CompareView::geometry() const {
  return {m_shown.layout, m_shown.wipe, m_engines->drawing().canvas().size(), devicePixelRatioF()};
}

OverlaySource CompareView::overlaySource() const {
  const double covered = m_panels->coveredBelow();
  return {m_shown,          geometry(),          pictureState(),
          font(),           m_labels->opacity(), m_input->hovered(),
          m_cropBoxVisible, m_input->heldFace(), m_input->reading(),
          covered};
}

void CompareView::redraw() {
  m_engines->drawing().restart();
  if (!m_shown.scene.volume)
    m_engines->drawing().forgetEffects();
  updatePanels();
}

void CompareView::repaintOverlay() {
  m_engines->drawing().canvas().update();
}

void CompareView::moveWipe(double fraction) {
  setWipePosition(fraction);
  emit wipeMoved(m_shown.wipe);
}

// What a coarse picture hides behind the wipe's border was not drawn.
void CompareView::showOtherParts() {
  if (m_shown.layout == CompareLayout::wipe && !pictureState().resting)
    redraw();
  else
    m_engines->drawing().arrangeAnew();
}

void CompareView::updatePanels() {
  m_panels->arrange(m_shown.scene.volume != nullptr, m_engines->problem());
  repaintOverlay();
}

void CompareView::arrangeParts() {
  m_panels->setFailure(m_engines->driverFailure(), m_engines->failureDetails());
  m_engines->drawing().canvas().setGeometry(0, 0, width(), height() - m_panels->takenBelow());
  m_fit->setAspect(pictureAspect());
  updatePanels();
}

void CompareView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  arrangeParts();
  redraw();
}

void CompareView::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (!pictureState().resting)
    redraw();
  else
    m_engines->drawing().resume();
}

void CompareView::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  m_engines->drawing().stop();
}

void CompareView::lookFrom(StandardView view) {
  m_input->obey(viewcommand::LookFrom{view});
}

void CompareView::resetCamera() {
  m_input->obey(viewcommand::Reset{});
}

void CompareView::offerModels(int position) {
  const QRectF plate = labelsOf(overlaySource())[static_cast<std::size_t>(position)].plate;
  const int side = sideShownAt(m_shown, position);
  popUpModels(this, mapToGlobal(plate.bottomLeft().toPoint()), sceneOfSide(side).shading.model,
              [this, side](ShadingModel model) { emit modelChosen(side, model); });
}

void CompareView::mousePressEvent(QMouseEvent* event) {
  m_input->press(*event);
}

void CompareView::mouseMoveEvent(QMouseEvent* event) {
  m_labels->wake();
  m_input->move(*event);
}

void CompareView::mouseReleaseEvent(QMouseEvent* event) {
  m_input->release(*event);
}

void CompareView::mouseDoubleClickEvent(QMouseEvent* event) {
  m_input->doubleClick(*event);
}

void CompareView::wheelEvent(QWheelEvent* event) {
  m_input->turnWheel(*event);
}

void CompareView::keyPressEvent(QKeyEvent* event) {
  if (!m_input->obey(commandOf(*event)))
    QWidget::keyPressEvent(event);
}

void CompareView::keyReleaseEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Shift)
    m_input->stopReading();
  if (event->key() == Qt::Key_Space && !event->isAutoRepeat())
    setSwapped(false);
  QWidget::keyReleaseEvent(event);
}

void CompareView::enterEvent(QEnterEvent* event) {
  QWidget::enterEvent(event);
  m_input->enter();
}

void CompareView::leaveEvent(QEvent* event) {
  QWidget::leaveEvent(event);
  m_input->leave();
}

void CompareView::focusOutEvent(QFocusEvent* event) {
  QWidget::focusOutEvent(event);
  setSwapped(false);
}

} // namespace limn
