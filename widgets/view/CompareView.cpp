// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/CompareView.h"

#include "scene/light/Shading.h"
#include "widgets/shading/ModelSection.h"
#include "widgets/view/drawing/EngineSwitch.h"
#include "widgets/view/gestures/CameraFit.h"
#include "widgets/view/gestures/ViewInput.h"
#include "widgets/view/overlay/Overlay.h"
#include "widgets/view/overlay/Titles.h"
#include "widgets/view/panels/FocusRing.h"
#include "widgets/view/panels/PanelStack.h"

#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>

namespace limn {

CompareView::CompareView(DrawingEngines engines, Engine engine, QWidget* parent)
    : QWidget(parent), m_fit(new CameraFit(this)), m_panels(new PanelStack(this)),
      m_labels(new LabelFade(this)) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAccessibleName(tr("3D view"));
  setAccessibleDescription(
      tr("Drag to rotate, middle drag to pan, right drag or wheel to zoom; arrows rotate, + and − zoom"));
  m_engines = new EngineSwitch(std::move(engines), engine, *this);

  ViewInput::Facts facts;
  facts.shown = [this] { return OverlaySource{m_order, pictureState()}; };
  facts.scaleOfSide = [this](int side) { return m_engines->drawing().gradientScaleOf(side); };
  facts.visible = [this]() -> const VisibleVoxels& { return m_fit->visible(); };
  m_input = new ViewInput(this, facts);

  connectEngines();
  connectInput();
  connect(m_fit, &CameraFit::cameraEdited, this, &CompareView::cameraFitted);
  connect(m_labels, &LabelFade::changed, this, &CompareView::push);
  arrangeParts();
  new FocusRing(this);
  new PointerFocus(this);
}

void CompareView::push() {
  m_order.geometry = geometry();
  m_order.font = font();
  m_order.labelOpacity = m_labels->opacity();
  m_order.hovered = m_input->hovered();
  m_order.heldFace = m_input->heldFace();
  m_order.isTurning = m_input->isTurning();
  m_order.read = m_input->reading();
  m_order.cutLine = m_input->cutLine();
  m_order.coveredBelow = m_panels->coveredBelow();
  m_order.isSeen = m_isShown && scene().volume;
  m_engines->show(m_order);
  const bool hasCorners = m_order.cutLine && m_order.cutLine->isByClicks;
  if (std::exchange(m_hasCorners, hasCorners) != hasCorners)
    emit cornersBegun(hasCorners);
}

void CompareView::take(const ViewNews& news) {
  showPreparing(news.prepared);
  if (news.failure != m_problem)
    updatePanels();
  if (news.state.resting)
    m_fit->settle();
  m_labels->noteState(news.state);
  emit told(news);
}

void CompareView::connectEngines() {
  connect(m_engines, &EngineSwitch::replaced, this, [this] {
    arrangeParts();
    showPreparing(1.0);
  });
  connect(m_engines, &EngineSwitch::told, this, &CompareView::take);
  connect(m_engines, &EngineSwitch::restored, this, &CompareView::graphicsRestored);
  connect(m_engines, &EngineSwitch::errorOccurred, this, &CompareView::errorOccurred);
  connect(m_panels, &PanelStack::retryRequested, m_engines, &EngineSwitch::retry);
  connect(m_panels, &PanelStack::driverRetryRequested, m_engines, &EngineSwitch::retryDriver);
  connect(m_panels, &PanelStack::loadingCancelled, this,
          [this] { m_isPreparing ? m_engines->cancelPreparing() : emit loadingCancelled(); });
}

void CompareView::connectInput() {
  connect(m_input, &ViewInput::cameraEdited, this, &CompareView::cameraEdited);
  connect(m_input, &ViewInput::wipeEdited, this, [this](double fraction) {
    setWipePosition(fraction);
    emit wipeMoved(wipePosition());
  });
  connect(m_input, &ViewInput::modelsRequested, this, &CompareView::offerModels);
  connect(m_input, &ViewInput::swapRequested, this, [this] { setSwapped(true); });
  connect(m_input, &ViewInput::toolChanged, this, &CompareView::toolChanged);
}

CompareView::~CompareView() {
  delete m_engines;
}

void CompareView::setScene(const Scene& scene) {
  const Scene before = this->scene();
  if (scene == before)
    return;
  m_order.comparison.scene = scene;
  m_fit->setScene(scene);
  if (scene.volume != before.volume)
    m_input->forget();
  if (scene.camera != before.camera)
    m_input->forgetLine(); // it was drawn on another picture
  push();
  if (scene.shading != before.shading)
    m_labels->wake();
  updatePanels();
}

void CompareView::setCompareLayout(CompareLayout layout) {
  if (layout == compareLayout())
    return;
  m_order.comparison.layout = layout;
  m_order.comparison.isSwapped = false;
  m_fit->setAspect(pictureAspect());
  push();
  m_labels->wake();
}

void CompareView::setSides(const SideModels& models, const std::optional<ComparedLook>& look) {
  if (models == m_order.comparison.models && look == m_order.comparison.look)
    return;
  m_order.comparison.models = models;
  m_order.comparison.look = look;
  push();
  m_labels->wake();
}

void CompareView::setSwapped(bool swapped) {
  if (swapped == m_order.comparison.isSwapped || (swapped && pictureCount(compareLayout()) < 2))
    return;
  m_order.comparison.isSwapped = swapped;
  push();
  m_labels->wake();
}

void CompareView::measureEffects(bool measures) {
  m_engines->drawing().measureEffects(measures);
}

void CompareView::setCropBoxVisible(bool visible) {
  if (visible == m_order.hasCropBox)
    return;
  m_input->forgetFace();
  set(m_order.hasCropBox, visible);
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
  push();
}

void CompareView::setLinesRemoveInside(bool isInside) {
  m_input->setLinesRemoveInside(isInside);
  push();
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

void CompareView::setEngine(Engine engine, const QString& reason) {
  m_engines->choose(engine, reason);
}

Engine CompareView::engine() const {
  return m_engines->engine();
}

PictureState CompareView::pictureState() const {
  return m_engines->drawing().state();
}

void CompareView::setMeasuredErrors(MeasuredErrors errors) {
  set(m_order.measured, std::make_shared<const MeasuredErrors>(std::move(errors)));
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
  return {compareLayout(), wipePosition(), m_engines->drawing().canvas().size(), devicePixelRatioF()};
}

void CompareView::updatePanels() {
  m_problem = m_engines->problem();
  m_panels->arrange(scene().volume != nullptr, m_problem);
  push();
}

void CompareView::arrangeParts() {
  m_panels->setFailure(m_engines->driverFailure(), m_engines->failureDetails());
  m_engines->drawing().canvas().setGeometry(0, 0, width(), height() - m_panels->takenBelow());
  m_fit->setAspect(pictureAspect());
  updatePanels();
}

bool CompareView::event(QEvent* event) {
  const bool isRecognised = QWidget::event(event);
  // Pixels may be of another size from now on.
  if (event->type() == QEvent::FontChange || event->type() == QEvent::ScreenChangeInternal)
    push();
  return isRecognised;
}

void CompareView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  arrangeParts();
}

void CompareView::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  set(m_isShown, true);
}

void CompareView::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  set(m_isShown, false);
}

void CompareView::lookFrom(StandardView view) {
  m_input->obey(viewcommand::LookFrom{view});
}

void CompareView::resetCamera() {
  m_input->obey(viewcommand::Reset{});
}

void CompareView::offerModels(int position) {
  const QRectF plate = labelsOf({m_order, pictureState()})[static_cast<std::size_t>(position)].plate;
  const int side = sideShownAt(m_order.comparison, position);
  const ShadingModel present = sceneOfSide(side).shading.model;
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  for (const ShadingModel model : shadingModels) {
    QAction* action = menu->addAction(modelName(model));
    action->setCheckable(true);
    action->setChecked(model == present);
    connect(action, &QAction::triggered, this, [this, side, model] { emit modelChosen(side, model); });
  }
  menu->addSeparator();
  QMenu* presets = menu->addMenu(tr("Preset"));
  connect(presets, &QMenu::aboutToShow, this, [this, presets, side] { emit presetMenuAsked(presets, side); });
  if (pictureCount(compareLayout()) > 1)
    menu->addAction(tr("Swap the sides"), this, &CompareView::swapAsked);
  menu->popup(mapToGlobal(plate.bottomLeft().toPoint()));
}

void CompareView::mousePressEvent(QMouseEvent* event) {
  m_input->press(*event);
  push();
}

void CompareView::mouseMoveEvent(QMouseEvent* event) {
  m_labels->wake();
  m_input->move(*event);
  push();
}

void CompareView::mouseReleaseEvent(QMouseEvent* event) {
  m_input->release(*event);
  push();
}

void CompareView::mouseDoubleClickEvent(QMouseEvent* event) {
  m_input->doubleClick(*event);
  push();
}

void CompareView::wheelEvent(QWheelEvent* event) {
  m_input->turnWheel(*event);
  push();
}

void CompareView::keyPressEvent(QKeyEvent* event) {
  if (!m_input->obey(commandOf(*event), event->timestamp()))
    QWidget::keyPressEvent(event);
  push();
}

void CompareView::keyReleaseEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Shift)
    m_input->stopReading();
  push();
  if (event->key() == Qt::Key_Space && !event->isAutoRepeat())
    setSwapped(false);
  QWidget::keyReleaseEvent(event);
}

void CompareView::leaveEvent(QEvent* event) {
  QWidget::leaveEvent(event);
  m_input->leave();
  push();
}

void CompareView::focusOutEvent(QFocusEvent* event) {
  QWidget::focusOutEvent(event);
  setSwapped(false);
}

// A right button that is pressed may be dragged, so that its menu comes with the release (ViewInput).
void CompareView::contextMenuEvent(QContextMenuEvent* event) {
  if (event->reason() == QContextMenuEvent::Keyboard)
    m_input->askForMenu(underMouse() ? QPointF(mapFromGlobal(QCursor::pos())) : logicalRect(0).center());
}

} // namespace limn
