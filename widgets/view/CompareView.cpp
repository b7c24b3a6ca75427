// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/CompareView.h"

#include "widgets/view/PictureOrders.h"
#include "widgets/view/SurfaceFormat.h"
#include "widgets/view/failure/DriverRecovery.h"
#include "widgets/view/gestures/ViewInput.h"
#include "widgets/view/overlay/LabelFade.h"
#include "widgets/view/overlay/Overlay.h"
#include "widgets/view/panels/ModelMenu.h"
#include "widgets/view/panels/PanelStack.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QOpenGLContext>

#include <algorithm>

namespace limn {

CompareView::CompareView(DrawingEngines engines, QWidget* parent)
    : QOpenGLWidget(parent), m_recovery(new DriverRecovery(std::move(engines.processor), this)),
      m_panels(new PanelStack(this)), m_labels(new LabelFade(this)) {
  setFormat(limnSurfaceFormat());
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAccessibleName(tr("3D view"));
  setAccessibleDescription(tr("Drag to rotate, middle drag to pan, right drag or wheel to zoom"));

  PictureContext context;
  context.canDraw = [this] { return isVisible() && m_shown.scene.volume && !m_recovery->hasFailed(); };
  context.makeCurrent = [this] { makeCurrent(); };
  context.doneCurrent = [this] { doneCurrent(); };
  context.guard = [this](const PictureContext::Work& work) { m_recovery->guard(work); };
  m_loop = new PictureLoop(std::move(engines.driver), context, this);

  ViewInput::Facts facts;
  facts.shown = [this] { return overlaySource(); };
  facts.scaleOfSide = [this](int side) { return m_loop->gradientScaleOf(side); };
  m_input = new ViewInput(this, facts);

  connectPictures();
  connectRecovery();
  connectInput();
}

void CompareView::connectPictures() {
  connect(m_loop, &PictureLoop::stateChanged, this, &CompareView::pictureStateChanged);
  connect(m_loop, &PictureLoop::effectsChanged, this, &CompareView::effectsChanged);
  connect(m_loop, &PictureLoop::timesChanged, this, &CompareView::effectTimesChanged);
  connect(m_loop, &PictureLoop::showNeeded, this, qOverload<>(&QWidget::update));
  connect(m_loop, &PictureLoop::completed, m_recovery, &DriverRecovery::noteSuccess);
  connect(m_loop, &PictureLoop::restFailed, this, &CompareView::errorOccurred);
}

void CompareView::connectRecovery() {
  connect(m_recovery, &DriverRecovery::stopped, m_loop, &PictureLoop::stop);
  connect(m_recovery, &DriverRecovery::rebuildNeeded, this, &CompareView::rebuildGraphics);
  connect(m_recovery, &DriverRecovery::givenUp, this, &CompareView::giveUpDriver);
  connect(m_recovery, &DriverRecovery::restored, this, &CompareView::graphicsRestored);
  connect(m_recovery, &DriverRecovery::stateChanged, this, &CompareView::pictureStateChanged);
  // Slots are called in the order in which they were connected.
  connect(m_recovery, &DriverRecovery::drawn, m_panels, &PanelStack::setPictures);
  connect(m_recovery, &DriverRecovery::drawn, this, &CompareView::updatePanels);
  connect(m_recovery, &DriverRecovery::failed, this, &CompareView::updatePanels);
  connect(m_recovery, &DriverRecovery::failed, this, &CompareView::errorOccurred);
  connect(m_panels, &PanelStack::retryRequested, m_recovery, &DriverRecovery::retry);
  connect(m_panels, &PanelStack::retryRequested, this, &CompareView::redraw);
  connect(m_panels, &PanelStack::driverRetryRequested, m_recovery, &DriverRecovery::forget);
  connect(m_panels, &PanelStack::driverRetryRequested, this, &CompareView::redraw);
}

void CompareView::connectInput() {
  connect(m_input, &ViewInput::cameraEdited, this, &CompareView::cameraEdited);
  connect(m_input, &ViewInput::functionEdited, this, &CompareView::windowLevelEdited);
  connect(m_input, &ViewInput::cropEdited, this, &CompareView::cropEdited);
  connect(m_input, &ViewInput::wipeEdited, this, &CompareView::moveWipe);
  connect(m_input, &ViewInput::probed, this, &CompareView::probed);
  connect(m_input, &ViewInput::pinRequested, this, &CompareView::pinRequested);
  connect(m_input, &ViewInput::modelsRequested, this, &CompareView::offerModels);
  connect(m_input, &ViewInput::maximiseRequested, this, &CompareView::maximiseRequested);
  connect(m_input, &ViewInput::windowPresetRequested, this, &CompareView::windowPresetRequested);
  connect(m_input, &ViewInput::shortcutListRequested, this, &CompareView::shortcutListRequested);
  connect(m_input, &ViewInput::swapRequested, this, [this] { setSwapped(true); });
  connect(m_labels, &LabelFade::changed, this, qOverload<>(&QWidget::update));
  connect(m_panels, &PanelStack::openFolderRequested, this, &CompareView::openFolderRequested);
  connect(m_panels, &PanelStack::openFileRequested, this, &CompareView::openFileRequested);
  connect(m_panels, &PanelStack::sampleRequested, this, &CompareView::sampleRequested);
  connect(m_panels, &PanelStack::loadingCancelled, this, &CompareView::loadingCancelled);
}

CompareView::~CompareView() {
  releasePictures();
  // The base class destroys the context after this class is gone.
  if (context())
    disconnect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &CompareView::releasePictures);
}

void CompareView::setScene(const Scene& scene) {
  const Scene& shown = m_shown.scene;
  if (scene == shown)
    return;
  const bool otherVolume = scene.volume != shown.volume;
  Scene asShown = scene;
  asShown.camera = shown.camera;
  if (otherVolume) {
    m_recovery->forget();
    m_loop->forget();
    m_input->forget();
  }
  if (asShown != shown && !m_recovery->processorState()) // more than the camera: what failed may work now
    m_recovery->retry();
  if (scene.projection != shown.projection)
    m_loop->forgetSpeed();
  if (scene.shading != shown.shading)
    m_labels->wake();
  m_shown.scene = scene;
  redraw();
}

void CompareView::setCompareLayout(CompareLayout layout) {
  if (layout == m_shown.layout)
    return;
  m_shown.layout = layout;
  m_shown.isSwapped = false;
  m_labels->wake();
  redraw();
}

void CompareView::setModels(ShadingModel left, ShadingModel right) {
  const std::array models{left, right};
  if (models == m_shown.models)
    return;
  m_shown.models = models;
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
  m_loop->setRefines(refines);
}

void CompareView::setMovingMs(double ms) {
  m_loop->setMovingMs(ms);
}

void CompareView::measureEffects() {
  m_loop->measureEffects();
}

void CompareView::setOverlayVisible(bool visible) {
  m_overlayVisible = visible;
  update();
}

void CompareView::setCropBoxVisible(bool visible) {
  if (visible == m_cropBoxVisible)
    return;
  m_cropBoxVisible = visible;
  m_input->forgetFace();
  update();
}

void CompareView::setLoading(double fraction, const QString& text) {
  m_panels->setLoading(fraction, text);
  updatePanels();
}

void CompareView::clearLoading() {
  m_panels->clearLoading();
  updatePanels();
}

const PictureState& CompareView::pictureState() const {
  const std::optional<PictureState>& onProcessor = m_recovery->processorState();
  return onProcessor ? *onProcessor : m_loop->state();
}

QImage CompareView::currentPicture(int side) {
  const SidePicture* resting = m_loop->resting(side);
  return resting ? resting->picture().bytes : QImage();
}

std::optional<Image> CompareView::restingImage(int side) {
  const SidePicture* resting = m_loop->resting(side);
  return resting ? std::optional(*resting->picture().image) : std::nullopt;
}

Scene CompareView::sceneOfRestingImage(int side) const {
  const SidePicture* resting = m_loop->resting(side);
  const Scene scene = sceneOfSide(side);
  return resting ? withStep(scene, resting->finishedStepVoxels()) : scene;
}

OverlaySource CompareView::overlaySource() const {
  return {m_shown,          geometry(),          pictureState(),
          font(),           m_labels->opacity(), m_input->hovered(),
          m_cropBoxVisible, m_input->heldFace(), m_input->reading()};
}

void CompareView::redraw() {
  m_loop->restart();
  if (!m_shown.scene.volume)
    m_loop->forgetEffects();
  updatePanels();
  if (m_recovery->processorState())
    drawOnProcessor();
  update();
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
    update();
}

void CompareView::updatePanels() {
  m_panels->arrange(m_shown.scene.volume != nullptr, m_recovery->sentence(),
                    m_recovery->processorState().has_value());
}

void CompareView::initializeGL() {
  // The context may be replaced when the view moves to another window.
  connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &CompareView::releasePictures,
          Qt::UniqueConnection);
  m_loop->forgetSpeed();
}

void CompareView::releasePictures() {
  if (!m_loop->pictures())
    return;
  m_loop->stop();
  makeCurrent();
  m_loop->release(!context()->isValid() || QOpenGLContext::currentContext() != context());
  doneCurrent();
}

void CompareView::paintGL() {
  const bool hasVolume = m_shown.scene.volume != nullptr;
  if (hasVolume && !m_recovery->hasFailed())
    m_recovery->guard([this] { m_loop->drawIfStale(requestOf(m_shown, geometry())); });
  const glm::dvec3 background = m_shown.scene.image.background;
  if (m_loop->pictures() && hasVolume && !m_recovery->hasFailed()) {
    m_loop->pictures()->show(arrangementOf(m_shown, geometry()), defaultFramebufferObject(), background);
    if (m_overlayVisible)
      paintOverlayInContext(overlayOf(overlaySource()), geometry());
  } else {
    clearTo(background);
  }
  m_loop->noteShown();
}

void CompareView::resizeEvent(QResizeEvent* event) {
  QOpenGLWidget::resizeEvent(event);
  updatePanels();
}

void CompareView::showEvent(QShowEvent* event) {
  QOpenGLWidget::showEvent(event);
  // Without OpenGL paintGL() is never called; the window would stay black.
  QTimer::singleShot(0, this, [this] {
    if (!isVisible() || isValid())
      return;
    const QString problem = openGlProblem();
    m_recovery->fail(problem.isEmpty()
                         ? tr("The graphics driver gives this window no OpenGL context; restart the program.")
                         : problem);
  });
  if (!pictureState().resting)
    redraw();
  else
    m_loop->resume();
}

// Qt makes a widget's context anew when its window changes, and tells the widget of it in this way, too where
// the window itself has lost its device.
void CompareView::rebuildGraphics(bool isLost) {
  if (isLost) {
    QEvent windowChanged(QEvent::WindowChangeInternal);
    QCoreApplication::sendEvent(this, &windowChanged);
  } else {
    releasePictures();
  }
  m_recovery->retry();
  redraw();
}

void CompareView::giveUpDriver() {
  releasePictures();
  m_panels->setReason(m_recovery->sentence(), m_recovery->details());
  updatePanels();
  emit errorOccurred(m_recovery->sentence());
  if (m_shown.scene.volume)
    drawOnProcessor();
}

void CompareView::drawOnProcessor() {
  const glm::ivec2 size = deviceSize(geometry());
  m_recovery->drawOnProcessor(scenesOfSides(), {size.x / pictureCount(m_shown.layout), size.y});
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
    QOpenGLWidget::keyPressEvent(event);
}

void CompareView::keyReleaseEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Shift)
    m_input->stopReading();
  if (event->key() == Qt::Key_Space && !event->isAutoRepeat())
    setSwapped(false);
  QOpenGLWidget::keyReleaseEvent(event);
}

void CompareView::enterEvent(QEnterEvent* event) {
  QOpenGLWidget::enterEvent(event);
  m_input->enter();
}

void CompareView::leaveEvent(QEvent* event) {
  QOpenGLWidget::leaveEvent(event);
  m_input->leave();
}

void CompareView::focusOutEvent(QFocusEvent* event) {
  QOpenGLWidget::focusOutEvent(event);
  setSwapped(false);
}

} // namespace limn
