// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/drawing/EngineSwitch.h"

#include "widgets/view/drawing/DriverDrawing.h"
#include "widgets/view/drawing/DriverRecovery.h"
#include "widgets/view/drawing/ProcessorDrawing.h"

namespace limn {

EngineSwitch::EngineSwitch(DrawingEngines engines, Engine engine, QWidget& view)
    : QObject(&view), m_engines(std::move(engines)), m_view(view), m_engine(engine) {
  connect(&m_recovery, &DriverRecovery::stopped, this, &EngineSwitch::push);
  connect(&m_recovery, &DriverRecovery::givenUp, this, &EngineSwitch::giveUpDriver);
  connect(&m_recovery, &DriverRecovery::tooLarge, this, &EngineSwitch::standIn);
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
  auto* drawing = new DriverDrawing(m_engines.driver, m_recovery, m_view);
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
  m_drawing =
      drawsWithOpenGl(engine) ? makeDriverDrawing() : new ProcessorDrawing(m_engines.processor, m_view);
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

// For this volume alone.
void EngineSwitch::standIn() {
  letProcessorDraw(m_tooLarge, tr("%1 The processor draws it.").arg(m_recovery.sentence()));
}

} // namespace limn
