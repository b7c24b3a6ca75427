// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/drawing/DriverDrawing.h"

#include "engine/DrawingEngine.h"
#include "widgets/view/SurfaceFormat.h"
#include "widgets/view/failure/DriverRecovery.h"
#include "widgets/view/pictures/GlScreen.h"

#include <QCoreApplication>
#include <QEvent>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QOpenGLWidget>

namespace limn {

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
    m_drawing.forgetSpeed();
  }
  void resizeGL(int, int) override { m_drawing.restart(); }
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

PictureContext contextOf(QOpenGLWidget* canvas, const ViewOrders& orders, DriverRecovery& recovery) {
  PictureContext context;
  context.canDraw = orders.canDraw;
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

DriverDrawing::DriverDrawing(MakeEngine makeEngine, ViewOrders orders, DriverRecovery& recovery,
                             QWidget& view)
    : ViewDrawing(&view), m_orders(std::move(orders)), m_recovery(recovery),
      m_canvas(new GlCanvas(*this, view)),
      m_loop(*new PictureLoop(
          [makeEngine = std::move(makeEngine)] {
            return std::make_unique<Pictures>(makeEngine(), makeGlScreen());
          },
          contextOf(m_canvas, m_orders, recovery), {}, this)) {
  connect(&m_loop, &PictureLoop::stateChanged, this, &ViewDrawing::stateChanged);
  connect(&m_loop, &PictureLoop::effectsChanged, this, &ViewDrawing::effectsChanged);
  connect(&m_loop, &PictureLoop::timesChanged, this, &ViewDrawing::timesChanged);
  connect(&m_loop, &PictureLoop::showNeeded, m_canvas, qOverload<>(&QWidget::update));
  connect(&m_loop, &PictureLoop::completed, this, &ViewDrawing::completed);
  connect(&m_loop, &PictureLoop::preparing, this, &ViewDrawing::preparing, Qt::QueuedConnection);
  connect(&m_loop, &PictureLoop::restFailed, this, &ViewDrawing::restFailed);
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

void DriverDrawing::restart() {
  m_loop.restart();
  m_canvas->update();
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
  if (m_orders.canDraw())
    m_recovery.guard([this] { m_loop.drawIfStale(m_orders.request()); });
  QOpenGLFunctions& gl = *m_canvas->context()->functions();
  gl.glBindFramebuffer(GL_FRAMEBUFFER, m_canvas->defaultFramebufferObject());
  if (m_loop.pictures() && m_orders.canDraw() && !m_loop.isPreparing()) {
    m_loop.pictures()->show(m_orders.arrangement(), m_orders.background());
    if (const std::optional<Overlay> overlay = m_orders.overlay())
      paintOverlayInContext(*overlay, m_orders.geometry());
  } else {
    clearTo(gl, m_orders.background());
  }
  m_loop.noteShown();
}

} // namespace limn
