// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/drawing/ProcessorDrawing.h"

#include "engine/DrawingEngine.h"
#include "scene/basics/Error.h"
#include "widgets/Translated.h"
#include "widgets/view/overlay/Overlay.h"
#include "widgets/view/pictures/PictureScreen.h"

#include <QPainter>

#include <utility>

namespace limn {
namespace {

// Nobody shares the thread. A strip is dropped where something else is asked for, so there is nothing to wait
// for before the first one; short turns show how far the picture is.
constexpr PicturePace workerPace{0, 12.0, 12.0};

} // namespace

PictureWorker::PictureWorker(MakeEngine makeEngine, MakePrecise makePrecise)
    : m_loop(
          [this, makeEngine = std::move(makeEngine), makePrecise = std::move(makePrecise)] {
            return std::make_unique<Pictures>(
                makeEngine(), makeMemoryScreen([this] { return m_isInterrupted && !m_isCoarse; }),
                makePrecise);
          },
          {[] {}, [] {}, [this](const auto& work) { guard(work); },
           [this] { return m_endsPreparing.load(); }},
          workerPace, this) {
  connect(&m_loop, &PictureLoop::showNeeded, this, &PictureWorker::show);
  // Together with the picture that it is of; but to get a volume ready takes all of a turn.
  connect(&m_loop, &PictureLoop::told, this, &PictureWorker::deliver, Qt::QueuedConnection);
  connect(&m_loop, &PictureLoop::told, this, [this] {
    if (m_loop.isPreparing())
      deliver();
  });
}

PictureWorker::~PictureWorker() = default;

// Only the last order counts, however late the thread wakes.
void PictureWorker::ask(PictureOrder order, int number) {
  const std::lock_guard lock(m_mutex);
  if (volumeOf(order) != volumeOf(m_last) || order.attempt != m_last.attempt)
    m_endsPreparing = true;
  m_last = std::move(order);
  m_lastNumber = number;
  m_isInterrupted = true;
  if (!std::exchange(m_isWoken, true))
    QMetaObject::invokeMethod(this, &PictureWorker::begin, Qt::QueuedConnection);
}

std::optional<PictureDelivery> PictureWorker::take() {
  const std::lock_guard lock(m_mutex);
  return std::exchange(m_delivery, std::nullopt);
}

void PictureWorker::begin() {
  PictureOrder order;
  {
    const std::lock_guard lock(m_mutex);
    order = m_last;
    m_number = m_lastNumber;
    m_isWoken = m_isInterrupted = m_endsPreparing = false;
  }
  m_failure.clear();
  if (volumeOf(order) != volumeOf(m_loop.order()))
    m_frame = {};
  m_loop.show(order);
  show();
}

void PictureWorker::measureEffects(bool measures) {
  m_isInterrupted = true;
  QMetaObject::invokeMethod(
      this, [this, measures] { beginMeasuring(measures); }, Qt::QueuedConnection);
}

void PictureWorker::beginMeasuring(bool measures) {
  {
    const std::lock_guard lock(m_mutex);
    m_isInterrupted = m_isWoken || m_endsPreparing; // an order, or the end, is still to come
  }
  ++m_measurements;
  m_loop.measureEffects(measures);
  deliver();
}

void PictureWorker::guard(const PictureContext::Work& work) {
  try {
    work();
  } catch (const Cancelled&) {
    // Something else is to be shown, or nothing.
  } catch (const std::exception& error) {
    PictureOrder nothing = m_loop.order();
    nothing.isSeen = false;
    m_loop.show(nothing);
    m_failure = translated(error);
    deliver();
  }
}

void PictureWorker::show() {
  if (!m_loop.order().isSeen)
    return;
  guard([this] {
    m_isCoarse = true;
    m_loop.drawIfStale();
    m_isCoarse = false;
    if (!m_loop.pictures())
      return;
    m_loop.pictures()->show(m_loop.order());
    m_frame = m_loop.pictures()->frame();
    m_camera = m_loop.pictures()->side(0).scene().camera;
    m_loop.noteShown();
  });
  m_isCoarse = false;
  if (m_loop.order().isSeen)
    deliver();
}

void PictureWorker::deliver() {
  PictureDelivery delivery{m_number, m_measurements, m_frame, m_camera, m_loop.news(), {}, {}};
  delivery.news.failure = m_failure;
  for (int side = 0; side < static_cast<int>(delivery.news.state.sides.size()); ++side) {
    delivery.scales.push_back(m_loop.gradientScaleOf(side));
    if (const SidePicture* resting = m_loop.resting(side))
      delivery.resting.push_back(restingPicture(*resting));
  }
  bool isTaken = false;
  {
    const std::lock_guard lock(m_mutex);
    isTaken = !m_delivery;
    m_delivery = std::move(delivery);
  }
  if (isTaken)
    emit delivered();
}

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

ProcessorDrawing::ProcessorDrawing(MakeEngine makeEngine, MakePrecise makePrecise, QWidget& view)
    : ViewDrawing(&view), m_canvas(new Canvas(*this, view)),
      m_worker(new PictureWorker(std::move(makeEngine), std::move(makePrecise))) {
  m_askTimer.setSingleShot(true);
  connect(&m_askTimer, &QTimer::timeout, this, [this] { m_worker->ask(m_pictures, m_number); });
  connect(m_worker, &PictureWorker::delivered, this, &ProcessorDrawing::receive);
  connect(&m_thread, &QThread::finished, m_worker, &QObject::deleteLater);
  m_worker->moveToThread(&m_thread);
  m_thread.start();
}

ProcessorDrawing::~ProcessorDrawing() {
  m_worker->interrupt();
  m_thread.quit();
  m_thread.wait();
  delete m_canvas;
}

QWidget& ProcessorDrawing::canvas() {
  return *m_canvas;
}

void ProcessorDrawing::drawOrder(const PictureOrder& order) {
  if (order == m_pictures)
    return;
  const PictureOrder before = std::exchange(m_pictures, order);
  if (volumeOf(order) != volumeOf(before)) {
    m_forgotten = m_number;
    ViewNews kept; // what the last picture calls for, until there is another
    if (volumeOf(order)) {
      kept.effects = m_delivery.news.effects;
      kept.effectsOf = m_delivery.news.effectsOf;
    }
    m_delivery = {};
    m_delivery.news = std::move(kept);
  }
  ViewNews& news = m_delivery.news;
  if (asksForOthers(order, before, news.state.resting)) {
    ++m_number;
    news.state = staleState(std::move(news.state));
    news.failure.clear();
  }
  if (!m_askTimer.isActive())
    m_askTimer.start(0);
}

void ProcessorDrawing::measureEffects(bool measures) {
  if (m_delivery.news.effects.empty())
    return;
  ++m_measurements;
  m_measures = measures;
  m_worker->measureEffects(measures);
  noteMeasuring();
  QMetaObject::invokeMethod(
      this, [this] { tell(); }, Qt::QueuedConnection);
}

// Said at once: to begin, or to end, the thread may first have to end a piece of what it draws.
void ProcessorDrawing::noteMeasuring() {
  if (m_delivery.measurements >= m_measurements)
    return;
  m_delivery.news.times = {};
  m_delivery.news.times.isMeasuring = m_measures;
}

// Pictures of an earlier order are shown, too: while something moves there are no others.
void ProcessorDrawing::receive() {
  std::optional<PictureDelivery> delivery = m_worker->take();
  if (!delivery || delivery->number <= m_forgotten)
    return;
  if (delivery->number != m_number) {
    delivery->news.state = staleState(std::move(delivery->news.state));
    delivery->news.failure.clear();
    delivery->resting.clear();
  }
  const ViewNews before = std::exchange(m_delivery, std::move(*delivery)).news;
  noteMeasuring();
  const bool isNews = before != m_delivery.news;
  m_canvas->update();
  if (isNews)
    tell();
}

std::optional<RestingPicture> ProcessorDrawing::resting(int side) const {
  const auto index = static_cast<std::size_t>(side);
  const bool isComplete = m_delivery.news.state.resting && index < m_delivery.resting.size();
  return isComplete ? std::optional(m_delivery.resting[index]) : std::nullopt;
}

GradientScale ProcessorDrawing::gradientScaleOf(int side) const {
  const auto index = static_cast<std::size_t>(side);
  return index < m_delivery.scales.size() ? m_delivery.scales[index] : GradientScale{};
}

void ProcessorDrawing::paint(QPainter& painter) {
  const QRect all = m_canvas->rect();
  const QImage& frame = m_delivery.frame;
  if (frame.isNull() || !order().isSeen) {
    const glm::dvec3 background = order().comparison.scene.image.background;
    painter.fillRect(all, QColor::fromRgbF(static_cast<float>(background.r), static_cast<float>(background.g),
                                           static_cast<float>(background.b)));
    return;
  }
  painter.drawImage(all, frame);
  if (!order().hasOverlay)
    return;
  // Letters, cube and marks belong to the picture that is seen, however late it is.
  OverlaySource source = overlaySource();
  source.comparison.scene.camera = m_delivery.camera;
  paintOverlay(painter, overlayOf(source));
}

} // namespace limn
