// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/failure/DriverRecovery.h"

#include "engine/VolumeTooLarge.h"
#include "gl/DriverHealth.h"
#include "widgets/Translated.h"

#include <QTimer>

#include <exception>

namespace limn {

void DriverRecovery::guard(const std::function<void()>& work) {
  try {
    forgetDriverErrors(); // those of Qt's painter
    work();
    requireHealthyDriver(Message::tr("drawing the picture"));
  } catch (const VolumeTooLarge& error) {
    m_sentence = translated(error);
    emit stopped();
    QTimer::singleShot(0, this, [this] {
      if (hasFailed()) // otherwise something else is to be shown
        emit tooLarge();
    });
  } catch (const DriverError& error) {
    failDriver(translated(error), QString::fromStdString(error.details()));
  } catch (const Error& error) {
    if (error.kind() == Error::Kind::openGl)
      failDriver(translated(error), {});
    else
      fail(translated(error));
  } catch (const std::exception& error) {
    fail(translated(error));
  }
}

void DriverRecovery::fail(const QString& sentence) {
  m_sentence = sentence;
  emit stopped();
  // Widgets must not be shown, nor the caller's slots run, in the middle of painting.
  QTimer::singleShot(0, this, [this, sentence] { emit failed(sentence); });
}

void DriverRecovery::giveUp(const QString& sentence) {
  m_sentence = sentence;
  m_details.clear();
  emit stopped();
  emit givenUp();
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
  m_sentence.clear();
  m_failures = 0;
}

void DriverRecovery::noteSuccess() {
  if (m_failures == 0)
    return;
  m_failures = 0;
  emit restored(tr("The graphics driver failed, and everything in it was made anew; nothing is lost."));
}

} // namespace limn
