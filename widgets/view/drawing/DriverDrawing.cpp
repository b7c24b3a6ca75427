// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/drawing/DriverDrawing.h"

#include "engine/DrawingEngine.h"
#include "widgets/view/drawing/DriverRecovery.h"
#include "widgets/view/overlay/Overlay.h"
#include "widgets/view/pictures/PictureScreen.h"

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

DriverDrawing::DriverDrawing(MakeEngine makeEngine, DriverRecovery& recovery, QWidget& view)
    : ViewDrawing(&view), m_recovery(recovery), m_canvas(new GlCanvas(*this, view)),
      m_loop(*new PictureLoop(
          [makeEngine = std::move(makeEngine)] {
            return std::make_unique<Pictures>(makeEngine(), makeGlScreen());
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

} // namespace limn
