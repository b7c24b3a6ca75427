// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/drawing/ProcessorDrawing.h"

#include <QPainter>

namespace limn {

class ProcessorDrawing::Canvas : public QWidget {
public:
  Canvas(ProcessorDrawing& drawing, QWidget& view) : QWidget(&view), m_drawing(drawing) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_OpaquePaintEvent);
  }

protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    m_drawing.paint(painter);
  }

private:
  ProcessorDrawing& m_drawing;
};

namespace {

// The same state while something else is asked for: nothing of it is complete any more.
PictureState stale(PictureState state) {
  state.resting = false;
  state.refines = false;
  state.refinementEnd.reset();
  for (SideState& side : state.sides)
    side.fraction = 0.0;
  return state;
}

} // namespace

ProcessorDrawing::ProcessorDrawing(MakeEngine makeEngine, ViewOrders orders, QWidget& view)
    : ViewDrawing(&view), m_orders(std::move(orders)), m_canvas(new Canvas(*this, view)),
      m_worker(new PictureWorker(std::move(makeEngine))) {
  m_askTimer.setSingleShot(true);
  connect(&m_askTimer, &QTimer::timeout, this, &ProcessorDrawing::ask);
  connect(m_worker, &PictureWorker::delivered, this, &ProcessorDrawing::receive);
  connect(m_worker, &PictureWorker::effectsChanged, this, &ViewDrawing::effectsChanged);
  connect(m_worker, &PictureWorker::timesChanged, this, &ViewDrawing::timesChanged);
  connect(m_worker, &PictureWorker::completed, this, &ViewDrawing::completed);
  connect(m_worker, &PictureWorker::preparing, this, &ViewDrawing::preparing);
  connect(m_worker, &PictureWorker::restFailed, this, &ViewDrawing::restFailed);
  connect(m_worker, &PictureWorker::failed, this, &ProcessorDrawing::failed);
  connect(&m_thread, &QThread::finished, m_worker, &QObject::deleteLater);
  m_worker->moveToThread(&m_thread);
  m_thread.start();
}

ProcessorDrawing::~ProcessorDrawing() {
  m_worker->interrupt();
  m_worker->endPreparing();
  m_thread.quit();
  m_thread.wait();
  delete m_canvas;
}

QWidget& ProcessorDrawing::canvas() {
  return *m_canvas;
}

void ProcessorDrawing::restart() {
  ++m_number;
  if (m_state.resting) {
    m_state = stale(m_state);
    emit stateChanged(m_state);
  }
  askSoon();
  m_canvas->update();
}

void ProcessorDrawing::arrangeAnew() {
  askSoon();
  m_canvas->update();
}

void ProcessorDrawing::askSoon() {
  if (!m_askTimer.isActive())
    m_askTimer.start(0);
}

void ProcessorDrawing::ask() {
  if (m_orders.canDraw())
    m_worker->ask({m_number, m_orders.request(), m_orders.arrangement(), m_orders.background()});
}

void ProcessorDrawing::stop() {
  m_worker->rest();
}

void ProcessorDrawing::resume() {
  QMetaObject::invokeMethod(m_worker, &PictureWorker::goOn);
}

void ProcessorDrawing::endPreparing() {
  m_worker->endPreparing();
}

void ProcessorDrawing::forget() {
  m_worker->endPreparing();
  m_forgotten = m_number;
  m_delivery = {};
  m_state = {};
  QMetaObject::invokeMethod(m_worker, &PictureWorker::forget);
}

void ProcessorDrawing::forgetSpeed() {
  QMetaObject::invokeMethod(m_worker, &PictureWorker::forgetSpeed);
}

void ProcessorDrawing::forgetEffects() {
  QMetaObject::invokeMethod(m_worker, &PictureWorker::forgetEffects);
}

void ProcessorDrawing::measureEffects() {
  QMetaObject::invokeMethod(m_worker, &PictureWorker::measureEffects);
}

void ProcessorDrawing::setRefines(bool refines) {
  QMetaObject::invokeMethod(m_worker, [worker = m_worker, refines] { worker->setRefines(refines); });
}

void ProcessorDrawing::setMovingMs(double ms) {
  QMetaObject::invokeMethod(m_worker, [worker = m_worker, ms] { worker->setMovingMs(ms); });
}

// Pictures of an earlier order are shown, too: while something moves there are no others.
void ProcessorDrawing::receive() {
  std::optional<PictureDelivery> delivery = m_worker->take();
  if (!delivery || delivery->number <= m_forgotten)
    return;
  const bool isLast = delivery->number == m_number;
  const PictureState state = isLast ? delivery->state : stale(delivery->state);
  m_delivery = std::move(*delivery);
  if (!isLast)
    m_delivery.resting.clear();
  m_canvas->update();
  if (state == m_state)
    return;
  m_state = state;
  emit stateChanged(m_state);
}

std::optional<RestingPicture> ProcessorDrawing::resting(int side) const {
  const auto index = static_cast<std::size_t>(side);
  const bool isComplete = m_state.resting && index < m_delivery.resting.size();
  return isComplete ? std::optional(m_delivery.resting[index]) : std::nullopt;
}

GradientScale ProcessorDrawing::gradientScaleOf(int side) const {
  const auto index = static_cast<std::size_t>(side);
  return index < m_delivery.scales.size() ? m_delivery.scales[index] : GradientScale{};
}

void ProcessorDrawing::paint(QPainter& painter) {
  const QRect all = m_canvas->rect();
  const glm::dvec3 background = m_orders.background();
  const QImage& frame = m_delivery.frame;
  if (frame.isNull() || !m_orders.canDraw()) {
    painter.fillRect(all, QColor::fromRgbF(static_cast<float>(background.r), static_cast<float>(background.g),
                                           static_cast<float>(background.b)));
    return;
  }
  painter.drawImage(all, frame);
  if (const std::optional<Overlay> overlay = m_orders.overlay())
    paintOverlay(painter, *overlay);
}

} // namespace limn
