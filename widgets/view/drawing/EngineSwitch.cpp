// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/drawing/EngineSwitch.h"

#include "engine/VolumeTooLarge.h"
#include "widgets/view/drawing/ProcessorDrawing.h"
#include "widgets/view/overlay/Overlay.h"

#include <QCoreApplication>
#include <QEvent>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QOpenGLWidget>

namespace limn {
namespace {

// As far as their light goes.
bool shadersMayDraw(const ViewOrder& order) {
  try {
    for (const Scene& scene : pictureOrderOf(order).scenes)
      if (scene.volume)
        requireLightOfShaders(scene);
    return true;
  } catch (const BeyondDriver&) {
    return false;
  }
}

} // namespace

class GlCanvas : public QOpenGLWidget {
public:
  GlCanvas(DriverDrawing& drawing, QWidget& view) : QOpenGLWidget(&view), m_drawing(drawing) {
    setFormat(limnSurfaceFormat());
    setAttribute(Qt::WA_TransparentForMouseEvents);
  }

protected:
  void initializeGL() override {
    // The context may be replaced when the view moves to another window.
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, &m_drawing, &DriverDrawing::release,
            Qt::UniqueConnection);
    m_drawing.m_loop.forgetSpeed();
  }
  void paintGL() override { m_drawing.paint(); }
  void showEvent(QShowEvent* event) override {
    QOpenGLWidget::showEvent(event);
    // Without OpenGL paintGL() is never called; the window would stay black.
    QTimer::singleShot(0, &m_drawing, [this] {
      if (isVisible() && !isValid())
        emit m_drawing.contextRefused();
    });
  }

private:
  DriverDrawing& m_drawing;
};

namespace {

PictureContext contextOf(QOpenGLWidget* canvas, DriverRecovery& recovery) {
  PictureContext context;
  context.makeCurrent = [canvas] { canvas->makeCurrent(); };
  context.doneCurrent = [canvas] { canvas->doneCurrent(); };
  context.guard = [&recovery](const PictureContext::Work& work) { recovery.guard(work); };
  return context;
}

void clearTo(QOpenGLFunctions& gl, const glm::dvec3& background) {
  gl.glClearColor(static_cast<float>(background.r), static_cast<float>(background.g),
                  static_cast<float>(background.b), 1.0f);
  gl.glClear(GL_COLOR_BUFFER_BIT);
}

} // namespace

DriverDrawing::DriverDrawing(const DrawingEngines& engines, DriverRecovery& recovery, QWidget& view)
    : ViewDrawing(&view), m_recovery(recovery), m_canvas(new GlCanvas(*this, view)),
      m_loop(*new PictureLoop(
          [engines] {
            return std::make_unique<Pictures>(engines.driver(), makeGlScreen(), engines.precisely,
                                              engines.processor);
          },
          contextOf(m_canvas, recovery), {}, this)) {
  // Receivers set widgets, which must not happen in the middle of painting.
  connect(&m_loop, &PictureLoop::told, this, &DriverDrawing::tell, Qt::QueuedConnection);
  connect(&m_loop, &PictureLoop::showNeeded, m_canvas, qOverload<>(&QWidget::update));
}

DriverDrawing::~DriverDrawing() {
  release();
  // The widget destroys its context after this is gone.
  if (m_canvas->context())
    disconnect(m_canvas->context(), nullptr, this, nullptr);
  delete m_canvas;
}

QWidget& DriverDrawing::canvas() {
  return *m_canvas;
}

std::optional<RestingPicture> DriverDrawing::resting(int side) const {
  const SidePicture* resting = m_loop.resting(side);
  return resting ? std::optional(restingPicture(*resting)) : std::nullopt;
}

void DriverDrawing::release() {
  if (!m_loop.pictures())
    return;
  m_loop.stop();
  m_canvas->makeCurrent();
  m_loop.release(!m_canvas->context()->isValid() || QOpenGLContext::currentContext() != m_canvas->context());
  m_canvas->doneCurrent();
}

// Qt makes a widget's context anew when its window changes, and tells the widget of it in this way, too where
// the window itself has lost its device.
void DriverDrawing::rebuild(bool isLost) {
  if (isLost) {
    QEvent windowChanged(QEvent::WindowChangeInternal);
    QCoreApplication::sendEvent(m_canvas, &windowChanged);
  } else {
    release();
  }
}

void DriverDrawing::paint() {
  if (order().isSeen)
    m_recovery.guard([this] { m_loop.drawIfStale(); });
  QOpenGLFunctions& gl = *m_canvas->context()->functions();
  gl.glBindFramebuffer(GL_FRAMEBUFFER, m_canvas->defaultFramebufferObject());
  if (m_loop.pictures() && order().isSeen && !m_loop.isPreparing()) {
    m_loop.pictures()->show(m_loop.order());
    if (order().hasOverlay)
      paintOverlayInContext(overlayOf(overlaySource()), order().geometry);
  } else {
    clearTo(gl, order().comparison.scene.image.background);
  }
  m_loop.noteShown();
}

EngineSwitch::EngineSwitch(DrawingEngines engines, Engine engine, QWidget& view)
    : QObject(&view), m_engines(std::move(engines)), m_view(view), m_engine(engine) {
  connect(&m_recovery, &DriverRecovery::stopped, this, &EngineSwitch::push);
  connect(&m_recovery, &DriverRecovery::givenUp, this, &EngineSwitch::giveUpDriver);
  connect(&m_recovery, &DriverRecovery::beyondDriver, this, &EngineSwitch::standIn);
  connect(&m_recovery, &DriverRecovery::restored, this, &EngineSwitch::restored);
  connect(&m_recovery, &DriverRecovery::failed, this, [this](const QString& sentence) {
    tell();
    emit errorOccurred(sentence);
  });
  draw(m_engines.driver ? m_engine : Engine::cpu);
}

EngineSwitch::~EngineSwitch() {
  delete m_drawing;
}

ViewDrawing* EngineSwitch::makeDriverDrawing() {
  auto* drawing = new DriverDrawing(m_engines, m_recovery, m_view);
  connect(&m_recovery, &DriverRecovery::rebuildNeeded, drawing, [this, drawing](bool isLost) {
    drawing->rebuild(isLost);
    retry();
  });
  const auto giveUp = [this] {
    const QString problem = openGlOffer().problem;
    m_recovery.giveUp(
        problem.isEmpty()
            ? tr("The graphics driver gives this window no OpenGL context; restart the program.")
            : problem);
  };
  // Not at once: the drawing that says so will be gone.
  connect(drawing, &DriverDrawing::contextRefused, this, giveUp, Qt::QueuedConnection);
  return drawing;
}

void EngineSwitch::draw(Engine engine) {
  delete std::exchange(m_drawing, nullptr);
  m_engine = engine;
  m_drawing = drawsWithOpenGl(engine)
                  ? makeDriverDrawing()
                  : new ProcessorDrawing(m_engines.processor, m_engines.precisely, m_view);
  connect(m_drawing, &ViewDrawing::told, this, &EngineSwitch::take);
  m_drawing->canvas().lower();
  m_drawing->canvas().show();
  push();
  emit replaced();
}

void EngineSwitch::show(const ViewOrder& order) {
  const Scene before = m_order.comparison.scene;
  const bool rested = m_drawing->state().resting;
  const bool isMeasuredAnew = order.measured != m_order.measured;
  m_order = order;
  Scene asBefore = order.comparison.scene;
  asBefore.camera = before.camera;
  const bool isOtherVolume = asBefore.volume != before.volume;
  if (isOtherVolume) { // nothing that failed of the last one counts
    m_recovery.forget();
    retryDriver();
  } else if (!m_tooLarge.isEmpty() && m_standsInForScene && shadersMayDraw(order)) {
    retryDriver();
  } else if (asBefore != before && m_recovery.hasFailed()) { // it may work now
    m_recovery.retry();
    ++m_attempt;
  }
  push();
  if (isOtherVolume || isMeasuredAnew || rested != m_drawing->state().resting)
    tell();
}

void EngineSwitch::push() {
  if (!m_drawing)
    return;
  ViewOrder order = m_order;
  order.isSeen = order.isSeen && !m_recovery.hasFailed();
  order.attempt = m_attempt;
  const bool hasFailed = !m_driverFailure.isEmpty();
  order.inUse = {m_engine,
                 !m_tooLarge.isEmpty() ? m_tooLarge
                 : hasFailed           ? m_driverFailure
                                       : m_reason,
                 hasFailed, m_tooLarge};
  m_drawing->show(order);
}

void EngineSwitch::tell() {
  m_news = m_drawing->news();
  m_news.failure = problem();
  emit told(m_news);
}

void EngineSwitch::take(const ViewNews& news) {
  const bool rested = m_news.state.resting;
  const QString failureAtRest = m_news.failureAtRest;
  if (!news.failure.isEmpty() && !m_recovery.hasFailed())
    m_recovery.fail(news.failure);
  tell();
  if (news.state.resting && !rested && !m_recovery.hasFailed())
    m_recovery.noteSuccess();
  if (!news.failureAtRest.isEmpty() && news.failureAtRest != failureAtRest)
    emit errorOccurred(news.failureAtRest);
}

void EngineSwitch::choose(Engine engine, const QString& reason) {
  if (!(drawsWithOpenGl(engine) ? m_engines.driver : m_engines.processor))
    return;
  m_reason = reason;
  const bool standsIn = !m_driverFailure.isEmpty() || !m_tooLarge.isEmpty();
  m_driverFailure.clear();
  m_tooLarge.clear();
  m_recovery.forget();
  if (engine != m_engine || standsIn)
    draw(engine);
  else
    push();
  tell();
}

void EngineSwitch::retryDriver() {
  if (!m_driverFailure.isEmpty() || !m_tooLarge.isEmpty())
    choose(Engine::rayCaster, m_reason);
}

void EngineSwitch::retry() {
  m_recovery.retry();
  ++m_attempt;
  push();
  tell();
}

void EngineSwitch::cancelPreparing() {
  ++m_attempt;
  m_recovery.fail(tr("Getting the volume ready for drawing was cancelled."));
}

// False where another engine was chosen meanwhile, or there is none: then the sentence is all there is.
bool EngineSwitch::letProcessorDraw(QString& reason, const QString& sentence) {
  if (!drawsWithOpenGl(m_engine))
    return false;
  if (!m_engines.processor) {
    m_recovery.fail(m_recovery.sentence());
    return false;
  }
  reason = sentence;
  m_recovery.forget();
  draw(Engine::cpu);
  tell();
  return true;
}

void EngineSwitch::giveUpDriver() {
  if (letProcessorDraw(m_driverFailure, m_recovery.sentence()))
    emit errorOccurred(m_driverFailure);
}

// For this volume alone, or this scene.
void EngineSwitch::standIn(bool isVolume) {
  m_standsInForScene = !isVolume;
  letProcessorDraw(m_tooLarge, tr("%1 The processor draws it.").arg(m_recovery.sentence()));
}

} // namespace limn
