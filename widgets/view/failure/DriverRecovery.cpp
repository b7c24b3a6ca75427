// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/failure/DriverRecovery.h"

#include "gl/DriverHealth.h"

#include <QTimer>

#include <exception>

namespace limn {

DriverRecovery::DriverRecovery(MakeEngine processor, QObject* parent)
    : QObject(parent), m_processor(std::move(processor)) {
  connect(&m_processor, &ProcessorDrawing::drawn, this, &DriverRecovery::showDrawn);
  connect(&m_processor, &ProcessorDrawing::failed, this, &DriverRecovery::fail);
}

void DriverRecovery::guard(const std::function<void()>& work) {
  try {
    forgetDriverErrors(); // those of Qt's painter
    work();
    requireHealthyDriver("drawing the picture");
  } catch (const DriverError& error) {
    failDriver(QString::fromStdString(error.what()), QString::fromStdString(error.details()));
  } catch (const Error& error) {
    if (error.kind() == Error::Kind::openGl)
      failDriver(QString::fromStdString(error.what()), {});
    else
      fail(QString::fromStdString(error.what()));
  } catch (const std::exception& error) {
    fail(QString::fromStdString(error.what()));
  }
}

void DriverRecovery::fail(const QString& sentence) {
  m_sentence = sentence;
  m_onProcessor.reset();
  emit stopped();
  // Widgets must not be shown, nor the caller's slots run, in the middle of painting.
  QTimer::singleShot(0, this, [this, sentence] { emit failed(sentence); });
}

void DriverRecovery::failDriver(const QString& sentence, const QString& details) {
  const bool isLost = contextIsLost();
  m_sentence = sentence;
  m_details = details;
  ++m_failures;
  emit stopped();
  QTimer::singleShot(0, this, [this, isLost] {
    if (m_failures < mostFailures)
      emit rebuildNeeded(isLost);
    else
      emit givenUp();
  });
}

void DriverRecovery::forget() {
  m_processor.stop();
  m_onProcessor.reset();
  m_sentence.clear();
  m_failures = 0;
}

void DriverRecovery::noteSuccess() {
  if (m_failures == 0)
    return;
  m_failures = 0;
  emit restored(tr("The graphics driver failed, and everything in it was made anew; nothing is lost."));
}

void DriverRecovery::drawOnProcessor(const std::vector<Scene>& scenes, const glm::ivec2& size) {
  if (!m_processor.canDraw())
    return;
  PictureState state;
  state.driverFailure = m_sentence;
  const bool hasChanged = m_onProcessor != state;
  m_onProcessor = state;
  m_processor.draw(scenes, size);
  if (hasChanged)
    emit stateChanged(state);
}

void DriverRecovery::showDrawn(const std::vector<QImage>& pictures, bool isComplete) {
  if (!m_onProcessor)
    return;
  emit drawn(pictures);
  m_onProcessor->processorIsDone = isComplete;
  emit stateChanged(*m_onProcessor);
}

} // namespace limn
