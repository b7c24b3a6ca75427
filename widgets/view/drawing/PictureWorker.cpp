// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/drawing/PictureWorker.h"

#include "engine/DrawingEngine.h"
#include "scene/basics/Error.h"
#include "widgets/Translated.h"
#include "widgets/view/pictures/MemoryScreen.h"

#include <utility>

namespace limn {
namespace {

// Nobody shares the thread. A strip is dropped where something else is asked for, so there is nothing to wait
// for before the first one; short turns show how far the picture is.
constexpr PicturePace workerPace{0, 12.0, 12.0};

} // namespace

PictureWorker::PictureWorker(MakeEngine makeEngine)
    : m_loop(
          [this, makeEngine = std::move(makeEngine)] {
            return std::make_unique<Pictures>(
                makeEngine(), makeMemoryScreen([this] { return m_isInterrupted && !m_isCoarse; }));
          },
          {[this] { return m_canDraw; }, [] {}, [] {}, [this](const auto& work) { guard(work); },
           [this] { return m_endsPreparing.load(); }},
          workerPace, this) {
  connect(&m_loop, &PictureLoop::showNeeded, this, &PictureWorker::show);
  connect(&m_loop, &PictureLoop::stateChanged, this, &PictureWorker::deliver);
  connect(&m_loop, &PictureLoop::effectsChanged, this, &PictureWorker::effectsChanged);
  connect(&m_loop, &PictureLoop::timesChanged, this, &PictureWorker::timesChanged);
  connect(&m_loop, &PictureLoop::completed, this, &PictureWorker::completed);
  connect(&m_loop, &PictureLoop::preparing, this, &PictureWorker::preparing);
  connect(&m_loop, &PictureLoop::restFailed, this, &PictureWorker::restFailed);
}

PictureWorker::~PictureWorker() = default;

void PictureWorker::ask(PictureOrder order) {
  const std::lock_guard lock(m_mutex);
  m_next = std::move(order);
  wake();
}

void PictureWorker::rest() {
  const std::lock_guard lock(m_mutex);
  m_next.reset();
  m_restsFirst = true;
  wake();
}

// Orders and rests come one after the other however late the thread wakes: a rest of its own in the queue
// could end what was asked for after it.
void PictureWorker::wake() {
  m_isInterrupted = true;
  if (!std::exchange(m_isWoken, true))
    QMetaObject::invokeMethod(this, &PictureWorker::begin, Qt::QueuedConnection);
}

std::optional<PictureDelivery> PictureWorker::take() {
  const std::lock_guard lock(m_mutex);
  return std::exchange(m_delivery, std::nullopt);
}

void PictureWorker::begin() {
  std::optional<PictureOrder> next;
  bool restsFirst = false;
  {
    const std::lock_guard lock(m_mutex);
    next = std::exchange(m_next, std::nullopt);
    restsFirst = std::exchange(m_restsFirst, false);
    m_isWoken = false;
    m_isInterrupted = false;
    if (next)
      m_endsPreparing = false;
  }
  if (restsFirst) {
    m_canDraw = false;
    m_loop.stop();
  }
  if (!next)
    return;
  const bool isOther = next->number != m_order.number;
  m_order = std::move(*next);
  if (isOther || !m_canDraw) {
    m_canDraw = true;
    m_loop.restart();
  }
  show();
  if (!isOther)
    m_loop.resume();
}

void PictureWorker::goOn() {
  m_canDraw = m_loop.pictures() != nullptr;
  m_loop.resume();
}

void PictureWorker::guard(const PictureContext::Work& work) {
  try {
    work();
  } catch (const Cancelled&) {
    // Something else is to be shown, or nothing.
  } catch (const std::exception& error) {
    m_canDraw = false;
    m_loop.stop();
    emit failed(translated(error));
  }
}

void PictureWorker::show() {
  if (!m_canDraw)
    return;
  guard([this] {
    m_isCoarse = true;
    m_loop.drawIfStale(m_order.request);
    m_isCoarse = false;
    if (!m_loop.pictures())
      return;
    m_loop.pictures()->show(m_order.arrangement, m_order.background);
    m_frame = m_loop.pictures()->frame();
    m_loop.noteShown();
  });
  m_isCoarse = false;
  if (m_canDraw)
    deliver();
}

void PictureWorker::deliver() {
  PictureDelivery delivery{m_order.number, m_frame, m_loop.state(), {}, {}};
  for (int side = 0; side < static_cast<int>(delivery.state.sides.size()); ++side) {
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

} // namespace limn
