// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/drawing/EngineSwitch.h"

#include "widgets/view/SurfaceFormat.h"
#include "widgets/view/drawing/DriverDrawing.h"
#include "widgets/view/drawing/ProcessorDrawing.h"

namespace limn {

EngineSwitch::EngineSwitch(DrawingEngines engines, ViewEngine engine, ViewOrders orders, QWidget& view)
    : QObject(&view), m_engines(std::move(engines)), m_orders(std::move(orders)), m_view(view),
      m_engine(engine) {
  m_orders.canDraw = [this, isSeen = m_orders.canDraw] { return isSeen() && !m_recovery.hasFailed(); };
  connect(&m_recovery, &DriverRecovery::givenUp, this, &EngineSwitch::giveUpDriver);
  connect(&m_recovery, &DriverRecovery::tooLarge, this, &EngineSwitch::standIn);
  connect(&m_recovery, &DriverRecovery::restored, this, &EngineSwitch::restored);
  connect(&m_recovery, &DriverRecovery::failed, this, &EngineSwitch::failed);
  draw(m_engines.driver ? m_engine : ViewEngine::processor);
}

EngineSwitch::~EngineSwitch() {
  delete m_drawing;
}

ViewDrawing* EngineSwitch::makeDriverDrawing() {
  auto* drawing = new DriverDrawing(m_engines.driver, m_orders, m_recovery, m_view);
  connect(&m_recovery, &DriverRecovery::rebuildNeeded, drawing, [this, drawing](bool isLost) {
    drawing->rebuild(isLost);
    m_recovery.retry();
    emit redrawNeeded();
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

ViewDrawing* EngineSwitch::makeProcessorDrawing() {
  auto* drawing = new ProcessorDrawing(m_engines.processor, m_orders, m_view);
  connect(drawing, &ProcessorDrawing::failed, &m_recovery, &DriverRecovery::fail);
  return drawing;
}

void EngineSwitch::draw(ViewEngine engine) {
  delete m_drawing;
  m_engine = engine;
  m_drawing = engine == ViewEngine::driver ? makeDriverDrawing() : makeProcessorDrawing();
  m_drawing->setRefines(m_refines);
  if (m_movingMs)
    m_drawing->setMovingMs(*m_movingMs);
  connect(m_drawing, &ViewDrawing::stateChanged, this, [this] { emit stateChanged(state()); });
  connect(m_drawing, &ViewDrawing::effectsChanged, this, &EngineSwitch::effectsChanged);
  connect(m_drawing, &ViewDrawing::timesChanged, this, &EngineSwitch::timesChanged);
  connect(m_drawing, &ViewDrawing::completed, &m_recovery, &DriverRecovery::noteSuccess);
  connect(m_drawing, &ViewDrawing::preparing, this, &EngineSwitch::preparing);
  connect(m_drawing, &ViewDrawing::restFailed, this, &EngineSwitch::errorOccurred);
  connect(&m_recovery, &DriverRecovery::stopped, m_drawing, &ViewDrawing::stop);
  m_drawing->canvas().lower();
  m_drawing->canvas().show();
  emit replaced();
}

void EngineSwitch::choose(ViewEngine engine, const QString& reason) {
  if (!(engine == ViewEngine::driver ? m_engines.driver : m_engines.processor))
    return;
  m_reason = reason;
  const bool standsIn = !m_driverFailure.isEmpty() || !m_tooLarge.isEmpty();
  m_driverFailure.clear();
  m_tooLarge.clear();
  m_recovery.forget();
  if (engine != m_engine || standsIn)
    draw(engine);
  emit stateChanged(state());
}

void EngineSwitch::retryDriver() {
  if (m_driverFailure.isEmpty() && m_tooLarge.isEmpty())
    return;
  choose(ViewEngine::driver, m_reason);
  emit engineChanged(m_engine);
}

void EngineSwitch::forget() {
  m_recovery.forget();
  m_drawing->forget();
  retryDriver();
  emit stateChanged(state());
}

void EngineSwitch::cancelPreparing() {
  m_drawing->endPreparing();
  m_recovery.fail(tr("Getting the volume ready for drawing was cancelled."));
}

void EngineSwitch::setRefines(bool refines) {
  m_refines = refines;
  m_drawing->setRefines(refines);
}

void EngineSwitch::setMovingMs(double ms) {
  m_movingMs = ms;
  m_drawing->setMovingMs(ms);
}

PictureState EngineSwitch::state() const {
  PictureState state = m_drawing->state();
  state.engine = m_engine;
  state.driverHasFailed = !m_driverFailure.isEmpty();
  state.engineReason = state.driverHasFailed ? m_driverFailure : m_reason;
  if (!m_tooLarge.isEmpty())
    state.engineReason = state.limitation = m_tooLarge;
  return state;
}

// False where another engine was chosen meanwhile, or there is none: then the sentence is all there is.
bool EngineSwitch::letProcessorDraw(QString& reason, const QString& sentence) {
  if (m_engine != ViewEngine::driver)
    return false;
  if (!m_engines.processor) {
    m_recovery.fail(m_recovery.sentence());
    return false;
  }
  reason = sentence;
  m_recovery.forget();
  draw(ViewEngine::processor);
  emit engineChanged(m_engine);
  return true;
}

void EngineSwitch::giveUpDriver() {
  if (letProcessorDraw(m_driverFailure, m_recovery.sentence()))
    emit errorOccurred(m_driverFailure);
}

// For this volume alone.
void EngineSwitch::standIn() {
  letProcessorDraw(m_tooLarge, tr("%1 The processor draws it.").arg(m_recovery.sentence()));
}

} // namespace limn
